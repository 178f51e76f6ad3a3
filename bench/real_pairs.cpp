// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <sstream>

#include "data.hpp"
#include "sets.hpp"
#include "shapes.hpp"

namespace gcv::bench {

using test::read_polygon;
using test::uniform;

std::vector<Set> blocks_of_pairs(const std::filesystem::path& directory) {
  std::vector<Set> blocks{{.name = "paper"}, {.name = "real"}, {.name = "growing", .grows = true}};
  std::ifstream stream(directory / "pairs.txt");
  std::size_t block = 0;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name;
    std::string a;
    std::string b;
    if (line.rfind('#', 0) == 0) {
      block += blocks[block].pairs.empty() ? 0 : 1;
    } else if (words >> name >> a >> b) {
      blocks.at(block).pairs.push_back(
          {name, [directory, a, b] {
             return Rings{read_polygon(directory / a), read_polygon(directory / b)};
           }});
    }
  }
  return blocks;
}

Set tiny_pairs(int count) {
  Set set{.name = "tiny"};
  for (int k = 1; k <= count; ++k) {
    set.pairs.push_back({std::to_string(k), [k] {
                           Random random(static_cast<std::uint64_t>(k));
                           Ring a = tiny(random);
                           return Rings{std::move(a), tiny(random)};
                         }});
  }
  return set;
}

Set nesting(const std::filesystem::path& directory, int count) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "nesting")) {
    if (entry.path().extension() == ".wkt") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  Set set{.name = "nesting", .for_all_peers = false};
  Random random(1);
  const auto draw = [&] {
    return files[static_cast<std::size_t>(uniform(random, 0, static_cast<int>(files.size()) - 1))];
  };
  for (int k = 0; k < count; ++k) {
    const auto a = draw();
    const auto b = draw();
    set.pairs.push_back({a.stem().string() + " + " + b.stem().string(), [a, b] {
                           return Rings{read_polygon(a), read_polygon(b)};
                         }});
  }
  return set;
}

Set lost_holes(const std::filesystem::path& directory) {
  Set set{.name = "lost holes"};
  for (const auto& entry : std::filesystem::directory_iterator(directory / "lost_holes")) {
    const std::string name = entry.path().stem().string();
    const std::string number = name.substr(0, name.find('_'));
    if (name == number + "_a") {
      set.pairs.push_back({number, [folder = directory / "lost_holes", number] {
                             return Rings{read_polygon(folder / (number + "_a.wkt")),
                                          read_polygon(folder / (number + "_b.wkt"))};
                           }});
    }
  }
  std::sort(set.pairs.begin(), set.pairs.end(),
            [](const Pair& p, const Pair& q) { return p.name < q.name; });
  return set;
}

PointVector tidy(const PointVector& ring) {
  Ring result;
  for (const Point& p : ring) {
    if (result.empty() || !(p == result.back())) {
      result.push_back(p);
    }
  }
  while (result.size() > 1 && result.back() == result.front()) {
    result.pop_back();
  }
  double twice_area = 0;
  for (std::size_t k = 1; k + 1 < result.size(); ++k) {
    const Point& o = result[0];
    twice_area += (result[k].x - o.x) * (result[k + 1].y - o.y) -
                  (result[k].y - o.y) * (result[k + 1].x - o.x);
  }
  if (twice_area < 0) {
    std::reverse(result.begin(), result.end());
  }
  return result;
}

}  // namespace gcv::bench
