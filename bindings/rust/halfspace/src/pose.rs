//! Pose of a shape.

use std::mem::{align_of, size_of};

use halfspace_sys as sys;

/// Pose of a shape: position of its centroid and rotation about the centroid. The default is at the
/// origin without rotation.
///
/// The layout is that of the C interface, so slices of poses need no copy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Pose {
    /// Position of the centroid, in m; finite, at most 1e75.
    pub position: [f64; 3],
    /// Unit quaternion x, y, z, w; its length may differ from 1 by 1e-6. In 2D x and y are 0.
    pub rotation: [f64; 4],
}

const _: () = assert!(size_of::<Pose>() == size_of::<sys::hs_pose>());
const _: () = assert!(align_of::<Pose>() == align_of::<sys::hs_pose>());

impl Pose {
    /// 2D: centroid at (x, y), rotated counter-clockwise by an angle in radians.
    pub fn in_plane(x: f64, y: f64, angle: f64) -> Self {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        Self {
            position: [x, y, 0.0],
            rotation: [0.0, 0.0, sine, cosine],
        }
    }

    /// The centroid at a position, without rotation.
    pub fn at(position: [f64; 3]) -> Self {
        Self {
            position,
            ..Self::default()
        }
    }

    pub(crate) fn raw(&self) -> *const sys::hs_pose {
        (self as *const Self).cast()
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self {
            position: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
        }
    }
}

impl From<sys::hs_pose> for Pose {
    fn from(raw: sys::hs_pose) -> Self {
        Self {
            position: raw.position,
            rotation: raw.rotation,
        }
    }
}

impl From<Pose> for sys::hs_pose {
    fn from(pose: Pose) -> Self {
        Self {
            position: pose.position,
            rotation: pose.rotation,
        }
    }
}
