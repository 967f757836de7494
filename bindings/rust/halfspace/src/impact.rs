//! Time of impact of two moving shapes.

use halfspace_sys as sys;

use crate::affine::Tensor;
use crate::call::call;
use crate::pose::Pose;
use crate::shape::Shape;
use crate::Result;

/// Motion of a shape with constant linear and angular velocity and constant rate of deformation.
/// The default is at rest at the origin.
///
/// At time t the material point X (in the shape's frame) is at position + t velocity + R(t
/// angular_velocity) Q (gradient + t gradient_rate) X, with position and rotation Q of the start,
/// and R(v) the rotation about v by the angle |v|.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Motion {
    pub(crate) raw: sys::hs_motion_def,
}

impl Motion {
    /// A motion that starts at a pose.
    pub fn from(start: Pose) -> Self {
        Self::default().start(start)
    }

    /// Pose at time 0.
    pub fn start(mut self, start: Pose) -> Self {
        self.raw.start = start.into();
        self
    }

    /// Deformation gradient at time 0, before the rotation of the start; by default the identity.
    pub fn gradient(mut self, gradient: Tensor) -> Self {
        self.raw.gradient = nine(gradient);
        self
    }

    /// Rate of the gradient, in 1/s; by default 0.
    pub fn gradient_rate(mut self, gradient_rate: Tensor) -> Self {
        self.raw.gradient_rate = nine(gradient_rate);
        self
    }
}

/// The components, row by row.
fn nine(tensor: Tensor) -> [f64; 9] {
    std::array::from_fn(|i| tensor[i / 3][i % 3])
}

/// First touch of two moving shapes.
#[derive(Clone, Copy, Debug, Default)]
#[repr(transparent)]
pub struct Impact {
    pub(crate) raw: sys::hs_impact,
}

impl Impact {
    /// Indices of a's and b's vertex, edge or face in that pair.
    pub fn features(&self) -> (usize, usize) {
        (self.raw.feature_a as usize, self.raw.feature_b as usize)
    }
}

/// Computes the time of impact of two moving shapes within a duration, in s, by conservative
/// advancement. The shapes are separated at all times before the reported one, whatever their
/// speed, thickness or number of revolutions.
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
    call!(a => hs_pair_time_of_impact(
        &motion_of_a.raw, b, &motion_of_b.raw, duration, &mut impact.raw
    ))?;
    Ok(impact)
}
