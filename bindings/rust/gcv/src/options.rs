// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::any::Any;
use std::cell::RefCell;
use std::fmt;
use std::mem::size_of;
use std::ops::ControlFlow;
use std::os::raw::c_void;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr;
use std::sync::{Arc, Mutex, PoisonError};

use gcv_sys as sys;

/// How exact coordinates become `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Rounding {
    /// To the nearest `f64`, save where vertices must move further, by a few units in
    /// the last place, for rings to be simple and not to cross.
    #[default]
    Nearest,
    /// So that a returned sum contains the exact one, and a returned inner-fit or free region
    /// lies inside the exact one: what is placed on a ring never overlaps. Segments and points
    /// that `f64` cannot show exactly are dropped.
    Outward,
}

impl Rounding {
    /// What it is in the C interface.
    pub(crate) fn value(self) -> i32 {
        match self {
            Self::Nearest => sys::GCV_ROUND_NEAREST,
            Self::Outward => sys::GCV_ROUND_OUTWARD,
        }
    }
}

/// What hears of the progress of a computation, and may end it.
type Progress<'a> = Arc<Mutex<dyn FnMut(u64, u64) -> ControlFlow<()> + Send + 'a>>;

/// Options of a computation.
///
/// ```
/// use gcv::{minkowski_sum, Options, Polygon, Rounding};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let notched = Polygon::new(&[[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]])?;
/// let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
/// let options = Options::new().rounding(Rounding::Outward).threads(0);
/// let face = minkowski_sum(&notched, &triangle, &options)?;
/// assert!(face.vertices()[4][1] >= 7. / 3.);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Options<'a> {
    rounding: Rounding,
    tolerance: f64,
    threads: usize,
    progress: Option<Progress<'a>>,
    leave_out_holes: bool,
    leave_out_fits: bool,
}

impl<'a> Options<'a> {
    /// Rounding to nearest, one thread, no tolerance, nothing that hears of progress, nothing
    /// left out.
    pub fn new() -> Self {
        Self {
            rounding: Rounding::Nearest,
            tolerance: 0.,
            threads: 1,
            progress: None,
            leave_out_holes: false,
            leave_out_fits: false,
        }
    }

    /// How exact coordinates become `f64`.
    #[must_use]
    pub fn rounding(mut self, rounding: Rounding) -> Self {
        self.rounding = rounding;
        self
    }

    /// How far, in input units, the result may be from the exact one beside the rounding;
    /// finite, from 0 on. Above 0, each polygon is first simplified by at most half of it,
    /// see [`Polygon::simplified`](crate::Polygon::simplified), where that saves a quarter of
    /// its vertices, and the exact ring is that of the simplified polygons. With
    /// [`Rounding::Outward`] the result still contains the exact sum. Must be 0 for inner fits,
    /// for ways out of overlaps and for scenes. Other questions about two polygons, such as
    /// [`relation`](crate::relation), are exact whatever it is.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// How many threads work on the answer, the calling one among them; 0 for as many as
    /// the machine runs at once. The result is the same for every number.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// Calls `progress` now and then with the number of steps that are done and an
    /// estimate of their final number, never below the first; on the thread that asked
    /// for the computation. `ControlFlow::Break(())` ends the computation with
    /// `GCV_ERR_CANCELLED`; so does a panic, which then goes on in the caller.
    ///
    /// Computations that run at the same time with these options, or with clones of
    /// them, take turns in calling it. It panics where it computes with them itself.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use gcv::{minkowski_sum, status, Options, Polygon};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let options = Options::new().progress(|_done, _estimate| ControlFlow::Break(()));
    /// let error = minkowski_sum(&square, &square, &options).unwrap_err();
    /// assert_eq!(error.status, status::GCV_ERR_CANCELLED);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn progress(
        mut self,
        progress: impl FnMut(u64, u64) -> ControlFlow<()> + Send + 'a,
    ) -> Self {
        self.progress = Some(Arc::new(Mutex::new(progress)));
        self
    }

    /// Whether the holes of a sum are left out, to save time. Not for inner fits and scenes, but
    /// for ways out of these: obstacles would be free there. Outer faces have no holes anyway.
    ///
    /// ```
    /// use gcv::{minkowski_sum_region, Options, Polygon};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let frame: Polygon = "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 8 1, 8 8, 1 8))".parse()?;
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let area = |options: Options| minkowski_sum_region(&frame, &square, &options)?.area();
    /// assert_eq!(area(Options::new())?, 100. - 36.);
    /// assert_eq!(area(Options::new().leave_out_holes(true))?, 100.);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn leave_out_holes(mut self, leave_out: bool) -> Self {
        self.leave_out_holes = leave_out;
        self
    }

    /// Whether the segments and points of a region are left out, to save time: positions
    /// where one polygon fits the other exactly. Outer faces have none anyway.
    #[must_use]
    pub fn leave_out_fits(mut self, leave_out: bool) -> Self {
        self.leave_out_fits = leave_out;
        self
    }

    /// What is left out, in the C interface.
    fn leave_out(&self) -> u64 {
        let mut bits = 0;
        if self.leave_out_holes {
            bits |= sys::GCV_LEAVE_OUT_HOLES;
        }
        if self.leave_out_fits {
            bits |= sys::GCV_LEAVE_OUT_FITS;
        }
        bits
    }

    /// Gives the options to a call of the C interface. What the call gives is dropped
    /// where the progress function panicked, and the panic goes on.
    pub(crate) fn pass<T>(&self, call: impl FnOnce(*const sys::gcv_options) -> T) -> T {
        let mut options = sys::gcv_options {
            struct_size: size_of::<sys::gcv_options>() as u32,
            rounding: self.rounding.value(),
            tolerance: self.tolerance,
            threads: i32::try_from(self.threads).unwrap_or(i32::MAX),
            progress: None,
            progress_context: ptr::null_mut(),
            leave_out: self.leave_out(),
        };
        let mut context = self.progress.as_ref().map(|progress| Context {
            progress,
            panic: None,
        });
        if let Some(context) = &mut context {
            options.progress = Some(report);
            options.progress_context = (context as *mut Context).cast();
        }
        let result = call(&options);
        if let Some(panic) = context.and_then(|context| context.panic) {
            drop(result);
            resume_unwind(panic);
        }
        result
    }
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Options<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Options")
            .field("rounding", &self.rounding)
            .field("tolerance", &self.tolerance)
            .field("threads", &self.threads)
            .field("progress", &self.progress.is_some())
            .field("leave_out_holes", &self.leave_out_holes)
            .field("leave_out_fits", &self.leave_out_fits)
            .finish()
    }
}

/// What `report` finds behind the pointer that the library hands to it.
struct Context<'p, 'a> {
    progress: &'p Progress<'a>,
    panic: Option<Box<dyn Any + Send>>,
}

thread_local! {
    /// The progress functions that this thread is in.
    static CALLED: RefCell<Vec<*const ()>> = const { RefCell::new(Vec::new()) };
}

/// The progress function of the C interface: not 0 to end the computation. A panic must
/// not go through the library, and waits in the context.
///
/// # Safety
/// `context` is the one of `Options::pass`, which outlives the call; the library calls
/// this on one thread.
unsafe extern "C" fn report(context: *mut c_void, done: u64, estimate: u64) -> i32 {
    let context = &mut *context.cast::<Context>();
    let function = Arc::as_ptr(context.progress).cast::<()>();
    let is_inside = CALLED.with(|called| called.borrow().contains(&function));
    if is_inside {
        context.panic = Some(Box::new(
            "a progress function computes with its own options",
        ));
        return 1;
    }
    let mut progress = context
        .progress
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    CALLED.with(|called| called.borrow_mut().push(function));
    let result = catch_unwind(AssertUnwindSafe(|| progress(done, estimate)));
    CALLED.with(|called| called.borrow_mut().pop());
    match result {
        Ok(flow) => flow.is_break().into(),
        Err(panic) => {
            context.panic = Some(panic);
            1
        }
    }
}
