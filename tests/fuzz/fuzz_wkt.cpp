// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Text -> gcv_polygon_create_wkt. What it accepts is what C reads from the text, goes round
// trip, and can be added to itself.
#include <cmath>
#include <vector>

#include "fuzz.hpp"

namespace {

using gcv::fuzz::check;
using gcv::fuzz::succeeds;
using Handle = gcv::fuzz::Polygon;

// Sums of more vertices than these take longer than a fuzzer should wait.
constexpr std::size_t most_vertices = 40;

// The vertices of rings, one ring after the other.
struct Rings {
  std::vector<double> xy;
  std::vector<std::size_t> sizes;

  friend bool operator==(const Rings&, const Rings&) = default;
};

Rings rings_of(const gcv_polygon* polygon) {
  Rings rings;
  std::size_t ring_count = 0;
  succeeds("gcv_polygon_ring_count", gcv_polygon_ring_count(polygon, &ring_count));
  for (std::size_t ring = 0; ring < ring_count; ++ring) {
    std::size_t count = 0;
    succeeds("gcv_polygon_ring", gcv_polygon_ring(polygon, ring, nullptr, 0, &count));
    const std::size_t begin = rings.xy.size();
    rings.xy.resize(begin + 2 * count);
    succeeds("gcv_polygon_ring",
             gcv_polygon_ring(polygon, ring, rings.xy.data() + begin, count, &count));
    rings.sizes.push_back(count);
  }
  return rings;
}

Handle polygon_of(const Rings& rings, gcv_status* status) {
  gcv_polygon* out = nullptr;
  *status =
      gcv_polygon_create_rings(rings.xy.data(), rings.sizes.data(), rings.sizes.size(), 0, &out);
  return Handle(out);
}

// The numbers of a text that is known to be a polygon.
Rings numbers_as_in_c(const std::string& text) {
  constexpr const char* space = " \t\n\v\f\r";
  Rings rings;
  const char* next = std::strchr(text.c_str(), '(');
  do {
    next = std::strchr(next + 1, '(');
    std::size_t count = 0;
    do {
      char* end = nullptr;
      rings.xy.push_back(std::strtod(next + 1, &end));
      rings.xy.push_back(std::strtod(end, &end));
      next = end + std::strspn(end, space);
      ++count;
    } while (*next == ',');
    rings.sizes.push_back(count);
    next += 1 + std::strspn(next + 1, space);
  } while (*next == ',');
  return rings;
}

bool is_empty(const std::string& text) { return text.find('(') == std::string::npos; }

// The same numbers as the text, in doubles, give the same status and the same polygon.
void check_numbers(const std::string& text, gcv_status status, const gcv_polygon* polygon) {
  gcv_status same = GCV_OK;
  const Handle out = polygon_of(numbers_as_in_c(text), &same);
  check(same == status, "the numbers of the text give another status");
  check(out == nullptr || rings_of(out.get()) == rings_of(polygon),
        "other numbers than in the text");
}

void check_numbers_of_polygon(const gcv_polygon* polygon, const std::vector<double>& xy) {
  double bounds[4] = {0, 0, 0, 0};
  double area = -1;
  succeeds("gcv_polygon_bounds", gcv_polygon_bounds(polygon, bounds));
  check(bounds[0] == xy[0] && bounds[1] <= xy[1] && bounds[1] < bounds[3] && bounds[0] < bounds[2],
        "the bounds are not those of the vertices");
  if (succeeds("gcv_polygon_area", gcv_polygon_area(polygon, &area), {GCV_ERR_RANGE})) {
    check(area >= 0 && std::isfinite(area), "the area is not an area");
  }
}

void check_round_trip(const gcv_polygon* polygon, const Rings& rings) {
  gcv_status status = GCV_OK;
  const Handle again = polygon_of(rings, &status);
  succeeds("gcv_polygon_create_rings", status);
  check(rings_of(again.get()) == rings, "the vertices do not go round trip");
  double area = 0;
  double same = 0;
  check(gcv_polygon_area(polygon, &area) == gcv_polygon_area(again.get(), &same) && area == same,
        "the area does not go round trip");
}

void check_sum(const gcv_polygon* polygon, const std::vector<double>& xy) {
  double size = 0;
  for (const double x : xy) {
    size = std::max(size, std::abs(x));
  }
  const bool may_overflow = size > 4e307;
  gcv_outer_face* sum = nullptr;
  const bool exists =
      succeeds("gcv_minkowski_sum", gcv_minkowski_sum(polygon, polygon, nullptr, &sum),
               {may_overflow ? GCV_ERR_RANGE : GCV_OK});
  if (!exists) {
    return;
  }
  const gcv::fuzz::OuterFace owner(sum);
  std::size_t length = 0;
  succeeds("gcv_outer_face_wkt", gcv_outer_face_wkt(sum, nullptr, 0, &length));
  std::string text(length, ' ');
  succeeds("gcv_outer_face_wkt", gcv_outer_face_wkt(sum, text.data(), length, &length));
  gcv_polygon* read = nullptr;
  succeeds("reading the sum back", gcv_polygon_create_wkt(text.data(), length - 1, &read));
  const Handle read_owner(read);
  gcv_polygon* given = nullptr;
  succeeds("gcv_outer_face_polygon", gcv_outer_face_polygon(sum, &given));
  const Handle given_owner(given);
  check(rings_of(read) == rings_of(given), "the text of the sum is not the sum");
}

// The place in the text that the message names.
std::size_t offset(std::size_t size) {
  const char* const byte = std::strstr(gcv_last_error_message(), "byte ");
  check(byte != nullptr, "the message names no byte");
  const std::size_t at = std::strtoull(byte + std::strlen("byte "), nullptr, 10);
  check(at <= size, "the message names a byte behind the text");
  return at;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char nothing = '\0';
  gcv_polygon* polygon = nullptr;
  const gcv_status status = gcv_polygon_create_wkt(
      size == 0 ? &nothing : reinterpret_cast<const char*>(data), size, &polygon);
  const Handle owner(polygon);
  succeeds("gcv_polygon_create_wkt", status,
           {GCV_ERR_PARSE, GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE});
  check((status == GCV_OK) == (polygon != nullptr), "a polygon or not?");
  const std::string text(data, data + size);
  if (status == GCV_ERR_PARSE) {
    offset(size);
  } else if (status == GCV_ERR_NOT_FINITE) {
    check(!std::isfinite(std::strtod(text.c_str() + offset(size), nullptr)), "a finite number");
  } else if (!is_empty(text)) {
    check_numbers(text, status, polygon);
  }
  if (status == GCV_OK) {
    const Rings rings = rings_of(polygon);
    check_numbers_of_polygon(polygon, rings.xy);
    check_round_trip(polygon, rings);
    if (rings.xy.size() <= 2 * most_vertices) {
      check_sum(polygon, rings.xy);
    }
  }
  return 0;
}
