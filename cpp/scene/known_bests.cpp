// SPDX-License-Identifier: LGPL-3.0-or-later
#include "known_bests.hpp"

#include <algorithm>

namespace gcv {

KnownBests::KnownBests(const KnownBests& other) {
  const std::lock_guard<std::mutex> lock(other.mutex_);
  entries_ = other.entries_;
  kept_ = other.kept_;
}

std::optional<KnownBests::Best> KnownBests::find(const Question& question) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.answers(question); });
  return entry == entries_.end() ? std::nullopt : std::optional(entry->best);
}

void KnownBests::keep(const Question& question, const Best& best) {
  const auto& [moving, direction, layers, with_fits] = question;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.answers(question); });
  if (known != entries_.end()) {
    known->best = best;
  } else if (entries_.size() < most) {
    entries_.push_back({moving, direction, layers, with_fits, best});
  } else {
    entries_[kept_++ % most] = {moving, direction, layers, with_fits, best};
  }
}

void KnownBests::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  entries_.clear();
}

std::size_t KnownBests::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.capacity() * sizeof(Entry);
}

}  // namespace gcv
