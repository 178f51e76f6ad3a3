// SPDX-License-Identifier: LGPL-3.0-or-later
#include "options.hpp"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "error.hpp"
#include "parallel.hpp"
#include "text_of.hpp"

#if defined(gcv_EXPORTS) && defined(__ELF__)
// Programs that were linked with version 0.1 keep the function that writes the struct of then.
extern "C" GCV_API void gcv_options_init_0_1(gcv_options* options);
__asm__(".symver gcv_options_init_0_1, gcv_options_init@GCV_0.1");
__asm__(".symver gcv_options_init, gcv_options_init@@@GCV_0.2");
#endif

namespace gcv::capi {

namespace {

// The options of the first version 0.1. No caller has fewer.
struct FirstOptions {
  std::uint32_t struct_size;
  std::int32_t rounding;
  double tolerance;
};

// The size of the options of 0.1.0.
constexpr std::size_t size_0_1 = offsetof(gcv_options, leave_out);

constexpr std::uint64_t known_parts = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;

bool is_known_size(std::uint32_t size) {
  return size == sizeof(FirstOptions) || size == size_0_1 || size >= sizeof(gcv_options);
}

bool has(std::uint64_t bits, std::uint64_t bit) { return (bits & bit) != 0; }

}  // namespace

Rounding read_rounding(std::int32_t rounding, const char* where) {
  if (rounding != GCV_ROUND_NEAREST && rounding != GCV_ROUND_OUTWARD) {
    throw Error(Status::invalid_argument, "%srounding is %d, neither %d nor %d", where, rounding,
                static_cast<int>(GCV_ROUND_NEAREST), static_cast<int>(GCV_ROUND_OUTWARD));
  }
  return static_cast<Rounding>(rounding);
}

void check_tolerance(double tolerance, const char* where) {
  if (!(tolerance >= 0 && std::isfinite(tolerance))) {
    throw Error(Status::invalid_argument, "%stolerance is %g, not a finite number from 0 on", where,
                tolerance);
  }
}

gcv_options read_options(const gcv_options* options) {
  gcv_options known = GCV_OPTIONS_INIT;
  if (options == nullptr) {
    return known;
  }
  const std::uint32_t size = options->struct_size;
  if (!is_known_size(size)) {
    throw Error(Status::invalid_argument,
                "options: struct_size is %u, neither %zu nor %zu nor at least %zu; initialise it "
                "with GCV_OPTIONS_INIT",
                size, sizeof(FirstOptions), size_0_1, sizeof(gcv_options));
  }
  const auto* const bytes = reinterpret_cast<const unsigned char*>(options);
  for (std::size_t k = sizeof(gcv_options); k < size; ++k) {
    if (bytes[k] != 0) {
      throw Error(Status::invalid_argument,
                  "options: byte %zu of %u is set, for an option that version " GCV_TEXT(
                      GCV_VERSION_MAJOR) "." GCV_TEXT(GCV_VERSION_MINOR) " does not know",
                  k, size);
    }
  }
  std::memcpy(&known, options, std::min<std::size_t>(size, sizeof known));
  static_cast<void>(read_rounding(known.rounding, "options: "));
  check_tolerance(known.tolerance, "options: ");
  if (known.threads < 0) {
    throw Error(Status::invalid_argument, "options: threads is %d, below 0", known.threads);
  }
  if (has(known.leave_out, ~known_parts)) {
    throw Error(Status::invalid_argument, "options: leave_out is %" PRIu64 ", with unknown bits",
                known.leave_out);
  }
  return known;
}

void refuse_tolerance(const gcv_options& options, const char* what) {
  if (options.tolerance > 0) {
    throw Error(Status::invalid_argument, "options: tolerance is %g; %s are exact, 0",
                options.tolerance, what);
  }
}

gcv_options read_exact_options(const gcv_options* options, const char* what) {
  const gcv_options known = read_options(options);
  refuse_tolerance(known, what);
  if (has(known.leave_out, GCV_LEAVE_OUT_HOLES)) {
    throw Error(Status::invalid_argument,
                "options: leave_out has GCV_LEAVE_OUT_HOLES; %s have all of their holes", what);
  }
  return known;
}

SumOptions sum_options(const gcv_options& options) {
  return {static_cast<Rounding>(options.rounding), options.tolerance};
}

RegionOptions region_options(const gcv_options& options) {
  return {sum_options(options), has(options.leave_out, GCV_LEAVE_OUT_HOLES),
          has(options.leave_out, GCV_LEAVE_OUT_FITS)};
}

WantedParts wanted_parts(const gcv_options& options) {
  return {!has(options.leave_out, GCV_LEAVE_OUT_HOLES),
          !has(options.leave_out, GCV_LEAVE_OUT_FITS)};
}

unsigned threads_of(const gcv_options& options) {
  constexpr std::int32_t most = 256;
  return options.threads == 0 ? available_threads()
                              : static_cast<unsigned>(std::min(options.threads, most));
}

}  // namespace gcv::capi

void gcv_options_init(gcv_options* options) {
  if (options != nullptr) {
    *options = GCV_OPTIONS_INIT;
  }
}

#if defined(gcv_EXPORTS) && defined(__ELF__)
void gcv_options_init_0_1(gcv_options* options) {
  gcv_options_init_size(options, gcv::capi::size_0_1);
}
#endif

void gcv_options_init_size(gcv_options* options, uint32_t struct_size) {
  if (options == nullptr || struct_size < sizeof(gcv::capi::FirstOptions)) {
    return;
  }
  gcv_options defaults;  // all of its bytes are written, those between the members too
  std::memset(&defaults, 0, sizeof defaults);
  defaults.struct_size = struct_size;
  defaults.threads = 1;
  std::memset(options, 0, struct_size);
  std::memcpy(options, &defaults, std::min<std::size_t>(struct_size, sizeof defaults));
}
