// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A vector whose elements, where they are trivial, are left unwritten by its size alone, in place
// of a pass over memory that shows in sums of small polygons: whoever sizes it writes them.
#pragma once

#include <boost/core/noinit_adaptor.hpp>
#include <memory>
#include <vector>

namespace gcv {

template <class T>
using Buffer = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

}  // namespace gcv
