// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Options, progress, cancelling, and many sums in one call.

use std::ops::ControlFlow::{Break, Continue};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::{Arc, Mutex};

use gcv::status::*;
use gcv::{entrance_block, minkowski_sum, minkowski_sum_many, no_fit_polygon};
use gcv::{EdgeSource, Options, Polygon, Rounding};

/// A star of `4 * quarter` vertices near a circle, every other one pulled inwards.
fn star(quarter: usize) -> Polygon {
    let vertex = |k: usize| {
        let t = (k % quarter) as f64 / quarter as f64;
        let radius = if k % 2 == 0 { 1000. } else { 999. - t } / (1. + t * t);
        let (c, s) = (radius * (1. - t * t), radius * 2. * t);
        [[c, s], [-s, c], [-c, -s], [s, -c]][k / quarter]
    };
    Polygon::new(&(0..4 * quarter).map(vertex).collect::<Vec<_>>()).unwrap()
}

fn triangle() -> Polygon {
    Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]]).unwrap()
}

fn huge() -> Polygon {
    Polygon::new(&[[0., 0.], [1.7e308, 0.], [0., 1.7e308]]).unwrap()
}

#[test]
fn outward_contains_nearest() {
    let notched = Polygon::from_wkt("POLYGON ((0 0, 8 0, 8 6, 3 1, 0 7))").unwrap();
    let area = |rounding| {
        let options = Options::new().rounding(rounding);
        let face = minkowski_sum(&notched, &triangle(), &options).unwrap();
        (face.vertices()[4], face.area().unwrap())
    };
    let (nearest, outward) = (area(Rounding::Nearest), area(Rounding::Outward));
    assert_ne!(nearest.0, outward.0);
    assert!(nearest.1 < outward.1 && outward.1 < nearest.1 + 1e-12);
}

/// A square with a bump of 1/8 on its lower side and a dent of 1/8 in its upper one.
fn bumpy() -> Polygon {
    let wkt = "POLYGON ((0 0, 1 0, 2 -0.125, 3 0, 4 0, 4 4, 3 4, 2 3.875, 1 4, 0 4))";
    Polygon::from_wkt(wkt).unwrap()
}

#[test]
fn tolerance_is_passed_on() {
    let bumpy = bumpy();
    let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]).unwrap();
    let options = Options::new().tolerance(0.4);
    let mut many = minkowski_sum_many([(&bumpy, &square)], &options);
    for face in [
        minkowski_sum(&bumpy, &square, &options),
        no_fit_polygon(&bumpy, &square, [1., 1.], &options),
        entrance_block(&square, &bumpy, [1., 1.], &options),
        many.next().unwrap(),
    ] {
        let face = face.unwrap();
        assert_eq!(face.vertices(), [[0., 0.], [5., 0.], [5., 5.], [0., 5.]]);
        assert!((0.125..0.1250001).contains(&face.error_bound()));
    }
    let error = minkowski_sum(&bumpy, &square, &Options::new().tolerance(-1.)).unwrap_err();
    assert_eq!(error.status, GCV_ERR_INVALID_ARGUMENT);
    assert!(error.message.contains("tolerance is -1"), "{error}");
}

#[test]
fn simplified() {
    let bumpy = bumpy();
    let (square, bound) = bumpy.simplified(0.2, Rounding::Nearest).unwrap();
    assert_eq!(square.vertices(), [[0., 0.], [4., 0.], [4., 4.], [0., 4.]]);
    assert!((0.125..0.1250001).contains(&bound));
    let sum = minkowski_sum(&square, &square, &Options::new()).unwrap();
    let numbers = [0, 4, 5, 9].map(|k| EdgeSource::TranslatedCorner {
        edge_a: k,
        edge_b: k,
    });
    assert_eq!(sum.sources(), numbers);

    let (around, bound) = bumpy.simplified(0.2, Rounding::Outward).unwrap();
    assert!(around.area().unwrap() > bumpy.area().unwrap() && around.vertices().len() < 10);
    assert!(0. < bound && bound <= 0.2);

    let (same, bound) = bumpy.simplified(0., Rounding::Outward).unwrap();
    assert_eq!((same.vertices(), bound), (bumpy.vertices(), 0.));
    for tolerance in [-1., f64::NAN, f64::INFINITY] {
        let error = bumpy.simplified(tolerance, Rounding::Nearest).unwrap_err();
        assert_eq!(error.status, GCV_ERR_INVALID_ARGUMENT);
        assert!(error.message.starts_with("tolerance is"), "{error}");
    }
}

#[test]
fn threads_give_the_same() {
    let star = star(50);
    let sum = |threads| {
        let face = minkowski_sum(&star, &star, &Options::new().threads(threads)).unwrap();
        (face.wkt(), face.sources())
    };
    let one = sum(1);
    for threads in [0, 2, 5, usize::MAX] {
        assert_eq!(sum(threads), one);
    }
}

#[test]
fn progress_is_reported() {
    let star = star(300);
    let mut reports = vec![];
    let options = Options::new().progress(|done, estimate| {
        reports.push((done, estimate));
        Continue(())
    });
    let face = minkowski_sum(&star, &star, &options).unwrap();
    drop(options);
    assert_eq!(
        face.wkt(),
        minkowski_sum(&star, &star, &Options::new()).unwrap().wkt()
    );
    assert!(reports.len() >= 3, "{reports:?}");
    assert!(
        reports.windows(2).all(|pair| pair[0].0 <= pair[1].0),
        "{reports:?}"
    );
    assert!(
        reports.iter().all(|(done, estimate)| done <= estimate),
        "{reports:?}"
    );
}

#[test]
fn breaking_cancels() {
    let star = star(300);
    for last in 1..=3 {
        let mut reports = 0;
        let options = Options::new().progress(|_, _| {
            reports += 1;
            if reports == last {
                Break(())
            } else {
                Continue(())
            }
        });
        let error = minkowski_sum(&star, &star, &options).unwrap_err();
        assert_eq!(error.status, GCV_ERR_CANCELLED);
        let pairs = [(&star, &star)];
        drop(options);
        assert_eq!(reports, last);

        let options = Options::new().progress(|_, _| Break(()));
        let error = minkowski_sum_many(pairs, &options)
            .next()
            .unwrap()
            .unwrap_err();
        assert_eq!(error.status, GCV_ERR_CANCELLED);
    }
}

#[test]
fn panics_go_on_in_the_caller() {
    let star = star(10);
    let options = Options::new().progress(|_, _| panic!("out of patience"));
    // Twice: a panic does not spoil the options.
    for _ in 0..2 {
        let sum = AssertUnwindSafe(|| minkowski_sum(&star, &star, &options));
        let panic = catch_unwind(sum).unwrap_err();
        assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
        let sums = AssertUnwindSafe(|| minkowski_sum_many([(&star, &star)], &options));
        let panic = catch_unwind(sums).unwrap_err();
        assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
    }
}

#[test]
fn a_progress_function_does_not_compute_with_its_own_options() {
    let own: Arc<Mutex<Option<Options<'static>>>> = Arc::default();
    let (inside, star) = (Arc::clone(&own), star(10));
    let again = star.clone();
    let options = Options::new().progress(move |_, _| {
        let options = inside.lock().unwrap().clone().unwrap();
        minkowski_sum(&again, &again, &options).map_or(Break(()), |_| Continue(()))
    });
    *own.lock().unwrap() = Some(options.clone());
    let sum = AssertUnwindSafe(|| minkowski_sum(&star, &star, &options));
    let panic = catch_unwind(sum).unwrap_err();
    let reason = "a progress function computes with its own options";
    assert_eq!(panic.downcast_ref(), Some(&reason));
    own.lock().unwrap().take();
}

#[test]
fn options_may_be_shared() {
    let star = star(20);
    let mut reports = 0;
    let options = Options::new().progress(|_, _| {
        reports += 1;
        Continue(())
    });
    std::thread::scope(|scope| {
        let sum = || minkowski_sum(&star, &star, &options.clone()).unwrap();
        scope.spawn(sum);
        scope.spawn(sum);
    });
    assert!(format!("{options:?}").contains("progress: true"));
    drop(options);
    assert!(reports >= 4);
}

#[test]
fn many() {
    let (star, triangle, huge) = (star(10), triangle(), huge());
    let polygons = [&star, &triangle, &huge, &star, &huge];
    let pairs: Vec<_> = polygons
        .iter()
        .zip(polygons)
        .map(|(&a, b)| (a, b))
        .collect();
    for threads in 0..3 {
        let options = Options::new().threads(threads);
        let sums = minkowski_sum_many(pairs.iter().copied(), &options);
        assert_eq!(sums.len(), pairs.len());
        for (index, (sum, (a, b))) in sums.zip(&pairs).enumerate() {
            match (sum, minkowski_sum(a, b, &options)) {
                (Ok(face), Ok(expected)) => assert_eq!(face.wkt(), expected.wkt()),
                (Err(error), Err(expected)) => {
                    assert_eq!(error.status, expected.status);
                    assert!(
                        error.message.starts_with(&format!("pair {index}: ")),
                        "{error}"
                    );
                    if index == 2 {
                        assert!(error.message.ends_with(&expected.message), "{error}");
                    }
                }
                (sum, expected) => panic!("pair {index}: {sum:?}, expected {expected:?}"),
            }
        }
    }
    assert_eq!(minkowski_sum_many([], &Options::new()).len(), 0);
}

#[test]
fn many_with_an_option_that_is_refused() {
    let triangle = triangle();
    let pairs = [(&triangle, &triangle); 3];
    let statuses: Vec<_> = minkowski_sum_many(pairs, &Options::new().tolerance(-1.))
        .map(|sum| sum.unwrap_err().status)
        .collect();
    assert_eq!(statuses, [GCV_ERR_INVALID_ARGUMENT; 3]);
}
