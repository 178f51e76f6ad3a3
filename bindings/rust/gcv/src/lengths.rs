// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Slices that are to be as long as one another.

use gcv_sys as sys;

use crate::Error;

/// The number of the first elements, if there are as many of the others. Both have names.
pub(crate) fn same_length<S, T>(
    (first_name, first): (&str, &[S]),
    (other_name, others): (&str, &[T]),
) -> Result<usize, Error> {
    let (count, other_count) = (first.len(), others.len());
    if other_count == count {
        return Ok(count);
    }
    Err(Error {
        status: sys::GCV_ERR_INVALID_ARGUMENT,
        message: format!(
            "{other_name}: the length is {other_count}, that of {first_name} is {count}"
        ),
    })
}
