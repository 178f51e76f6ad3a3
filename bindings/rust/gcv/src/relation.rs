// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use gcv_sys as sys;

use crate::call::check;
use crate::lengths::same_length;
use crate::{Error, Options, Polygon};

/// How two polygons lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i8)]
pub enum Relation {
    /// Their interiors meet.
    Overlapping = sys::GCV_OVERLAPPING,
    /// Their boundaries meet, their interiors do not.
    Touching = sys::GCV_TOUCHING,
    /// They have no point in common.
    Apart = sys::GCV_APART,
}

impl Relation {
    /// What the C interface calls so.
    pub(crate) fn of(relation: i32) -> Self {
        match i8::try_from(relation) {
            Ok(sys::GCV_OVERLAPPING) => Self::Overlapping,
            Ok(sys::GCV_TOUCHING) => Self::Touching,
            Ok(sys::GCV_APART) => Self::Apart,
            _ => unreachable!("libgcv gives three relations, and gave {relation}"),
        }
    }
}

/// How A and B + translation lie, exactly.
///
/// The coordinates of B + translation are exact sums of two `f64`. Holes count: B in a hole of
/// A is apart from A. Nothing is built for the pair. The first question to a polygon prepares
/// it, later ones are faster for it.
///
/// ```
/// use gcv::{relation, Options, Polygon, Relation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let options = Options::new();
/// assert_eq!(relation(&square, &square, [0.5, 0.5], &options)?, Relation::Overlapping);
/// assert_eq!(relation(&square, &square, [1., 0.5], &options)?, Relation::Touching);
/// assert_eq!(relation(&square, &square, [1.5, 0.5], &options)?, Relation::Apart);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// `GCV_ERR_NOT_FINITE` for a translation; the message names its number.
/// `GCV_ERR_INVALID_ARGUMENT` for an option; `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`.
pub fn relation(
    a: &Polygon,
    b: &Polygon,
    translation: [f64; 2],
    options: &Options,
) -> Result<Relation, Error> {
    let mut out = [Relation::Apart];
    relation_into(a, b, &[translation], options, &mut out)?;
    Ok(out[0])
}

/// The relation of A and B for each translation of B, in their order.
///
/// The translations are shared out over the threads of the options, and its progress function
/// counts them. The call gives all relations or none.
///
/// ```
/// use gcv::{relation_many, Options, Polygon, Relation};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let translations = [[0.5, 0.], [1., 0.], [1.5, 0.]];
/// let relations = relation_many(&square, &square, &translations, &Options::new())?;
/// let expected = [Relation::Overlapping, Relation::Touching, Relation::Apart];
/// assert_eq!(relations, expected);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`relation`].
pub fn relation_many(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
) -> Result<Vec<Relation>, Error> {
    let mut out = vec![Relation::Apart; translations.len()];
    relation_into(a, b, translations, options, &mut out)?;
    Ok(out)
}

/// As [`relation_many`], with the relations written to `out`, one for each translation.
///
/// On failure `out` is as it was.
///
/// # Errors
/// As [`relation`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
pub fn relation_into(
    a: &Polygon,
    b: &Polygon,
    translations: &[[f64; 2]],
    options: &Options,
    out: &mut [Relation],
) -> Result<(), Error> {
    let count = same_length(("translations", translations), ("out", out))?;
    let (xy, out) = (translations.as_ptr().cast(), out.as_mut_ptr().cast());
    // SAFETY: the polygons are alive, the options are for the call, and there are as many
    // translations and as much room as said. What is written are values of `Relation`.
    options.pass(|options| {
        check(unsafe { sys::gcv_relation(a.as_ptr(), b.as_ptr(), xy, count, options, out) })
    })
}
