// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls of the functions of regions.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "polygon_calls.hpp"

namespace gcv::fuzz {

class RegionCalls : protected PolygonCalls {
 protected:
  using PolygonCalls::PolygonCalls;

  void sum_region() {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    make("gcv_minkowski_sum_region", regions_, faults, {GCV_ERR_RANGE},
         [&](gcv_region** out) { return gcv_minkowski_sum_region(a, b, options.get(), out); });
  }

  void no_fit_region() { with_reference("gcv_no_fit_region", gcv_no_fit_region); }
  void entrance_region() { with_reference("gcv_entrance_region", gcv_entrance_region); }
  void inner_fit_region() {
    with_reference("gcv_inner_fit_region", gcv_inner_fit_region, Options::Use::inner_fit);
  }

  // Up to three pairs, of which some fail alone.
  void region_many() {
    const std::size_t count = input_.below(4);
    std::array<const gcv_polygon*, 3> a{};
    std::array<const gcv_polygon*, 3> b{};
    std::array<double, 6> references{};
    for (std::size_t k = 0; k < count; ++k) {
      a[k] = polygons_[input_.below(polygons_.size())].get();
      b[k] = polygons_[input_.below(polygons_.size())].get();
      references[2 * k] = number();
      references[2 * k + 1] = number();
    }
    Faults faults;
    const Options options(input_, faults);
    const bool without = input_.below(16) == 0;
    std::array<gcv_region*, 4> out{};
    std::array<gcv_status, 4> statuses{};
    statuses.fill(-1);
    faults.pointer(without ? nullptr : references.data());
    const gcv_status status =
        gcv_no_fit_region_many(a.data(), b.data(), without ? nullptr : references.data(), count,
                               options.get(), out.data(), statuses.data());
    message_ = gcv_last_error_message();
    check(count == 0 || faults.none() ? status == GCV_OK : faults.explain(status),
          std::string("gcv_no_fit_region_many gave ") + gcv_status_name(status));
    for (std::size_t k = 0; k < out.size(); ++k) {
      const bool tried = status == GCV_OK && k < count;
      check((out[k] != nullptr) == (statuses[k] == GCV_OK) && (tried || statuses[k] == -1),
            "a region or not?");
      if (out[k] != nullptr) {
        regions_[k % regions_.size()].reset(out[k]);
      }
    }
  }

  void region_numbers() {
    number_of<double>("gcv_region_area", regions_, 1, {GCV_ERR_RANGE}, gcv_region_area);
    number_of<double>("gcv_region_error_bound", regions_, 1, {}, gcv_region_error_bound);
  }

  void region_lists() {
    const std::size_t list = input_.below(7);
    if (list == 0) {
      list_of<gcv_region_part>("gcv_region_parts", gcv_region_parts);
    } else if (list == 1) {
      list_of<gcv_region_part>("gcv_region_exact_parts", gcv_region_exact_parts);
    } else if (list == 2) {
      list_of<gcv_edge_source>("gcv_region_edge_sources", gcv_region_edge_sources);
    } else if (list == 3) {
      list_of<std::uint64_t>("gcv_region_edge_owners", gcv_region_edge_owners);
    } else if (list == 4) {
      list_of<std::uint64_t>("gcv_region_exact_indices", gcv_region_exact_indices);
    } else {
      Faults faults;
      const gcv_region* const region = pick(regions_, faults);
      fill<Vertex>("gcv_region_vertices", faults,
                   [&](Vertex* out, std::size_t capacity, std::size_t* required) {
                     return gcv_region_vertices(region, reinterpret_cast<double*>(out), capacity,
                                                required);
                   });
    }
  }

  void region_texts() {
    Faults faults;
    const std::size_t text = input_.below(3);
    const gcv_region* const region = pick(regions_, faults);
    if (text == 0) {
      exact_vertex_of(region, faults);
      return;
    }
    const auto function = text == 1 ? gcv_region_wkt : gcv_region_fits_wkt;
    fill_text<char>("gcv_region_wkt", faults,
                    [&](char* out, std::size_t capacity, std::size_t* required) {
                      return function(region, out, capacity, required);
                    });
  }

  void region_polygon() {
    Faults faults;
    const gcv_region* const region = pick(regions_, faults);
    const std::size_t polygons = region == nullptr ? 0 : polygon_count(region);
    const auto index = input_.one_of<std::size_t>({0, 0, 1, polygons - 1, polygons, SIZE_MAX});
    faults.add_if(region != nullptr && index >= polygons, GCV_ERR_INVALID_ARGUMENT);
    make("gcv_region_polygon", polygons_, faults, {},
         [&](gcv_polygon** out) { return gcv_region_polygon(region, index, out); });
  }

  void locate() {
    Faults faults;
    const gcv_region* const region = pick(regions_, faults);
    const std::size_t count = input_.below(5);
    std::vector<double> xy(2 * count + 1);
    bool is_finite = true;
    for (std::size_t k = 0; k < 2 * count; ++k) {
      xy[k] = number();
      is_finite = is_finite && std::isfinite(xy[k]);
    }
    faults.add_if(!is_finite, GCV_ERR_NOT_FINITE);
    const bool without = input_.below(16) == 0;
    faults.add_if(without && count > 0, GCV_ERR_NULL_ARGUMENT);
    Bytes out(count + sentinels, untouched_byte);
    const bool well = judge("gcv_region_locate",
                            gcv_region_locate(region, without ? nullptr : xy.data(), count,
                                              reinterpret_cast<std::int8_t*>(out.data())),
                            faults);
    check(untouched(out, well ? count : 0), "gcv_region_locate writes where it must not");
    for (std::size_t k = 0; well && k < count; ++k) {
      check(static_cast<std::uint8_t>(out[k] + 1) < 3, "neither inside nor outside nor between");
    }
  }

  void region_stats() { stats_of("gcv_region_stats", regions_, gcv_region_stats); }

 private:
  template <class Function>
  void with_reference(const char* name, Function function, Options::Use use = Options::Use::sum) {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults, use);
    std::array<double, 2> point{};
    const double* const given = reference(point, faults);
    make(name, regions_, faults, {GCV_ERR_RANGE},
         [&](gcv_region** out) { return function(a, b, given, options.get(), out); });
  }

  template <class Element, class Function>
  void list_of(const char* name, Function function) {
    Faults faults;
    const gcv_region* const region = pick(regions_, faults);
    fill<Element>(name, faults, [&](Element* out, std::size_t capacity, std::size_t* required) {
      return function(region, out, capacity, required);
    });
  }

  void exact_vertex_of(const gcv_region* region, Faults& faults) {
    std::size_t count = 0;
    if (region != nullptr) {
      judge("gcv_region_edge_owners", gcv_region_edge_owners(region, nullptr, 0, &count), faults);
    }
    const auto index = input_.one_of<std::size_t>({0, 1, 2, count - 1, count, SIZE_MAX});
    faults.add_if(region != nullptr && index >= count, GCV_ERR_INVALID_ARGUMENT);
    fill_text<char>("gcv_region_exact_vertex", faults,
                    [&](char* out, std::size_t capacity, std::size_t* required) {
                      return gcv_region_exact_vertex(region, index, out, capacity, required);
                    });
  }

  static std::size_t polygon_count(const gcv_region* region) {
    std::size_t count = 0;
    check(gcv_region_parts(region, nullptr, 0, &count) == GCV_OK, "no number of parts");
    std::vector<gcv_region_part> parts(count + 1);
    check(gcv_region_parts(region, parts.data(), count, &count) == GCV_OK, "no parts");
    return static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(),
                      [](const gcv_region_part& part) { return part.kind == GCV_PART_OUTER; }));
  }
};

}  // namespace gcv::fuzz
