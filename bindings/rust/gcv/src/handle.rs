// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What the library made, and ends when nothing uses it any more.

use std::ptr::NonNull;
use std::sync::Arc;

use gcv_sys as sys;

/// What the library makes, shares and ends.
pub(crate) trait Made {
    /// Ends it. The pointer is to what is alive and is not used again.
    const DESTROY: unsafe extern "C" fn(*mut Self);
}

impl Made for sys::gcv_polygon {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_polygon_destroy;
}

impl Made for sys::gcv_outer_face {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_outer_face_destroy;
}

impl Made for sys::gcv_region {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_region_destroy;
}

impl Made for sys::gcv_contact_list {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_contact_list_destroy;
}

impl Made for sys::gcv_pair_list {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_pair_list_destroy;
}

impl Made for sys::gcv_scene {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_scene_destroy;
}

impl Made for sys::gcv_superset {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::gcv_superset_destroy;
}

/// What the library made, with one owner. Without `&mut` it does not change.
pub(crate) struct Owned<T: Made>(NonNull<T>);

// SAFETY: the library lets any thread use it and any thread end it. What can change does so only
// by the pointer of `as_mut_ptr`, when no other thread uses it.
unsafe impl<T: Made> Send for Owned<T> {}
unsafe impl<T: Made> Sync for Owned<T> {}

impl<T: Made> Owned<T> {
    /// # Safety
    /// The pointer is to what is alive, and is not owned by anything else.
    pub(crate) unsafe fn own(pointer: NonNull<T>) -> Self {
        Self(pointer)
    }

    pub(crate) fn as_ptr(&self) -> *const T {
        self.0.as_ptr()
    }

    pub(crate) fn as_mut_ptr(&mut self) -> *mut T {
        self.0.as_ptr()
    }
}

/// A handle of the library. It never changes, so that its clones are the same one.
pub(crate) struct Handle<T: Made>(Arc<Owned<T>>);

impl<T: Made> Handle<T> {
    pub(crate) fn as_ptr(&self) -> *const T {
        self.0.as_ptr()
    }
}

impl<T: Made> From<Owned<T>> for Handle<T> {
    fn from(owned: Owned<T>) -> Self {
        Self(Arc::new(owned))
    }
}

impl<T: Made> Clone for Handle<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T: Made> Drop for Owned<T> {
    fn drop(&mut self) {
        // SAFETY: it is owned and not used again.
        unsafe { T::DESTROY(self.0.as_ptr()) }
    }
}
