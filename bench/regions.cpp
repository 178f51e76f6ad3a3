// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_regions [--quick] [--parts NAME,...]
//
// Times whole regions beside outer faces and beside systems that give holes too, and counts what
// those get wrong. One thread. Prints the tables of docs/PERFORMANCE.md and docs/ACCURACY.md.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "region/answers.hpp"
#include "region/tables.hpp"
#include "region/ways_out.hpp"
#include "text.hpp"

namespace gcv::bench {
namespace {

struct Part {
  const char* name;
  const char* title;
  void (*print)(bool quick);
};

constexpr Part parts[] = {{"pairs", "Pairs", print_pairs},
                          {"samples", "Samples", print_samples},
                          {"growth", "Growth", print_growth},
                          {"positions", "Positions", print_positions},
                          {"answers", "Wrong answers", print_answers},
                          {"ways-out", "Ways out", print_ways_out}};

void run(const std::vector<std::string>& arguments) {
  bool quick = false;
  std::vector<std::string> chosen;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "--quick") {
      quick = true;
    } else if (arguments[k] == "--parts") {
      chosen = split(arguments.at(++k));
    } else {
      throw std::invalid_argument("unknown argument: " + arguments[k]);
    }
  }
  for (const std::string& name : chosen) {
    bool is_known = false;
    for (const Part& part : parts) {
      is_known = is_known || name == part.name;
    }
    if (!is_known) {
      throw std::invalid_argument("unknown part: " + name);
    }
  }
  for (const Part& part : parts) {
    if (chosen.empty() || contains(chosen, part.name)) {
      std::printf("## %s\n\n", part.title);
      std::fflush(stdout);
      part.print(quick);
    }
  }
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_regions: %s\n", exception.what());
    return 1;
  }
  return 0;
}
