/*
 * gcv.hpp - the interface of gcv.h for C++, header-only.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * C++17 and later. Nothing here is part of the library: all of it is compiled into the program
 * that uses it, and calls the functions of gcv.h, which say what each of them computes.
 *
 * Objects own what the library made: they are moved, not copied, and end it in their destructors.
 * An object that was moved from is empty, and so is a gcv::Polygon() of nothing: to use it throws,
 * with GCV_ERR_NULL_ARGUMENT. Polygons, outer faces, regions and lists never change, and threads
 * may share them. A scene is changed by its functions without const, by one thread at a time.
 *
 * A call that fails throws gcv::Error with the status and the message of the library. Where there
 * is no memory, std::bad_alloc can be thrown too. What a progress function throws comes out of
 * the call that it has ended.
 *
 * Vertices come in as anything with data() and size(), such as a std::vector<gcv::Point>, as a
 * pointer and a size, or in braces. They come out as a std::vector, or go to the caller's memory.
 */
#ifndef GCV_GCV_HPP
#define GCV_GCV_HPP

#if __cplusplus < 201703L && (!defined(_MSVC_LANG) || _MSVC_LANG < 201703L)
#error "gcv.hpp needs C++17"
#else
#include <gcv/hpp/offset.hpp>
#include <gcv/hpp/outer_face.hpp>
#include <gcv/hpp/polygon.hpp>
#include <gcv/hpp/region.hpp>
#include <gcv/hpp/scene.hpp>
#include <gcv/hpp/sums.hpp>
#include <gcv/hpp/two_polygons.hpp>
#endif

#endif
