// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Six digests for each family of the catalogue. The first is over all that the library says of
// its sums: coordinates to the last bit, sources, bounds, in both roundings, exactly and within a
// tolerance. The second is over the regions of the same pairs, and of some made of them: exact and
// rounded parts, sources, bounds, places of points. The third is over relations, distances and
// casts, the fourth over ways out of overlaps and lists of contacts, the fifth over scenes, the
// sixth over what is free in scenes. They are the same for every compiler and every level of
// optimisation.
//
//   digest                  prints them
//   digest FILE             compares them with the ones in the file
//   digest FILE PART PARTS  compares those of one part of the families, which is 1 to PARTS
#include "digest.hpp"

#include <cstdint>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "catalogue.hpp"
#include "gcv/gcv.h"
#include "question_digest.hpp"
#include "region_digest.hpp"
#include "region_operands.hpp"

namespace gcv::hard {
namespace {

gcv_polygon* polygon(const Polygon& ring) {
  gcv_polygon* result = nullptr;
  if (gcv_polygon_create(ring.front().data(), ring.size(), 0, &result) != GCV_OK) {
    std::cerr << gcv_last_error_message() << '\n';
  }
  return result;
}

void add_face(Digest& digest, const gcv_outer_face* face) {
  std::size_t count = 0;
  bool read = gcv_outer_face_vertex_count(face, &count) == GCV_OK;
  std::vector<double> xy(2 * count);
  read = read && gcv_outer_face_vertices(face, xy.data(), count, &count) == GCV_OK;
  read = read && gcv_outer_face_exact_vertex_count(face, &count) == GCV_OK;
  std::vector<gcv_edge_source> sources(count);
  read = read && gcv_outer_face_edge_sources(face, sources.data(), count, &count) == GCV_OK;
  double bound = 0;
  read = read && gcv_outer_face_error_bound(face, &bound) == GCV_OK;
  digest.add(&read, sizeof read);
  digest.add(xy);
  digest.add(sources);
  digest.add(&bound, sizeof bound);
}

void add_sum(Digest& digest, const gcv_polygon* a, const gcv_polygon* b, std::int32_t rounding,
             double tolerance) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = rounding;
  options.tolerance = tolerance;
  gcv_outer_face* face = nullptr;
  const gcv_status status = gcv_minkowski_sum(a, b, &options, &face);
  digest.add(&status, sizeof status);
  if (status == GCV_OK) {
    add_face(digest, face);
  }
  gcv_outer_face_destroy(face);
}

// A 64th of the width of the polygon.
double tolerance_for(const gcv_polygon* polygon) {
  double box[4] = {0, 0, 0, 0};
  if (gcv_polygon_bounds(polygon, box) != GCV_OK) {
    std::cerr << gcv_last_error_message() << '\n';
  }
  return box[2] / 64 - box[0] / 64;
}

std::uint64_t digest_of(const Pairs& pairs) {
  Digest digest;
  for (const Pair& pair : pairs) {
    gcv_polygon* const a = polygon(pair.a);
    gcv_polygon* const b = polygon(pair.b);
    for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
      for (const double tolerance : {0.0, tolerance_for(a)}) {
        add_sum(digest, a, b, rounding, tolerance);
      }
    }
    gcv_polygon_destroy(a);
    gcv_polygon_destroy(b);
  }
  return digest.value();
}

// Of some pairs with few superset edges. Builds that check everything take long for the others.
std::uint64_t digest_of_regions(const Pairs& pairs) {
  Digest digest;
  for (const Pair& pair : region_pairs(pairs, 15)) {
    const RegionOperands operands(pair);
    const double origin[2] = {0, 0};
    const double reference[2] = {0.1, -3};
    add_regions(digest, [&](const gcv_options* options, gcv_region** out) {
      return gcv_minkowski_sum_region(operands.a.get(), operands.b.get(), options, out);
    });
    add_regions(digest, [&](const gcv_options* options, gcv_region** out) {
      return gcv_no_fit_region(operands.a.get(), operands.b.get(), reference, options, out);
    });
    for (const auto& moving : operands.moving) {
      add_regions(digest, [&](const gcv_options* options, gcv_region** out) {
        return gcv_inner_fit_region(operands.a.get(), moving.get(), reference, options, out);
      });
      if (operands.frame != nullptr) {
        add_regions(digest, [&](const gcv_options* options, gcv_region** out) {
          return gcv_no_fit_region(operands.frame.get(), moving.get(), origin, options, out);
        });
      }
    }
  }
  return digest.value();
}

std::string digests_of(const Family& family) {
  const Pairs pairs = family.pairs();
  std::ostringstream text;
  text << family.name << ' ' << std::hex << digest_of(pairs) << ' ' << digest_of_regions(pairs)
       << ' ' << digest_of_questions(pairs) << ' ' << digest_of_overlaps(pairs) << ' '
       << digest_of_scenes(pairs) << ' ' << digest_of_free_positions(pairs);
  return text.str();
}

std::vector<Family> all_families() {
  std::vector<Family> families;
  for (const auto theme : {fits, directions, coincidences, curves, magnitudes}) {
    const std::vector<Family> more = theme();
    families.insert(families.end(), more.begin(), more.end());
  }
  return families;
}

std::vector<std::string> lines_of(const char* name) {
  std::ifstream file(name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

// Says what differs from the lines in the file, of every `parts`th family from `first` on.
bool are_kept(const char* name, std::size_t first, std::size_t parts) {
  const std::vector<Family> families = all_families();
  const std::vector<std::string> kept = lines_of(name);
  bool are_equal = kept.size() == families.size() && first < parts;
  if (!are_equal) {
    std::cout << name << " has " << kept.size() << " lines for " << families.size() << '\n';
  }
  for (std::size_t k = first; are_equal && k < families.size(); k += parts) {
    const std::string digests = digests_of(families[k]);
    std::cout << digests << '\n';
    if (digests != kept[k]) {
      std::cout << "differs from " << name << ":\n" << kept[k] << '\n';
      return false;
    }
  }
  return are_equal;
}

}  // namespace
}  // namespace gcv::hard

int main(int argc, char** argv) {
  if (argc == 1) {
    for (const gcv::hard::Family& family : gcv::hard::all_families()) {
      std::cout << gcv::hard::digests_of(family) << '\n';
    }
    return 0;
  }
  const bool is_part = argc == 4;
  const std::size_t first = is_part ? std::stoul(argv[2]) - 1 : 0;
  return gcv::hard::are_kept(argv[1], first, is_part ? std::stoul(argv[3]) : 1) ? 0 : 1;
}
