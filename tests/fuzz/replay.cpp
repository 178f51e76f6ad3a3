// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Runs a fuzz target without a fuzzing engine:
//
//   FOLDER...        over every file of the folders
//   soak SEED COUNT  over so many random inputs, each of which has a seed: SEED, SEED + 1, ...
//
// The same seed gives the same input everywhere. What fails is printed by the target, and then its
// seed; the exit code is 1.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
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

// ---------------------------------------------------------------------------- soak --

using RandomInput = std::array<std::uint64_t, 32>;

RandomInput random_input(std::uint64_t seed) {
  RandomInput words{};
  std::uint64_t state = seed * 0xd1342543de82ef95;
  for (std::uint64_t& word : words) {
    state += 0x9e3779b97f4a7c15;
    word = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9;
    word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
    word ^= word >> 31;
  }
  return words;
}

// How to run the input again that is run.
std::array<char, 64> repetition{};

// The exit code is 1, whatever ends the process.
void report_and_exit(int) {
  bool is_written = true;
  for (const std::string_view text :
       {std::string_view(gcv::fuzz::current_case), std::string_view(repetition.data())}) {
    is_written = write(STDERR_FILENO, text.data(), text.size()) >= 0 && is_written;
  }
  _exit(is_written ? 1 : 2);
}

void soak(std::uint64_t seed, std::uint64_t count) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE}) {
    std::signal(signal, report_and_exit);
  }
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t k = 0; k < count; ++k) {
    std::snprintf(repetition.data(), repetition.size(), "\nfailed: soak %llu 1\n",
                  static_cast<unsigned long long>(seed + k));
    const RandomInput words = random_input(seed + k);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(words.data()), sizeof words);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%llu executions, %.1f s, %.0f a second\n", static_cast<unsigned long long>(count),
              seconds.count(), static_cast<double>(count) / seconds.count());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER... | soak SEED COUNT\n";
    return 2;
  }
  try {
    if (argc == 4 && argv[1] == std::string("soak")) {
      soak(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
      return 0;
    }
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
