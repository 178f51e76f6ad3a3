// SPDX-License-Identifier: LGPL-3.0-or-later
#include "stats.hpp"

#include <cstddef>
#include <cstring>

#include "error.hpp"

namespace gcv::capi {

void give_stats(const Counts& counts, std::uint64_t vertices_repaired, std::uint64_t parts_dropped,
                gcv_stats* out) {
  constexpr std::size_t first_size = offsetof(gcv_stats, parts_dropped);
  const std::uint32_t size = out->struct_size;
  if (size < first_size) {
    throw Error(Status::invalid_argument,
                "stats: struct_size is %u, less than %zu; set it to sizeof(gcv_stats)", size,
                first_size);
  }
  // The bytes between the members are written too.
  gcv_stats stats;
  std::memset(&stats, 0, sizeof stats);
  stats.struct_size = size;
  stats.walk_steps = counts.walk_steps;
  stats.candidate_edges = counts.candidate_edges;
  stats.predicates_filtered = counts.predicates.filtered;
  stats.predicates_fixed_width = counts.predicates.fixed_width;
  stats.predicates_rational = counts.predicates.rational;
  stats.vertices_repaired = vertices_repaired;
  stats.parts_dropped = parts_dropped;
  std::memset(out, 0, size);
  std::memcpy(out, &stats, size < sizeof stats ? first_size : sizeof stats);
}

}  // namespace gcv::capi
