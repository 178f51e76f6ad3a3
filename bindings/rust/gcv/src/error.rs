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

/// What a failed call came to, for `match`: [`Error::kind`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// An argument has a value that it cannot have.
    InvalidArgument,
    /// A coordinate of the input is a NaN or an infinity.
    NotFinite,
    /// A polygon without area.
    Degenerate,
    /// Rings that cross, overlap, or lie where they may not.
    NotSimple,
    /// The result cannot be given in finite `f64`.
    Range,
    /// The text is not what it should be.
    Parse,
    /// There is not enough memory.
    NoMemory,
    /// The progress function ended the computation.
    Cancelled,
    /// A defect of libgcv; please report it with the input.
    Internal,
    /// What a later version of the library adds; see [`Error::status`].
    Unknown,
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
    /// The status as an enum.
    ///
    /// ```
    /// use gcv::{ErrorKind, Polygon};
    ///
    /// let error = Polygon::new(&[[0., 0.], [1., 1.]]).unwrap_err();
    /// assert_eq!(error.kind(), ErrorKind::Degenerate);
    /// ```
    pub fn kind(&self) -> ErrorKind {
        match self.status {
            status::GCV_ERR_INVALID_ARGUMENT => ErrorKind::InvalidArgument,
            status::GCV_ERR_NOT_FINITE => ErrorKind::NotFinite,
            status::GCV_ERR_DEGENERATE => ErrorKind::Degenerate,
            status::GCV_ERR_NOT_SIMPLE => ErrorKind::NotSimple,
            status::GCV_ERR_RANGE => ErrorKind::Range,
            status::GCV_ERR_PARSE => ErrorKind::Parse,
            status::GCV_ERR_NO_MEMORY => ErrorKind::NoMemory,
            status::GCV_ERR_CANCELLED => ErrorKind::Cancelled,
            status::GCV_ERR_INTERNAL => ErrorKind::Internal,
            _ => ErrorKind::Unknown,
        }
    }

    /// The same error, whose message begins with the name that the argument has in Rust.
    pub(crate) fn renamed(mut self, name: &str, name_here: &str) -> Self {
        if let Some(rest) = self.message.strip_prefix(name) {
            self.message = format!("{name_here}{rest}");
        }
        self
    }

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
