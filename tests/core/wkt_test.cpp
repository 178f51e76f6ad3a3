// SPDX-License-Identifier: LGPL-3.0-or-later
#include "wkt.hpp"

#include <gtest/gtest.h>

#include "error.hpp"
#include "numbers.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

const Ring triangle{{0, 0}, {4, 0}, {0, 3}};

Status status_of(std::string_view text) {
  try {
    parse_polygon(text, "polygon");
    return Status::ok;
  } catch (const Error& error) {
    return error.status();
  }
}

std::string message_of(std::string_view text) {
  try {
    parse_polygon(text, "polygon");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Wkt, Accepts) {
  EXPECT_EQ(parse_polygon("POLYGON((0 0,4 0,0 3))", "").front(), triangle);
  EXPECT_EQ(parse_polygon(" polygon\n( ( 0 0 , 4\t0 , 0 3 ) ) \r\n", "").front(), triangle);
  EXPECT_EQ(parse_polygon("Polygon ((0e5 -0, +4.0 0., .0 30E-1), (1 1, 2 1, 1 2))", "").front(),
            triangle);
}

TEST(Wkt, ReadsNumbersAtTheEdges) {
  EXPECT_EQ(parse_polygon("POLYGON((1e-400 0.0000001e-330, 1 0, 0 1))", "").front().front(),
            (Point{0, 0}));
  EXPECT_EQ(parse_polygon("POLYGON((5e-324 1.7976931348623157e308, 1 0, 0 1))", "").front().front(),
            (Point{5e-324, 1.7976931348623157e308}));
  EXPECT_EQ(status_of("POLYGON((1e309 0, 1 0, 0 1))"), Status::not_finite);
  EXPECT_EQ(status_of("POLYGON((0.00001e400 0, 1 0, 0 1))"), Status::not_finite);
  EXPECT_EQ(status_of("POLYGON((1000000e-99999999999999999999 0, 1 0, 0 1))"), Status::ok);
  EXPECT_EQ(status_of("POLYGON((1e99999999999999999999 0, 1 0, 0 1))"), Status::not_finite);
  EXPECT_EQ(status_of("POLYGON((nan 0, 1 0, 0 1))"), Status::not_finite);
  EXPECT_EQ(status_of("POLYGON((-inf 0, 1 0, 0 1))"), Status::not_finite);
}

TEST(Wkt, Refuses) {
  for (const char* text :
       {"", "POLYGON", "POLYGON (", "POLYGON ()", "POLYGON (())", "POLYGON ((0 0, 1 0, 0 1)",
        "POLYGON ((0 0, 1 0, 0 1)) x", "POLYGON ((0, 1 0, 0 1))", "POLYGON ((0 0 0, 1 0, 0 1))",
        "POLYGON ((0 0; 1 0; 0 1))", "POINT (1 1)", "POLYGON ((0x1 0, 1 0, 0 1))",
        "POLYGON ((+-1 0, 1 0, 0 1))", "POLYGON ((0 0, 1 0, 0 1), (0 0, 1 1))",
        "POLYGON ((0 0, 1 0, 0 1), (2 2, 3 3, 2 2))", "POLYGON ((1,5 0, 1 0, 0 1))"}) {
    EXPECT_EQ(status_of(text), Status::parse) << text;
  }
  EXPECT_EQ(status_of(" polygon empty "), Status::degenerate);
  EXPECT_EQ(message_of("POLYGON ((0 0, 1 z))"), "polygon: byte 17: expected a number, found 'z'");
  EXPECT_EQ(message_of("POINT (1 2)"), "polygon: byte 0: expected POLYGON, found 'POINT'");
  EXPECT_EQ(message_of("POLYGON ((0 0, 1 "),
            "polygon: byte 17: expected a number, but the text ends");
}

TEST(Wkt, RoundTrips) {
  Random random(3);
  for (int k = 0; k < 5000; ++k) {
    Ring ring;
    for (int i = 0; i < 4; ++i) {
      ring.push_back({test::attacking_double(random), test::attacking_double(random)});
    }
    Ring closed = ring;
    closed.push_back(ring.front());
    ASSERT_EQ(parse_polygon(format_polygon(ring), "").front(), closed);
  }
}

}  // namespace
}  // namespace gcv
