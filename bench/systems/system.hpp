// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compared: ways from two arrays of doubles to the outer face in doubles.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

using Ring = PointVector;

// What is known of the last run beside its result; 0 where a system does not tell.
struct Observation {
  std::size_t exact_vertices = 0;  // of the exact ring, without collinear ones
  std::size_t superset_edges = 0;
  double superset_seconds = 0;  // what it takes to find them
  double error_bound = 0;       // of the result by the system's own account, in input units
};

// run is what is timed: all that a caller has to pay for one sum, to the vertices in his
// own memory. Throws where there is no sum.
struct Job {
  std::function<Ring()> run;
  std::function<Observation()> observe = [] { return Observation{}; };
};

enum class Role {
  libgcv,          // runs on everything
  principal_peer,  // runs on all sets
  peer,            // runs on the sets that are for all peers
};

using Prepare = std::function<Job(const Ring& a, const Ring& b)>;

struct System {
  std::string name;
  Role role;
  double most_vertex_pairs;  // not tried on polygons of n and m vertices beyond n m
  Prepare prepare;
};

// All systems of this build.
std::vector<System> systems();

// Of gcv_options.
struct Precision {
  bool outward = false;
  double tolerance = 0;  // in input units
};

// libgcv through its C interface, from the shared library in that file: with both polygons
// made anew for each sum, or with their handles at hand, simplified where there is a tolerance.
Prepare libgcv_cold(const char* library, Precision precision = {});
Prepare libgcv_prepared(const char* library, Precision precision = {});

// CGAL with its exact kernel; the result is converted to doubles.
Job cgal_reduced_convolution(const Ring& a, const Ring& b);
Job cgal_full_convolution(const Ring& a, const Ring& b);
Job cgal_decomposition(const Ring& a, const Ring& b);

// The paper's way 2: the unbounded face of CGAL's arrangement of a superset. GCVMSOF takes
// the superset of the paper; RCMSOF the reduced convolution, which is the same without
// merged edges.
Job gcv_arrangement(const Ring& a, const Ring& b);
Job reduced_convolution_arrangement(const Ring& a, const Ring& b);

// SFCGAL through its C interface, which is exact too; the result is converted to doubles.
Job sfcgal(const Ring& a, const Ring& b);

// Unions of parallelograms, on integer grids. They throw where the grid is too fine for
// their integers.
Job boost_polygon(const Ring& a, const Ring& b, double cells_per_unit);
Job clipper(const Ring& a, const Ring& b, double cells_per_unit);
Job clipper2(const Ring& a, const Ring& b, double cells_per_unit);

// The finest grid of a power of two on which all of the sum is within 2^bits.
double cells_per_unit(const Ring& a, const Ring& b, int bits);

}  // namespace gcv::bench
