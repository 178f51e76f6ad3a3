/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The wrapper gcv.hpp: every class and function of it, errors, and what moves. As C++17 and C++20.
 */
#include <gcv/gcvx.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <gcv/gcv.hpp>
#include <limits>
#include <optional>

#include "wrapper_check.hpp"

using gcv::ContactKind;
using gcv::EdgeKind;
using gcv::Location;
using gcv::Options;
using gcv::PartKind;
using gcv::Point;
using gcv::Polygon;
using gcv::Relation;
using gcv::Rounding;
using gcv::View;

static_assert(std::is_nothrow_move_constructible_v<Polygon>);
static_assert(!std::is_copy_constructible_v<Polygon>);
static_assert(std::is_nothrow_move_assignable_v<gcv::Region>);

/* Points that are larger: they are not one behind the other as points are. */
struct Node : Point {
  int id = 0;
};
static_assert(std::is_constructible_v<View<Point>, Point*, std::size_t>);
static_assert(std::is_constructible_v<View<Point>, const Point*, std::size_t>);
static_assert(!std::is_constructible_v<View<Point>, Node*, std::size_t>);
static_assert(!std::is_constructible_v<View<Point>, double*, std::size_t>);
static_assert(!std::is_constructible_v<View<Point>, void*, std::size_t>);
static_assert(std::is_convertible_v<std::vector<Point>, View<Point>>);
static_assert(std::is_convertible_v<std::array<Point, 3>, View<Point>>);
static_assert(std::is_convertible_v<std::vector<Polygon*>, View<const Polygon*>>);
static_assert(!std::is_convertible_v<std::vector<Node>, View<Point>>);
static_assert(!std::is_convertible_v<std::array<Node, 3>, View<Point>>);
static_assert(!std::is_constructible_v<Polygon, std::vector<Node>>);

/* Can vertices be written to objects of such a class? */
template <class Shape, class Out, class = void>
constexpr bool writes = false;
template <class Shape, class Out>
constexpr bool writes<
    Shape, Out,
    std::void_t<decltype(std::declval<Shape>().vertices(std::declval<Out*>(), std::size_t{}))>> =
    true;
static_assert(writes<Polygon, Point> && !writes<Polygon, Node>);
static_assert(writes<gcv::OuterFace, Point> && !writes<gcv::OuterFace, Node>);
static_assert(writes<gcv::Region, Point> && !writes<gcv::Region, Node>);

/* The enums of gcv.hpp and the numbers of gcv.h. */
static_assert(Rounding::outward == GCV_ROUND_OUTWARD && Rounding::outward != GCV_ROUND_NEAREST);
static_assert(GCV_INSIDE == Location::inside && GCV_BOUNDARY == Location::boundary);
static_assert(GCV_OUTSIDE == Location::outside && GCV_OUTSIDE != Location::inside);
static_assert(GCV_PART_OUTER == PartKind::outer && GCV_PART_HOLE == PartKind::hole);
static_assert(GCV_PART_SEGMENT == PartKind::segment && GCV_PART_POINT == PartKind::point);
static_assert(GCV_EDGE_TRANSLATED == EdgeKind::translated && GCV_EDGE_CORNER == EdgeKind::corner);
static_assert(GCV_EDGE_TRANSLATED_CORNER == EdgeKind::translated_corner);
static_assert(GCV_APART == Relation::apart && GCV_TOUCHING == Relation::touching);
static_assert(GCV_OVERLAPPING == Relation::overlapping);
static_assert(GCV_CONTACT_EDGE_VERTEX == ContactKind::edge_vertex);
static_assert(GCV_CONTACT_VERTEX_EDGE == ContactKind::vertex_edge);
static_assert(GCV_CONTACT_VERTEX_VERTEX == ContactKind::vertex_vertex);

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
  CHECK(Polygon(ring).vertex_count() == 3 && Polygon(ring).vertices(nullptr, 0) == 3);
  CHECK(Polygon(ring).translated({1, -1}).vertices()[0] == (Point{1, -1}));

  const std::vector<Point> rings{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {2, 1}, {2, 2}};
  const Polygon holed = Polygon::of_rings(rings, std::vector<std::size_t>{4, 3});
  CHECK(holed.ring_count() == 2 && holed.area() == 80.5);
  CHECK((holed.ring(1) == std::vector<Point>{{1, 1}, {2, 2}, {2, 1}}));
  CHECK(Polygon::disc({1, 1}, 2, 0.01, Rounding::outward).bounds()[0] <= -1);
  const auto simple = Polygon::disc({}, 1, 1e-4).simplified(0.1);
  CHECK(simple.error_bound <= 0.1 && simple.polygon.vertices().size() < 20);

  auto many = gcv::polygons(rings, std::vector<std::size_t>{4, 3});
  CHECK(many.value()[1].area() == 0.5 && std::move(many).value()[0].area() > 0);
  auto failing = gcv::polygons(View<Point>(rings.data(), 5), std::vector<std::size_t>{3, 2});
  CHECK(failing.statuses[0] == GCV_OK && failing.statuses[1] == GCV_ERR_DEGENERATE);
  CHECK(failing.results[0].area() == 40.5 && failing.results[1].get() == nullptr);
  CHECK_THROWS(GCV_ERR_DEGENERATE, "polygon 1: ", std::move(failing).value());

  for (const std::vector<std::size_t>& sizes :
       {std::vector<std::size_t>{4, 2}, {4, 4}, {7, SIZE_MAX}, {SIZE_MAX, 8}}) {
    CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "do not add up to 7", Polygon::of_rings(rings, sizes));
    CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "do not add up to 7", gcv::polygons(rings, sizes));
  }
}

static void outer_faces() {
  const Polygon notched{{0, 0}, {8, 0}, {8, 6}, {3, 1}, {0, 7}};
  const Polygon triangle{{0, 0}, {1, 0}, {0, 1}};
  const gcv::OuterFace face = gcv::minkowski_sum(notched, triangle);
  CHECK(face.vertices().size() == face.exact_vertex_count());
  CHECK(face.exact_vertex(4) == "10/3 7/3");
  CHECK(face.edge_sources()[4].kind == EdgeKind::translated && face.exact_indices()[4] == 4);
  CHECK(face.vertex_count() == face.vertices().size());
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
  CHECK(region.parts().size() == 3 && region.exact_parts()[2].kind == PartKind::segment);
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
  CHECK(found.value()[1].wkt() == gcv::no_fit_region(fixed[1], peg, {1, 0}).wkt());
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
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "tolerance: -1e-09 is not", gcv::offset(square, 1, -1e-9));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "tolerance: -0.30000000000000004 is not",
               gcv::offset(square, 1, -0.1 - 0.2));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "distance: 0 is not", gcv::offset(square, 0, 1));
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
  CHECK(gcv::distance(square, square, places)[2].nearest.kind == ContactKind::vertex_vertex);
  CHECK(gcv::distance(square, square, places)[2].relation == Relation::apart);
  CHECK(gcv::penetration(square, square, {0.75, 0}).depth == 0.25);
  CHECK(gcv::penetration(square, square, places)[0].depth == 1);
  CHECK(gcv::penetration(square, square, places)[0].relation != Relation::overlapping);
  CHECK(gcv::cast(square, square, {5, 0}, {-8, 0}).time == 0.5);
  CHECK(Relation::touching == gcv::cast(square, square, {5, 0}, {-8, 0}).relation);
  CHECK(gcv::cast(square, square, places, places).size() == 3);
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "motions: there are 0, for 3 translations",
               gcv::cast(square, square, places, View<Point>{}));
  const gcv::ContactList list = gcv::contacts(square, square, {1, 0});
  CHECK(list.contacts()[0].gap == 0 && list.previous()[0] == UINT64_MAX);
}

/* Of nothing, all calls say what they lack, or give nothing. */
static void views_of_nothing() {
  const View<Point> points;
  const View<std::size_t> sizes;
  const View<gcv::Id> ids;
  const std::vector<const Polygon*> polygons;
  const Polygon square = box(0, 0, 1, 1);
  CHECK_THROWS(GCV_ERR_DEGENERATE, "0 distinct", Polygon(points));
  CHECK_THROWS(GCV_ERR_DEGENERATE, "ring_count is 0", Polygon::of_rings({}));
  CHECK_THROWS(GCV_ERR_DEGENERATE, "ring_count is 0", Polygon::of_rings(points, sizes));
  CHECK_THROWS(GCV_ERR_DEGENERATE, "0 distinct", Polygon::of_rings({points}));
  CHECK_THROWS(GCV_ERR_PARSE, "byte 0", Polygon::of_wkt({}));
  CHECK(gcv::polygons(points, sizes).value().empty());
  CHECK_THROWS(GCV_ERR_DEGENERATE, "0 distinct",
               gcv::polygons(points, std::vector<std::size_t>{0}).value());
  CHECK(gcv::minkowski_sum_many(polygons, polygons).value().empty());
  CHECK(gcv::no_fit_polygon_many(polygons, polygons, points).value().empty());
  CHECK(gcv::minkowski_sum_region_many(polygons, polygons).value().empty());
  CHECK(gcv::no_fit_region_many(polygons, polygons, points).value().empty());
  CHECK(gcv::minkowski_sum_region(square, square).locate(points).empty());
  CHECK(gcv::relation(square, square, points).empty());
  CHECK(gcv::distance(square, square, points).empty());
  CHECK(gcv::penetration(square, square, points).empty());
  CHECK(gcv::cast(square, square, points, points).empty());

  gcv::Scene scene;
  scene.set_container(box(0, 0, 4, 2));
  CHECK(scene.add(polygons, points).empty());
  scene.move(ids, points);
  scene.set_polygons(ids, polygons);
  scene.set(ids, polygons, points);
  scene.set_layers(ids, View<std::uint32_t>{});
  scene.remove(ids);
  CHECK(scene.ids().empty() && scene.positions(ids).empty());
  CHECK(scene.relation(square, points).empty() && scene.distance(square, points).empty());
  CHECK(scene.penetration(square, points).empty() && scene.cast(square, points, points).empty());
  CHECK(scene.near(square, {1, 0.5}, 0).pairs().empty() && scene.pairs(1).pairs().empty());
  CHECK(scene.contacts(1).contacts().empty() && scene.contacts(1).previous().empty());

  const Point* const no_points = nullptr;
  CHECK(View<Point>(no_points, 0).size() == 0);
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "view is NULL", View<Point>(no_points, 3));
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
  CHECK(scene.contacts(0, 0, {}, {}).previous()[0] == UINT64_MAX);
  CHECK(scene.contacts(0, 0, {}, {1, {1, 3}}).contacts().empty());
  CHECK(scene.pairs(0, {}, {1, {1, 3}}).pairs().empty());
  CHECK(pairs.pairs()[0].relation == Relation::touching);
  gcv::ContactList last;
  for (int step = 0; step < 2; ++step) {
    last = scene.contacts(0, 0, last);
    CHECK(last.previous()[0] == (step == 0 ? UINT64_MAX : 0));
  }

  const gcv::Scene before = scene.copy();
  scene.move(4, {2, 0});
  scene.move({2, 3}, {{0, 1}, {1, 1}});
  scene.set_polygon(4, box(0, 0, 0.5, 0.5));
  scene.set_layers({2}, {0});
  CHECK(scene.position(4) == (Point{2, 0}));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "positions: there are 1, for 2 ids",
               scene.move({2, 3}, {{0, 1}}));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "layers: there are 1, for 2 ids",
               scene.set_layers({2, 3}, {0}));
  scene.remove(3);
  scene.remove_container();
  CHECK(scene.ids().size() == 2 && before.ids().size() == 3);
  CHECK(scene.polygon(4).area() == 0.25 && before.polygon(4).area() == 1);
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.remove(3));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.free_region(square));
}

static void members_set() {
  const Polygon square = box(0, 0, 1, 1);
  const Polygon wide = box(0, 0, 2, 1);
  const std::vector<std::reference_wrapper<const Polygon>> polygons{wide, square};
  gcv::Scene scene;
  const std::vector<gcv::Id> ids =
      scene.add(std::vector<const Polygon*>{&square, &square}, {{0, 0}, {5, 0}});
  scene.set(ids, polygons, {{1, 1}, {6, 1}});
  CHECK((scene.positions(ids) == std::vector<Point>{{1, 1}, {6, 1}}));
  CHECK(scene.polygon(ids[0]).area() == 2 && scene.polygon(ids[1]).area() == 1);
  scene.set_polygons({ids[1], ids[0]}, polygons);
  CHECK((scene.positions(ids) == std::vector<Point>{{1, 1}, {6, 1}}));
  CHECK(scene.polygon(ids[0]).area() == 1 && scene.polygon(ids[1]).area() == 2);
  scene.set(ids[1], square, {9, 0});
  CHECK(scene.position(ids[1]) == (Point{9, 0}) && scene.polygon(ids[1]).area() == 1);

  /* All or nothing. */
  Polygon empty;
  const std::vector<const Polygon*> one_empty{&wide, &empty};
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.set({ids[0], 99}, polygons, {{0, 0}, {0, 0}}));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "", scene.set_polygons({ids[0], ids[0]}, polygons));
  CHECK_THROWS(GCV_ERR_NOT_FINITE, "", scene.set(ids, polygons, {{0, 0}, {NAN, 0}}));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "number 1", scene.set_polygons(ids, one_empty));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.set(ids[0], empty, {0, 0}));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "polygons: there are 2, for 1 ids",
               scene.set_polygons(
                   {
                       ids[0],
                   },
                   polygons));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "positions: there are 1, for 2 ids",
               scene.set(ids, polygons, {{0, 0}}));
  CHECK_THROWS(GCV_ERR_INVALID_ARGUMENT, "positions: there are 1, for 2 polygons",
               scene.add(polygons, {{0, 0}}));
  CHECK((scene.positions(ids) == std::vector<Point>{{1, 1}, {9, 0}}));
  CHECK(scene.polygon(ids[0]).area() == 1 && scene.polygon(ids[1]).area() == 1);
}

/* An empty polygon is not taken for none. */
static void empty_objects() {
  struct Body {
    Polygon polygon;
    gcv::OuterFace face;
    gcv::Region region;
    gcv::PairList pairs;
    gcv::ContactList contacts;
  };
  const Body body = {};
  const Polygon square = box(0, 0, 1, 1);
  gcv::Scene scene;
  Polygon frame = box(0, 0, 4, 2);
  scene.set_container(frame);
  scene.add(square, {1, 0});
  const Polygon moved_frame = std::move(frame);

  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "container is NULL", scene.set_container(frame));
  CHECK(scene.relation(square, {3.5, 0}) == Relation::overlapping);
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", body.polygon.vertices());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", body.face.vertices());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", body.region.locate({0, 0}));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", body.pairs.pairs());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", body.contacts.contacts());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", gcv::minkowski_sum(square, frame));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", gcv::offset(frame, 1, 0.1));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", gcv::superset(frame, square));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", gcv::relation(square, frame, View<Point>{}));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", gcv::contacts(frame, square));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "pair 1",
               gcv::minkowski_sum_many(std::vector<const Polygon*>{&square, &frame},
                                       std::vector<const Polygon*>{&square, &square})
                   .value());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.add(frame));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.set_polygon(2, frame));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.free_region(frame));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.best(frame, {1, 0}));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.relation(frame, View<Point>{}));
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", scene.near(frame, {0, 0}, 0));
  const gcv::Scene moved_scene = std::move(scene);
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "scene is NULL", scene.ids());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "scene is NULL", scene.remove_container());
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "scene is NULL", scene.move(View<gcv::Id>{}, {}));
}

/* The conveniences for C, which a program in C++ may use too. */
static void conveniences() {
  const Polygon square = box(0, 0, 1, 1);
  gcv::Scene scene;
  scene.add(std::vector<const Polygon*>{&square, &square}, {{0, 0}, {1, 0}});
  const gcv::ContactList list = scene.contacts(0);
  gcv_contact* contacts = nullptr;
  std::uint64_t* numbers = nullptr;
  gcv_pair* pairs = nullptr;
  std::size_t count = 0;
  CHECK(gcvx_contact_list_contacts(list.get(), &contacts, &count) == GCV_OK);
  CHECK(count == list.contacts().size() && contacts[0].id_b == 3);
  CHECK(gcvx_contact_list_previous(list.get(), &numbers, &count) == GCV_OK);
  CHECK(count == list.contacts().size() && numbers[0] == UINT64_MAX);
  std::free(numbers);
  CHECK(gcvx_pair_list_pairs(scene.pairs(0).get(), &pairs, &count) == GCV_OK);
  CHECK(count == 1 && pairs[0].a == 2 && pairs[0].b == 3);
  CHECK(gcvx_scene_ids(scene.get(), &numbers, &count) == GCV_OK);
  CHECK(count == 2 && numbers[1] == 3);
  std::free(numbers);
  std::free(pairs);
  std::free(contacts);
}

static void errors_and_moves() {
  CHECK_THROWS(GCV_ERR_NOT_SIMPLE, "edges 0 and 2", Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK_THROWS(GCV_ERR_PARSE, "byte", Polygon::of_wkt("POLYGON"));
  try {
    Polygon::of_rings({});
    CHECK(false);
  } catch (const std::exception& error) {
    CHECK(std::strcmp(dynamic_cast<const gcv::Error&>(error).status_name(), "GCV_ERR_DEGENERATE") ==
          0);
  }
  Polygon square = box(0, 0, 1, 1);
  Polygon moved = std::move(square);
  CHECK(moved.area() == 1);
  CHECK_THROWS(GCV_ERR_NULL_ARGUMENT, "", square.area());
  square = Polygon(moved.release());
  CHECK(square.area() == 1 && moved.get() == nullptr);
  CHECK(gcv::version() == gcv_version_string());
  CHECK(gcv::version_number() == gcv_version_number());
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
  views_of_nothing();
  scenes();
  members_set();
  empty_objects();
  conveniences();
  errors_and_moves();
  progress();
  return check_failures != 0;
}
