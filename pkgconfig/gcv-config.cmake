# SPDX-License-Identifier: LGPL-3.0-or-later
#
# find_package(gcv): the targets gcv::gcv (shared) and gcv::gcv_static.
include("${CMAKE_CURRENT_LIST_DIR}/gcv-targets.cmake")
