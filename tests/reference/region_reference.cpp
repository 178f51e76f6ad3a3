// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_reference.hpp"

#include <algorithm>

#include "arranged_region.hpp"

namespace gcv::reference {

using namespace arranged;

std::vector<RegionPart> sum_region(const Rings& a, const Rings& b, const Point& shift) {
  const int scale = std::max(binary_places(a), binary_places(b));
  const Summands sum{make_solid(scaled(a, scale), false), make_solid(scaled(b, scale), false)};
  return Region({sum}, Region::Kind::sum).parts(scale, shift);
}

// A part at t lies in the container if it does not overlap what is not in the container. So t is
// not in the open sum of that and the reflected part.
std::vector<RegionPart> inner_fit_region(const Rings& container, const Rings& moving,
                                         const Point& reference) {
  const int scale = std::max(binary_places(container), binary_places(moving));
  const Summands sum{make_solid(scaled(container, scale), true),
                     make_solid(scaled(moving, scale, true), false)};
  return Region({sum}, Region::Kind::free_in_container).parts(scale, reference);
}

std::vector<RegionPart> free_region(const PlacedRings& members, const Rings* container,
                                    const Rings& moving, const std::optional<Window>& window) {
  int scale = binary_places(moving);
  for (const auto& [rings, place] : members) {
    scale = std::max({scale, binary_places(rings), binary_places(PointVector{place})});
  }
  if (container != nullptr) {
    scale = std::max(scale, binary_places(*container));
  }
  if (window) {
    scale = std::max(scale, binary_places(PointVector{window->low, window->high}));
  }
  const Solid reflected = make_solid(scaled(moving, scale, true), false);
  std::vector<Summands> sums;
  for (const auto& [rings, place] : members) {
    sums.push_back(
        {make_solid(scaled(rings, scale, false, scaled(place, scale)), false), reflected});
  }
  if (container != nullptr) {
    sums.push_back({make_solid(scaled(*container, scale), true), reflected});
  }
  const auto frame =
      window ? std::optional(Frame{scaled(window->low, scale), scaled(window->high, scale)})
             : std::nullopt;
  return Region(
             sums,
             container != nullptr ? Region::Kind::free_in_container : Region::Kind::free_in_window,
             frame)
      .parts(scale, {0, 0});
}

std::string text(const std::vector<RegionPart>& region) {
  constexpr const char* names[] = {"outer", "hole", "segment", "point"};
  std::string result;
  for (const RegionPart& part : region) {
    result += names[part.kind - 1];
    if (part.kind <= 2) {
      result += " " + std::to_string(part.polygon);
    }
    const char* separator = ": ";
    for (const std::string& vertex : part.vertices) {
      result += separator + vertex;
      separator = ", ";
    }
    result += "\n";
  }
  return result;
}

}  // namespace gcv::reference
