// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What calls of any function share: handles in slots, hostile arguments, and verdicts on what a
// call gave.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz.hpp"

namespace gcv::fuzz {

inline constexpr unsigned char untouched_byte = 0xa5;
inline constexpr std::size_t sentinels = 32;

using Bytes = std::vector<unsigned char>;
using Statuses = std::initializer_list<gcv_status>;

inline bool untouched(const Bytes& bytes, std::size_t from) {
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

inline std::int32_t any_rounding(Input& input) {
  return input.one_of<std::int32_t>({0, 1, 0, 1, 2, -1, INT32_MIN, INT32_MAX});
}
inline double any_tolerance(Input& input) {
  return input.one_of({0.0, 0.0, -0.0, 0.5, 1e-300, -1.0, std::nan(""), HUGE_VAL});
}
inline bool is_rounding(std::int32_t rounding) { return rounding == 0 || rounding == 1; }
inline bool is_tolerance(double tolerance) { return tolerance >= 0 && tolerance < HUGE_VAL; }

// Options of any size and with any values, in just as much memory; or NULL. Those of inner fits and
// of ways out are more restricted.
class Options {
 public:
  enum class Use { sum, inner_fit, escape };

  Options(Input& input, Faults& faults, Use use = Use::sum) {
    const std::size_t size =
        input.one_of<std::size_t>({16, 48, 48, 0, 4, 12, 15, 17, 24, 64, SIZE_MAX, 40, 39, 41, 47});
    if (size == SIZE_MAX) {
      return;
    }
    gcv_options options;
    gcv_options_init(&options);
    options.struct_size = static_cast<std::uint32_t>(size);
    options.rounding = any_rounding(input);
    options.tolerance = any_tolerance(input);
    options.threads = input.one_of<std::int32_t>({1, 1, 1, 0, 2, 3, -1, INT32_MIN});
    options.leave_out = input.one_of<std::uint64_t>({0, 0, 0, 1, 2, 3, 4, UINT64_MAX});
    const auto unknown = static_cast<unsigned char>(input.below(2));
    bytes_.assign(std::max(size, sizeof options.struct_size), unknown);
    std::memcpy(bytes_.data(), &options, std::min(bytes_.size(), sizeof options));
    const bool is_first = size == 16;  // the size of the first version
    const bool is_0_1 = size == 40;
    const std::uint64_t leave_out = is_first || is_0_1 ? 0 : options.leave_out;
    faults.add_if((!is_first && !is_0_1 && size < sizeof options) ||
                      (size > sizeof options && unknown != 0) || !is_rounding(options.rounding) ||
                      !is_tolerance(options.tolerance) || (!is_first && options.threads < 0) ||
                      leave_out > 3,
                  GCV_ERR_INVALID_ARGUMENT);
    faults.add_if((use != Use::sum && options.tolerance > 0) ||
                      (use == Use::inner_fit && (leave_out & 1) != 0),
                  GCV_ERR_INVALID_ARGUMENT);
  }

  [[nodiscard]] const gcv_options* get() const {
    return bytes_.empty() ? nullptr : reinterpret_cast<const gcv_options*>(bytes_.data());
  }

 private:
  Bytes bytes_;
};

class Caller {
 protected:
  Caller(const std::uint8_t* data, std::size_t size) : input_(data, size) {}

  template <class Handle>
  using Slots = std::array<std::unique_ptr<Handle, Destroy>, 3>;

  // --------------------------------------------------------------------- verdicts --

  // Gives whether the call went well.
  bool judge(const char* call, gcv_status status, const Faults& faults, Statuses others = {}) {
    const char* const message = gcv_last_error_message();
    check(faults.none() ? status == GCV_OK || contains(others, status) : faults.explain(status),
          std::string(call) + " gave " + gcv_status_name(status));
    check(status == GCV_OK ? message_ == message : *message != '\0' && std::strlen(message) < 512,
          std::string(call) + " gave a wrong message");
    message_ = message;
    return status == GCV_OK;
  }

  // call(&out) gives a new handle for a slot, or leaves `out` alone. Gives the handle, or NULL.
  template <class Handle, class Call>
  Handle* make(const char* name, Slots<Handle>& slots, Faults& faults, Statuses others, Call call) {
    static Handle* const nothing = reinterpret_cast<Handle*>(&slots);
    auto& slot = slots[input_.below(slots.size())];
    Handle* out = nothing;
    const bool well =
        judge(name, call(faults.pointer(input_.below(16) == 0 ? nullptr : &out)), faults, others);
    check(well ? out != nothing && out != nullptr : out == nothing, "a handle or not?");
    if (!well) {
      return nullptr;
    }
    slot.reset(out);
    return out;
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

  template <class Number, class Handle>
  void number_of(const char* name, const Slots<Handle>& slots, std::size_t count, Statuses others,
                 gcv_status (*function)(const Handle*, Number*)) {
    Faults faults;
    const Handle* const handle = pick(slots, faults);
    get<Number>(name, count, faults, others, [&](Number* out) { return function(handle, out); });
  }

  struct Vertex {
    double x;
    double y;
  };

  // A reference point, or NULL.
  const double* reference(std::array<double, 2>& point, Faults& faults) {
    point = {number(), number()};
    faults.add_if(!std::isfinite(point[0]) || !std::isfinite(point[1]), GCV_ERR_NOT_FINITE);
    return faults.pointer(input_.below(16) == 0 ? nullptr : point.data());
  }

  // Stats of any size.
  template <class Handle>
  void stats_of(const char* name, const Slots<Handle>& slots,
                gcv_status (*function)(const Handle*, gcv_stats*)) {
    Faults faults;
    const Handle* const handle = pick(slots, faults);
    const auto size =
        input_.one_of<std::uint32_t>({sizeof(gcv_stats), 57, 64, 200, 0, 4, 55, 56, 63});
    faults.add_if(size < 56, GCV_ERR_INVALID_ARGUMENT);  // the size in version 0.1
    Bytes bytes(std::max<std::size_t>(size, sizeof size) + sentinels, untouched_byte);
    std::memcpy(bytes.data(), &size, sizeof size);
    auto* const out = reinterpret_cast<gcv_stats*>(bytes.data());
    const bool well =
        judge(name, function(handle, faults.pointer(input_.below(8) == 0 ? nullptr : out)), faults);
    check(std::memcmp(bytes.data(), &size, sizeof size) == 0, "struct_size has changed");
    check(untouched(bytes, well ? size : sizeof size),
          std::string(name) + " writes where it must not");
  }

  Input input_;
  std::string message_ = gcv_last_error_message();
  Slots<gcv_polygon> polygons_;
  Slots<gcv_outer_face> faces_;
  Slots<gcv_superset> supersets_;
  Slots<gcv_region> regions_;
  Slots<gcv_contact_list> lists_;
};

}  // namespace gcv::fuzz
