// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;

use gcv_sys as sys;

/// The features of a contact.
///
/// The numbers are those of the caller: vertex `k` as passed, edge `k` from vertex `k`
/// to `k + 1`. They run through all rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ContactKind {
    /// An edge of A and a vertex of B.
    EdgeVertex {
        /// The edge of A.
        edge_a: usize,
        /// The vertex of B.
        vertex_b: usize,
    },
    /// A vertex of A and an edge of B.
    VertexEdge {
        /// The vertex of A.
        vertex_a: usize,
        /// The edge of B.
        edge_b: usize,
    },
    /// A vertex of A and a vertex of B.
    VertexVertex {
        /// The vertex of A.
        vertex_a: usize,
        /// The vertex of B.
        vertex_b: usize,
    },
}

/// A feature of A and one of B that touch, or would, and where.
#[derive(Clone, Copy, PartialEq)]
#[repr(transparent)]
pub struct Contact(sys::gcv_contact);

impl Contact {
    /// What the C interface gives; `None` where it is all 0.
    pub(crate) fn of(contact: sys::gcv_contact) -> Option<Self> {
        (contact.kind != 0).then_some(Self(contact))
    }

    /// Which features they are.
    pub fn kind(&self) -> ContactKind {
        let (a, b) = (self.0.a as usize, self.0.b as usize);
        match self.0.kind {
            sys::GCV_CONTACT_EDGE_VERTEX => ContactKind::EdgeVertex {
                edge_a: a,
                vertex_b: b,
            },
            sys::GCV_CONTACT_VERTEX_EDGE => ContactKind::VertexEdge {
                vertex_a: a,
                edge_b: b,
            },
            sys::GCV_CONTACT_VERTEX_VERTEX => ContactKind::VertexVertex {
                vertex_a: a,
                vertex_b: b,
            },
            kind => unreachable!("libgcv gives three kinds of contacts, and gave {kind}"),
        }
    }

    /// The id of A in its [`Scene`](crate::Scene): of a member, or
    /// [`Scene::CONTAINER`](crate::Scene::CONTAINER). 0 where A is of no scene.
    pub fn id_a(&self) -> u64 {
        self.0.id_a
    }

    /// The id of B in its [`Scene`](crate::Scene); 0 where B is of no scene.
    pub fn id_b(&self) -> u64 {
        self.0.id_b
    }

    /// The distance between the features, correctly rounded.
    ///
    /// In a list of [`contacts`](crate::contacts()) it is below 0 where the vertex lies on the
    /// solid side of the line of the edge. It is never below 0 for two vertices.
    pub fn gap(&self) -> f64 {
        self.0.gap
    }

    /// A unit vector, each coordinate within 1 ulp: the normal of the edge, towards B.
    ///
    /// For two vertices it is the direction from that of A to that of B, or `[0., 0.]` where
    /// they coincide.
    pub fn normal(&self) -> [f64; 2] {
        self.0.normal
    }

    /// The point of the feature of A that is nearest to that of B, each coordinate correctly
    /// rounded.
    pub fn on_a(&self) -> [f64; 2] {
        self.0.on_a
    }

    /// The point of the feature of B that is nearest to that of A, each coordinate correctly
    /// rounded. It is a point of B as translated.
    pub fn on_b(&self) -> [f64; 2] {
        self.0.on_b
    }
}

impl fmt::Debug for Contact {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Contact")
            .field("kind", &self.kind())
            .field("id_a", &self.id_a())
            .field("id_b", &self.id_b())
            .field("gap", &self.gap())
            .field("normal", &self.normal())
            .field("on_a", &self.on_a())
            .field("on_b", &self.on_b())
            .finish()
    }
}
