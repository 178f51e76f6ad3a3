# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The sections of gcv.h as groups of Doxygen, and the comment at its start as that of the file. What is
# said of exactness, cost, threads and version is a paragraph of its own.
1s|^/\*$|/** @file|
/^ \* (gcv\.h - |Copyright|SPDX)/d
s|^/\* -+ status -- \*/$|/** @defgroup status */ /** @{ */|
s|^/\* -+ (.+) -- \*/$|/** @} */ /** @defgroup \1 */ /** @{ */|
s|@defgroup ([a-z]+) ([a-z]+)|@defgroup \1_\2|
s|@defgroup ([a-z_]+)|& \1|
$a /** @} */
s#^ \* ((Exactness|Cost|Threads)[:,])# * @par \\ilinebr \1#
s|@since ([0-9.]+)|Since version \1.|
