// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pairs of polygons that between them take every way through the library, and all that its
// getters say of a handle, byte by byte.
#pragma once

#include <gcv/gcv.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gcv::faults {

struct Destroy {
  void operator()(gcv_polygon* polygon) const { gcv_polygon_destroy(polygon); }
  void operator()(gcv_outer_face* face) const { gcv_outer_face_destroy(face); }
  void operator()(gcv_superset* superset) const { gcv_superset_destroy(superset); }
  void operator()(gcv_region* region) const { gcv_region_destroy(region); }
  void operator()(gcv_contact_list* list) const { gcv_contact_list_destroy(list); }
  void operator()(gcv_pair_list* list) const { gcv_pair_list_destroy(list); }
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
};

template <class Handle>
using Owner = std::unique_ptr<Handle, Destroy>;

inline void check(bool holds, std::string_view subject, const char* failure = "") {
  if (!holds) {
    std::fprintf(stderr, "%.*s%s\n  last error: \"%s\"\n", static_cast<int>(subject.size()),
                 subject.data(), failure, gcv_last_error_message());
    std::exit(1);
  }
}

inline void require(gcv_status status) {
  check(status == GCV_OK, "a call gave ", gcv_status_name(status));
}

// ----------------------------------------------------------------------------- pairs --

inline Owner<gcv_polygon> read(std::string_view text) {
  gcv_polygon* polygon = nullptr;
  require(gcv_polygon_create_wkt(text.data(), text.size(), &polygon));
  return Owner<gcv_polygon>(polygon);
}

struct Pair {
  const char* name;
  Owner<gcv_polygon> a;
  Owner<gcv_polygon> b;
  double tolerance;  // within which there are vertices to leave out
};

// The second is a slot and a tooth that fits, turned by an angle: rounding alone would make
// the walls of the slit cross. The last is beyond the integers of 512 bits.
inline std::vector<Pair> pairs() {
  std::vector<Pair> pairs;
  pairs.push_back({"integers", read("POLYGON ((0 0, 4 4, 2 3, 0 4))"),
                   read("POLYGON ((0 0, 3 3, 1 2, 0 2))"), 4});
  pairs.push_back(
      {"rotated slot",
       read("POLYGON ((0 0, 6.7823869519745132 1.7318277147816605, 4.8031552779383295 "
            "9.4831270884668193, 2.8653304345170403 8.9883191699577729, 4.5971581492987008 "
            "2.2059322179832592, 2.6593333058774116 1.7111242994742135, 0.92750559109575081 "
            "8.4935112514487265, -1.9792316740361835 7.7512993736851579))"),
       read("POLYGON ((0 0, 1.9378248434212895 0.49480791850904587, 0.4534010878941519 "
            "6.3082824487729141, -1.4844237555271376 5.8134745302638686))"),
       4});
  pairs.push_back({"convex", read("POLYGON ((0 0, 0.1 0, 0.2 0.1, 0.1 0.3))"),
                   read("POLYGON ((0 0, 0.7 0, 0.7 0.1, 0 0.1))"), 1});
  pairs.push_back({"holes",
                   read("POLYGON ((0 0, 12 0, 12 7, 6 6.9, 0 7), (1 1, 5 1, 5 5, 1 4), "
                        "(7 2, 9 2, 9 4, 7 4))"),
                   read("POLYGON ((0 0, 2 0, 2 2, 0 2))"), 1});
  pairs.push_back({"all magnitudes",
                   read("POLYGON ((-1e100 1e-300, 3 -1e-310, 1e17 1, 5e15 1e30))"),
                   read("POLYGON ((0 0, 1e-200 1e-200, 1 1e-308, 1e9 1e-9, 0.1 1e5))"), 1e10});
  return pairs;
}

inline gcv_options options(std::int32_t rounding, double tolerance = 0) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = rounding;
  options.tolerance = tolerance;
  return options;
}

inline gcv_stats stats(const gcv_outer_face* face) {
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  require(gcv_outer_face_stats(face, &stats));
  return stats;
}

inline gcv_stats stats(const gcv_region* region) {
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  require(gcv_region_stats(region, &stats));
  return stats;
}

// ----------------------------------------------------------------------- transcripts --

template <class Number>
void append(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class Handle, class Number>
void append(std::string& bytes, gcv_status (*get)(const Handle*, Number*), const Handle* handle) {
  Number number{};
  require(get(handle, &number));
  append(bytes, number);
}

inline void append(std::string& bytes, const gcv_stats& s) {
  append(bytes, s.walk_steps);
  append(bytes, s.candidate_edges);
  append(bytes, s.predicates_filtered);
  append(bytes, s.predicates_fixed_width);
  append(bytes, s.predicates_rational);
  append(bytes, s.vertices_repaired);
  append(bytes, s.parts_dropped);
}

// get(out, capacity, &required) fills a buffer.
template <class Element, class Get>
void append_elements(std::string& bytes, Get get) {
  std::size_t count = 0;
  require(get(static_cast<Element*>(nullptr), std::size_t{0}, &count));
  std::vector<Element> elements(count);
  require(get(elements.data(), count, &count));
  bytes.append(reinterpret_cast<const char*>(elements.data()), count * sizeof(Element));
}

struct Vertex {
  double x;
  double y;
};

inline std::string transcript(const gcv_polygon* polygon) {
  std::string bytes;
  double bounds[4];
  require(gcv_polygon_bounds(polygon, bounds));
  append(bytes, bounds);
  append(bytes, gcv_polygon_vertex_count, polygon);
  append(bytes, gcv_polygon_area, polygon);
  append_elements<Vertex>(bytes, [&](Vertex* out, std::size_t capacity, std::size_t* required) {
    return gcv_polygon_vertices(polygon, reinterpret_cast<double*>(out), capacity, required);
  });
  std::size_t rings = 0;
  require(gcv_polygon_ring_count(polygon, &rings));
  for (std::size_t k = 0; k < rings; ++k) {
    append_elements<Vertex>(bytes, [&](Vertex* out, std::size_t capacity, std::size_t* required) {
      return gcv_polygon_ring(polygon, k, reinterpret_cast<double*>(out), capacity, required);
    });
  }
  return bytes;
}

inline std::string transcript(const gcv_outer_face* face) {
  std::string bytes;
  append(bytes, gcv_outer_face_vertex_count, face);
  append(bytes, gcv_outer_face_error_bound, face);
  append(bytes, gcv_outer_face_area, face);
  append_elements<Vertex>(bytes, [&](Vertex* out, std::size_t capacity, std::size_t* required) {
    return gcv_outer_face_vertices(face, reinterpret_cast<double*>(out), capacity, required);
  });
  append_elements<gcv_edge_source>(
      bytes, [&](gcv_edge_source* out, std::size_t capacity, std::size_t* required) {
        return gcv_outer_face_edge_sources(face, out, capacity, required);
      });
  append_elements<char>(bytes, [&](char* out, std::size_t capacity, std::size_t* required) {
    return gcv_outer_face_wkt(face, out, capacity, required);
  });
  std::size_t count = 0;
  require(gcv_outer_face_exact_vertex_count(face, &count));
  for (std::size_t k = 0; k < count; ++k) {
    append_elements<char>(bytes, [&](char* out, std::size_t capacity, std::size_t* required) {
      return gcv_outer_face_exact_vertex(face, k, out, capacity, required);
    });
  }
  append_elements<std::uint64_t>(
      bytes, [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
        return gcv_outer_face_exact_indices(face, out, capacity, required);
      });
  append(bytes, stats(face));
  return bytes;
}

inline std::string transcript(const gcv_region* region) {
  std::string bytes;
  append(bytes, gcv_region_error_bound, region);
  append(bytes, gcv_region_area, region);
  append_elements<Vertex>(bytes, [&](Vertex* out, std::size_t capacity, std::size_t* required) {
    return gcv_region_vertices(region, reinterpret_cast<double*>(out), capacity, required);
  });
  for (const auto parts : {gcv_region_parts, gcv_region_exact_parts}) {
    append_elements<gcv_region_part>(
        bytes, [&](gcv_region_part* out, std::size_t capacity, std::size_t* required) {
          return parts(region, out, capacity, required);
        });
  }
  append_elements<gcv_edge_source>(
      bytes, [&](gcv_edge_source* out, std::size_t capacity, std::size_t* required) {
        return gcv_region_edge_sources(region, out, capacity, required);
      });
  for (const auto numbers : {gcv_region_exact_indices, gcv_region_edge_owners}) {
    append_elements<std::uint64_t>(
        bytes, [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
          return numbers(region, out, capacity, required);
        });
  }
  for (const auto text : {gcv_region_wkt, gcv_region_fits_wkt}) {
    append_elements<char>(bytes, [&](char* out, std::size_t capacity, std::size_t* required) {
      return text(region, out, capacity, required);
    });
  }
  append(bytes, stats(region));
  return bytes;
}

inline std::string transcript(const gcv_superset* superset) {
  std::string bytes;
  std::size_t count = 0;
  require(gcv_superset_edges(superset, nullptr, 0, &count));
  std::vector<gcv_superset_edge> edges(count);
  require(gcv_superset_edges(superset, edges.data(), count, &count));
  for (const gcv_superset_edge& edge : edges) {
    append(bytes, Vertex{edge.x0, edge.y0});
    append(bytes, Vertex{edge.x1, edge.y1});
    append(bytes, edge.source);
  }
  return bytes;
}

inline std::string transcript(const gcv_contact_list* list) {
  std::string bytes;
  append_elements<gcv_contact>(bytes,
                               [&](gcv_contact* out, std::size_t capacity, std::size_t* required) {
                                 return gcv_contact_list_contacts(list, out, capacity, required);
                               });
  append_elements<std::uint64_t>(
      bytes, [&](std::uint64_t* out, std::size_t capacity, std::size_t* required) {
        return gcv_contact_list_previous(list, out, capacity, required);
      });
  return bytes;
}

inline std::string transcript(const gcv_pair_list* list) {
  std::string bytes;
  append_elements<gcv_pair>(bytes, [&](gcv_pair* out, std::size_t capacity, std::size_t* required) {
    return gcv_pair_list_pairs(list, out, capacity, required);
  });
  return bytes;
}

// A call without faults: what it gives.
template <class Handle, class Call>
Owner<Handle> made(Call call) {
  Handle* out = nullptr;
  require(call(&out));
  return Owner<Handle>(out);
}

}  // namespace gcv::faults
