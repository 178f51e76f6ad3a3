// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;
use std::ops::Deref;
use std::slice;
use std::sync::Arc;

use gcv_sys as sys;

use crate::call::{create, elements};
use crate::handle::Handle;
use crate::{Contact, Error, Options, Polygon};

/// The contacts of two polygons, or of a scene: a slice of [`Contact`], nearest first.
///
/// Made by [`contacts`] and [`Scene::contacts`](crate::Scene::contacts). It never changes: a clone
/// is the same one, and costs nothing. Two are equal where their contacts and what
/// [`ContactList::previous`] gives are.
#[derive(Clone)]
pub struct ContactList {
    list: Handle<sys::gcv_contact_list>,
    contacts: Arc<[Contact]>,
    previous: Arc<[Option<usize>]>,
}

impl ContactList {
    /// With what the library's list has.
    pub(crate) fn of(list: Handle<sys::gcv_contact_list>) -> Self {
        // SAFETY: see `elements`.
        let contacts: Vec<sys::gcv_contact> = elements(|out, capacity, required| unsafe {
            sys::gcv_contact_list_contacts(list.as_ptr(), out, capacity, required)
        });
        // SAFETY: see `elements`.
        let previous: Vec<u64> = elements(|out, capacity, required| unsafe {
            sys::gcv_contact_list_previous(list.as_ptr(), out, capacity, required)
        });
        Self {
            list,
            contacts: contacts.into_iter().filter_map(Contact::of).collect(),
            previous: previous.into_iter().map(index).collect(),
        }
    }

    pub(crate) fn as_list_ptr(&self) -> *const sys::gcv_contact_list {
        self.list.as_ptr()
    }

    /// For each contact its index in the earlier list that was passed, or `None` where it was not
    /// there: for all contacts of [`contacts`], which takes no list.
    pub fn previous(&self) -> &[Option<usize>] {
        &self.previous
    }
}

impl PartialEq for ContactList {
    fn eq(&self, other: &Self) -> bool {
        self.contacts == other.contacts && self.previous == other.previous
    }
}

impl Deref for ContactList {
    type Target = [Contact];

    fn deref(&self) -> &[Contact] {
        &self.contacts
    }
}

impl AsRef<[Contact]> for ContactList {
    fn as_ref(&self) -> &[Contact] {
        self
    }
}

impl<'a> IntoIterator for &'a ContactList {
    type Item = &'a Contact;
    type IntoIter = slice::Iter<'a, Contact>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Debug for ContactList {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.debug_list().entries(self).finish()
    }
}

/// An index as the library gives it; `u64::MAX` is none.
fn index(given: u64) -> Option<usize> {
    usize::try_from(given).ok().filter(|_| given != u64::MAX)
}

/// The pairs of features of A and B + translation that can touch, with a |gap| of at most
/// `distance`. The gap is below 0 where a vertex lies on the solid side of the line of an edge.
///
/// They are in the order of |gap|, then of kind, then of the number in A, then in B. Kinds are
/// in the order of [`ContactKind`](crate::ContactKind). Parallel edges give the ends of what
/// overlaps, as contacts of a vertex and an edge. Beyond the end of an edge, both the contact of
/// the edge and that of the vertices are there.
///
/// `slope` is from 0 on. Contacts that need a turn of one polygon, by an angle of at most this
/// tangent, are there too. So faces that are parallel but for rounding keep both of their
/// contacts.
///
/// ```
/// use gcv::{contacts, ContactKind, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.]])?;
/// let contacts = contacts(&square, &square, [1., 4.5], 1., 0., &Options::new())?;
/// let kind = ContactKind::EdgeVertex { edge_a: 2, vertex_b: 0 };
/// let contact = contacts.iter().find(|contact| contact.kind() == kind).unwrap();
/// assert_eq!(contact.gap(), 0.5);
/// assert_eq!(contact.normal(), [0., 1.]);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// `GCV_ERR_NOT_FINITE` for a number that is not finite; `GCV_ERR_INVALID_ARGUMENT` for a
/// distance or a slope below 0, or an option; `GCV_ERR_RANGE` where a result is beyond the
/// largest `f64`; `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`.
pub fn contacts(
    a: &Polygon,
    b: &Polygon,
    translation: [f64; 2],
    distance: f64,
    slope: f64,
    options: &Options,
) -> Result<ContactList, Error> {
    let (a, b, t) = (a.as_ptr(), b.as_ptr(), translation.as_ptr());
    // SAFETY: the polygons and the translation are alive, the options are for the call.
    let list = options.pass(|options| {
        create(|out| unsafe { sys::gcv_contacts(a, b, t, distance, slope, options, out) })
    })?;
    Ok(ContactList::of(list))
}
