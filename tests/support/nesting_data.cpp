// SPDX-License-Identifier: LGPL-3.0-or-later
#include "nesting_data.hpp"

// Else Boost prints a note on its own use of boost::bind.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS

#include <algorithm>
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <string>

namespace gcv::test {

namespace {

// Elements of an array are children without a name.
using Json = boost::property_tree::ptree;

Json read_json(const std::filesystem::path& file) {
  Json json;
  boost::property_tree::read_json(file.string(), json);
  return json;
}

double number(const Json& json) { return std::stod(json.get_value<std::string>()); }

// From [[x, y], ...].
PointVector points(const Json& json) {
  PointVector result;
  for (const auto& [name, point] : json) {
    result.push_back({number(point.front().second), number(point.back().second)});
  }
  return result;
}

// All pieces and boards have one ring.
PointVector ring_of(const Json& piece) {
  return points(piece.get_child("rings").front().second.get_child("xy"));
}

// From [fixed, moving, ring], with ids such as polygon12.
StoredRing stored_ring(const Json& json) {
  const auto index = [](const Json& id) {
    return std::stoul(id.get_value<std::string>().substr(std::string("polygon").size()));
  };
  auto element = json.begin();
  StoredRing stored{index(element->second), 0, {}};
  ++element;
  stored.moving = index(element->second);
  ++element;
  stored.ring = points(element->second);
  return stored;
}

NestingInstance nesting_instance(const Json& json) {
  NestingInstance instance;
  instance.name = json.get<std::string>("name");
  instance.board = ring_of(json.get_child("boards").front().second);
  for (const auto& [name, piece] : json.get_child("pieces")) {
    instance.pieces.push_back(ring_of(piece));
    instance.quantities.push_back(std::stoul(piece.get<std::string>("quantity")));
  }
  for (const auto& [name, stored] : json.get_child("nfps")) {
    instance.no_fits.push_back(stored_ring(stored));
  }
  for (const auto& [name, stored] : json.get_child("ifps")) {
    instance.inner_fits.push_back(stored_ring(stored));
  }
  // Pieces are counted from 1, as the board is polygon0; or from 0.
  const auto less = [](const StoredRing& r, const StoredRing& s) { return r.moving < s.moving; };
  const std::size_t first =
      std::min_element(instance.no_fits.begin(), instance.no_fits.end(), less)->moving;
  for (StoredRing& stored : instance.no_fits) {
    stored.fixed -= first;
    stored.moving -= first;
  }
  for (StoredRing& stored : instance.inner_fits) {
    stored.moving -= first;
  }
  return instance;
}

std::vector<std::filesystem::path> json_files(const std::filesystem::path& directory,
                                              bool jigsaws) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "esicup")) {
    const bool is_jigsaw = entry.path().filename().string().rfind("terashima", 0) == 0;
    if (entry.path().extension() == ".json" && is_jigsaw == jigsaws) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<NestingInstance> read_nesting_instances(const std::filesystem::path& directory) {
  std::vector<NestingInstance> instances;
  for (const auto& file : json_files(directory, false)) {
    instances.push_back(nesting_instance(read_json(file)));
  }
  return instances;
}

std::vector<Jigsaw> read_jigsaws(const std::filesystem::path& directory) {
  std::vector<Jigsaw> jigsaws;
  for (const auto& file : json_files(directory, true)) {
    for (const auto& [name, instance] : read_json(file)) {
      const double width = number(instance.get_child("width"));
      const double height = number(instance.get_child("height"));
      for (const auto& [unnamed, bin] : instance.get_child("bins")) {
        Jigsaw jigsaw{name + " " + std::to_string(jigsaws.size()), width, height, {}};
        for (const auto& [none, piece] : bin) {
          jigsaw.pieces.push_back(points(piece));
        }
        jigsaws.push_back(std::move(jigsaw));
      }
    }
  }
  return jigsaws;
}

}  // namespace gcv::test
