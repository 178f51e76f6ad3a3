// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the fuzz targets share: bytes as numbers, and the end of the process as a verdict.
#pragma once

#include <gcv/gcv.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace gcv::fuzz {

// The bytes of an input, from first to last, and then zeros for ever.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  [[nodiscard]] bool empty() const { return left_ == 0; }

  template <class Number>
  Number take() {
    Number number{};
    const std::size_t size = std::min(left_, sizeof number);
    if (size > 0) {
      std::memcpy(&number, next_, size);
      next_ += size;
      left_ -= size;
    }
    return number;
  }

  // 0, ..., count - 1, from one byte.
  std::size_t below(std::size_t count) { return take<std::uint8_t>() % count; }

  template <class Number, std::size_t Count>
  Number one_of(const Number (&numbers)[Count]) {
    return numbers[below(Count)];
  }

 private:
  const std::uint8_t* next_;
  std::size_t left_;
};

// The case that is checked, as text, where the target says so. What is left of it when the process
// ends has not been printed.
inline std::string current_case;

[[noreturn]] inline void fail(const std::string& sentence) {
  std::fprintf(stderr, "%s%s\n  last error: \"%s\"\n", sentence.c_str(), current_case.c_str(),
               gcv_last_error_message());
  current_case.clear();
  std::abort();
}

inline void check(bool holds, const std::string& sentence) {
  if (!holds) {
    fail(sentence);
  }
}

inline bool contains(std::initializer_list<gcv_status> statuses, gcv_status status) {
  return std::find(statuses.begin(), statuses.end(), status) != statuses.end();
}

// Gives whether the call went well; else it gave one of the other documented statuses.
inline bool succeeds(const char* call, gcv_status status,
                     std::initializer_list<gcv_status> documented = {}) {
  if (status != GCV_OK && !contains(documented, status)) {
    fail(std::string(call) + " gave " + gcv_status_name(status));
  }
  return status == GCV_OK;
}

struct Destroy {
  void operator()(gcv_polygon* polygon) const { gcv_polygon_destroy(polygon); }
  void operator()(gcv_outer_face* face) const { gcv_outer_face_destroy(face); }
  void operator()(gcv_superset* superset) const { gcv_superset_destroy(superset); }
  void operator()(gcv_region* region) const { gcv_region_destroy(region); }
  void operator()(gcv_contact_list* list) const { gcv_contact_list_destroy(list); }
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
  void operator()(gcv_pair_list* list) const { gcv_pair_list_destroy(list); }
};

using Polygon = std::unique_ptr<gcv_polygon, Destroy>;
using OuterFace = std::unique_ptr<gcv_outer_face, Destroy>;
using ContactList = std::unique_ptr<gcv_contact_list, Destroy>;

}  // namespace gcv::fuzz
