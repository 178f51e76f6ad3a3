// SPDX-License-Identifier: LGPL-3.0-or-later
#include <clipper2/clipper.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "grid.hpp"
#include "nest.hpp"

namespace gcv::bench {

namespace {

using Clipper2Lib::Path64;
using Clipper2Lib::Paths64;
using Clipper2Lib::Point64;
using Grid = IntegerGrid<std::int64_t>;

// A power of two, so that small integers stay what they are.
constexpr int bits_of_length = 29;

class Clipper2Nester : public Nester {
 public:
  Clipper2Nester(const NestingJob& job, NoFits no_fits)
      : keeps_(no_fits == NoFits::kept),
        grid_(std::ldexp(1.0, bits_of_length - std::ilogb(job.length)), Clipper2Lib::MAX_COORD),
        length_(grid_.to_grid(job.length)),
        height_(grid_.to_grid(job.height)) {
    for (const Ring& shape : job.shapes) {
      Path64& path = shapes_.emplace_back();
      Path64& reflection = reflected_.emplace_back();
      for (const Point& p : shape) {
        path.emplace_back(grid_.to_grid(p.x), grid_.to_grid(p.y));
        reflection.emplace_back(-path.back().x, -path.back().y);
      }
    }
  }

  std::optional<Point> place(std::size_t shape) override {
    const Clipper2Lib::Rect64 box = Clipper2Lib::GetBounds(shapes_[shape]);
    const Paths64 fit{Clipper2Lib::MakePath({-box.left, -box.top, length_ - box.right, -box.top,
                                             length_ - box.right, height_ - box.bottom, -box.left,
                                             height_ - box.bottom})};
    Paths64 no_fits;
    for (const auto& [other, position] : placed_) {
      for (const Path64& path : no_fit(other, shape)) {
        no_fits.push_back(Clipper2Lib::TranslatePath(path, position.x, position.y));
      }
    }
    no_fits = Clipper2Lib::Union(no_fits, Clipper2Lib::FillRule::NonZero);
    const Paths64 free = Clipper2Lib::Difference(fit, no_fits, Clipper2Lib::FillRule::NonZero);
    std::optional<Point64> best;
    for (const Path64& path : free) {
      for (const Point64& p : path) {
        if (!best || p.x < best->x || (p.x == best->x && p.y < best->y)) {
          best = p;
        }
      }
    }
    if (!best) {
      return std::nullopt;
    }
    placed_.emplace_back(shape, *best);
    return Point{grid_.from_grid(best->x), grid_.from_grid(best->y)};
  }

 private:
  // MinkowskiSum sums outlines: what they enclose is filled by a translate of each polygon.
  const Paths64& no_fit(std::size_t fixed, std::size_t moving) {
    const auto [at, is_new] = no_fits_.try_emplace({fixed, moving});
    if (is_new || !keeps_) {
      const Path64& p = shapes_[fixed];
      const Path64& q = reflected_[moving];
      Paths64 paths = Clipper2Lib::MinkowskiSum(p, q, true);
      paths.push_back(Clipper2Lib::TranslatePath(p, q[0].x, q[0].y));
      paths.push_back(Clipper2Lib::TranslatePath(q, p[0].x, p[0].y));
      at->second = Clipper2Lib::Union(paths, Clipper2Lib::FillRule::NonZero);
    }
    return at->second;
  }

  bool keeps_;
  Grid grid_;
  std::int64_t length_;
  std::int64_t height_;
  std::vector<Path64> shapes_;
  std::vector<Path64> reflected_;
  std::map<std::pair<std::size_t, std::size_t>, Paths64> no_fits_;
  std::vector<std::pair<std::size_t, Point64>> placed_;
};

}  // namespace

std::unique_ptr<Nester> clipper2_nester(const NestingJob& job, NoFits no_fits) {
  return std::make_unique<Clipper2Nester>(job, no_fits);
}

}  // namespace gcv::bench
