// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "catalogue.hpp"

namespace gcv::hard {

// Over all answers to questions about some of the pairs, byte by byte: relations, distances, casts.
// The second polygon is moved to vertices of the no-fit region, and from one to the next.
std::uint64_t digest_of_questions(const Pairs& pairs);

// Likewise: ways out of overlaps, between such vertices; and lists of contacts, in them.
std::uint64_t digest_of_overlaps(const Pairs& pairs);

// Likewise: pairs and contacts of scenes of such polygons, distances and casts in them.
std::uint64_t digest_of_scenes(const Pairs& pairs);

// Likewise: free regions, best positions and ways out in such scenes.
std::uint64_t digest_of_free_positions(const Pairs& pairs);

}  // namespace gcv::hard
