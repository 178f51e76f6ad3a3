// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> calls of all functions in any order, with hostile arguments: NULL, too small,
// unaligned, of unknown versions. Each status must be one that the arguments explain;
// nothing may be written beyond a buffer, nor anywhere on failure.
#include <array>
#include <cmath>
#include <vector>

#include "scene_question_calls.hpp"

namespace {

using gcv::fuzz::any_rounding;
using gcv::fuzz::any_tolerance;
using gcv::fuzz::Bytes;
using gcv::fuzz::check;
using gcv::fuzz::Faults;
using gcv::fuzz::is_rounding;
using gcv::fuzz::is_tolerance;
using gcv::fuzz::Options;
using gcv::fuzz::untouched;
using gcv::fuzz::untouched_byte;

class Session : private gcv::fuzz::SceneQuestionCalls {
 public:
  Session(const std::uint8_t* data, std::size_t size) : SceneQuestionCalls(data, size) {}

  void run() {
    using Call = void (Session::*)();
    static constexpr Call calls[] = {&Session::create,
                                     &Session::create_wkt,
                                     &Session::sum,
                                     &Session::no_fit,
                                     &Session::entrance,
                                     &Session::superset,
                                     &Session::face_polygon,
                                     &Session::polygon_numbers,
                                     &Session::face_numbers,
                                     &Session::polygon_vertices,
                                     &Session::face_vertices,
                                     &Session::exact_vertex,
                                     &Session::edge_sources,
                                     &Session::wkt,
                                     &Session::edges,
                                     &Session::stats,
                                     &Session::destroy,
                                     &Session::constants,
                                     &Session::simplified,
                                     &Session::create_rings,
                                     &Session::create_many,
                                     &Session::disc,
                                     &Session::affine,
                                     &Session::ring,
                                     &Session::sum_region,
                                     &Session::no_fit_region,
                                     &Session::entrance_region,
                                     &Session::inner_fit_region,
                                     &Session::region_many,
                                     &Session::region_numbers,
                                     &Session::region_lists,
                                     &Session::region_texts,
                                     &Session::region_polygon,
                                     &Session::locate,
                                     &Session::region_stats,
                                     &Session::exact_indices,
                                     &Session::relation,
                                     &Session::distance,
                                     &Session::cast,
                                     &Session::penetration,
                                     &Session::contacts,
                                     &Session::listed_contacts,
                                     &Session::listed_indices,
                                     &Session::destroy_contacts,
                                     &Session::scene_create,
                                     &Session::scene_copy,
                                     &Session::scene_set_container,
                                     &Session::scene_add,
                                     &Session::scene_set,
                                     &Session::scene_set_layers,
                                     &Session::scene_remove,
                                     &Session::scene_ids,
                                     &Session::scene_positions,
                                     &Session::scene_polygon,
                                     &Session::scene_destroy,
                                     &Session::scene_relation,
                                     &Session::scene_distance,
                                     &Session::scene_cast,
                                     &Session::scene_penetration,
                                     &Session::scene_near,
                                     &Session::scene_pairs,
                                     &Session::scene_contacts,
                                     &Session::listed_pairs,
                                     &Session::scene_listed_contacts,
                                     &Session::scene_listed_indices,
                                     &Session::scene_free_region,
                                     &Session::scene_best,
                                     &Session::destroy_lists};
    for (int steps = 0; steps < 64 && !input_.empty(); ++steps) {
      (this->*input_.one_of(calls))();
    }
  }

 private:
  void sum() {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    make("gcv_minkowski_sum", faces_, faults, {GCV_ERR_RANGE},
         [&](gcv_outer_face** out) { return gcv_minkowski_sum(a, b, options.get(), out); });
  }

  template <class Function>
  void sum_with_reflected(const char* name, Function function) {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    std::array<double, 2> point{};
    const double* const given = reference(point, faults);
    make(name, faces_, faults, {GCV_ERR_RANGE},
         [&](gcv_outer_face** out) { return function(a, b, given, options.get(), out); });
  }

  void no_fit() { sum_with_reflected("gcv_no_fit_polygon", gcv_no_fit_polygon); }
  void entrance() { sum_with_reflected("gcv_entrance_block", gcv_entrance_block); }

  void superset() {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    make("gcv_superset_create", supersets_, faults, {GCV_ERR_RANGE},
         [&](gcv_superset** out) { return gcv_superset_create(a, b, out); });
  }

  void face_polygon() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    make("gcv_outer_face_polygon", polygons_, faults, {},
         [&](gcv_polygon** out) { return gcv_outer_face_polygon(face, out); });
  }

  void face_numbers() {
    number_of<std::size_t>("gcv_outer_face_vertex_count", faces_, 1, {},
                           gcv_outer_face_vertex_count);
    number_of<std::size_t>("gcv_outer_face_exact_vertex_count", faces_, 1, {},
                           gcv_outer_face_exact_vertex_count);
    number_of<double>("gcv_outer_face_error_bound", faces_, 1, {}, gcv_outer_face_error_bound);
    number_of<double>("gcv_outer_face_area", faces_, 1, {GCV_ERR_RANGE}, gcv_outer_face_area);
  }

  void face_vertices() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    fill<Vertex>("gcv_outer_face_vertices", faults,
                 [&](Vertex* out, std::size_t capacity, std::size_t* required) {
                   return gcv_outer_face_vertices(face, reinterpret_cast<double*>(out), capacity,
                                                  required);
                 });
  }

  void exact_vertex() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    std::size_t count = 0;
    if (face != nullptr) {
      judge("gcv_outer_face_exact_vertex_count", gcv_outer_face_exact_vertex_count(face, &count),
            faults);
    }
    const auto index = input_.one_of<std::size_t>({0, 1, 2, count - 1, count, SIZE_MAX});
    faults.add_if(face != nullptr && index >= count, GCV_ERR_INVALID_ARGUMENT);
    fill_text<char>("gcv_outer_face_exact_vertex", faults,
                    [&](char* out, std::size_t capacity, std::size_t* required) {
                      return gcv_outer_face_exact_vertex(face, index, out, capacity, required);
                    });
  }

  void edge_sources() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    fill<gcv_edge_source>("gcv_outer_face_edge_sources", faults,
                          [&](gcv_edge_source* out, std::size_t capacity, std::size_t* required) {
                            return gcv_outer_face_edge_sources(face, out, capacity, required);
                          });
  }

  void wkt() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    fill_text<char>("gcv_outer_face_wkt", faults,
                    [&](char* out, std::size_t capacity, std::size_t* required) {
                      return gcv_outer_face_wkt(face, out, capacity, required);
                    });
  }

  void edges() {
    Faults faults;
    const gcv_superset* const superset = pick(supersets_, faults);
    fill<gcv_superset_edge>(
        "gcv_superset_edges", faults,
        [&](gcv_superset_edge* out, std::size_t capacity, std::size_t* required) {
          return gcv_superset_edges(superset, out, capacity, required);
        });
  }

  void exact_indices() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    fill<std::uint64_t>("gcv_outer_face_exact_indices", faults,
                        [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
                          return gcv_outer_face_exact_indices(face, out, capacity, required);
                        });
  }

  void stats() { stats_of("gcv_outer_face_stats", faces_, gcv_outer_face_stats); }

  void destroy() {
    polygons_[input_.below(polygons_.size())].reset();
    faces_[input_.below(faces_.size())].reset();
    supersets_[input_.below(supersets_.size())].reset();
    regions_[input_.below(regions_.size())].reset();
    gcv_polygon_destroy(nullptr);
    gcv_outer_face_destroy(nullptr);
    gcv_superset_destroy(nullptr);
    gcv_region_destroy(nullptr);
  }

  void constants() {
    const auto status = input_.take<gcv_status>();
    check(std::strncmp(gcv_status_name(status), "GCV_", 4) == 0, "a status without a name");
    check(gcv_version_number() / 10000 == GCV_VERSION_MAJOR, "a wrong version");
    check(std::strchr(gcv_version_string(), '.') != nullptr, "a wrong version");
    gcv_options_init(nullptr);
    Bytes bytes(100, untouched_byte);
    const std::size_t size = static_cast<std::size_t>(status) % bytes.size();
    gcv_options_init_size(reinterpret_cast<gcv_options*>(bytes.data()),
                          static_cast<std::uint32_t>(size));
    check(untouched(bytes, size < 16 ? 0 : size), "gcv_options_init_size writes elsewhere");
  }
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Session(data, size).run();
  return 0;
}
