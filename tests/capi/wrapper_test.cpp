/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The wrapper gcv.hpp: every class and function of it, errors, and what moves. As C++17 and C++20.
 */
#include <cmath>
#include <cstring>
#include <functional>
#include <gcv/gcv.hpp>
#include <limits>

#include "wrapper_check.hpp"

using gcv::Location;
using gcv::Options;
using gcv::Point;
using gcv::Polygon;
using gcv::Relation;
using gcv::Rounding;

static_assert(std::is_nothrow_move_constructible_v<Polygon>);
static_assert(!std::is_copy_constructible_v<Polygon>);
static_assert(std::is_nothrow_move_assignable_v<gcv::Region>);

static Polygon box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

static const char* const SHEET =
    "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 4 1, 4 4, 1 4), (5 3, 8 3, 8 5, 5 5))";

static void polygons() {
  const std::vector<Point> ring{{0, 0}, {4, 0}, {4, 3}};
  const double tight[] = {0, 0, 4, 0, 4, 3};
  const double spaced[] = {0, 0, 7, 4, 0, 7, 4, 3, 7};
  for (const Polygon& polygon :
       {Polygon(ring), Polygon{{0, 0}, {4, 0}, {4, 3}}, Polygon({{0, 0}, {4, 0}, {4, 3}}),
        Polygon(tight, 3), Polygon(spaced, 3, 3 * sizeof(double)),
        Polygon::of_wkt("POLYGON ((0 0, 4 0, 4 3, 0 0))"), Polygon::of_rings({ring}),
        Polygon(ring).affine({1, 0, 0, 0, 1, 0}), -(-Polygon(ring))}) {
    CHECK(polygon.vertices() == ring);
    CHECK(polygon.area() == 6);
    CHECK((polygon.bounds() == gcv::Box{0, 0, 4, 3}));
  }
  Point out[8];
  CHECK(Polygon(ring).vertices(out, 8) == 3 && out[2] == ring[2]);
  CHECK(Polygon(ring).translated({1, -1}).vertices()[0] == (Point{1, -1}));

  const std::vector<Point> rings{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {2, 1}, {2, 2}};
  const Polygon holed = Polygon::of_rings(rings, std::vector<std::size_t>{4, 3});
  CHECK(holed.ring_count() == 2 && holed.area() == 80.5);
  CHECK((holed.ring(1) == std::vector<Point>{{1, 1}, {2, 2}, {2, 1}}));
  CHECK(Polygon::disc({1, 1}, 2, 0.01, Rounding::outward).bounds()[0] <= -1);
  const auto simple = Polygon::disc({}, 1, 1e-4).simplified(0.1);
  CHECK(simple.error_bound <= 0.1 && simple.polygon.vertices().size() < 20);

  auto many = gcv::polygons(rings, std::vector<std::size_t>{4, 3});
  CHECK(std::move(many).value()[1].area() == 0.5);
  auto failing = gcv::polygons(rings, std::vector<std::size_t>{3, 2});
  CHECK(failing.statuses[0] == GCV_OK && failing.statuses[1] == GCV_ERR_DEGENERATE);
  CHECK(failing.results[0].area() == 40.5 && failing.results[1].get() == nullptr);
  CHECK_THROWS(GCV_ERR_DEGENERATE, "polygon 1: ", std::move(failing).value());
}

static void outer_faces() {
  const Polygon notched{{0, 0}, {8, 0}, {8, 6}, {3, 1}, {0, 7}};
  const Polygon triangle{{0, 0}, {1, 0}, {0, 1}};
  const gcv::OuterFace face = gcv::minkowski_sum(notched, triangle);
  CHECK(face.vertices().size() == face.exact_vertex_count());
  CHECK(face.exact_vertex(4) == "10/3 7/3");
  CHECK(face.edge_sources()[4].kind == GCV_EDGE_TRANSLATED && face.exact_indices()[4] == 4);
  CHECK(face.error_bound() > 0 && face.stats().walk_steps > 0);
  CHECK(face.wkt().substr(0, 14) == "POLYGON ((0 0," && face.polygon().area() == face.area());
  std::vector<Point> out(20);
  CHECK(face.vertices(out.data(), out.size()) == 7 && out[1] == face.vertices()[1]);
  CHECK_THROWS(GCV_ERR_BUFFER_TOO_SMALL, "", face.vertices(out.data(), 3));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", face.exact_vertex(99));
  CHECK(!gcv::superset(notched, triangle).empty());

  const Polygon square = box(0, 0, 1, 1);
  const std::string wkt = "POLYGON ((-2 -2, 1 -2, 1 1, -2 1, -2 -2))";
  CHECK(gcv::no_fit_polygon(square, box(0, 0, 2, 2)).wkt() == wkt);
  CHECK(gcv::no_fit_polygon(square, box(0, 0, 2, 2), {1, 0}).vertices()[0].x == -1);
  CHECK(gcv::entrance_block(box(0, 0, 2, 2), square, {0, 0}).wkt() == wkt);
}

static void regions() {
  const Polygon sheet = Polygon::of_wkt(SHEET);
  const Polygon peg = box(0, 0, 2, 2);
  const gcv::Region region = gcv::no_fit_region(sheet, peg);
  CHECK(region.fits_wkt() == "GEOMETRYCOLLECTION (LINESTRING (5 3, 6 3))");
  CHECK(region.wkt().substr(0, 14) == "MULTIPOLYGON (");
  CHECK(region.parts().size() == 3 && region.exact_parts()[2].kind == GCV_PART_SEGMENT);
  CHECK(region.vertices().size() == 10 && region.edge_sources().size() == 10);
  CHECK(region.exact_indices()[9] == 9 && region.exact_vertex(9) == "6/1 3/1");
  CHECK(region.edge_owners() == std::vector<std::uint64_t>(10));
  CHECK(region.area() == 120 && region.error_bound() == 0 && region.stats().parts_dropped == 0);
  CHECK(region.polygon(0).ring_count() == 2);
  Point out[16];
  CHECK(region.vertices(out, 16) == 10);
  CHECK(region.locate({5.5, 3}) == Location::boundary && region.locate({0, 0}) == Location::inside);
  CHECK((region.locate({{1.5, 1.5}, {7, 7}}) ==
         std::vector<Location>{Location::outside, Location::inside}));

  Options less;
  less.leave_out_holes = less.leave_out_fits = true;
  CHECK(gcv::no_fit_region(sheet, peg, {}, less).parts().size() == 1);
  CHECK(gcv::minkowski_sum_region(sheet, -peg).wkt() == region.wkt());
  CHECK(gcv::entrance_region(peg, sheet).wkt() == region.wkt());
  CHECK(gcv::inner_fit_region(box(0, 0, 5, 2), peg).vertices().size() == 2);
}

static void many() {
  std::vector<Polygon> fixed;
  fixed.push_back(box(0, 0, 1, 1));
  fixed.push_back(Polygon::of_wkt(SHEET));
  const Polygon peg = box(0, 0, 2, 2);
  const std::vector<const Polygon*> moving(2, &peg);
  const std::vector<std::reference_wrapper<const Polygon>> same(2, peg);
  const std::vector<Point> references{{0, 0}, {1, 0}};
  Options threads;
  threads.threads = 2;
  CHECK(gcv::minkowski_sum_many(fixed, moving, threads).results[1].wkt() ==
        gcv::minkowski_sum(fixed[1], peg).wkt());
  CHECK(gcv::no_fit_polygon_many(fixed, same, references).results[1].wkt() ==
        gcv::no_fit_polygon(fixed[1], peg, {1, 0}).wkt());
  CHECK(gcv::minkowski_sum_region_many(fixed, same).results[0].area() == 9);
  auto found = gcv::no_fit_region_many(fixed, moving, references, threads);
  CHECK(std::move(found).value()[1].wkt() == gcv::no_fit_region(fixed[1], peg, {1, 0}).wkt());
  auto failing = gcv::no_fit_polygon_many(fixed, moving, {{0, 0}, {0, NAN}});
  CHECK_THROWS(GCV_ERR_NOT_FINITE, "pair 1: ", std::move(failing).value());
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "2 and 1",
               gcv::no_fit_polygon_many(fixed, moving, {{0, 0}}));
}

static void offsets() {
  const Polygon square = box(0, 0, 4, 4);
  const gcv::Region grown = gcv::offset(square, 1, 0.01);
  CHECK(grown.area() > 32 + 3.14159 && grown.area() < 32 + 3.14159 + 0.3);
  CHECK(grown.locate({-0.7, -0.7}) == Location::inside && grown.vertices()[0].x <= -1);
  const gcv::Region shrunk = gcv::offset(square, -1, 0.01);
  CHECK(shrunk.vertices()[0].x >= 1 && shrunk.area() > 3.9 && shrunk.area() <= 4);
  CHECK(gcv::offset(square, -2, 0.01).parts().empty());
  for (const double bad : {0.0, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "distance: ", gcv::offset(square, bad, 0.01));
    CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "tolerance: ", gcv::offset(square, 1, bad));
  }
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT,
               "tolerance: ", gcv::offset(box(1e9, 0, 1e9 + 1, 1), 0.3, 1e-7));
}

static void two_polygons() {
  const Polygon square = box(0, 0, 1, 1);
  const std::vector<Point> places{{0, 0}, {1, 0}, {4, 5}};
  CHECK(gcv::relation(square, square) == Relation::overlapping);
  CHECK(gcv::relation(square, square, {0, 1}) == Relation::touching);
  CHECK((gcv::relation(square, square, places) ==
         std::vector<Relation>{Relation::overlapping, Relation::touching, Relation::apart}));
  CHECK(gcv::distance(square, square, {4, 5}).distance == 5);
  CHECK(gcv::distance(square, square, places)[2].nearest.kind == GCV_CONTACT_VERTEX_VERTEX);
  CHECK(gcv::penetration(square, square, {0.75, 0}).depth == 0.25);
  CHECK(gcv::penetration(square, square, places)[0].depth == 1);
  CHECK(gcv::cast(square, square, {5, 0}, {-8, 0}).time == 0.5);
  CHECK(gcv::cast(square, square, places, places).size() == 3);
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT,
               "motions: ", gcv::cast(square, square, places, gcv::View<Point>{}));
  const gcv::ContactList list = gcv::contacts(square, square, {1, 0});
  CHECK(list.contacts()[0].gap == 0 && list.previous()[0] == UINT64_MAX);
  CHECK(gcv::relation(square, square, gcv::View<Point>{}).empty());
  CHECK_THROWS(GCV_ERR_DEGENERATE, "0 distinct", gcv::Polygon(gcv::View<Point>{}));
}

static void scenes() {
  gcv::Scene scene;
  const Polygon square = box(0, 0, 1, 1);
  scene.set_container(box(0, 0, 4, 2));
  const gcv::Id first = scene.add(square);
  const std::vector<gcv::Id> others =
      scene.add(std::vector<const Polygon*>{&square, &square}, {{1, 0}, {3, 0}});
  CHECK(first == 2 && (scene.ids() == std::vector<gcv::Id>{2, 3, 4}));
  CHECK(scene.positions({4})[0] == (Point{3, 0}));
  CHECK(scene.polygon(others[0]).area() == 1);
  CHECK(scene.relation(square, {2, 0}) == Relation::touching);
  CHECK(scene.relation(square, {2, 0}, {0, {}}) == Relation::apart);
  CHECK(scene.distance(square, {2, 0}).distance == 0);
  CHECK(scene.distance(box(0, 0, 0.5, 0.5), {2.125, 0.75}).nearest.id_a == 3);
  CHECK(scene.penetration(square, {1.75, 0}).depth == 0.25);
  CHECK(scene.cast(square, {2, 1}, {0, -1}).hit == 0);
  CHECK(scene.best(square, {0, -1}) == std::optional<Point>(Point{2, 0}));
  CHECK(!scene.best(box(0, 0, 5, 5), {0, -1}));
  CHECK(scene.free_region(square).area() == 0);
  CHECK(scene.free_region(square, gcv::Box{0, 0, 3, 3}, {1, {2, 3, 4}}).area() == 3);
  CHECK(scene.near(square, {2, 0}, 0).pairs().size() == 3);
  const gcv::PairList pairs = scene.pairs(0);
  const gcv::ContactList contacts = scene.contacts(0);
  CHECK(scene.pairs(0, pairs).pairs().size() == pairs.pairs().size());
  CHECK(scene.contacts(0, 0, contacts).previous()[0] == 0);

  const gcv::Scene before = scene.copy();
  scene.move(4, {2, 0});
  scene.move({2, 3}, {{0, 1}, {1, 1}});
  scene.set_polygon(4, box(0, 0, 0.5, 0.5));
  scene.set_layers({2}, {0});
  scene.remove(3);
  scene.remove_container();
  CHECK(scene.ids().size() == 2 && before.ids().size() == 3);
  CHECK(scene.polygon(4).area() == 0.25 && before.polygon(4).area() == 1);
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.remove(3));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.free_region(square));
}

static void errors_and_moves() {
  CHECK_THROWS(GCV_ERR_NOT_SIMPLE, "edges 0 and 2", Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK_THROWS(GCV_ERR_PARSE, "byte", Polygon::of_wkt("POLYGON"));
  try {
    Polygon::of_rings({});
    CHECK(false);
  } catch (const std::exception& error) {
    CHECK(std::strcmp(dynamic_cast<const gcv::Error&>(error).status_name(),
                      "GCV_ERR_NULL_ARGUMENT") == 0 ||
          dynamic_cast<const gcv::Error&>(error).status() == GCV_ERR_DEGENERATE);
  }
  Polygon square = box(0, 0, 1, 1);
  Polygon moved = std::move(square);
  CHECK(moved.area() == 1);
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", square.area());
  square = Polygon(moved.release());
  CHECK(square.area() == 1 && moved.get() == nullptr);
  CHECK(gcv::version() == gcv_version_string());
}

static void progress() {
  const Polygon disc = Polygon::disc({}, 1, 1e-5);
  const Polygon saw = [] {
    std::vector<Point> ring{{0, -1}};
    for (int k = 0; k < 200; ++k) {
      ring.push_back({k + 0.5, 0.0});
      ring.push_back({k + 1.0, k == 199 ? -1.0 : 0.75});
    }
    return Polygon(ring);
  }();
  int calls = 0;
  Options options;
  options.progress = [&](std::uint64_t done, std::uint64_t estimate) {
    ++calls;
    CHECK(done <= estimate);
    return false;
  };
  CHECK(gcv::minkowski_sum(disc, saw, options).area() > 0 && calls >= 2);
  options.progress = [](std::uint64_t, std::uint64_t) { return true; };
  CHECK_THROWS(GCV_ERR_CANCELLED, "", gcv::minkowski_sum(disc, saw, options));
  CHECK_THROWS(GCV_ERR_CANCELLED, "", gcv::offset(saw, 1, 0.1, options));
  options.progress = [](std::uint64_t, std::uint64_t) -> bool { throw 7; };
  try {
    gcv::no_fit_region(saw, disc, {}, options);
    CHECK(false);
  } catch (const int thrown) {
    CHECK(thrown == 7);
  }
#if __cplusplus >= 202002L
  CHECK(gcv::minkowski_sum(disc, saw, {.rounding = Rounding::outward, .threads = 2}).area() > 0);
#endif
}

int main() {
  polygons();
  outer_faces();
  regions();
  many();
  offsets();
  two_polygons();
  scenes();
  errors_and_moves();
  progress();
  return check_failures != 0;
}
