// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> calls of all functions in any order, with hostile arguments: NULL, too small,
// unaligned, of unknown versions. Each status must be one that the arguments explain;
// nothing may be written beyond a buffer, nor anywhere on failure.
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz.hpp"

namespace {

using gcv::fuzz::check;
using gcv::fuzz::Input;

constexpr unsigned char untouched_byte = 0xa5;
constexpr std::size_t sentinels = 32;

using Bytes = std::vector<unsigned char>;
using Statuses = std::initializer_list<gcv_status>;

bool untouched(const Bytes& bytes, std::size_t from) {
  return std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(),
                     [](unsigned char byte) { return byte == untouched_byte; });
}

// What is wrong with the arguments of a call: each fault explains a status.
class Faults {
 public:
  // Gives its second argument.
  bool add_if(bool is_fault, gcv_status status) {
    if (is_fault) {
      statuses_.push_back(status);
    }
    return is_fault;
  }
  template <class Pointer>
  Pointer* pointer(Pointer* p) {
    add_if(p == nullptr, GCV_ERR_NULL_ARGUMENT);
    return p;
  }
  [[nodiscard]] bool none() const { return statuses_.empty(); }
  [[nodiscard]] bool explain(gcv_status status) const {
    return std::find(statuses_.begin(), statuses_.end(), status) != statuses_.end();
  }

 private:
  std::vector<gcv_status> statuses_;
};

std::int32_t any_rounding(Input& input) {
  return input.one_of<std::int32_t>({0, 1, 0, 1, 2, -1, INT32_MIN, INT32_MAX});
}
double any_tolerance(Input& input) {
  return input.one_of({0.0, 0.0, -0.0, 0.5, 1e-300, -1.0, std::nan(""), HUGE_VAL});
}
bool is_rounding(std::int32_t rounding) { return rounding == 0 || rounding == 1; }
bool is_tolerance(double tolerance) { return tolerance >= 0 && tolerance < HUGE_VAL; }

// Options of any size and with any values, in just as much memory; or NULL.
class Options {
 public:
  Options(Input& input, Faults& faults) {
    const std::size_t size =
        input.one_of<std::size_t>({16, 40, 40, 0, 4, 12, 15, 17, 24, 64, SIZE_MAX});
    if (size == SIZE_MAX) {
      return;
    }
    gcv_options options;
    gcv_options_init(&options);
    options.struct_size = static_cast<std::uint32_t>(size);
    options.rounding = any_rounding(input);
    options.tolerance = any_tolerance(input);
    options.threads = input.one_of<std::int32_t>({1, 1, 1, 0, 2, 3, -1, INT32_MIN});
    const auto unknown = static_cast<unsigned char>(input.below(2));
    bytes_.assign(std::max(size, sizeof options.struct_size), unknown);
    std::memcpy(bytes_.data(), &options, std::min(bytes_.size(), sizeof options));
    const bool is_first = size == 16;  // the size of the first version
    faults.add_if((!is_first && size < sizeof options) || (size > sizeof options && unknown != 0) ||
                      !is_rounding(options.rounding) || !is_tolerance(options.tolerance) ||
                      (!is_first && options.threads < 0),
                  GCV_ERR_INVALID_ARGUMENT);
  }

  [[nodiscard]] const gcv_options* get() const {
    return bytes_.empty() ? nullptr : reinterpret_cast<const gcv_options*>(bytes_.data());
  }

 private:
  Bytes bytes_;
};

class Session {
 public:
  Session(const std::uint8_t* data, std::size_t size) : input_(data, size) {}

  void run() {
    using Call = void (Session::*)();
    static constexpr Call calls[] = {&Session::create,        &Session::create_wkt,
                                     &Session::sum,           &Session::no_fit,
                                     &Session::entrance,      &Session::superset,
                                     &Session::face_polygon,  &Session::polygon_numbers,
                                     &Session::face_numbers,  &Session::polygon_vertices,
                                     &Session::face_vertices, &Session::exact_vertex,
                                     &Session::edge_sources,  &Session::wkt,
                                     &Session::edges,         &Session::stats,
                                     &Session::destroy,       &Session::constants,
                                     &Session::simplified,    &Session::create_rings,
                                     &Session::create_many,   &Session::disc,
                                     &Session::affine,        &Session::ring};
    for (int steps = 0; steps < 64 && !input_.empty(); ++steps) {
      (this->*input_.one_of(calls))();
    }
  }

 private:
  template <class Handle>
  using Slots = std::array<std::unique_ptr<Handle, gcv::fuzz::Destroy>, 3>;

  // --------------------------------------------------------------------- verdicts --

  // Gives whether the call went well.
  bool judge(const char* call, gcv_status status, const Faults& faults, Statuses others = {}) {
    const char* const message = gcv_last_error_message();
    check(faults.none() ? status == GCV_OK || gcv::fuzz::contains(others, status)
                        : faults.explain(status),
          std::string(call) + " gave " + gcv_status_name(status));
    check(status == GCV_OK ? message_ == message : *message != '\0' && std::strlen(message) < 512,
          std::string(call) + " gave a wrong message");
    message_ = message;
    return status == GCV_OK;
  }

  // call(&out) gives a new handle for a slot, or leaves `out` alone.
  template <class Handle, class Call>
  void make(const char* name, Slots<Handle>& slots, Faults& faults, Statuses others, Call call) {
    static Handle* const nothing = reinterpret_cast<Handle*>(&slots);
    auto& slot = slots[input_.below(slots.size())];
    Handle* out = nothing;
    const bool well =
        judge(name, call(faults.pointer(input_.below(16) == 0 ? nullptr : &out)), faults, others);
    check(well ? out != nothing && out != nullptr : out == nothing, "a handle or not?");
    if (well) {
      slot.reset(out);
    }
  }

  // call(out) writes `count` numbers to out, or none.
  template <class Number, class Call>
  void get(const char* name, std::size_t count, Faults& faults, Statuses others, Call call) {
    Bytes bytes(count * sizeof(Number) + sentinels, untouched_byte);
    auto* const out = reinterpret_cast<Number*>(bytes.data());
    const bool well =
        judge(name, call(faults.pointer(input_.below(8) == 0 ? nullptr : out)), faults, others);
    check(untouched(bytes, well ? count * sizeof(Number) : 0), "a getter writes where it must not");
  }

  // call(out, capacity, &required), with buffers of all kinds. Gives what was written.
  template <class Element, class Call>
  Bytes fill(const char* name, Faults faults, Call call) {
    std::size_t count = 0;
    if (faults.none()) {
      count = SIZE_MAX;
      judge(name, call(nullptr, std::size_t{0}, &count), faults);
      check(count < SIZE_MAX, std::string(name) + " does not say how many");
    }
    enum { none, null, too_small, exact, larger, nowhere };
    const std::size_t kind = input_.below(6);
    const std::size_t difference = 1 + input_.below(8);
    const std::size_t capacity = kind == none        ? 0
                                 : kind == too_small ? count - std::min(count, difference)
                                 : kind == exact     ? count
                                                     : count + difference;
    std::size_t required = 0;
    Bytes bytes(capacity * sizeof(Element) + sentinels, untouched_byte);
    auto* const out =
        kind == none || kind == null ? nullptr : reinterpret_cast<Element*>(bytes.data());
    faults.add_if(kind == null || kind == nowhere, GCV_ERR_NULL_ARGUMENT);
    const bool small = faults.add_if(capacity < count && out != nullptr, GCV_ERR_BUFFER_TOO_SMALL);
    const bool well =
        judge(name, call(out, capacity, kind == nowhere ? nullptr : &required), faults);
    check(!(well || small) || required == count, std::string(name) + " requires other sizes");
    const std::size_t written = well && out != nullptr ? count * sizeof(Element) : 0;
    check(untouched(bytes, written), std::string(name) + " writes where it must not");
    bytes.resize(written);
    return bytes;
  }

  template <class Element, class Call>
  void fill_text(const char* name, const Faults& faults, Call call) {
    const Bytes text = fill<Element>(name, faults, call);
    check(text.empty() || std::find(text.begin(), text.end(), '\0') == text.end() - 1,
          std::string(name) + " does not end in NUL");
  }

  // -------------------------------------------------------------------- arguments --

  template <class Handle>
  const Handle* pick(const Slots<Handle>& slots, Faults& faults) {
    return faults.pointer(slots[input_.below(slots.size())].get());
  }

  double number() {
    static constexpr double special[] = {
        HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN(),
        1e308,    -1.7e308,  5e-324,
        1e-308,   -0.0,      0.1,
        1e17,     1e-17,     3.5};
    const std::size_t k = input_.below(256);
    return k < std::size(special) ? special[k] : static_cast<double>(k % 16);
  }

  // --------------------------------------------------------------------- the calls --

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
        "POLYGON((0.1 0.2,0.7 0.1,1.3 0.4,0.9 0.6,1.1 1.7,0.6 0.7,0.2 1.1),(0 0,1 0,0 1))",
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

  void sum() {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    make("gcv_minkowski_sum", faces_, faults, {GCV_ERR_RANGE},
         [&](gcv_outer_face** out) { return gcv_minkowski_sum(a, b, options.get(), out); });
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

  template <class Function>
  void sum_with_reflected(const char* name, Function function) {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    const std::array<double, 2> point{number(), number()};
    const double* const given = faults.pointer(input_.below(16) == 0 ? nullptr : point.data());
    faults.add_if(!std::isfinite(point[0]) || !std::isfinite(point[1]), GCV_ERR_NOT_FINITE);
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

  template <class Number, class Handle>
  void number_of(const char* name, const Slots<Handle>& slots, std::size_t count, Statuses others,
                 gcv_status (*function)(const Handle*, Number*)) {
    Faults faults;
    const Handle* const handle = pick(slots, faults);
    get<Number>(name, count, faults, others, [&](Number* out) { return function(handle, out); });
  }

  void polygon_numbers() {
    number_of<std::size_t>("gcv_polygon_vertex_count", polygons_, 1, {}, gcv_polygon_vertex_count);
    number_of<double>("gcv_polygon_area", polygons_, 1, {GCV_ERR_RANGE}, gcv_polygon_area);
    number_of<double>("gcv_polygon_bounds", polygons_, 4, {}, gcv_polygon_bounds);
  }

  void face_numbers() {
    number_of<std::size_t>("gcv_outer_face_vertex_count", faces_, 1, {},
                           gcv_outer_face_vertex_count);
    number_of<std::size_t>("gcv_outer_face_exact_vertex_count", faces_, 1, {},
                           gcv_outer_face_exact_vertex_count);
    number_of<double>("gcv_outer_face_error_bound", faces_, 1, {}, gcv_outer_face_error_bound);
    number_of<double>("gcv_outer_face_area", faces_, 1, {GCV_ERR_RANGE}, gcv_outer_face_area);
  }

  struct Vertex {
    double x;
    double y;
  };

  void polygon_vertices() {
    Faults faults;
    const gcv_polygon* const polygon = pick(polygons_, faults);
    fill<Vertex>("gcv_polygon_vertices", faults,
                 [&](Vertex* out, std::size_t capacity, std::size_t* required) {
                   return gcv_polygon_vertices(polygon, reinterpret_cast<double*>(out), capacity,
                                               required);
                 });
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

  void stats() {
    Faults faults;
    const gcv_outer_face* const face = pick(faces_, faults);
    const auto size = input_.one_of<std::uint32_t>({sizeof(gcv_stats), 57, 64, 200, 0, 4, 55});
    faults.add_if(size < sizeof(gcv_stats), GCV_ERR_INVALID_ARGUMENT);
    Bytes bytes(std::max<std::size_t>(size, sizeof size) + sentinels, untouched_byte);
    std::memcpy(bytes.data(), &size, sizeof size);
    auto* const out = reinterpret_cast<gcv_stats*>(bytes.data());
    const bool well = judge(
        "gcv_outer_face_stats",
        gcv_outer_face_stats(face, faults.pointer(input_.below(8) == 0 ? nullptr : out)), faults);
    check(std::memcmp(bytes.data(), &size, sizeof size) == 0, "struct_size has changed");
    check(untouched(bytes, well ? size : sizeof size),
          "gcv_outer_face_stats writes where it must not");
  }

  void destroy() {
    polygons_[input_.below(polygons_.size())].reset();
    faces_[input_.below(faces_.size())].reset();
    supersets_[input_.below(supersets_.size())].reset();
    gcv_polygon_destroy(nullptr);
    gcv_outer_face_destroy(nullptr);
    gcv_superset_destroy(nullptr);
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

  Input input_;
  std::string message_ = gcv_last_error_message();
  Slots<gcv_polygon> polygons_;
  Slots<gcv_outer_face> faces_;
  Slots<gcv_superset> supersets_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Session(data, size).run();
  return 0;
}
