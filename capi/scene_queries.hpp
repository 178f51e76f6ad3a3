// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Reads and checks gcv_query of any version.
#pragma once

#include "gcv/gcv.h"
#include "query.hpp"

namespace gcv::capi {

// Takes a struct of any version, or NULL for all solids. Throws Error: invalid_argument,
// null_argument.
Query read_query(const gcv_query* query);

}  // namespace gcv::capi
