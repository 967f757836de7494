//! Time of impact: when do two moving shapes first touch?

use std::mem::{size_of, MaybeUninit};

use halfspace_sys as sys;

use crate::affine::Tensor;
use crate::constants::{constants, setters};
use crate::contact::PairKind;
use crate::pose::Pose;
use crate::shape::Shape;
use crate::Result;

constants! {
    /// What comes of two motions.
    ImpactState {
        /// They do not touch within the duration.
        Never = HS_IMPACT_NEVER,
        /// They touch at the start already.
        AtStart = HS_IMPACT_AT_START,
        /// They are apart at the start and come to touch.
        Touch = HS_IMPACT_TOUCH,
    }
}

/// How a shape moves: its centroid straight and its turn even. The default rests at the origin.
///
/// At time t the point that is at X in the shape's frame is at position + t velocity +
/// R(t angular_velocity) Q (gradient + t gradient_rate) X, with position and Q those of the start,
/// and R(v) the turn about v by its length.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Motion {
    raw: sys::hs_motion_def,
}

impl Motion {
    setters! {
        /// Of the centroid, in m/s.
        velocity: [f64; 3],
        /// In rad/s; in the plane about z. It may turn by up to 1e6 rad in the duration.
        angular_velocity: [f64; 3],
    }

    /// From a pose on.
    pub fn from(start: Pose) -> Self {
        Self::default().start(start)
    }

    /// Where it is at first.
    pub fn start(mut self, start: Pose) -> Self {
        self.raw.start = start.into();
        self
    }

    /// How it is strained at first, before the start turns it; by default it is not.
    pub fn gradient(mut self, gradient: Tensor) -> Self {
        self.raw.gradient = nine(gradient);
        self
    }

    /// Of the gradient, in 1/s; by default 0.
    pub fn gradient_rate(mut self, gradient_rate: Tensor) -> Self {
        self.raw.gradient_rate = nine(gradient_rate);
        self
    }
}

impl Default for Motion {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_motion_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_motion_def_init(raw.as_mut_ptr(), size_of::<sys::hs_motion_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}

/// Rows one after the other.
fn nine(tensor: Tensor) -> [f64; 9] {
    std::array::from_fn(|i| tensor[i / 3][i % 3])
}

/// When, where and how two moving shapes first touch.
#[derive(Clone, Copy, Debug, Default)]
#[repr(transparent)]
pub struct Impact {
    raw: sys::hs_impact,
}

impl Impact {
    /// What comes of the motions. Of [`ImpactState::Never`], only the time has a meaning.
    pub fn state(&self) -> ImpactState {
        ImpactState::from_raw(self.raw.state)
    }

    /// In s from the start: never later than the first touch; the duration if there is none.
    pub fn time(&self) -> f64 {
        self.raw.time
    }

    /// Of the potential pair of largest gap then.
    pub fn pair_kind(&self) -> PairKind {
        PairKind::from_raw(self.raw.pair_kind)
    }

    /// Indices of a's and b's vertex, edge or face in that pair.
    pub fn features(&self) -> (usize, usize) {
        (self.raw.feature_a as usize, self.raw.feature_b as usize)
    }

    /// Of the pair then: small to rounding; at most 0 when touching at the start.
    pub fn gap(&self) -> f64 {
        self.raw.gap
    }

    /// Unit, from a to b then.
    pub fn normal(&self) -> [f64; 3] {
        self.raw.normal
    }

    /// Where they touch: the middle of the contact region.
    pub fn point(&self) -> [f64; 3] {
        self.raw.point
    }
}

/// When do two moving shapes first touch, within a duration in s? No touch is passed over, however
/// fast or thin the shapes are or however often they turn: they are apart at every time before the
/// one told.
///
/// ```
/// use halfspace::{time_of_impact, Context, ImpactState, Motion, Pose, Shape};
///
/// let context = Context::new()?;
/// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let falling = Motion::from(Pose::at([0.0, 4.0, 0.0])).velocity([0.0, -300.0, 0.0]);
/// let impact = time_of_impact(&square, &Motion::default(), &square, &falling, 1.0)?;
/// assert_eq!(impact.state(), ImpactState::Touch);
/// assert!((impact.time() - 0.01).abs() < 1e-12);
/// # Ok::<(), halfspace::Error>(())
/// ```
pub fn time_of_impact(
    a: &Shape,
    motion_of_a: &Motion,
    b: &Shape,
    motion_of_b: &Motion,
    duration: f64,
) -> Result<Impact> {
    let mut impact = Impact::default();
    // SAFETY: the shapes live and are of this thread, all else are references.
    let status = unsafe {
        sys::hs_pair_time_of_impact(
            a.handle(),
            &motion_of_a.raw,
            b.handle(),
            &motion_of_b.raw,
            duration,
            &mut impact.raw,
        )
    };
    // The library leaves its text in the context of the first shape.
    a.owner().check(status)?;
    Ok(impact)
}
