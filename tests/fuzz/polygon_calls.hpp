// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls of the functions of polygons.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "calls.hpp"

namespace gcv::fuzz {

class PolygonCalls : protected Caller {
 protected:
  using Caller::Caller;

  void create() {
    Faults faults;
    const auto stride = input_.one_of<std::size_t>({0, 0, 0, 16, 17, 24, 40, 1, 8, 15});
    const std::size_t step = stride == 0 ? 16 : stride;
    std::size_t count = input_.below(8);
    Bytes bytes(count * step + 16);
    for (std::size_t k = 0; k < count; ++k) {
      const std::array<double, 2> point{number(), number()};
      std::memcpy(bytes.data() + k * step, &point, sizeof point);
    }
    if (input_.below(16) == 0) {
      count = input_.one_of<std::size_t>({SIZE_MAX, std::size_t{1} << 31, SIZE_MAX / 16});
    }
    faults.add_if(step < 16 || count > INT32_MAX, GCV_ERR_INVALID_ARGUMENT);
    const double* const xy = faults.pointer(
        input_.below(16) == 0 ? nullptr : reinterpret_cast<const double*>(bytes.data()));
    make("gcv_polygon_create", polygons_, faults,
         {GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE},
         [&](gcv_polygon** out) { return gcv_polygon_create(xy, count, stride, out); });
  }

  void create_rings() {
    Faults faults;
    const Rings given = rings();
    const std::size_t count = given.sizes.size() - 1;
    const double* const xy = faults.pointer(input_.below(16) == 0 ? nullptr : given.xy.data() + 2);
    const std::size_t* const sizes =
        faults.pointer(input_.below(16) == 0 ? nullptr : given.sizes.data());
    faults.add_if(given.huge, GCV_ERR_INVALID_ARGUMENT);
    faults.add_if(count == 0, GCV_ERR_DEGENERATE);
    make("gcv_polygon_create_rings", polygons_, faults,
         {GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE},
         [&](gcv_polygon** out) { return gcv_polygon_create_rings(xy, sizes, count, 0, out); });
  }

  void create_many() {
    const Rings given = rings();
    const std::size_t count = given.sizes.size() - 1;
    const bool without_xy = input_.below(16) == 0;
    const double* const xy = without_xy ? nullptr : given.xy.data() + 2;
    std::array<gcv_polygon*, 5> out{};
    std::array<gcv_status, 5> statuses{};
    statuses.fill(-1);
    const gcv_status status =
        gcv_polygon_create_many(xy, given.sizes.data(), count, 0, out.data(), statuses.data());
    check(status == (count == 0   ? GCV_OK
                     : without_xy ? GCV_ERR_NULL_ARGUMENT
                     : given.huge ? GCV_ERR_INVALID_ARGUMENT
                                  : GCV_OK),
          std::string("gcv_polygon_create_many gave ") + gcv_status_name(status));
    message_ = gcv_last_error_message();
    for (std::size_t k = 0; k < out.size(); ++k) {
      const bool tried = status == GCV_OK && k < count;
      check((out[k] != nullptr) == (statuses[k] == GCV_OK) && (tried || statuses[k] == -1),
            "a polygon or not?");
      if (out[k] != nullptr) {
        polygons_[k % polygons_.size()].reset(out[k]);
      }
    }
  }

  void disc() {
    Faults faults;
    const std::array<double, 2> centre{number(), number()};
    const double radius = number();
    const double tolerance = std::abs(radius) * input_.one_of({0.5, 0.01, 1e-4, 1e-20, -1.0, 0.0});
    const std::int32_t rounding = any_rounding(input_);
    faults.add_if(!std::isfinite(centre[0]) || !std::isfinite(centre[1]) || !std::isfinite(radius),
                  GCV_ERR_NOT_FINITE);
    faults.add_if(!(radius > 0) || !(tolerance > 0) || !is_rounding(rounding),
                  GCV_ERR_INVALID_ARGUMENT);
    const double* const given = faults.pointer(input_.below(16) == 0 ? nullptr : centre.data());
    make("gcv_polygon_create_disc", polygons_, faults, {GCV_ERR_INVALID_ARGUMENT, GCV_ERR_RANGE},
         [&](gcv_polygon** out) {
           return gcv_polygon_create_disc(given, radius, tolerance, rounding, out);
         });
  }

  void affine() {
    Faults faults;
    const gcv_polygon* const polygon = pick(polygons_, faults);
    std::array<double, 6> m{};
    for (double& x : m) {
      x = number();
      faults.add_if(!std::isfinite(x), GCV_ERR_NOT_FINITE);
    }
    const double* const given = faults.pointer(input_.below(16) == 0 ? nullptr : m.data());
    make("gcv_polygon_affine", polygons_, faults,
         {GCV_ERR_RANGE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE},
         [&](gcv_polygon** out) { return gcv_polygon_affine(polygon, given, out); });
  }

  void ring() {
    Faults faults;
    const gcv_polygon* const polygon = pick(polygons_, faults);
    std::size_t count = 0;
    if (polygon != nullptr) {
      judge("gcv_polygon_ring_count", gcv_polygon_ring_count(polygon, &count), faults);
    }
    const auto index = input_.one_of<std::size_t>({0, 0, 1, count - 1, count, SIZE_MAX});
    faults.add_if(polygon != nullptr && index >= count, GCV_ERR_INVALID_ARGUMENT);
    fill<Vertex>("gcv_polygon_ring", faults,
                 [&](Vertex* out, std::size_t capacity, std::size_t* required) {
                   return gcv_polygon_ring(polygon, index, reinterpret_cast<double*>(out), capacity,
                                           required);
                 });
  }

  void create_wkt() {
    Faults faults;
    const std::string whole = input_.one_of({
        "POLYGON ((0 0, 4 4, 2 3, 0 4))",
        "POLYGON((0.1 0.2,0.7 0.1,1.3 0.4,0.9 0.6,1.1 1.7,0.6 0.7,0.2 1.1),(0.5 0.5,1 0.4,1 0.5))",
        "POLYGON ((0 0, 1.7e308 1.7e308, 1e308 1.6e308, 0 1.7e308))",
        "POLYGON ((0 0, 2e-323 2e-323, 1e-323 1.5e-323, 0 2e-323))",
        "POLYGON ((0 0, 1 1, 1 0, 0 1))",
        "POLYGON ((0 0, 1e999 0, 0 1))",
        "POLYGON EMPTY",
    });
    const std::vector<char> text(whole.begin(),  // without a NUL
                                 whole.end() - (input_.below(8) == 0 ? 1 : 0));
    const char* const given = faults.pointer(input_.below(16) == 0 ? nullptr : text.data());
    make("gcv_polygon_create_wkt", polygons_, faults,
         {GCV_ERR_PARSE, GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE},
         [&](gcv_polygon** out) { return gcv_polygon_create_wkt(given, text.size(), out); });
  }

  void simplified() {
    Faults faults;
    const gcv_polygon* const polygon = pick(polygons_, faults);
    const double tolerance = any_tolerance(input_);
    const std::int32_t rounding = any_rounding(input_);
    faults.add_if(!is_tolerance(tolerance) || !is_rounding(rounding), GCV_ERR_INVALID_ARGUMENT);
    double bound = -1;
    double* const given = faults.pointer(input_.below(16) == 0 ? nullptr : &bound);
    make("gcv_polygon_simplified", polygons_, faults, {}, [&](gcv_polygon** out) {
      return gcv_polygon_simplified(polygon, tolerance, rounding, out, given);
    });
    check(bound == -1 ? !faults.none() : faults.none() && bound >= 0 && bound <= tolerance,
          "a bound or not?");
  }

  void polygon_numbers() {
    number_of<std::size_t>("gcv_polygon_vertex_count", polygons_, 1, {}, gcv_polygon_vertex_count);
    number_of<double>("gcv_polygon_area", polygons_, 1, {GCV_ERR_RANGE}, gcv_polygon_area);
    number_of<double>("gcv_polygon_bounds", polygons_, 4, {}, gcv_polygon_bounds);
  }

  void polygon_vertices() {
    Faults faults;
    const gcv_polygon* const polygon = pick(polygons_, faults);
    fill<Vertex>("gcv_polygon_vertices", faults,
                 [&](Vertex* out, std::size_t capacity, std::size_t* required) {
                   return gcv_polygon_vertices(polygon, reinterpret_cast<double*>(out), capacity,
                                               required);
                 });
  }

 private:
  // Numbers of vertices of up to four rings, now and then one that is beyond all memory, and the
  // vertices.
  struct Rings {
    std::vector<std::size_t> sizes;
    std::vector<double> xy;
    bool huge = false;
  };
  Rings rings() {
    Rings rings;
    rings.sizes.resize(input_.below(5));
    rings.xy.resize(2);  // an address
    for (std::size_t& size : rings.sizes) {
      size = input_.below(6);
      for (std::size_t k = 0; k < 2 * size; ++k) {
        rings.xy.push_back(number());
      }
    }
    if (!rings.sizes.empty() && input_.below(8) == 0) {
      rings.huge = true;
      rings.sizes.front() = input_.one_of<std::size_t>({SIZE_MAX, SIZE_MAX / 16, SIZE_MAX - 2});
    }
    rings.sizes.push_back(0);  // likewise
    return rings;
  }
};

}  // namespace gcv::fuzz
