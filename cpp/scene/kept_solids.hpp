// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All solids of a scene, joined and prepared, for the next question before the scene changes.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace gcv {

struct JoinedSolids;  // joined_solids.hpp

// Those that were asked for last. May be asked by many threads at once.
class KeptSolids {
 public:
  KeptSolids() = default;
  KeptSolids(const KeptSolids& other) {
    const std::lock_guard<std::mutex> lock(other.mutex_);
    layers_ = other.layers_;
    solids_ = other.solids_;
  }
  KeptSolids& operator=(const KeptSolids&) = delete;
  ~KeptSolids() = default;

  // Those of a query for these layers that ignores nothing; nullptr if they are not there.
  [[nodiscard]] std::shared_ptr<const JoinedSolids> find(std::uint32_t layers) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return layers == layers_ ? solids_ : nullptr;
  }
  void keep(std::uint32_t layers, std::shared_ptr<const JoinedSolids> solids) {
    const std::lock_guard<std::mutex> lock(mutex_);
    layers_ = layers;
    solids_ = std::move(solids);
  }
  void clear() { keep(0, nullptr); }

 private:
  mutable std::mutex mutex_;
  std::uint32_t layers_ = 0;
  std::shared_ptr<const JoinedSolids> solids_;
};

}  // namespace gcv
