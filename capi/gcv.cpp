// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The C interface: arguments are checked here, and all else is the core's.
#include "gcv/gcv.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "area.hpp"
#include "edge_sources.hpp"
#include "guard.hpp"
#include "lazy.hpp"
#include "minkowski_sum.hpp"
#include "parallel.hpp"
#include "polygon.hpp"
#include "simplification.hpp"
#include "task.hpp"
#include "wkt.hpp"

struct gcv_polygon {
  explicit gcv_polygon(std::shared_ptr<const gcv::Polygon> prepared)
      : polygon(std::move(prepared)) {}

  // Made for the first no-fit polygon that needs it, and kept.
  [[nodiscard]] std::shared_ptr<const gcv::Polygon> reflected() const {
    return reflected_.get(
        [this] { return std::make_shared<const gcv::Polygon>(gcv::reflected(*polygon)); });
  }

  const std::shared_ptr<const gcv::Polygon> polygon;

 private:
  gcv::Lazy<std::shared_ptr<const gcv::Polygon>> reflected_;
};

struct gcv_outer_face {
  gcv::OuterFace face;
};

struct gcv_superset {
  std::vector<gcv_superset_edge> edges;
};

namespace {

using gcv::Error;
using gcv::Point;
using gcv::PointVector;
using gcv::Status;
using gcv::capi::caught;
using gcv::capi::fill;
using gcv::capi::guarded;
using gcv::capi::require;

#define GCV_TEXT_OF(x) #x
#define GCV_TEXT(x) GCV_TEXT_OF(x)

gcv_polygon* new_polygon(PointVector boundary) {
  auto polygon =
      std::make_shared<const gcv::Polygon>(gcv::make_polygon(std::move(boundary), "polygon"));
  return new gcv_polygon(std::move(polygon));
}

PointVector read_vertices(const double* xy, std::size_t count, std::size_t stride) {
  constexpr std::size_t most = 0x7fffffff;
  if (count > most) {
    throw Error(Status::invalid_argument, "vertex_count is %zu, at most %zu is possible", count,
                most);
  }
  if (stride != 0 && stride < sizeof(Point)) {
    throw Error(Status::invalid_argument, "stride_bytes is %zu, neither 0 nor at least %zu", stride,
                sizeof(Point));
  }
  const std::size_t step = stride == 0 ? sizeof(Point) : stride;
  PointVector points(count);
  const char* next = reinterpret_cast<const char*>(xy);
  for (Point& point : points) {
    std::memcpy(&point, next, sizeof point);
    next += step;
  }
  return points;
}

void check_rounding(std::int32_t rounding, const char* where) {
  if (rounding != GCV_ROUND_NEAREST && rounding != GCV_ROUND_OUTWARD) {
    throw Error(Status::invalid_argument, "%srounding is %d, neither %d nor %d", where, rounding,
                static_cast<int>(GCV_ROUND_NEAREST), static_cast<int>(GCV_ROUND_OUTWARD));
  }
}

void check_tolerance(double tolerance, const char* where) {
  if (!(tolerance >= 0 && std::isfinite(tolerance))) {
    throw Error(Status::invalid_argument, "%stolerance is %g, not a finite number from 0 on", where,
                tolerance);
  }
}

// The options of version 0.1 as it was first: the least that a caller can have.
struct FirstOptions {
  std::uint32_t struct_size;
  std::int32_t rounding;
  double tolerance;
};

// The options that this version knows, from a struct of any version.
gcv_options read_options(const gcv_options* options) {
  gcv_options known = GCV_OPTIONS_INIT;
  if (options == nullptr) {
    return known;
  }
  const std::uint32_t size = options->struct_size;
  if (size != sizeof(FirstOptions) && size < sizeof(gcv_options)) {
    throw Error(Status::invalid_argument,
                "options: struct_size is %u, neither %zu nor at least %zu; initialise it with "
                "GCV_OPTIONS_INIT",
                size, sizeof(FirstOptions), sizeof(gcv_options));
  }
  const auto* const bytes = reinterpret_cast<const unsigned char*>(options);
  for (std::size_t k = sizeof(gcv_options); k < size; ++k) {
    if (bytes[k] != 0) {
      throw Error(Status::invalid_argument,
                  "options: byte %zu of %u is set, for an option that version " GCV_TEXT(
                      GCV_VERSION_MAJOR) "." GCV_TEXT(GCV_VERSION_MINOR) " does not know",
                  k, size);
    }
  }
  std::memcpy(&known, options, std::min<std::size_t>(size, sizeof known));
  check_rounding(known.rounding, "options: ");
  check_tolerance(known.tolerance, "options: ");
  if (known.threads < 0) {
    throw Error(Status::invalid_argument, "options: threads is %d, below 0", known.threads);
  }
  return known;
}

unsigned threads_of(const gcv_options& options) {
  constexpr std::int32_t most = 256;
  return options.threads == 0 ? gcv::available_threads()
                              : static_cast<unsigned>(std::min(options.threads, most));
}

gcv::Rounding rounding_of(const gcv_options& options) {
  return static_cast<gcv::Rounding>(options.rounding);
}

// A guess of the steps of a sum: edges walked and vertices rounded.
std::uint64_t estimated_steps(const gcv::Operand& a, const gcv::Operand& b) {
  return 2 * (std::uint64_t{a.polygon->size()} + b.polygon->size());
}

// The polygon within half of the tolerance, for the errors of both add up in the sum; or the
// polygon itself where that would not save a quarter of the vertices, and so no time.
gcv::Simplified simplified_for_sum(const std::shared_ptr<const gcv::Polygon>& polygon,
                                   const gcv_options& options) {
  return gcv::simplify(polygon, options.tolerance / 2, rounding_of(options),
                       3 * polygon->vertices.size() / 4);
}

gcv::Operand simplified(const gcv::Operand& operand, const gcv_options& options) {
  const gcv::Simplified near = simplified_for_sum(operand.polygon, options);
  return {near.polygon, operand.name, near.error_bound};
}

// The outer face of a + b + shift, reported from start to end.
gcv_outer_face* new_outer_face(const gcv::Operand& a, const gcv::Operand& b, const Point& shift,
                               const gcv_options& options) {
  gcv::Task task(threads_of(options), options.progress, options.progress_context,
                 estimated_steps(a, b));
  task.begin();
  const gcv::Operand near_a = simplified(a, options);
  task.advance(0);
  const gcv::Operand near_b = a.polygon == b.polygon
                                  ? gcv::Operand{near_a.polygon, b.name, near_a.error_bound}
                                  : simplified(b, options);
  std::unique_ptr<gcv_outer_face> face(
      new gcv_outer_face{gcv::minkowski_sum(near_a, near_b, shift, rounding_of(options), task)});
  task.finish();
  return face.release();
}

Point read_reference(const double reference[2], const char* name) {
  require(reference, name);
  const Point point{reference[0], reference[1]};
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    throw Error(Status::not_finite, "%s: the %s coordinate is %g, not a finite number", name,
                std::isfinite(point.x) ? "y" : "x", std::isfinite(point.x) ? point.y : point.x);
  }
  return {point.x + 0.0, point.y + 0.0};
}

// Writes `value` to *out, unless it is not finite.
void give_finite(double value, const char* what, double* out) {
  if (!std::isfinite(value)) {
    throw Error(Status::range, "%s is beyond the largest double", what);
  }
  *out = value;
}

void fill_points(const PointVector& points, double* xy, std::size_t capacity,
                 std::size_t* required) {
  fill(points.size(), "vertices", "xy", xy, capacity, required,
       [&](double* out) { std::memcpy(out, points.data(), points.size() * sizeof(Point)); });
}

void fill_text(const std::string& text, char* out, std::size_t capacity, std::size_t* required) {
  fill(text.size() + 1, "bytes", "text", out, capacity, required,
       [&](char* to) { std::memcpy(to, text.c_str(), text.size() + 1); });
}

gcv_edge_source public_source(const gcv::EdgeSource& source) {
  return {static_cast<std::int32_t>(source.kind), source.a, source.b};
}

gcv::Operand operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->polygon, name};
}

gcv::Operand reflected_operand(const gcv_polygon* polygon, const char* name) {
  return {polygon->reflected(), name};
}

// The pairs of gcv_minkowski_sum_many.
class Batch {
 public:
  Batch(const gcv_polygon* const* a, const gcv_polygon* const* b, std::size_t count,
        const gcv_options& options)
      : a_(a), b_(b), options_(options), faces_(count), statuses_(count), first_failed_(count) {}

  void run(gcv_outer_face** out, gcv_status* statuses) {
    gcv::Task task(1, options_.progress, options_.progress_context, estimate());
    task.begin();
    simplify_all(task);
    gcv::for_each_in_parallel(
        faces_.size(), threads_of(options_), [&](std::size_t k) { add(k, task); },
        [&] { task.watch(); });
    task.finish();
    if (first_failed_ < faces_.size()) {
      static_cast<void>(gcv::capi::record(failure_));
    }
    std::copy(statuses_.begin(), statuses_.end(), statuses);
    std::transform(faces_.begin(), faces_.end(), out,
                   [](std::unique_ptr<gcv_outer_face>& face) { return face.release(); });
  }

 private:
  [[nodiscard]] std::uint64_t estimate() const {
    std::uint64_t steps = 0;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      if (a_[k] != nullptr && b_[k] != nullptr) {
        steps += estimated_steps(operand(a_[k], "a"), operand(b_[k], "b"));
      }
    }
    return steps;
  }

  // A polygon of the pairs, simplified; or why it is not, which is for its pairs to say.
  struct Part {
    gcv::Simplified simplified;
    std::exception_ptr failure;
  };

  // Each polygon once, however many pairs it is in.
  void simplify_all(gcv::Task& task) {
    for (const gcv_polygon* const* const polygons : {a_, b_}) {
      for (std::size_t k = 0; k < faces_.size(); ++k) {
        if (polygons[k] != nullptr) {
          simplified_.try_emplace(polygons[k]);
        }
      }
    }
    std::vector<std::pair<const gcv_polygon* const, Part>*> all;
    all.reserve(simplified_.size());
    for (auto& entry : simplified_) {
      all.push_back(&entry);
    }
    gcv::for_each_in_parallel(all.size(), threads_of(options_), [&](std::size_t k) {
      task.advance(0);
      Part& part = all[k]->second;
      try {
        part.simplified = simplified_for_sum(all[k]->first->polygon, options_);
      } catch (...) {
        part.failure = std::current_exception();
      }
    });
  }

  [[nodiscard]] gcv::Operand simplified_operand(const gcv_polygon* polygon,
                                                const char* name) const {
    require(polygon, name);
    const Part& part = simplified_.find(polygon)->second;
    if (part.failure) {
      std::rethrow_exception(part.failure);
    }
    return {part.simplified.polygon, name, part.simplified.error_bound};
  }

  // Computes pair k. Throws Error: cancelled.
  void add(std::size_t k, gcv::Task& task) {
    task.advance(0);
    try {
      const gcv::Operand a = simplified_operand(a_[k], "a");
      const gcv::Operand b = simplified_operand(b_[k], "b");
      faces_[k] = std::make_unique<gcv_outer_face>(
          gcv_outer_face{gcv::minkowski_sum(a, b, {0, 0}, rounding_of(options_), task)});
    } catch (...) {
      const Error error = gcv::capi::current_error();
      if (error.status() == Status::cancelled) {
        throw;
      }
      fail(k, error);
    }
  }

  void fail(std::size_t k, const Error& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    statuses_[k] = static_cast<gcv_status>(error.status());
    if (k < first_failed_) {
      first_failed_ = k;
      failure_ = Error(error.status(), "pair %zu: %s", k, error.what());
    }
  }

  const gcv_polygon* const* a_;
  const gcv_polygon* const* b_;
  const gcv_options& options_;
  std::vector<std::unique_ptr<gcv_outer_face>> faces_;
  std::vector<gcv_status> statuses_;
  std::map<const gcv_polygon*, Part> simplified_;
  std::mutex mutex_;
  std::size_t first_failed_;
  Error failure_{Status::ok, "%s", ""};
};

// Sums of a handle's coordinates can overflow.
double finite_sum(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) {
    throw Error(Status::range,
                "superset: the sum of %g of a and %g of b is beyond the largest double", a, b);
  }
  return sum + 0.0;
}

}  // namespace

uint32_t gcv_version_number(void) {
  return GCV_VERSION_MAJOR * 10000 + GCV_VERSION_MINOR * 100 + GCV_VERSION_PATCH;
}

const char* gcv_version_string(void) {
  return GCV_TEXT(GCV_VERSION_MAJOR) "." GCV_TEXT(GCV_VERSION_MINOR) "." GCV_TEXT(
      GCV_VERSION_PATCH);
}

const char* gcv_status_name(gcv_status status) {
  switch (status) {
    case GCV_OK:
      return "GCV_OK";
    case GCV_ERR_NULL_ARGUMENT:
      return "GCV_ERR_NULL_ARGUMENT";
    case GCV_ERR_INVALID_ARGUMENT:
      return "GCV_ERR_INVALID_ARGUMENT";
    case GCV_ERR_NOT_FINITE:
      return "GCV_ERR_NOT_FINITE";
    case GCV_ERR_DEGENERATE:
      return "GCV_ERR_DEGENERATE";
    case GCV_ERR_NOT_SIMPLE:
      return "GCV_ERR_NOT_SIMPLE";
    case GCV_ERR_BUFFER_TOO_SMALL:
      return "GCV_ERR_BUFFER_TOO_SMALL";
    case GCV_ERR_RANGE:
      return "GCV_ERR_RANGE";
    case GCV_ERR_PARSE:
      return "GCV_ERR_PARSE";
    case GCV_ERR_NO_MEMORY:
      return "GCV_ERR_NO_MEMORY";
    case GCV_ERR_CANCELLED:
      return "GCV_ERR_CANCELLED";
    case GCV_ERR_INTERNAL:
      return "GCV_ERR_INTERNAL";
    default:
      return "GCV_ERR_UNKNOWN";
  }
}

const char* gcv_last_error_message(void) { return gcv::capi::last_message(); }

gcv_status gcv_polygon_create(const double* xy, size_t vertex_count, size_t stride_bytes,
                              gcv_polygon** out) {
  return guarded([&] {
    require(xy, "xy");
    require(out, "out");
    *out = new_polygon(read_vertices(xy, vertex_count, stride_bytes));
  });
}

gcv_status gcv_polygon_create_wkt(const char* text, size_t length, gcv_polygon** out) {
  return guarded([&] {
    require(text, "text");
    require(out, "out");
    *out = new_polygon(gcv::parse_polygon(std::string_view(text, length), "polygon"));
  });
}

void gcv_polygon_destroy(gcv_polygon* polygon) { delete polygon; }

gcv_status gcv_polygon_vertex_count(const gcv_polygon* polygon, size_t* out) {
  return caught([&] {
    require(polygon, "polygon");
    require(out, "out");
    *out = polygon->polygon->vertices.size();
  });
}

gcv_status gcv_polygon_vertices(const gcv_polygon* polygon, double* xy, size_t capacity,
                                size_t* required) {
  return caught([&] {
    require(polygon, "polygon");
    fill_points(polygon->polygon->vertices, xy, capacity, required);
  });
}

gcv_status gcv_polygon_area(const gcv_polygon* polygon, double* out) {
  return guarded([&] {
    require(polygon, "polygon");
    require(out, "out");
    give_finite(gcv::ring_area(polygon->polygon->vertices), "the area of the polygon", out);
  });
}

gcv_status gcv_polygon_bounds(const gcv_polygon* polygon, double out[4]) {
  return caught([&] {
    require(polygon, "polygon");
    require(out, "out");
    const gcv::Box& box = polygon->polygon->bounds;
    out[0] = box.x0;
    out[1] = box.y0;
    out[2] = box.x1;
    out[3] = box.y1;
  });
}

gcv_status gcv_polygon_simplified(const gcv_polygon* polygon, double tolerance, int32_t rounding,
                                  gcv_polygon** out, double* error_bound) {
  return guarded([&] {
    require(polygon, "polygon");
    require(out, "out");
    require(error_bound, "error_bound");
    check_tolerance(tolerance, "");
    check_rounding(rounding, "");
    gcv::Simplified near =
        gcv::simplify(polygon->polygon, tolerance, static_cast<gcv::Rounding>(rounding),
                      polygon->polygon->vertices.size() - 1);
    *out = new gcv_polygon(std::move(near.polygon));
    *error_bound = near.error_bound;
  });
}

void gcv_options_init(gcv_options* options) {
  if (options != nullptr) {
    *options = GCV_OPTIONS_INIT;
  }
}

gcv_status gcv_minkowski_sum(const gcv_polygon* a, const gcv_polygon* b, const gcv_options* options,
                             gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    *out = new_outer_face(operand(a, "a"), operand(b, "b"), {0, 0}, known);
  });
}

gcv_status gcv_no_fit_polygon(const gcv_polygon* fixed, const gcv_polygon* moving,
                              const double reference[2], const gcv_options* options,
                              gcv_outer_face** out) {
  return guarded([&] {
    require(fixed, "fixed");
    require(moving, "moving");
    require(out, "out");
    const gcv_options known = read_options(options);
    const Point shift = read_reference(reference, "reference");
    *out =
        new_outer_face(operand(fixed, "fixed"), reflected_operand(moving, "moving"), shift, known);
  });
}

gcv_status gcv_entrance_block(const gcv_polygon* a, const gcv_polygon* b, const double a0[2],
                              const gcv_options* options, gcv_outer_face** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    const gcv_options known = read_options(options);
    const Point shift = read_reference(a0, "a0");
    *out = new_outer_face(reflected_operand(a, "a"), operand(b, "b"), shift, known);
  });
}

gcv_status gcv_minkowski_sum_many(const gcv_polygon* const* a, const gcv_polygon* const* b,
                                  size_t count, const gcv_options* options, gcv_outer_face** out,
                                  gcv_status* statuses) {
  return guarded([&] {
    if (count == 0) {
      return;
    }
    require(a, "a");
    require(b, "b");
    require(out, "out");
    require(statuses, "statuses");
    Batch(a, b, count, read_options(options)).run(out, statuses);
  });
}

void gcv_outer_face_destroy(gcv_outer_face* face) { delete face; }

gcv_status gcv_outer_face_vertex_count(const gcv_outer_face* face, size_t* out) {
  return caught([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.rounded.vertices.size();
  });
}

gcv_status gcv_outer_face_vertices(const gcv_outer_face* face, double* xy, size_t capacity,
                                   size_t* required) {
  return caught([&] {
    require(face, "face");
    fill_points(face->face.rounded.vertices, xy, capacity, required);
  });
}

gcv_status gcv_outer_face_exact_vertex_count(const gcv_outer_face* face, size_t* out) {
  return caught([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.exact.size();
  });
}

gcv_status gcv_outer_face_exact_vertex(const gcv_outer_face* face, size_t index, char* text,
                                       size_t capacity, size_t* required) {
  return guarded([&] {
    require(face, "face");
    if (index >= face->face.exact.size()) {
      throw Error(Status::invalid_argument, "index is %zu, the exact ring has %zu vertices", index,
                  face->face.exact.size());
    }
    fill_text(gcv::exact_vertex(face->face.exact, index), text, capacity, required);
  });
}

gcv_status gcv_outer_face_edge_sources(const gcv_outer_face* face, gcv_edge_source* out,
                                       size_t capacity, size_t* required) {
  return guarded([&] {
    require(face, "face");
    fill(face->face.exact.size(), "edges", "out", out, capacity, required,
         [&](gcv_edge_source* to) {
           const std::vector<gcv::EdgeSource> sources = gcv::edge_sources(face->face.exact);
           std::transform(sources.begin(), sources.end(), to, public_source);
         });
  });
}

gcv_status gcv_outer_face_error_bound(const gcv_outer_face* face, double* out) {
  return caught([&] {
    require(face, "face");
    require(out, "out");
    *out = face->face.rounded.error_bound;
  });
}

gcv_status gcv_outer_face_area(const gcv_outer_face* face, double* out) {
  return guarded([&] {
    require(face, "face");
    require(out, "out");
    give_finite(gcv::ring_area(face->face.rounded.vertices), "the area of the outer face", out);
  });
}

gcv_status gcv_outer_face_wkt(const gcv_outer_face* face, char* text, size_t capacity,
                              size_t* required) {
  return guarded([&] {
    require(face, "face");
    fill_text(gcv::format_polygon(face->face.rounded.vertices), text, capacity, required);
  });
}

gcv_status gcv_outer_face_polygon(const gcv_outer_face* face, gcv_polygon** out) {
  return guarded([&] {
    require(face, "face");
    require(out, "out");
    *out = new_polygon(face->face.rounded.vertices);
  });
}

gcv_status gcv_outer_face_stats(const gcv_outer_face* face, gcv_stats* out) {
  return caught([&] {
    require(face, "face");
    require(out, "out");
    const std::uint32_t size = out->struct_size;
    if (size < sizeof(gcv_stats)) {
      throw Error(Status::invalid_argument, "stats: struct_size is %u, less than %zu", size,
                  sizeof(gcv_stats));
    }
    const gcv::Counts& counts = face->face.counts;
    const gcv_stats stats{size,
                          counts.walk_steps,
                          counts.candidate_edges,
                          counts.predicates.filtered,
                          counts.predicates.fixed_width,
                          counts.predicates.rational,
                          face->face.rounded.vertices_repaired};
    std::memset(out, 0, size);
    std::memcpy(out, &stats, sizeof stats);
  });
}

gcv_status gcv_superset_create(const gcv_polygon* a, const gcv_polygon* b, gcv_superset** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(out, "out");
    auto superset = std::make_unique<gcv_superset>();
    for (const gcv::SupersetEdge& edge : gcv::superset(*a->polygon, *b->polygon)) {
      superset->edges.push_back({finite_sum(edge.from.a.x, edge.from.b.x),
                                 finite_sum(edge.from.a.y, edge.from.b.y),
                                 finite_sum(edge.to.a.x, edge.to.b.x),
                                 finite_sum(edge.to.a.y, edge.to.b.y), public_source(edge.source)});
    }
    *out = superset.release();
  });
}

void gcv_superset_destroy(gcv_superset* superset) { delete superset; }

gcv_status gcv_superset_edges(const gcv_superset* superset, gcv_superset_edge* out, size_t capacity,
                              size_t* required) {
  return guarded([&] {
    require(superset, "superset");
    fill(superset->edges.size(), "edges", "out", out, capacity, required,
         [&](gcv_superset_edge* to) {
           std::copy(superset->edges.begin(), superset->edges.end(), to);
         });
  });
}
