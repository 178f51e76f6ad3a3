// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_nesting [LIMIT [NAME...]]
//
// Bottom-left layouts of nesting instances: parts go into a strip one after another, the largest
// first, unturned, each to the lexicographically smallest of its free positions. Prints two tables
// in Markdown, times and layouts: libgcv beside CGAL and Clipper2. A peer stops after LIMIT seconds
// of a layout, 10 by default, and is compared with libgcv's time for as many parts. Exit status 1
// if a part that libgcv has placed overlaps anything.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "data.hpp"
#include "nesting_data.hpp"
#include "region/turns.hpp"
#include "systems/nest.hpp"
#include "text.hpp"

namespace gcv::bench {
namespace {

// ---- Instances

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / 2;
}

struct Box {
  double width, height;
};

Box box_of(const Ring& ring) {
  const auto [left, right] = std::minmax_element(
      ring.begin(), ring.end(), [](const Point& p, const Point& q) { return p.x < q.x; });
  const auto [bottom, top] = std::minmax_element(
      ring.begin(), ring.end(), [](const Point& p, const Point& q) { return p.y < q.y; });
  return {right->x - left->x, top->y - bottom->y};
}

// Counter-clockwise, no vertex repeated in a row.
Ring cleaned(Ring ring) {
  const auto is_same = [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; };
  ring.erase(std::unique(ring.begin(), ring.end(), is_same), ring.end());
  if (is_same(ring.front(), ring.back())) {
    ring.pop_back();
  }
  if (signed_area(ring) < 0) {
    std::reverse(ring.begin(), ring.end());
  }
  return ring;
}

// The strip is so long that all parts fit in one after another.
NestingJob job_of(const std::string& name, double height, const std::vector<Ring>& shapes,
                  const std::vector<std::size_t>& quantities) {
  NestingJob job{name, 0, height, {}, {}};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    job.shapes.push_back(cleaned(shapes[k]));
    job.order.insert(job.order.end(), quantities[k], k);
    job.length += static_cast<double>(quantities[k] + 1) * box_of(shapes[k]).width;
  }
  std::stable_sort(job.order.begin(), job.order.end(), [&](std::size_t i, std::size_t j) {
    return signed_area(job.shapes[i]) > signed_area(job.shapes[j]);
  });
  return job;
}

// Those with a strip, then two of them with many times the parts, then larger ones without: theirs
// is twice as high as the highest part.
std::vector<NestingJob> jobs_in(const std::filesystem::path& directory) {
  std::vector<NestingJob> jobs;
  for (const test::NestingInstance& instance : test::read_nesting_instances(directory)) {
    jobs.push_back(
        job_of(instance.name, box_of(instance.board).height, instance.pieces, instance.quantities));
  }
  constexpr std::size_t times = 4;
  for (const test::NestingInstance& instance : test::read_nesting_instances(directory)) {
    if (instance.name == "Shapes0" || instance.name == "Shirts") {
      std::vector<std::size_t> quantities = instance.quantities;
      for (std::size_t& quantity : quantities) {
        quantity *= times;
      }
      jobs.push_back(job_of(instance.name + " x " + std::to_string(times),
                            box_of(instance.board).height, instance.pieces, quantities));
    }
  }
  for (const std::string name : {"gardeyn1", "gardeyn2", "gardeyn3", "gardeyn6"}) {
    std::map<int, Ring> parts;
    for (const auto& entry : std::filesystem::directory_iterator(directory / "nesting")) {
      const std::string stem = entry.path().stem().string();
      if (stem.rfind(name + "_", 0) == 0) {
        parts[std::stoi(stem.substr(name.size() + 1))] = test::read_polygon(entry.path());
      }
    }
    std::vector<Ring> shapes;
    double height = 0;
    for (const auto& [number, ring] : parts) {
      shapes.push_back(ring);
      height = std::max(height, 2 * box_of(ring).height);
    }
    jobs.push_back(job_of("~" + name, height, shapes, std::vector<std::size_t>(shapes.size(), 1)));
  }
  jobs.erase(std::remove_if(jobs.begin(), jobs.end(),
                            [](const NestingJob& job) { return job.order.size() < 8; }),
             jobs.end());
  return jobs;
}

// ---- Layouts

struct System {
  const char* name;
  std::function<std::unique_ptr<Nester>(const NestingJob&)> make;
  bool is_peer = true;
  bool is_counted = true;  // else its layout is that of another one
};

std::function<std::unique_ptr<Nester>(const NestingJob&)> with(
    std::unique_ptr<Nester> (*make)(const NestingJob&, NoFits), NoFits no_fits) {
  return [=](const NestingJob& job) { return make(job, no_fits); };
}

const std::vector<System>& all_systems() {
  static const std::vector<System> systems{
      {"best", libgcv_best_nester, false},
      {"region", libgcv_region_nester, false},
#ifdef GCV_BENCH_CLIPPER2
      {"Clipper2", with(clipper2_nester, NoFits::kept)},
#endif
      {"CGAL", with(cgal_nester, NoFits::kept)},
#ifdef GCV_BENCH_CLIPPER2
      {"Clipper2 anew", with(clipper2_nester, NoFits::anew), true, false},
#endif
      {"CGAL anew", with(cgal_nester, NoFits::anew), true, false}};
  return systems;
}

struct Layout {
  std::vector<std::optional<Point>> positions;
  std::vector<double> seconds;  // from the beginning to after each part

  [[nodiscard]] std::size_t size() const { return positions.size(); }
};

// Of this thread on its processor, whatever others have had of it.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Layout layout_of(const System& system, const NestingJob& job, double limit) {
  Layout layout;
  const double begin = processor_seconds();
  const auto nester = system.make(job);
  for (const std::size_t shape : job.order) {
    layout.positions.push_back(nester->place(shape));
    layout.seconds.push_back(processor_seconds() - begin);
    if (layout.seconds.back() > limit) {
      break;
    }
  }
  return layout;
}

// Where the last part ends on the right.
double used_length(const NestingJob& job, const Layout& layout) {
  double length = 0;
  for (std::size_t k = 0; k < layout.size(); ++k) {
    for (const Point& p : job.shapes[job.order[k]]) {
      length = layout.positions[k] ? std::max(length, layout.positions[k]->x + p.x) : length;
    }
  }
  return length;
}

// The layouts of all systems in turns: rounds[round][system].
std::vector<std::vector<Layout>> rounds_of(const NestingJob& job, double limit) {
  std::vector<std::vector<Layout>> rounds;
  double longest = 0;
  do {
    std::vector<Layout>& round = rounds.emplace_back();
    for (const System& system : all_systems()) {
      round.push_back(
          layout_of(system, job, system.is_peer ? limit : std::numeric_limits<double>::infinity()));
      longest = std::max(longest, round.back().seconds.back());
    }
  } while (rounds.size() < (longest < 0.5 ? 9U : longest < 5 ? 3U : 1U));
  return rounds;
}

// What the rounds have, where get(round) gives a number of each.
template <class Get>
double median_of(const std::vector<std::vector<Layout>>& rounds, Get get) {
  std::vector<double> values;
  for (const std::vector<Layout>& round : rounds) {
    values.push_back(get(round));
  }
  return median(values);
}

// A line of each table, and whether no part overlaps that libgcv has placed.
struct Lines {
  std::string times;
  std::string layouts;
  bool is_right = true;
};

template <class... Values>
std::string cell(const char* format, Values... values) {
  char text[100];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// Three digits, or all before the point.
std::string number(double x) { return cell(x < 999.5 ? "%.3g" : "%.0f", x); }

Lines measure(const NestingJob& job, double limit) {
  std::size_t vertices = 0;
  for (const std::size_t shape : job.order) {
    vertices += job.shapes[shape].size();
  }
  const auto rounds = rounds_of(job, limit);
  std::string times;
  std::string ratios;
  std::string lengths;
  std::string overlaps;
  Lines lines;
  for (std::size_t k = 0; k < all_systems().size(); ++k) {
    const System& system = all_systems()[k];
    const Layout& layout = rounds.front()[k];
    const bool is_whole = layout.size() == job.order.size();
    const double ms = median_of(
        rounds, [&](const std::vector<Layout>& round) { return 1000 * round[k].seconds.back(); });
    times +=
        is_whole ? ' ' + number(ms) + " |" : " > " + number(ms) + cell(" (%zu) |", layout.size());
    if (k > 0) {
      const double ratio = median_of(rounds, [&](const std::vector<Layout>& round) {
        return round[k].seconds.back() / round[0].seconds[round[k].size() - 1];
      });
      ratios += ' ' + number(ratio) + " |";
    }
    if (system.is_counted) {
      const Overlaps found = count_overlaps(job, layout.positions);
      const auto lost =
          std::count(layout.positions.begin(), layout.positions.end(), std::optional<Point>());
      lengths += is_whole ? cell(" %.6g |", used_length(job, layout)) : " - |";
      overlaps += cell(" %zu", found.all);
      overlaps += is_whole ? "" : cell(" of %zu", layout.size());
      overlaps += found.deep > 0 ? cell(", %zu deep", found.deep) : "";
      overlaps += lost > 0 ? cell(", %td lost |", lost) : " |";
      lines.is_right = lines.is_right && (system.is_peer || (found.all == 0 && lost == 0));
    }
  }
  lines.times = cell("| %s | %zu | %zu |", job.name.c_str(), job.order.size(), vertices) + times +
                ratios + '\n';
  lines.layouts = "| " + job.name + " |" + lengths + overlaps + '\n';
  return lines;
}

// A heading with two columns of each system, but for the second one of the first where it is a
// ratio.
std::string heading(std::string names, const char* first, const char* second,
                    bool is_about_layouts) {
  for (const char* const what : {first, second}) {
    for (const System& system : all_systems()) {
      const bool is_ratio_to_itself =
          !is_about_layouts && what == second && &system == all_systems().data();
      if (!is_ratio_to_itself && (system.is_counted || !is_about_layouts)) {
        names += ' ' + std::string(system.name) + what + " |";
      }
    }
  }
  std::string line = "| ---";
  for (auto bars = std::count(names.begin(), names.end(), '|'); bars > 2; --bars) {
    line += " | ---:";
  }
  return names + '\n' + line + " |\n";
}

int run(double limit, const std::vector<std::string>& names) {
  const auto directory = test::data_directory();
  if (!directory) {
    std::puts("No polygon data: set GCV_DATA_DIR.");
    return 0;
  }
  std::fputs(heading("| instance | parts | vertices |", " ms", " : best", false).c_str(), stdout);
  std::string layouts = heading("| instance |", ", length", ", overlaps", true);
  bool is_right = true;
  for (const NestingJob& job : jobs_in(*directory)) {
    if (names.empty() || contains(names, job.name)) {
      const Lines lines = measure(job, limit);
      std::fputs(lines.times.c_str(), stdout);
      std::fflush(stdout);
      layouts += lines.layouts;
      is_right = is_right && lines.is_right;
    }
  }
  std::printf("\n%s", layouts.c_str());
  if (!is_right) {
    std::puts("\nParts that libgcv has placed overlap.");
  }
  return is_right ? 0 : 1;
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  return gcv::bench::run(argc > 1 ? std::strtod(argv[1], nullptr) : 10,
                         {argv + std::min(argc, 2), argv + argc});
}
