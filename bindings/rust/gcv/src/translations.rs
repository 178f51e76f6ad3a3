// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What functions of many translations have in common.

use gcv_sys as sys;

use crate::Error;

/// The number of translations, if there are as many of what else there is one of for each.
pub(crate) fn check_length<T>(
    translations: &[[f64; 2]],
    others: &[T],
    name: &str,
) -> Result<usize, Error> {
    let (count, other_count) = (translations.len(), others.len());
    if other_count == count {
        return Ok(count);
    }
    Err(Error {
        status: sys::GCV_ERR_INVALID_ARGUMENT,
        message: format!("{name}: the length is {other_count}, that of translations is {count}"),
    })
}
