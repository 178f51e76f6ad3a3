// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;

use gcv_sys as sys;

use crate::call::check;
use crate::lengths::same_length;
use crate::{Contact, Error, Options, Polygon, Relation};

/// How far two polygons are from each other.
///
/// The default is that of polygons that touch. It is for slices that results are written to.
#[derive(Clone, Copy, Default, PartialEq)]
#[repr(transparent)]
pub struct Separation(sys::gcv_separation);

impl Separation {
    /// The Euclidean distance, correctly rounded; 0 where they touch or overlap.
    ///
    /// It can underflow to 0 while they are apart. In a scene it is infinite where there is
    /// nothing to be near.
    pub fn distance(&self) -> f64 {
        self.0.distance
    }

    /// How they lie, exactly.
    pub fn relation(&self) -> Relation {
        Relation::of(self.0.relation)
    }

    /// The id of what is nearest in a [`Scene`](crate::Scene), also where the distance is 0; 0
    /// where there is nothing, and of two polygons.
    pub fn id(&self) -> u64 {
        self.0.nearest.id_a
    }

    /// Where the distance is taken; `None` where they touch or overlap.
    ///
    /// Of several, it is the one of the smallest kind, then of the smallest number in A, then
    /// in B. Kinds are in the order of [`ContactKind`](crate::ContactKind).
    pub fn nearest(&self) -> Option<Contact> {
        Contact::of(self.0.nearest)
    }
}

impl fmt::Debug for Separation {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Separation")
            .field("distance", &self.distance())
            .field("relation", &self.relation())
            .field("id", &self.id())
            .field("nearest", &self.nearest())
            .finish()
    }
}

/// How far B + translation is from A, and where they are nearest.
///
/// What [`relation`](crate::relation) says of translations and holes holds here too.
///
/// ```
/// use gcv::{distance, ContactKind, Options, Polygon, Relation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let separation = distance(&square, &square, [4., 5.], &Options::new())?;
/// assert_eq!(separation.distance(), 5.);
/// assert_eq!(separation.relation(), Relation::Apart);
/// let nearest = separation.nearest().unwrap();
/// let corners = ContactKind::VertexVertex { vertex_a: 2, vertex_b: 0 };
/// assert_eq!(nearest.kind(), corners);
/// assert_eq!((nearest.on_a(), nearest.on_b()), ([1., 1.], [4., 5.]));
/// assert_eq!(nearest.normal(), [0.6, 0.8]);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`relation`](crate::relation); `GCV_ERR_RANGE` where a result is beyond the largest
/// `f64`.
pub fn distance(
    a: &Polygon,
    b: &Polygon,
    translation: [f64; 2],
    options: &Options,
) -> Result<Separation, Error> {
    let mut out = [Separation::default()];
    distance_into(a, b, &[translation], options, &mut out)?;
    Ok(out[0])
}

/// The distance of A and B for each translation of B, in their order.
///
/// The translations are shared out over the threads of the options, and its progress function
/// counts them. The call gives all distances or none.
///
/// # Errors
/// As [`distance`].
pub fn distance_many(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
) -> Result<Vec<Separation>, Error> {
    let mut out = vec![Separation::default(); translations.len()];
    distance_into(a, b, translations, options, &mut out)?;
    Ok(out)
}

/// As [`distance_many`], with the distances written to `out`, one for each translation.
///
/// On failure `out` is as it was.
///
/// ```
/// use gcv::{distance_into, Options, Polygon, Separation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let mut out = [Separation::default(); 2];
/// distance_into(&square, &square, &[[3., 0.], [1., 0.]], &Options::new(), &mut out)?;
/// assert_eq!(out.map(|separation| separation.distance()), [2., 0.]);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`distance`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
pub fn distance_into(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
    out: &mut [Separation],
) -> Result<(), Error> {
    let count = same_length(("translations", translations), ("out", out))?;
    let (xy, out) = (translations.as_ptr().cast(), out.as_mut_ptr().cast());
    // SAFETY: the polygons are alive, the options are for the call, and there are as many
    // translations and as much room as said.
    options.pass(|options| {
        check(unsafe { sys::gcv_distance(a.as_ptr(), b.as_ptr(), xy, count, options, out) })
    })
}
