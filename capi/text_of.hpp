// SPDX-License-Identifier: LGPL-3.0-or-later
//
// GCV_TEXT(x) is the value of the macro x as text.
#pragma once

#define GCV_TEXT_OF(x) #x
#define GCV_TEXT(x) GCV_TEXT_OF(x)
