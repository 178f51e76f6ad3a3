// SPDX-License-Identifier: LGPL-3.0-or-later
#include "wkt.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "error.hpp"

namespace gcv {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_letter(int c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char to_upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class Parser {
 public:
  Parser(std::string_view text, const char* name) : text_(text), name_(name) {}

  std::vector<PointVector> polygon() {
    expect_word("POLYGON");
    if (accept_word("EMPTY")) {
      expect_end();
      throw Error(Status::degenerate, "%s: POLYGON EMPTY has no vertices", name_);
    }
    expect('(');
    std::vector<PointVector> rings{ring(0)};
    while (accept(',')) {
      vertices_before_ += rings.back().size();
      rings.push_back(ring(rings.size()));
      check_hole(rings.back(), rings.size() - 1);
    }
    expect(')');
    expect_end();
    return rings;
  }

 private:
  [[noreturn]] void fail(const char* expected) const {
    if (at_ == text_.size()) {
      throw Error(Status::parse, "%s: byte %zu: expected %s, but the text ends", name_, at_,
                  expected);
    }
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if (byte <= ' ' || byte >= 0x7f) {
      throw Error(Status::parse, "%s: byte %zu: expected %s, found byte 0x%02x", name_, at_,
                  expected, byte);
    }
    constexpr std::size_t longest = 20;
    std::size_t length = 1;
    while (length < longest && at_ + length < text_.size() && is_letter(byte) &&
           is_letter(text_[at_ + length])) {
      ++length;
    }
    throw Error(Status::parse, "%s: byte %zu: expected %s, found '%.*s'", name_, at_, expected,
                static_cast<int>(length), text_.data() + at_);
  }

  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) {
      ++at_;
    }
  }

  bool accept(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) {
      return false;
    }
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) {
      const std::array<char, 4> expected{'\'', c, '\'', '\0'};
      fail(expected.data());
    }
  }

  bool accept_word(std::string_view word) {
    skip_space();
    if (text_.size() - at_ < word.size()) {
      return false;
    }
    for (std::size_t k = 0; k < word.size(); ++k) {
      if (to_upper(text_[at_ + k]) != word[k]) {
        return false;
      }
    }
    at_ += word.size();
    return true;
  }

  void expect_word(const char* word) {
    if (!accept_word(word)) {
      fail(word);
    }
  }

  void expect_end() {
    skip_space();
    if (at_ != text_.size()) {
      fail("the end of the text");
    }
  }

  double number(std::size_t ring, std::size_t vertex) {
    skip_space();
    const std::size_t begin = at_;
    if (at_ < text_.size() && text_[at_] == '+') {  // from_chars accepts only '-'
      ++at_;
      if (at_ < text_.size() && text_[at_] == '-') {
        fail("a number");
      }
    }
    double value = 0;
    const char* const last = text_.data() + text_.size();
    const auto [end, error] = std::from_chars(text_.data() + at_, last, value);
    if (error == std::errc::invalid_argument) {
      at_ = begin;
      fail("a number");
    }
    const std::size_t length = static_cast<std::size_t>(end - text_.data()) - begin;
    const std::string_view digits = text_.substr(begin, length);
    if (error == std::errc::result_out_of_range) {
      value = underflows(digits) ? 0.0 : HUGE_VAL;
    }
    if (!std::isfinite(value)) {
      throw Error(Status::not_finite,
                  "%s: byte %zu: %.*s in vertex %zu of ring %zu is not a finite double", name_,
                  begin, static_cast<int>(length < 40 ? length : 40), digits.data(), vertex, ring);
    }
    at_ = begin + length;
    if (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != ',' && text_[at_] != ')') {
      fail("a space, ',' or ')' after a number");
    }
    return value;
  }

  // Is a number that is out of range too small? from_chars does not say that. The decimal exponent
  // of its first digit other than 0 does.
  static bool underflows(std::string_view digits) {
    long point = 0;  // the number of digits before the point, from the first that is not 0
    bool started = false;
    bool fraction = false;
    std::size_t k = 0;
    for (; k < digits.size() && to_upper(digits[k]) != 'E'; ++k) {
      const char c = digits[k];
      if (c == '.') {
        fraction = true;
      } else if (c >= '0' && c <= '9') {
        started = started || c != '0';
        if (started && !fraction) {
          ++point;
        } else if (!started && fraction) {
          --point;
        }
      }
    }
    ++k;
    if (k < digits.size() && digits[k] == '+') {
      ++k;
    }
    long exponent = 0;
    if (k < digits.size()) {
      const auto result =
          std::from_chars(digits.data() + k, digits.data() + digits.size(), exponent);
      if (result.ec == std::errc::result_out_of_range) {
        return digits[k] == '-';
      }
    }
    return exponent < -point;
  }

  PointVector ring(std::size_t number_of_ring) {
    PointVector points;
    expect('(');
    do {
      const std::size_t vertex = vertices_before_ + points.size();
      const double x = number(number_of_ring, vertex);
      const double y = number(number_of_ring, vertex);
      points.push_back({x, y});
    } while (accept(','));
    if (!accept(')')) {
      fail("',' or ')'");
    }
    return points;
  }

  void check_hole(const PointVector& hole, std::size_t number) const {
    std::size_t vertices = hole.size();
    while (vertices > 1 && hole.front() == hole[vertices - 1]) {
      --vertices;
    }
    if (vertices < 3) {
      throw Error(Status::parse, "%s: byte %zu: hole %zu has %zu vertices, at least 3 are needed",
                  name_, at_, number, vertices);
    }
  }

  std::string_view text_;
  const char* name_;
  std::size_t at_ = 0;
  std::size_t vertices_before_ = 0;  // in the rings before
};

void append(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

}  // namespace

void append_point(std::string& text, const Point& point) {
  append(text, point.x);
  text += ' ';
  append(text, point.y);
}

void append_ring(std::string& text, std::span<const Point> ring) {
  assert(!ring.empty());
  text += '(';
  for (const Point& point : ring) {
    append_point(text, point);
    text += ", ";
  }
  append_point(text, ring.front());
  text += ')';
}

std::vector<PointVector> parse_polygon(std::string_view text, const char* name) {
  return Parser(text, name).polygon();
}

std::string format_polygon(std::span<const Point> ring) {
  std::string text = "POLYGON (";
  append_ring(text, ring);
  text += ')';
  return text;
}

}  // namespace gcv
