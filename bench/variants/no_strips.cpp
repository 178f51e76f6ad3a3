// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In place of strip.cpp: no strip is ever gathered.
#include "strip.hpp"

namespace gcv {

bool Strip::keep_up(const Point&, PairsMet*) { return false; }

double Strip::room(const Point&, double, double) const { return 0; }

}  // namespace gcv
