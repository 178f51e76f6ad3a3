// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The options of programs that try random cases: [--cases=N] [--seed=N].
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace gcv::test {

struct CaseOptions {
  int cases;  // of each family
  std::uint64_t seed = 1;

  // False for any other option.
  bool take(int argc, char** argv) {
    for (int k = 1; k < argc; ++k) {
      const std::string option = argv[k];
      const std::size_t length = option.find('=') + 1;
      const std::string value = option.substr(length);
      if (option.starts_with("--cases=")) {
        cases = std::atoi(value.c_str());
      } else if (option.starts_with("--seed=")) {
        seed = std::strtoull(value.c_str(), nullptr, 10);
      } else {
        return false;
      }
    }
    return true;
  }
};

// The name of a family of cases, for the tests of it.
template <class Family>
std::string name_of_family(const ::testing::TestParamInfo<Family>& family) {
  std::string name = family.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// Runs all tests with the options of the command line. The exit status.
inline int run_with(CaseOptions& options, int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (!options.take(argc, argv)) {
    std::cerr << "usage: " << argv[0] << " [--cases=N] [--seed=N]\n";
    return 2;
  }
  return RUN_ALL_TESTS();
}

}  // namespace gcv::test
