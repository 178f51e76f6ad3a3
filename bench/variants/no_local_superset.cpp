// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of local_superset.cpp: nothing is kept from step to step, so that every step
// searches the implicit superset from the roots of its trees.
#include "local_superset.hpp"

namespace gcv {

LocalSuperset::LocalSuperset(const ImplicitSuperset& superset, double slack)
    : superset_(superset), slack_(slack), reach_(0), window_{0, 0, 0, 0} {}

bool LocalSuperset::gather(const Point&, const Point&, PairsMet*) { return false; }

}  // namespace gcv
