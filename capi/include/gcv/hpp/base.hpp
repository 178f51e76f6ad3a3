/* Points, views, errors, options, and what the classes of gcv.hpp are made with.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_BASE_HPP
#define GCV_HPP_BASE_HPP

#include <gcv/gcv.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gcv {

/** The names have a namespace of their own, so that none is one of the library's inside. */
inline namespace hpp {

/** A point or a vector. */
struct Point {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(const Point& a, const Point& b) {
    return a.x == b.x && a.y == b.y;
  }
  friend constexpr bool operator!=(const Point& a, const Point& b) { return !(a == b); }
};
static_assert(sizeof(Point) == 2 * sizeof(double), "points are two doubles, as in gcv.h");

/** A call that failed. */
class Error : public std::runtime_error {
 public:
  Error(gcv_status status, const std::string& message)
      : std::runtime_error(message), status_(status) {}

  /** One of the GCV_ERR_ values, or one that a later version of the library adds. */
  [[nodiscard]] gcv_status status() const noexcept { return status_; }
  /** The name of the status, such as "GCV_ERR_NOT_SIMPLE". */
  [[nodiscard]] const char* status_name() const noexcept { return gcv_status_name(status_); }

 private:
  gcv_status status_;
};

namespace detail {

/** Throws for a null pointer, where the library would take it for nothing given. */
template <class T>
T* required(T* pointer, const char* name) {
  if (pointer == nullptr) {
    throw Error(GCV_ERR_NULL_ARGUMENT, std::string(name) + " is NULL");
  }
  return pointer;
}

/** The number of things; throws where there are not as many of others. */
inline std::size_t as_many(const char* name, std::size_t count, const char* others,
                           std::size_t other_count) {
  if (count != other_count) {
    throw Error(GCV_ERR_INVALID_ARGUMENT, std::string(name) + ": there are " +
                                              std::to_string(count) + ", for " +
                                              std::to_string(other_count) + " " + others);
  }
  return count;
}

/** Throws where the sizes of parts do not add up to the number of vertices. */
template <class Sizes>
void require_all(std::size_t vertices, const Sizes& sizes) {
  std::size_t left = vertices;
  bool are_enough = true;
  for (const std::size_t size : sizes) {
    are_enough = are_enough && size <= left;
    left -= are_enough ? size : 0;
  }
  if (!are_enough || left != 0) {
    throw Error(GCV_ERR_INVALID_ARGUMENT,
                "sizes: they do not add up to " + std::to_string(vertices) + " vertices");
  }
}

/** Pointers to elements that can be read as those of an array of T. Objects of a class derived from
 *  T cannot: the next one is further away. */
template <class Pointer, class T>
using IfElements =
    std::enable_if_t<std::is_pointer_v<Pointer> &&
                     std::is_convertible_v<std::remove_pointer_t<Pointer> (*)[], const T (*)[]>>;

}  // namespace detail

/** Elements of the caller's, which must stay while the view is used. */
template <class T>
class View {
 public:
  constexpr View() = default;
  /** A template, so that {0, 0} is a point and not a null pointer with its size. */
  template <class Pointer, class = detail::IfElements<Pointer, T>>
  constexpr View(Pointer data, std::size_t size)
      : data_(size == 0 ? data : detail::required(data, "the pointer of a view")), size_(size) {}
  View(std::initializer_list<T> list) : View(list.begin(), list.size()) {}

  /** Of a std::vector, a std::array, a std::span, and the like. */
  template <class Range,
            class = detail::IfElements<decltype(std::declval<const Range&>().data()), T>>
  constexpr View(const Range& range) : View(range.data(), range.size()) {}

  [[nodiscard]] constexpr const T* data() const { return data_; }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr const T* begin() const { return data_; }
  [[nodiscard]] constexpr const T* end() const { return data_ + size_; }

 private:
  const T* data_ = nullptr;
  std::size_t size_ = 0;
};

/** How exact coordinates become doubles. */
enum class Rounding : std::int32_t {
  nearest = GCV_ROUND_NEAREST,
  outward = GCV_ROUND_OUTWARD,
};

namespace detail {

/** Those of the enums here, whose values are numbers of gcv.h. */
template <class Enum>
inline constexpr bool is_of_gcv = false;
template <>
inline constexpr bool is_of_gcv<Rounding> = true;

template <class Enum>
using IfOfGcv = std::enable_if_t<is_of_gcv<Enum>>;

}  // namespace detail

/** All enums compare with the numbers in the structs of gcv.h, too. */
template <class Enum, class = detail::IfOfGcv<Enum>>
constexpr bool operator==(Enum a, std::int32_t b) {
  return static_cast<std::int32_t>(a) == b;
}
template <class Enum, class = detail::IfOfGcv<Enum>>
constexpr bool operator==(std::int32_t a, Enum b) {
  return a == static_cast<std::int32_t>(b);
}
template <class Enum, class = detail::IfOfGcv<Enum>>
constexpr bool operator!=(Enum a, std::int32_t b) {
  return static_cast<std::int32_t>(a) != b;
}
template <class Enum, class = detail::IfOfGcv<Enum>>
constexpr bool operator!=(std::int32_t a, Enum b) {
  return a != static_cast<std::int32_t>(b);
}

/** Options of a computation, as gcv_options has them. */
struct Options {
  Rounding rounding = Rounding::nearest;
  double tolerance = 0;
  /** 0 for as many as the machine runs at once. */
  std::int32_t threads = 1;
  /** Called with the steps done and an estimate of all; ends the computation by giving true. */
  std::function<bool(std::uint64_t done, std::uint64_t estimate)> progress = {};
  bool leave_out_holes = false;
  bool leave_out_fits = false;
};

namespace detail {

/** Throws the error of a call that failed. */
inline void check(gcv_status status) {
  if (status != GCV_OK) {
    throw Error(status, gcv_last_error_message());
  }
}

template <class T, void (*destroy)(T*)>
struct Deleter {
  void operator()(T* object) const noexcept { destroy(object); }
};

template <class T, void (*destroy)(T*)>
using Handle = std::unique_ptr<T, Deleter<T, destroy>>;

/** The object that a call makes, which has the place for its pointer as its last argument. */
template <class Owner, class... Parameters, class... Arguments>
Owner made(gcv_status (*function)(Parameters...), Arguments... arguments) {
  decltype(std::declval<Owner>().release()) out = nullptr;
  check(function(arguments..., &out));
  return Owner(out);
}

/** The value that a call gives. */
template <class T, class Object>
T value(gcv_status (*function)(const Object*, T*), const Object* object) {
  T out{};
  check(function(object, &out));
  return out;
}

/** The elements that a call with a buffer gives. */
template <class T, class Call>
std::vector<T> elements(const Call& call) {
  std::size_t required = 0;
  check(call(nullptr, 0, &required));
  std::vector<T> out(required);
  if (required != 0) {
    check(call(out.data(), out.size(), &required));
  }
  return out;
}

/** The text that a call with a buffer gives. */
template <class Call>
std::string text(const Call& call) {
  const std::vector<char> out = elements<char>(call);
  return out.data();
}

// Those of no points are not null, so that the library says what it lacks.
inline const double* doubles(const Point* points) {
  static const double none = 0;
  return points != nullptr ? reinterpret_cast<const double*>(points) : &none;
}
inline double* doubles(Point* points) { return reinterpret_cast<double*>(points); }

/** Options as the library takes them, during a call. */
class PassedOptions {
 public:
  explicit PassedOptions(const Options& options) : progress_(options.progress) {
    gcv_options_init_size(&options_, sizeof options_);
    options_.rounding = static_cast<std::int32_t>(options.rounding);
    options_.tolerance = options.tolerance;
    options_.threads = options.threads;
    if (options.leave_out_holes) {
      options_.leave_out |= GCV_LEAVE_OUT_HOLES;
    }
    if (options.leave_out_fits) {
      options_.leave_out |= GCV_LEAVE_OUT_FITS;
    }
    if (progress_) {
      options_.progress = report;
      options_.progress_context = this;
    }
  }
  PassedOptions(const PassedOptions&) = delete;
  PassedOptions& operator=(const PassedOptions&) = delete;

  [[nodiscard]] const gcv_options* get() const { return &options_; }

  /** Throws what the progress function has thrown, else the error of a call that failed. */
  void check(gcv_status status) const {
    if (thrown_) {
      std::rethrow_exception(thrown_);
    }
    detail::check(status);
  }

  /** The object that such a call makes. */
  template <class Owner, class Call>
  Owner made(const Call& call) const {
    decltype(std::declval<Owner>().release()) out = nullptr;
    check(call(&options_, &out));
    return Owner(out);
  }

 private:
  static std::int32_t report(void* context, std::uint64_t done, std::uint64_t estimate) {
    auto& self = *static_cast<PassedOptions*>(context);
    try {
      return self.progress_(done, estimate) ? 1 : 0;
    } catch (...) {
      self.thrown_ = std::current_exception();
      return 1;
    }
  }

  gcv_options options_;
  const std::function<bool(std::uint64_t, std::uint64_t)>& progress_;
  std::exception_ptr thrown_;
};

}  // namespace detail

/** The version of the library that is running, such as "0.2.0". */
inline std::string version() { return gcv_version_string(); }
/** The same as a number: major * 10000 + minor * 100 + patch. */
inline std::uint32_t version_number() { return gcv_version_number(); }

}  // namespace hpp
}  // namespace gcv

#endif
