// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gcv/gcv.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "exact_containment.hpp"
#include "exact_geometry.hpp"
#include "exact_vertices.hpp"
#include "handles.hpp"
#include "invariants.hpp"

namespace gcv::invariants {

namespace {

class Sentences {
 public:
  void expect(bool holds, const std::string& sentence) {
    if (!holds) {
      sentences_.push_back(where + ": " + sentence);
    }
  }
  [[nodiscard]] std::vector<std::string> all() const { return sentences_; }

  std::string where;

 private:
  std::vector<std::string> sentences_;
};

std::string in_words(double tolerance, std::int32_t rounding) {
  std::ostringstream words;
  words << "tolerance " << tolerance << (rounding == GCV_ROUND_OUTWARD ? ", outward" : ", nearest");
  return words.str();
}

// Is each of the points in the ring or within the distance of it?
bool all_in_or_near(const Ring& points, const Ring& ring, double distance, std::size_t samples) {
  Ring outside;
  for (const std::size_t k : sample(points.size(), samples)) {
    if (location(ring, points[k]) < 0) {
      outside.push_back(points[k]);
    }
  }
  return outside.empty() || all_near(outside, ring, distance);
}

struct Returned {
  Polygon ring;
  double error_bound = 0;
};

Returned sum(const Polygon& a, const Polygon& b, const gcv_options& options) {
  gcv_outer_face* handle = nullptr;
  require(gcv_minkowski_sum(make(a).get(), make(b).get(), &options, &handle), "the sum");
  const std::unique_ptr<gcv_outer_face, Destroy> face(handle);
  Returned returned{vertices(gcv_outer_face_vertices, face.get()), 0};
  require(gcv_outer_face_error_bound(handle, &returned.error_bound), "the error bound");
  return returned;
}

}  // namespace

std::vector<std::string> broken_simplification(const Polygon& polygon, double tolerance,
                                               const Effort& effort) {
  Sentences sentences;
  const PolygonHandle given = make(polygon);
  const Polygon before = vertices(gcv_polygon_vertices, given.get());
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    sentences.where = in_words(tolerance, rounding);
    gcv_polygon* handle = nullptr;
    double bound = -1;
    require(gcv_polygon_simplified(given.get(), tolerance, rounding, &handle, &bound),
            "the simplified polygon");
    const Polygon after = vertices(gcv_polygon_vertices, PolygonHandle(handle).get());
    const Ring old_ring = exact(before);
    const Ring new_ring = exact(after);
    sentences.expect(bound >= 0 && bound <= tolerance, "The bound is above the tolerance.");
    sentences.expect((bound == 0) == (after == before), "The bound says what did not happen.");
    sentences.expect(after.size() <= before.size(), "There are more vertices than before.");
    sentences.expect(!find_meeting(new_ring), "The boundary is not simple.");
    sentences.expect(twice_area(new_ring) > 0, "The boundary is not counter-clockwise.");
    sentences.expect(all_edges_near(old_ring, new_ring, bound, effort.work / 4),
                     "The old boundary is too far.");
    sentences.expect(all_edges_near(new_ring, old_ring, bound, effort.work / 4),
                     "The new boundary is too far.");
    if (rounding == GCV_ROUND_OUTWARD) {
      sentences.expect(contains(new_ring, old_ring, effort.work / before.size() + 1),
                       "Something lies outside.");
    } else {
      auto place = before.begin();
      sentences.expect(std::all_of(after.begin(), after.end(),
                                   [&](const Point& p) {
                                     place = std::find(place, before.end(), p);
                                     return place != before.end();
                                   }),
                       "A vertex is new.");
    }
  }
  return sentences.all();
}

std::vector<std::string> broken_sum_within(const Polygon& a, const Polygon& b, double tolerance,
                                           const Effort& effort) {
  Sentences sentences;
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face* handle = nullptr;
  const gcv_status status = gcv_minkowski_sum(make(a).get(), make(b).get(), &options, &handle);
  const std::unique_ptr<gcv_outer_face, Destroy> face(handle);
  if (status == GCV_ERR_RANGE && effort.may_be_out_of_range) {
    return {};
  }
  require(status, "the sum");
  const Ring exact_sum = exact_ring(face.get());
  options.tolerance = tolerance;
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    options.rounding = rounding;
    sentences.where = in_words(tolerance, rounding);
    const Returned returned = sum(a, b, options);
    const Ring ring = exact(returned.ring);
    const std::size_t samples = effort.work / (exact_sum.size() + ring.size()) + 1;
    sentences.expect(!find_meeting(ring), "The ring is not simple.");
    sentences.expect(all_in_or_near(ring, exact_sum, returned.error_bound, samples),
                     "A vertex is too far from the exact sum.");
    sentences.expect(all_in_or_near(exact_sum, ring, returned.error_bound, samples),
                     "An exact vertex is too far outside.");
    if (rounding == GCV_ROUND_OUTWARD) {
      sentences.expect(contains(ring, exact_sum, samples), "Some of the sum lies outside.");
    }
  }
  return sentences.all();
}

}  // namespace gcv::invariants
