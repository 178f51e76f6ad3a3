# SPDX-License-Identifier: LGPL-3.0-or-later
#
# For Windows on x86-64, by Debian's g++-mingw-w64-x86-64-posix. The libraries of the compiler are
# linked statically, so that what is built needs only Windows. wine runs it where it is installed.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)

# Boost, of which the headers suffice, in a folder without those of this machine's C library.
set(boost ${CMAKE_BINARY_DIR}/boost)
file(MAKE_DIRECTORY ${boost}/include)
file(CREATE_LINK /usr/include/boost ${boost}/include/boost SYMBOLIC)
set(Boost_NO_BOOST_CMAKE ON)

set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 ${boost})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

find_program(GCV_WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(GCV_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${GCV_WINE})
endif()
