//! A shape with its pose.

use crate::pose::Pose;
use crate::shape::Shape;

/// A shape with its pose, from [`Shape::at`].
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    pub(crate) shape: &'a Shape,
    pub(crate) pose: &'a Pose,
}

impl Shape {
    /// This shape at a pose, for [`detect`](crate::detect).
    #[inline]
    pub fn at<'a>(&'a self, pose: &'a Pose) -> Placed<'a> {
        Placed { shape: self, pose }
    }
}
