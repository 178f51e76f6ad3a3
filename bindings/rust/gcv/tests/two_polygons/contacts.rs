// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Lists of contacts.

use std::collections::HashSet;
use std::ops::ControlFlow::Break;

use gcv::status::*;
use gcv::ContactKind::{self, EdgeVertex, VertexEdge};
use gcv::{contacts, ContactList, Options, Polygon};

use crate::{polygon, square, status};

fn list(a: &Polygon, b: &Polygon, t: [f64; 2], distance: f64, slope: f64) -> ContactList {
    contacts(a, b, t, distance, slope, &Options::new()).unwrap()
}

fn kinds(list: &ContactList) -> Vec<ContactKind> {
    list.iter().map(|contact| contact.kind()).collect()
}

/// The right edge of the left square and the lowest vertex beside it.
const LOWER_END: ContactKind = EdgeVertex {
    edge_a: 1,
    vertex_b: 0,
};

/// Two faces share a part of a line: its two ends.
#[test]
fn faces() {
    let square = square(4.);
    let found = list(&square, &square, [4., 1.], 0., 0.);
    let upper_end = VertexEdge {
        vertex_a: 2,
        edge_b: 3,
    };
    assert_eq!(kinds(&found), [LOWER_END, upper_end]);
    for contact in &found {
        assert_eq!((contact.gap(), contact.normal()), (0., [1., 0.]));
        assert_eq!(contact.on_a(), contact.on_b());
    }
    assert_eq!((found[0].on_a(), found[1].on_a()), ([4., 1.], [4., 4.]));
}

#[test]
fn apart_and_deep() {
    let square = square(4.);
    for (x, gap) in [(4.5, 0.5), (3.5, -0.5)] {
        let found = list(&square, &square, [x, 1.], 0.75, 0.);
        let contact = found.iter().find(|contact| contact.kind() == LOWER_END);
        assert_eq!(contact.unwrap().gap(), gap);
        assert_eq!(contact.unwrap().normal(), [1., 0.]);
    }
    assert!(list(&square, &square, [4.5, 1.], 0.25, 0.).is_empty());
    assert!(list(&square, &square, [9., 9.], 1., 1.).is_empty());
}

#[test]
fn nearest_first_and_each_once() {
    let square = square(4.);
    let found = list(&square, &square, [3., 3.5], 6., 0.);
    assert!(found.len() > 4);
    let gaps: Vec<_> = found.iter().map(|contact| contact.gap().abs()).collect();
    assert!(gaps.windows(2).all(|pair| pair[0] <= pair[1]), "{gaps:?}");
    assert!(gaps.iter().all(|gap| *gap <= 6.), "{gaps:?}");
    let different: HashSet<_> = kinds(&found).into_iter().collect();
    assert_eq!(different.len(), found.len());
}

/// Two faces that are parallel but for an angle of 2^-42.
#[test]
fn slopes() {
    let dent = 2_f64.powi(-40);
    let nearly_square = polygon(&[[0., 0.], [4., 0.], [4., 4.], [-dent, 4.]]);
    let of_faces = |slope| {
        let found = list(&square(4.), &nearly_square, [4. + dent, 0.], 1e-6, slope);
        let upper_end = EdgeVertex {
            edge_a: 1,
            vertex_b: 3,
        };
        let kinds = kinds(&found);
        [LOWER_END, upper_end].map(|kind| kinds.contains(&kind))
    };
    assert_eq!(of_faces(0.), [false, true]);
    assert_eq!(of_faces(1e-9), [true, true]);
}

#[test]
fn slices_and_clones() {
    fn shareable<T: Send + Sync>() {}
    shareable::<ContactList>();

    let square = square(4.);
    let found = list(&square, &square, [4., 1.], 0., 0.);
    let clone = found.clone();
    assert_eq!(clone, found);
    assert_eq!(clone.as_ptr(), found.as_ptr());
    let debug = format!("{found:?}");
    assert!(
        debug.starts_with("[Contact { kind: EdgeVertex { "),
        "{debug}"
    );
    drop(found);
    assert_eq!(clone.previous(), [None, None]);
    assert_eq!(clone.as_ref().len(), 2);
    assert_eq!((&clone).into_iter().len(), 2);
    assert_ne!(clone, list(&square, &square, [4., 2.], 0., 0.));
}

#[test]
fn refused() {
    let square = square(4.);
    let refused = |t, distance, slope, options: Options| {
        status(contacts(&square, &square, t, distance, slope, &options))
    };
    let (t, nan) = ([4., 1.], f64::NAN);
    let new = Options::new;
    assert_eq!(refused([nan, 0.], 1., 0., new()), GCV_ERR_NOT_FINITE);
    assert_eq!(refused(t, nan, 0., new()), GCV_ERR_NOT_FINITE);
    assert_eq!(refused(t, 1., nan, new()), GCV_ERR_NOT_FINITE);
    assert_eq!(refused(t, -1., 0., new()), GCV_ERR_INVALID_ARGUMENT);
    assert_eq!(refused(t, 1., -1., new()), GCV_ERR_INVALID_ARGUMENT);
    let options = new().tolerance(-1.);
    assert_eq!(refused(t, 1., 0., options), GCV_ERR_INVALID_ARGUMENT);
    let impatient = new().progress(|_, _| Break(()));
    assert_eq!(refused(t, 1., 0., impatient), GCV_ERR_CANCELLED);
}
