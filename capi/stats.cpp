// SPDX-License-Identifier: LGPL-3.0-or-later
#include "stats.hpp"

#include <cstddef>
#include <cstring>

#include "error.hpp"

namespace gcv::capi {

void give_stats(const Counts& counts, std::uint64_t vertices_repaired, std::uint64_t parts_dropped,
                gcv_stats* out) {
  constexpr std::size_t first_size = offsetof(gcv_stats, parts_dropped);
  const std::uint32_t size = out->struct_size;
  if (size < first_size) {
    throw Error(Status::invalid_argument, "stats: struct_size is %u, less than %zu", size,
                first_size);
  }
  const gcv_stats stats{size,
                        counts.walk_steps,
                        counts.candidate_edges,
                        counts.predicates.filtered,
                        counts.predicates.fixed_width,
                        counts.predicates.rational,
                        vertices_repaired,
                        parts_dropped};
  std::memset(out, 0, size);
  std::memcpy(out, &stats, size < sizeof stats ? first_size : sizeof stats);
}

}  // namespace gcv::capi
