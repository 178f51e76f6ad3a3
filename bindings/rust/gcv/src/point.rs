// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

/// What has an x and a y: `[f64; 2]`, `(f64, f64)`, with the feature `geo-types` its `Coord`
/// and `Point`, and types of your own.
///
/// ```
/// use gcv::{Point, Polygon};
///
/// struct Corner {
///     x: f32,
///     y: f32,
/// }
///
/// impl Point for Corner {
///     fn xy(&self) -> [f64; 2] {
///         [self.x.into(), self.y.into()]
///     }
/// }
///
/// # fn main() -> Result<(), gcv::Error> {
/// let corner = |x, y| Corner { x, y };
/// let triangle = Polygon::new(&[corner(0., 0.), corner(2., 0.), corner(0., 2.)])?;
/// assert_eq!(triangle, Polygon::new(&[(0., 0.), (2., 0.), (0., 2.)])?);
/// # Ok(())
/// # }
/// ```
pub trait Point {
    /// The coordinates.
    fn xy(&self) -> [f64; 2];
}

impl Point for [f64; 2] {
    fn xy(&self) -> [f64; 2] {
        *self
    }
}

impl Point for (f64, f64) {
    fn xy(&self) -> [f64; 2] {
        [self.0, self.1]
    }
}

impl<P: Point> Point for &P {
    fn xy(&self) -> [f64; 2] {
        (*self).xy()
    }
}

/// The smallest box around points; `None` without points.
pub(crate) fn bounds_of(points: &[[f64; 2]]) -> Option<[f64; 4]> {
    let first = points.first()?;
    let around = [first[0], first[1], first[0], first[1]];
    Some(
        points
            .iter()
            .fold(around, |[xmin, ymin, xmax, ymax], &[x, y]| {
                [xmin.min(x), ymin.min(y), xmax.max(x), ymax.max(y)]
            }),
    )
}
