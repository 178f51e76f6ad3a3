// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What every call of the C interface has in common.

use std::ffi::CStr;
use std::os::raw::c_char;
use std::ptr::{self, NonNull};

use gcv_sys as sys;

use crate::Error;

pub(crate) const INFALLIBLE: &str = "libgcv fails here only for want of memory";

/// Turns a status into a result, with the message of the thread that got it.
pub(crate) fn check(status: i32) -> Result<(), Error> {
    if status == sys::GCV_OK {
        return Ok(());
    }
    let message = last_error_message();
    Err(Error { status, message })
}

/// What the last failure on this thread was about.
pub(crate) fn last_error_message() -> String {
    // SAFETY: the message stays until the next failure on this thread.
    unsafe { text(sys::gcv_last_error_message()) }
}

/// The name of a status.
pub(crate) fn status_name(status: i32) -> String {
    // SAFETY: the function takes any value and gives a text that stays.
    unsafe { text(sys::gcv_status_name(status)) }
}

/// Copies a text of the library.
///
/// # Safety
/// `text` ends in a NUL and does not change during the call.
pub(crate) unsafe fn text(text: *const c_char) -> String {
    CStr::from_ptr(text).to_string_lossy().into_owned()
}

/// What a function gives through an output argument.
pub(crate) fn value<T: Default>(call: impl FnOnce(*mut T) -> i32) -> Result<T, Error> {
    let mut out = T::default();
    check(call(&mut out)).map(|()| out)
}

/// The handle that a function gives through an output argument.
pub(crate) fn create<T>(call: impl FnOnce(*mut *mut T) -> i32) -> Result<NonNull<T>, Error> {
    let mut out = ptr::null_mut();
    check(call(&mut out))?;
    Ok(NonNull::new(out).expect("libgcv gives a handle where it succeeds"))
}

/// What a function writes to a buffer: asks for the number of elements, then for them.
pub(crate) fn elements<T>(call: impl Fn(*mut T, usize, *mut usize) -> i32) -> Vec<T>
where
    T: Clone + Default,
{
    let mut count = 0;
    check(call(ptr::null_mut(), 0, &mut count)).expect(INFALLIBLE);
    let mut out = vec![T::default(); count];
    check(call(out.as_mut_ptr(), count, &mut count)).expect(INFALLIBLE);
    out
}

/// What a function writes to a buffer as a text with a final NUL.
pub(crate) fn string(call: impl Fn(*mut c_char, usize, *mut usize) -> i32) -> String {
    let bytes = elements(|out: *mut u8, capacity, required| call(out.cast(), capacity, required));
    let end = bytes.len() - 1;
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}
