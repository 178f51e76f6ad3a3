# SPDX-License-Identifier: LGPL-3.0-or-later
#
# A toolchain file that lets the compiler take half of the time, for tests of the ways in which others
# build the library, not of what it does.
foreach(type IN ITEMS RELEASE DEBUG)
  set(CMAKE_CXX_FLAGS_${type} -O0 CACHE STRING "Not optimised")
endforeach()
