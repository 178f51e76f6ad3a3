// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Runs a fuzz target over every file of the folders given, without a fuzzing engine.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "fuzz.hpp"

namespace {

// Gives the number of files.
std::size_t replay(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    std::cout << file.string() << std::endl;
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
      throw std::runtime_error(file.string() + " cannot be read");
    }
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  return files.size();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER...\n";
    return 2;
  }
  try {
    for (int k = 1; k < argc; ++k) {
      if (replay(argv[k]) == 0) {
        std::cerr << "the folder of inputs " << argv[k] << " is empty\n";
        return 1;
      }
    }
  } catch (const std::exception& exception) {
    std::cerr << "the inputs cannot be replayed: " << exception.what() << "\n";
    return 1;
  }
}
