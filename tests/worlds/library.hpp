// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The library, by its C interface, as what is compared.
#pragma once

#include <gcv/gcv.h>

#include <memory>
#include <string>
#include <vector>

#include "plane.hpp"

namespace worlds {

struct Destroy {
  void operator()(gcv_polygon* handle) const { gcv_polygon_destroy(handle); }
  void operator()(gcv_outer_face* handle) const { gcv_outer_face_destroy(handle); }
  void operator()(gcv_region* handle) const { gcv_region_destroy(handle); }
  void operator()(gcv_scene* handle) const { gcv_scene_destroy(handle); }
};
template <class Handle>
using Owner = std::unique_ptr<Handle, Destroy>;

// Throws std::runtime_error with the message of the library.
void check(gcv_status status);

gcv_status make_polygon(const Polygon& polygon, Owner<gcv_polygon>& out);
Owner<gcv_polygon> make_polygon(const Polygon& polygon);

// As `text` of parts.
std::string text(const gcv_region& region);
std::string text(const gcv_outer_face& face);

// What is asked at many places.
class Subject {
 public:
  virtual ~Subject() = default;
  virtual std::vector<std::int8_t> relation(const std::vector<double>& places) const = 0;
  virtual std::vector<gcv_separation> distance(const std::vector<double>& places) const = 0;
  virtual std::vector<gcv_escape> penetration(const std::vector<double>& places) const = 0;
};

class PairSubject : public Subject {
 public:
  PairSubject(const gcv_polygon& a, const gcv_polygon& b) : a_(a), b_(b) {}
  std::vector<std::int8_t> relation(const std::vector<double>& places) const override;
  std::vector<gcv_separation> distance(const std::vector<double>& places) const override;
  std::vector<gcv_escape> penetration(const std::vector<double>& places) const override;

 private:
  const gcv_polygon& a_;
  const gcv_polygon& b_;
};

class SceneSubject : public Subject {
 public:
  SceneSubject(const gcv_scene& scene, const gcv_polygon& moving)
      : scene_(scene), moving_(moving) {}
  std::vector<std::int8_t> relation(const std::vector<double>& places) const override;
  std::vector<gcv_separation> distance(const std::vector<double>& places) const override;
  std::vector<gcv_escape> penetration(const std::vector<double>& places) const override;

 private:
  const gcv_scene& scene_;
  const gcv_polygon& moving_;
};

}  // namespace worlds
