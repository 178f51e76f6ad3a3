// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>

#include "libgcv_handles.hpp"
#include "nest.hpp"

namespace gcv::bench {

namespace {

// The strip, and the parts that are in it.
class Strip {
 public:
  explicit Strip(const NestingJob& job) {
    gcv_scene* out = nullptr;
    check(gcv_scene_create(&out));
    scene_.reset(out);
    const auto container =
        make_polygon({{0, 0}, {job.length, 0}, {job.length, job.height}, {0, job.height}});
    check(gcv_scene_set_container(out, container.get()));
    for (const Ring& shape : job.shapes) {
      shapes_.push_back(make_polygon(shape));
    }
  }

  [[nodiscard]] std::optional<Point> best(std::size_t shape, std::uint64_t leave_out) const {
    const double left[] = {-1, 0};
    gcv_options options = GCV_OPTIONS_INIT;
    options.leave_out = leave_out;
    Point position{};
    std::int32_t is_found = 0;
    check(gcv_scene_best(scene_.get(), shapes_[shape].get(), left, nullptr, &options, &position.x,
                         &is_found));
    return is_found == 1 ? std::make_optional(position) : std::nullopt;
  }

  [[nodiscard]] std::optional<Point> smallest_vertex(std::size_t shape,
                                                     std::uint64_t leave_out) const {
    gcv_options options = GCV_OPTIONS_INIT;
    options.rounding = GCV_ROUND_OUTWARD;
    options.leave_out = leave_out;
    gcv_region* out = nullptr;
    check(gcv_scene_free_region(scene_.get(), shapes_[shape].get(), nullptr, nullptr, &options,
                                &out));
    const Owned<gcv_region> region(out);
    std::size_t count = 0;
    check(gcv_region_vertices(out, nullptr, 0, &count));
    if (count == 0) {
      return std::nullopt;
    }
    Ring vertices(count);
    check(gcv_region_vertices(out, &vertices.data()->x, count, &count));
    return *std::min_element(vertices.begin(), vertices.end(), [](const Point& p, const Point& q) {
      return p.x < q.x || (p.x == q.x && p.y < q.y);
    });
  }

  [[nodiscard]] bool is_free(std::size_t shape, const Point& position) const {
    std::int8_t relation = 0;
    check(gcv_scene_relation(scene_.get(), shapes_[shape].get(), &position.x, 1, nullptr, nullptr,
                             &relation));
    return relation != GCV_OVERLAPPING;
  }

  [[nodiscard]] double depth(std::size_t shape, const Point& position) const {
    gcv_escape escape{};
    check(gcv_scene_penetration(scene_.get(), shapes_[shape].get(), &position.x, 1, nullptr,
                                nullptr, &escape));
    return escape.depth;
  }

  void add(std::size_t shape, const Point& position) {
    const gcv_polygon* const polygon = shapes_[shape].get();
    std::uint64_t id = 0;
    check(gcv_scene_add(scene_.get(), &polygon, &position.x, 1, &id));
  }

 private:
  Owned<gcv_scene> scene_;
  std::vector<Owned<gcv_polygon>> shapes_;
};

// Where no doubles are free at an exact fit, the next best without fits.
template <class Find>
class StripNester : public Nester {
 public:
  StripNester(const NestingJob& job, Find find) : strip_(job), find_(find) {}

  std::optional<Point> place(std::size_t shape) override {
    std::optional<Point> position = (strip_.*find_)(shape, 0);
    if (position && !strip_.is_free(shape, *position)) {
      position = (strip_.*find_)(shape, GCV_LEAVE_OUT_FITS);
    }
    if (position) {
      strip_.add(shape, *position);
    }
    return position;
  }

 private:
  Strip strip_;
  Find find_;
};

}  // namespace

std::unique_ptr<Nester> libgcv_best_nester(const NestingJob& job) {
  return std::make_unique<StripNester<decltype(&Strip::best)>>(job, &Strip::best);
}

std::unique_ptr<Nester> libgcv_region_nester(const NestingJob& job) {
  return std::make_unique<StripNester<decltype(&Strip::smallest_vertex)>>(job,
                                                                          &Strip::smallest_vertex);
}

Overlaps count_overlaps(const NestingJob& job, const std::vector<std::optional<Point>>& positions) {
  Strip strip(job);
  Overlaps overlaps;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (positions[k]) {
      if (!strip.is_free(job.order[k], *positions[k])) {
        ++overlaps.all;
        overlaps.deep += strip.depth(job.order[k], *positions[k]) > 1e-6 * job.height ? 1 : 0;
      }
      strip.add(job.order[k], *positions[k]);
    }
  }
  return overlaps;
}

}  // namespace gcv::bench
