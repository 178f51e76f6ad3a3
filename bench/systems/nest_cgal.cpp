// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <map>

#include "cgal.hpp"
#include "nest.hpp"

namespace gcv::bench {

namespace {

using CgalRegion = CGAL::Polygon_with_holes_2<Kernel>;

CgalRegion moved(const CgalRegion& region, const Point& by) {
  const Kernel::Aff_transformation_2 move(CGAL::TRANSLATION, Kernel::Vector_2(by.x, by.y));
  CgalRegion result(CGAL::transform(move, region.outer_boundary()));
  for (const CgalPolygon& hole : region.holes()) {
    result.add_hole(CGAL::transform(move, hole));
  }
  return result;
}

class CgalNester : public Nester {
 public:
  CgalNester(const NestingJob& job, NoFits no_fits) : job_(job), keeps_(no_fits == NoFits::kept) {
    for (const Ring& shape : job.shapes) {
      shapes_.push_back(to_cgal(shape));
      reflected_.push_back(
          CGAL::transform(Kernel::Aff_transformation_2(CGAL::SCALING, -1), shapes_.back()));
    }
  }

  std::optional<Point> place(std::size_t shape) override {
    const CGAL::Bbox_2 box = shapes_[shape].bbox();  // of doubles, so exact
    const Kernel::FT left = -Kernel::FT(box.xmin());
    const Kernel::FT right = Kernel::FT(job_.length) - box.xmax();
    const Kernel::FT bottom = -Kernel::FT(box.ymin());
    const Kernel::FT top = Kernel::FT(job_.height) - box.ymax();
    if (top <= bottom || right <= left) {
      return std::nullopt;
    }
    CgalPolygon fit;
    fit.push_back({left, bottom});
    fit.push_back({right, bottom});
    fit.push_back({right, top});
    fit.push_back({left, top});

    std::vector<CgalRegion> no_fits;
    for (const auto& [other, position] : placed_) {
      no_fits.push_back(moved(no_fit(other, shape), position));
    }
    std::vector<CgalRegion> covered;
    CGAL::join(no_fits.begin(), no_fits.end(), std::back_inserter(covered));
    std::vector<CgalRegion> free{CgalRegion(fit)};
    for (const CgalRegion& one : covered) {
      std::vector<CgalRegion> rest;
      for (const CgalRegion& part : free) {
        CGAL::difference(part, one, std::back_inserter(rest));
      }
      free = std::move(rest);
    }

    const Kernel::Point_2* best = nullptr;
    for (const CgalRegion& part : free) {
      for (const Kernel::Point_2& p : part.outer_boundary().container()) {
        if (best == nullptr || CGAL::lexicographically_xy_smaller(p, *best)) {
          best = &p;
        }
      }
    }
    if (best == nullptr) {
      return std::nullopt;
    }
    const Point position{CGAL::to_double(best->x()), CGAL::to_double(best->y())};
    placed_.emplace_back(shape, position);
    return position;
  }

 private:
  const CgalRegion& no_fit(std::size_t fixed, std::size_t moving) {
    const auto [at, is_new] = no_fits_.try_emplace({fixed, moving});
    if (is_new || !keeps_) {
      at->second = CGAL::minkowski_sum_by_reduced_convolution_2(shapes_[fixed], reflected_[moving]);
    }
    return at->second;
  }

  const NestingJob& job_;
  bool keeps_;
  std::vector<CgalPolygon> shapes_;
  std::vector<CgalPolygon> reflected_;
  std::map<std::pair<std::size_t, std::size_t>, CgalRegion> no_fits_;
  std::vector<std::pair<std::size_t, Point>> placed_;
};

}  // namespace

std::unique_ptr<Nester> cgal_nester(const NestingJob& job, NoFits no_fits) {
  return std::make_unique<CgalNester>(job, no_fits);
}

}  // namespace gcv::bench
