# SPDX-License-Identifier: LGPL-3.0-or-later
#
# find_package(gcv): the targets gcv::gcv (shared) and gcv::gcv_static.
include("${CMAKE_CURRENT_LIST_DIR}/gcv-targets.cmake")
if(MSVC)
  # The package for Windows has an import library for Microsoft's linker beside that of mingw-w64.
  set_target_properties(gcv::gcv PROPERTIES
                        IMPORTED_IMPLIB_RELEASE "${CMAKE_CURRENT_LIST_DIR}/../../gcv.lib")
endif()
