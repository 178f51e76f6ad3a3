// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;

use gcv_sys as sys;

use crate::call::check;
use crate::lengths::same_length;
use crate::{Contact, Error, Options, Polygon, Relation};

/// How far a motion leads before the polygons overlap.
///
/// The default is that of polygons that touch and do not move. It is for slices that results
/// are written to.
#[derive(Clone, Copy, PartialEq)]
#[repr(transparent)]
pub struct Impact(sys::gcv_impact);

impl Impact {
    /// Whether B would overlap A right after [`Impact::time`].
    pub fn hit(&self) -> bool {
        self.0.hit != 0
    }

    /// The largest part of the motion, from 0 to 1, up to which they never overlap, rounded
    /// down; 1 without a hit.
    pub fn time(&self) -> f64 {
        self.0.time
    }

    /// Where B is at that time: a translation in `f64`, ready for use.
    ///
    /// It is within 2 ulps of the exact one, and B does not overlap A there, if there is such
    /// a translation. Otherwise it is the nearest one.
    pub fn position(&self) -> [f64; 2] {
        self.0.position
    }

    /// How they lie at [`Impact::position`], exactly.
    pub fn relation(&self) -> Relation {
        Relation::of(self.0.relation)
    }

    /// The id of what is hit first in a [`Scene`](crate::Scene), also for an overlap at the
    /// start; 0 without a hit, and of two polygons.
    pub fn id(&self) -> u64 {
        self.0.contact.id_a
    }

    /// What is hit, with gap 0; `None` without a hit, and where B overlaps A at the start.
    ///
    /// Of several, it is the one of the smallest kind, then of the smallest number in A, then
    /// in B. Kinds are in the order of [`ContactKind`](crate::ContactKind).
    pub fn contact(&self) -> Option<Contact> {
        Contact::of(self.0.contact)
    }
}

impl Default for Impact {
    fn default() -> Self {
        Self(sys::gcv_impact {
            time: 1.,
            ..Default::default()
        })
    }
}

impl fmt::Debug for Impact {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Impact")
            .field("hit", &self.hit())
            .field("time", &self.time())
            .field("position", &self.position())
            .field("relation", &self.relation())
            .field("id", &self.id())
            .field("contact", &self.contact())
            .finish()
    }
}

/// How far B can move from a translation along a motion before it overlaps A.
///
/// B moves from translation to translation + motion. Sliding along a boundary is no hit.
/// Touching at the end of the motion is none. What [`relation`](crate::relation) says of
/// translations and holes holds here too.
///
/// ```
/// use gcv::{cast, ContactKind, Options, Polygon, Relation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let impact = cast(&square, &square, [5., 0.5], [-8., 0.], &Options::new())?;
/// assert!(impact.hit());
/// assert_eq!(impact.time(), 0.5);
/// assert_eq!(impact.position(), [1., 0.5]);
/// assert_eq!(impact.relation(), Relation::Touching);
/// let contact = impact.contact().unwrap();
/// assert_eq!(contact.kind(), ContactKind::EdgeVertex { edge_a: 1, vertex_b: 0 });
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`distance`](crate::distance), for the motion too.
pub fn cast(
    a: &Polygon,
    b: &Polygon,
    translation: [f64; 2],
    motion: [f64; 2],
    options: &Options,
) -> Result<Impact, Error> {
    let mut out = [Impact::default()];
    cast_into(a, b, &[translation], &[motion], options, &mut out)?;
    Ok(out[0])
}

/// The impact of every motion, in their order, each from the translation of the same number.
///
/// The motions are shared out over the threads of the options, and its progress function
/// counts them. The call gives all impacts or none.
///
/// # Errors
/// As [`cast`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
pub fn cast_many(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    motions: &[[f64; 2]],
    options: &Options,
) -> Result<Vec<Impact>, Error> {
    let mut out = vec![Impact::default(); translations.len()];
    cast_into(a, b, translations, motions, options, &mut out)?;
    Ok(out)
}

/// As [`cast_many`], with the impacts written to `out`, one for each motion.
///
/// On failure `out` is as it was.
///
/// # Errors
/// As [`cast_many`].
pub fn cast_into(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    motions: &[[f64; 2]],
    options: &Options,
    out: &mut [Impact],
) -> Result<(), Error> {
    same_length(("translations", translations), ("motions", motions))?;
    let count = same_length(("translations", translations), ("out", out))?;
    let (a, b, out) = (a.as_ptr(), b.as_ptr(), out.as_mut_ptr().cast());
    let (from, motions) = (translations.as_ptr().cast(), motions.as_ptr().cast());
    // SAFETY: the polygons are alive, the options are for the call, and there are as many
    // translations and motions and as much room as said.
    options
        .pass(|options| check(unsafe { sys::gcv_cast(a, b, from, motions, count, options, out) }))
}
