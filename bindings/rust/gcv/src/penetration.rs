// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;

use gcv_sys as sys;

use crate::call::check;
use crate::lengths::same_length;
use crate::{Contact, Error, Options, Polygon, Relation};

/// How deep two polygons overlap, and the shortest way out.
///
/// The default is that of polygons that touch. It is for slices that results are written to.
#[derive(Clone, Copy, Default, PartialEq)]
#[repr(transparent)]
pub struct Escape(sys::gcv_escape);

impl Escape {
    /// The length of the shortest way out, correctly rounded; 0 where they do not overlap.
    ///
    /// In a scene it is infinite where nothing is free.
    pub fn depth(&self) -> f64 {
        self.0.depth
    }

    /// The shortest vector that B must be moved by not to overlap A, each coordinate rounded to
    /// nearest. Of several, it is the lexicographically smallest.
    pub fn translation(&self) -> [f64; 2] {
        self.0.translation
    }

    /// Where B is then: a translation in `f64`, ready for use.
    ///
    /// It is within 2 ulps of the exact one, and B does not overlap A there, if there is such
    /// a translation. Otherwise it is the nearest one.
    pub fn position(&self) -> [f64; 2] {
        self.0.position
    }

    /// How they lie at [`Escape::position`], exactly.
    pub fn relation(&self) -> Relation {
        Relation::of(self.0.relation)
    }

    /// The id of what touches at the end of the way out in a [`Scene`](crate::Scene); 0 where
    /// nothing overlaps, where nothing is free, and of two polygons.
    pub fn id(&self) -> u64 {
        self.0.contact.id_a
    }

    /// What touches at the end of the way out; `None` where they do not overlap, where nothing is
    /// free, and where only points touch there at which rings of both polygons touch.
    pub fn contact(&self) -> Option<Contact> {
        Contact::of(self.0.contact)
    }
}

impl fmt::Debug for Escape {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Escape")
            .field("depth", &self.depth())
            .field("translation", &self.translation())
            .field("position", &self.position())
            .field("relation", &self.relation())
            .field("id", &self.id())
            .field("contact", &self.contact())
            .finish()
    }
}

/// The shortest vector that B + translation must be moved by not to overlap A.
///
/// Ways into holes and exact fits count, unless [`Options::leave_out_holes`] or
/// [`Options::leave_out_fits`] leaves them out. What [`relation`](crate::relation()) says of
/// translations and holes holds here too.
///
/// ```
/// use gcv::{penetration, Options, Polygon, Relation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.]])?;
/// let escape = penetration(&square, &square, [3., 1.], &Options::new())?;
/// assert_eq!(escape.depth(), 1.);
/// assert_eq!(escape.translation(), [1., 0.]);
/// assert_eq!(escape.position(), [4., 1.]);
/// assert_eq!(escape.relation(), Relation::Touching);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`distance`](crate::distance()); `GCV_ERR_INVALID_ARGUMENT` also for a tolerance above 0.
pub fn penetration(
    a: &Polygon,
    b: &Polygon,
    translation: [f64; 2],
    options: &Options,
) -> Result<Escape, Error> {
    let mut out = [Escape::default()];
    penetration_into(a, b, &[translation], options, &mut out)?;
    Ok(out[0])
}

/// The penetration of A and B for each translation of B, in their order.
///
/// The translations are shared out over the threads of the options, and its progress function
/// counts them. The call gives all answers or none.
///
/// # Errors
/// As [`penetration`].
pub fn penetration_many(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
) -> Result<Vec<Escape>, Error> {
    let mut out = vec![Escape::default(); translations.len()];
    penetration_into(a, b, translations, options, &mut out)?;
    Ok(out)
}

/// As [`penetration_many`], with the answers written to `out`, one for each translation.
///
/// On failure `out` is as it was.
///
/// # Errors
/// As [`penetration`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
pub fn penetration_into(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
    out: &mut [Escape],
) -> Result<(), Error> {
    let count = same_length(("translations", translations), ("out", out))?;
    let (xy, out) = (translations.as_ptr().cast(), out.as_mut_ptr().cast());
    // SAFETY: the polygons are alive, the options are for the call, and there are as many
    // translations and as much room as said.
    options.pass(|options| {
        check(unsafe { sys::gcv_penetration(a.as_ptr(), b.as_ptr(), xy, count, options, out) })
    })
}
