// SPDX-License-Identifier: LGPL-3.0-or-later
#include "data.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "wkt.hpp"

namespace gcv::test {

std::optional<std::filesystem::path> data_directory() {
  const char* const given = std::getenv("GCV_DATA_DIR");
  const std::filesystem::path directory =
      given != nullptr ? given : GCV_SOURCE_DIR "/../shared/data";
  if (!std::filesystem::exists(directory / "pairs.txt")) {
    return std::nullopt;
  }
  return directory;
}

std::vector<PointVector> read_rings(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_polygon(text, file.c_str());
}

PointVector read_polygon(const std::filesystem::path& file) { return read_rings(file).front(); }

std::vector<NamedPair> read_pairs(const std::filesystem::path& directory) {
  std::vector<NamedPair> pairs;
  std::ifstream stream(directory / "pairs.txt");
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name;
    std::string a;
    std::string b;
    if (line.rfind('#', 0) != 0 && words >> name >> a >> b) {
      pairs.push_back({name, read_polygon(directory / a), read_polygon(directory / b)});
    }
  }
  return pairs;
}

}  // namespace gcv::test
