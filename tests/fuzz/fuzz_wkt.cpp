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

std::vector<double> vertices(const gcv_polygon* polygon) {
  std::size_t count = 0;
  succeeds("gcv_polygon_vertices", gcv_polygon_vertices(polygon, nullptr, 0, &count));
  std::vector<double> xy(2 * count);
  succeeds("gcv_polygon_vertices", gcv_polygon_vertices(polygon, xy.data(), count, &count));
  return xy;
}

// The numbers of the outer ring of a text that is known to be a polygon.
std::vector<double> numbers_as_in_c(const std::string& text) {
  std::vector<double> numbers;
  const char* next = std::strchr(std::strchr(text.c_str(), '(') + 1, '(');
  do {
    char* end = nullptr;
    numbers.push_back(std::strtod(next + 1, &end));
    numbers.push_back(std::strtod(end, &end));
    next = end + std::strspn(end, " \t\n\v\f\r");
  } while (*next == ',');
  return numbers;
}

bool is_empty(const std::string& text) { return text.find('(') == std::string::npos; }

// The same numbers as the text, in doubles, give the same status and the same polygon.
void check_numbers(const std::string& text, gcv_status status, const gcv_polygon* polygon) {
  const std::vector<double> numbers = numbers_as_in_c(text);
  gcv_polygon* out = nullptr;
  const gcv_status same = gcv_polygon_create(numbers.data(), numbers.size() / 2, 0, &out);
  const Handle owner(out);
  check(same == status, "the numbers of the text give another status");
  check(out == nullptr || vertices(out) == vertices(polygon), "other numbers than in the text");
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

void check_round_trip(const gcv_polygon* polygon, const std::vector<double>& xy) {
  gcv_polygon* out = nullptr;
  succeeds("gcv_polygon_create", gcv_polygon_create(xy.data(), xy.size() / 2, 0, &out));
  const Handle again(out);
  check(vertices(out) == xy, "the vertices do not go round trip");
  double area = 0;
  double same = 0;
  check(gcv_polygon_area(polygon, &area) == gcv_polygon_area(out, &same) && area == same,
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
  check(vertices(read) == vertices(given), "the text of the sum is not the sum");
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
    const std::vector<double> xy = vertices(polygon);
    check_numbers_of_polygon(polygon, xy);
    check_round_trip(polygon, xy);
    if (xy.size() <= 2 * most_vertices) {
      check_sum(polygon, xy);
    }
  }
  return 0;
}
