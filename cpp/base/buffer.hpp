// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A vector that does not write trivial elements when it is sized. Who sizes it must write them.
// This saves a pass over memory, which shows in the times of sums of small polygons.
#pragma once

#include <boost/core/noinit_adaptor.hpp>
#include <memory>
#include <vector>

namespace gcv {

template <class T>
using Buffer = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

}  // namespace gcv
