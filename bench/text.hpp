// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Arguments in, JSON out.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace gcv::bench {

inline std::vector<std::string> split(const std::string& text, char separator = ',') {
  std::vector<std::string> names;
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, separator);) {
    names.push_back(name);
  }
  return names;
}

inline bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Control characters become spaces.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + '"';
}

}  // namespace gcv::bench
