# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What tests need and a machine may lack. A warning names the tool and its package, and the
# summary of ctest lists the tests that need it as disabled. tests/run insists on every tool.
option(GCV_REQUIRE_TOOLS "Treat a missing tool of the tests as an error" OFF)

# Where packages of Python come from.
set(GCV_BY_PIP "by pip, perhaps in a virtual environment: -DGCV_VENV=<folder>")

# gcv_disable_tests(TOOL PACKAGE TEST...): tests of this folder that TOOL is missing for. Those that
# are not there, since they could not be built, are added.
function(gcv_disable_tests tool package)
  string(JOIN " " tests ${ARGN})
  set(text "${tool} not found (${package}), for the tests ${tests}")
  if(GCV_REQUIRE_TOOLS)
    message(FATAL_ERROR "${text}")
  endif()
  message(WARNING "${text}: disabled")
  foreach(test IN LISTS ARGN)
    if(NOT TEST ${test})
      add_test(NAME ${test} COMMAND ${CMAKE_COMMAND} -E false)
    endif()
    set_tests_properties(${test} PROPERTIES DISABLED ON)
  endforeach()
endfunction()
