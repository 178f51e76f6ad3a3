// SPDX-License-Identifier: LGPL-3.0-or-later
#include "known_bests.hpp"

#include <algorithm>
#include <utility>

namespace gcv {

KnownBests::KnownBests(const KnownBests& other) {
  const std::lock_guard<std::mutex> lock(other.mutex_);
  entries_ = other.entries_;
  vertices_ = other.vertices_;
}

bool KnownBests::Entry::answers(const Question& question) const {
  return direction == question.direction && layers == question.layers &&
         with_fits == question.with_fits && vertices == question.moving.vertices &&
         layout == question.moving.layout;
}

std::size_t KnownBests::index_of(const Question& question) const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.answers(question); });
  return static_cast<std::size_t>(entry - entries_.begin());
}

std::optional<KnownBests::Best> KnownBests::find(const Question& question) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t k = index_of(question);
  return k < entries_.size() ? std::optional(entries_[k].best) : std::nullopt;
}

void KnownBests::keep(const Question& question, const Best& best) {
  const auto& [moving, direction, layers, with_fits] = question;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const std::size_t k = index_of(question); k < entries_.size()) {
    entries_[k].best = best;
    return;
  }
  if (moving.size() > most_vertices) {
    return;
  }
  Entry entry{moving.vertices, moving.layout, direction, layers, with_fits, best};
  entries_.reserve(std::min(most, 2 * entries_.size() + 1));
  while (entries_.size() == most || vertices_ + moving.size() > most_vertices) {
    vertices_ -= entries_.front().vertices.size();
    entries_.erase(entries_.begin());
  }
  entries_.push_back(std::move(entry));
  vertices_ += moving.size();
}

void KnownBests::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  entries_.clear();
  vertices_ = 0;
}

std::size_t KnownBests::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.capacity() * sizeof(Entry) + vertices_ * sizeof(Point);
}

}  // namespace gcv
