// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What every call of the C interface has in common.

use std::ffi::CStr;
use std::os::raw::c_char;
use std::ptr::{self, NonNull};

use gcv_sys as sys;

use crate::handle::{Handle, Made, Owned};
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
fn last_error_message() -> String {
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

/// The handle that a function gives through an output argument, with one owner.
pub(crate) fn create_owned<T: Made>(
    call: impl FnOnce(*mut *mut T) -> i32,
) -> Result<Owned<T>, Error> {
    let mut out = ptr::null_mut();
    check(call(&mut out))?;
    let out = NonNull::new(out).expect("libgcv gives a handle where it succeeds");
    // SAFETY: the library has just made it, for the caller.
    Ok(unsafe { Owned::own(out) })
}

/// The handle that a function gives through an output argument, to be shared.
pub(crate) fn create<T: Made>(call: impl FnOnce(*mut *mut T) -> i32) -> Result<Handle<T>, Error> {
    create_owned(call).map(Handle::from)
}

/// What a function gives that makes many: `count` handles, or the status where there is none.
/// The library's message is about the first of those, by its `name` and number; those of the
/// others are only that and the status. Where the call as a whole fails, each has its error.
pub(crate) fn create_many<T: Made>(
    count: usize,
    name: &str,
    call: impl FnOnce(*mut *mut T, *mut i32) -> i32,
) -> Vec<Result<Handle<T>, Error>> {
    let mut made = vec![ptr::null_mut(); count];
    let mut statuses = vec![sys::GCV_OK; count];
    if let Err(error) = check(call(made.as_mut_ptr(), statuses.as_mut_ptr())) {
        return vec![Err(error); count];
    }
    let mut first_message = Some(last_error_message());
    let mut results = Vec::with_capacity(count);
    for (index, (pointer, status)) in made.into_iter().zip(statuses).enumerate() {
        results.push(match NonNull::new(pointer) {
            // SAFETY: the library has just made it, for the caller.
            Some(pointer) => Ok(unsafe { Owned::own(pointer) }.into()),
            None => {
                let message = first_message.take();
                let message =
                    message.unwrap_or_else(|| format!("{name} {index}: {}", status_name(status)));
                Err(Error { status, message })
            }
        });
    }
    results
}

/// The number of elements that a function writes to a buffer.
pub(crate) fn count<T>(call: impl Fn(*mut T, usize, *mut usize) -> i32) -> usize {
    let mut count = 0;
    check(call(ptr::null_mut(), 0, &mut count)).expect(INFALLIBLE);
    count
}

/// What a function writes to a buffer: asks for the number of elements, then for them.
pub(crate) fn elements<T>(call: impl Fn(*mut T, usize, *mut usize) -> i32) -> Vec<T>
where
    T: Clone + Default,
{
    let mut count = count(&call);
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
