// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;

use crate::call::status_name;

/// What a failed call came to: the values of [`Error::status`](crate::Error::status).
pub mod status {
    pub use gcv_sys::{
        GCV_ERR_CANCELLED, GCV_ERR_DEGENERATE, GCV_ERR_INTERNAL, GCV_ERR_INVALID_ARGUMENT,
        GCV_ERR_NOT_FINITE, GCV_ERR_NOT_SIMPLE, GCV_ERR_NO_MEMORY, GCV_ERR_PARSE, GCV_ERR_RANGE,
    };
}

/// A call that failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// The status, one of [`status`] or one that a later version of the library adds.
    pub status: i32,
    /// What it was about, in one sentence.
    pub message: String,
}

impl Error {
    /// The name of the status, such as `"GCV_ERR_NOT_SIMPLE"`.
    pub fn status_name(&self) -> String {
        status_name(self.status)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Error {}
