// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> two small polygons that fit each other exactly, or nearly so; or a small scene. What the
// library says of them must hang together, and be the same, to the bit, of polygons that are moved,
// scaled, turned, spelled differently or exchanged. Relations are those of the definition; and a
// share of all inputs is compared with the definitions altogether (tests/worlds).
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "../worlds/compare.hpp"
#include "fuzz.hpp"
#include "world_answers.hpp"
#include "world_scenes.hpp"
#include "world_shapes.hpp"
#include "world_variants.hpp"

namespace {

using gcv::fuzz::Answers;
using gcv::fuzz::Comparison;
using gcv::fuzz::Handle;
using gcv::fuzz::Input;
using gcv::fuzz::Places;
using gcv::fuzz::Theme;
using gcv::fuzz::Variant;
using gcv::fuzz::World;
using gcv::fuzz::WorldPair;
using gcv::fuzz::WorldPoint;
using gcv::fuzz::WorldScene;

// One input in so many is compared with all definitions, if a byte is 1: no short input. Of scenes
// more, which are fewer.
constexpr std::size_t pairs_per_definition = 256;
constexpr std::size_t scenes_per_definition = 32;
// One input in so many is a scene.
constexpr std::size_t inputs_per_scene = 64;

std::string text(const WorldPair& pair) {
  return "\n  A: " + worlds::text(pair.a) + "\n  B: " + worlds::text(pair.b);
}

std::string text(const Variant& variant) {
  const auto vector = [](WorldPoint p) { return std::to_string(p.x) + " " + std::to_string(p.y); };
  return "\n  scaled by 2^" + std::to_string(variant.exponent) + ", moved by " +
         vector(variant.shift) + " and " + vector(variant.moving_shift) + ", symmetry " +
         std::to_string(variant.symmetry) + (variant.exchanged ? ", exchanged" : "") +
         (variant.respelled ? ", spelled differently" : "");
}

std::string text(const Places& places) {
  std::string result = "\n  at";
  for (const WorldPoint& p : places.at) {
    result += " (" + std::to_string(p.x) + "/2 " + std::to_string(p.y) + "/2)";
  }
  for (const WorldPoint& p : places.motions) {
    result += ", motion (" + std::to_string(p.x) + "/2 " + std::to_string(p.y) + "/2)";
  }
  return result;
}

void expect_none(const char* wrong) {
  if (wrong != nullptr) {
    gcv::fuzz::fail(wrong);
  }
}

void expect_agreement(const worlds::Report& report) {
  if (report.differences() > 0) {
    std::fflush(stdout);
    gcv::fuzz::fail("not as defined");
  }
}

// --------------------------------------------------------------------------- pairs --

// The holes that the library refuses are taken out.
void keep_what_is_valid(World& polygon, bool compare) {
  Handle handle;
  while (polygon.size() > 1) {
    const gcv_status status = gcv::fuzz::make(polygon, {}, {}, handle);
    if (compare && (status == GCV_OK) != worlds::is_valid(polygon)) {
      gcv::fuzz::fail("refused or not: " + worlds::text(polygon));
    }
    if (gcv::fuzz::succeeds("gcv_polygon_create_rings", status, {GCV_ERR_NOT_SIMPLE})) {
      return;
    }
    polygon.pop_back();
  }
}

void ask_regions(const gcv_polygon* a, const gcv_polygon* b, const double* point,
                 const std::vector<double>& xy, const Variant& variant, Answers& answers) {
  gcv_region* region = nullptr;
  worlds::check(gcv_no_fit_region(a, b, point, nullptr, &region));
  const worlds::Owner<gcv_region> region_owner(region);
  answers.region = gcv::fuzz::parts(*region, variant);
  answers.located = gcv::fuzz::locate(*region, xy);
  gcv_outer_face* face = nullptr;
  worlds::check(gcv_no_fit_polygon(a, b, point, nullptr, &face));
  const worlds::Owner<gcv_outer_face> face_owner(face);
  answers.face = gcv::fuzz::parts(*face, variant);
  if (variant.exponent == 0) {
    worlds::check(gcv_region_area(region, &answers.region_area));
    worlds::check(gcv_outer_face_area(face, &answers.face_area));
  }
}

void ask_fits(const gcv_polygon* a, const gcv_polygon* b, const double* point,
              const std::vector<double>& xy, const Variant& variant, Answers& answers) {
  gcv_region* fit = nullptr;
  worlds::check(gcv_inner_fit_region(a, b, point, nullptr, &fit));
  const worlds::Owner<gcv_region> owner(fit);
  answers.fit = gcv::fuzz::parts(*fit, variant);
  answers.in_fit = gcv::fuzz::locate(*fit, xy);
}

Answers ask(const WorldPair& pair, const Places& places, Theme theme, const Variant& variant) {
  Handle a = gcv::fuzz::make(pair.a, variant, variant.shift);
  Handle b = gcv::fuzz::make(pair.b, variant, variant.moving_shift);
  if (variant.exchanged) {
    std::swap(a, b);
  }
  // The point of B that lies in the origin where nothing is moved: regions stay where they are.
  const WorldPoint moved = variant.moving_shift - variant.shift;
  const std::array<double, 2> point{variant.number(moved.x), variant.number(moved.y)};
  Variant unmoved = variant;
  unmoved.shift = unmoved.moving_shift = {};
  const std::vector<double> xy = gcv::fuzz::doubles(places, unmoved);
  Answers answers;
  if (theme == Theme::regions) {
    ask_regions(a.get(), b.get(), point.data(), xy, variant, answers);
  } else if (theme == Theme::fits) {
    ask_fits(a.get(), b.get(), point.data(), xy, variant, answers);
  }
  const auto cast = [&](auto... arguments) { return gcv_cast(a.get(), b.get(), arguments...); };
  gcv::fuzz::ask(worlds::PairSubject(*a, *b), places, variant, theme, cast, answers);
  return answers;
}

double area(const World& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double twice = std::abs(static_cast<double>(worlds::twice_area(polygon[k])));
    sum += k == 0 ? twice / 2 : -twice / 2;
  }
  return sum;
}

// What is wrong with the region and the outer face; or nothing.
const char* wrong_region(const WorldPair& pair, const Answers& answers) {
  if (answers.face.size() != 1 || answers.region.empty() ||
      answers.face.front() != answers.region.front()) {
    return "the outer face is not the outer ring of the region";
  }
  if (gcv::fuzz::sorted(answers.region) != answers.region) {
    return "the region is not in canonical order";
  }
  // Brunn-Minkowski.
  const double least = std::sqrt(area(pair.a)) + std::sqrt(area(pair.b));
  if (answers.region_area < least * least * (1 - 1e-12) ||
      answers.face_area < answers.region_area) {
    return "the area is too small";
  }
  for (std::size_t k = 0; k < answers.relation.size(); ++k) {
    if (answers.relation[k] != -answers.located[k]) {
      return "the region is not where the polygons overlap";
    }
  }
  return nullptr;
}

// What is wrong with answers at places, beside the relation; or nothing.
const char* wrong_at_places(const Answers& answers) {
  const std::vector<std::int8_t>& relation = answers.relation;
  for (std::size_t k = 0; k < answers.in_fit.size(); ++k) {
    if (answers.in_fit[k] != GCV_OUTSIDE && relation[k] != GCV_OVERLAPPING) {
      return "in the inner fit the polygons do not overlap";
    }
  }
  for (std::size_t k = 0; k < answers.distance.size(); ++k) {
    if (answers.distance[k].relation != relation[k] ||
        (answers.distance[k].distance > 0) != (relation[k] == GCV_APART)) {
      return "the distance is not that of the relation";
    }
  }
  for (std::size_t k = 0; k < answers.escape.size(); ++k) {
    if ((answers.escape[k].depth > 0) != (relation[k] == GCV_OVERLAPPING)) {
      return "the depth is not that of the relation";
    }
  }
  return nullptr;
}

// What is wrong where A has grown to its outer ring, or to its box; or nothing.
const char* shrunk(const Answers& small, const Answers& grown, bool same_face) {
  if (grown.region_area < small.region_area || grown.face_area < small.face_area ||
      (same_face && grown.face != small.face)) {
    return "A grows, and the sum does not";
  }
  for (std::size_t k = 0; k < small.relation.size(); ++k) {
    if (grown.relation[k] > small.relation[k]) {
      return "A grows, and overlaps no longer";
    }
  }
  for (std::size_t k = 0; k < small.in_fit.size(); ++k) {
    if (grown.in_fit[k] < small.in_fit[k]) {
      return "A grows, and B does not fit into it any longer";
    }
  }
  for (std::size_t k = 0; k < small.distance.size(); ++k) {
    if (grown.distance[k].distance > small.distance[k].distance) {
      return "A grows, and is further away";
    }
  }
  for (std::size_t k = 0; k < small.escape.size(); ++k) {
    if (grown.escape[k].depth < small.escape[k].depth) {
      return "A grows, and the way out is shorter";
    }
  }
  for (std::size_t k = 0; k < small.impact.size(); ++k) {
    if (grown.impact[k].time > small.impact[k].time) {
      return "A grows, and is hit later";
    }
  }
  return nullptr;
}

const char* wrong_relation(const WorldPair& pair, const Places& places, const Answers& answers) {
  worlds::OpenSum sum;
  sum.add(worlds::inner_pieces(pair.a), worlds::inner_pieces(worlds::reflected(pair.b)));
  for (std::size_t k = 0; k < places.at.size(); ++k) {
    const WorldPoint place = worlds::kUnit / 2 * places.at[k];
    const int expected = sum.holds(place)     ? GCV_OVERLAPPING
                         : sum.reaches(place) ? GCV_TOUCHING
                                              : GCV_APART;
    if (answers.relation[k] != expected) {
      return "the relation is not as defined";
    }
  }
  return nullptr;
}

void check_pair(Input& input) {
  WorldPair pair = gcv::fuzz::read_pair(input);
  const bool is_defined = gcv::fuzz::is_defined(pair.a) && gcv::fuzz::is_defined(pair.b);
  const bool compares_all = input.below(pairs_per_definition) == 1 && is_defined;
  keep_what_is_valid(pair.a, compares_all);
  keep_what_is_valid(pair.b, compares_all);
  const WorldPoint size_a = worlds::bounds(pair.a[0]).second;
  const WorldPoint size_b = worlds::bounds(pair.b[0]).second;
  const Places places =
      Places::read(input, -2 * size_b - WorldPoint{1, 1}, 2 * size_a + WorldPoint{1, 1});
  const Theme theme = input.one_of(gcv::fuzz::themes);
  gcv::fuzz::current_case = text(pair) + text(places);
  const Answers answers = ask(pair, places, theme, {});
  if (theme == Theme::regions) {
    expect_none(wrong_region(pair, answers));
  }
  expect_none(wrong_at_places(answers));
  if (is_defined) {
    expect_none(wrong_relation(pair, places, answers));
  }
  if (input.below(4) == 0) {
    const bool has_holes = pair.a.size() > 1;
    gcv::fuzz::current_case += "\n  A grows";
    WorldPair grown = pair;
    grown.a = {has_holes ? pair.a[0] : gcv::fuzz::rectangle(0, 0, size_a.x, size_a.y)};
    expect_none(shrunk(answers, ask(grown, places, theme, {}), has_holes));
  } else {
    const Variant variant = Variant::read(input);
    gcv::fuzz::current_case += text(variant);
    expect_none(Comparison(variant).difference(answers, ask(pair, places, theme, variant)));
  }
  if (compares_all) {
    worlds::Report report;
    worlds::compare_pair(worlds::Operand(pair.a), worlds::Operand(pair.b), report);
    expect_agreement(report);
  }
}

// -------------------------------------------------------------------------- scenes --

void check_scene(Input& input) {
  const WorldScene scene = gcv::fuzz::read_scene(input);
  const bool compares_all = input.below(scenes_per_definition) == 1;
  const WorldPoint size = worlds::bounds(scene.container[0]).second;
  const Places places = Places::read(input, {-1, -1}, 2 * size + WorldPoint{1, 1});
  Variant variant = Variant::read(input);
  variant.exchanged = false;
  variant.moving_shift = variant.shift;
  const Theme theme = input.one_of(gcv::fuzz::themes);
  gcv::fuzz::current_case = gcv::fuzz::text(scene) + text(places);
  const gcv::fuzz::MadeScene made(scene, {});
  const Answers answers = gcv::fuzz::ask_scene(made, places, {}, theme);
  expect_none(gcv::fuzz::contradiction(scene, made, places, answers));
  const gcv::fuzz::MadeScene other(scene, variant);
  gcv::fuzz::current_case += text(variant);
  expect_none(
      Comparison(variant).difference(answers, gcv::fuzz::ask_scene(other, places, variant, theme)));
  if (compares_all) {
    worlds::Report report;
    gcv::fuzz::compare(scene, report);
    expect_agreement(report);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  try {
    if (input.below(inputs_per_scene) + 1 == inputs_per_scene) {
      check_scene(input);
    } else {
      check_pair(input);
    }
  } catch (const std::exception& exception) {
    gcv::fuzz::fail(std::string("failure: ") + exception.what());
  }
  return 0;
}
