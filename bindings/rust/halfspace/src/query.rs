//! Queries without contact: rays, closest points, and pairs of overlapping boxes.

use halfspace_sys as sys;

use crate::call::{call, counted, written};
use crate::context::Context;
use crate::placed::Placed;
use crate::records::{ClosestPoints, RayHit};
use crate::view::View;
use crate::world::World;
use crate::Result;

/// Finds the closest points of two shapes, by GJK. Shapes with parallel faces may have many; one
/// pair is returned. The depth of an overlap is the gap of [`detect`](crate::detect).
///
/// ```
/// use halfspace::{closest_points, Context, Pose, Shape};
///
/// let context = Context::new()?;
/// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let (here, there) = (Pose::default(), Pose::at([4.0, 5.0, 0.0]));
/// let closest = closest_points(square.at(&here), square.at(&there))?;
/// assert_eq!((closest.distance, closest.normal), (5.0, [0.6, 0.8, 0.0])); // from corner to corner
/// # Ok::<(), halfspace::Error>(())
/// ```
pub fn closest_points(a: Placed<'_>, b: Placed<'_>) -> Result<ClosestPoints> {
    written(|points, _| call!(a.shape => hs_pair_distance(a.pose, b.shape, b.pose, points)))
}

impl Placed<'_> {
    /// Casts a ray of a length, in m, at the shape; `None` if it does not meet it. A ray that touches
    /// the shape to rounding hits it. The direction may have any length except 0.
    ///
    /// ```
    /// use halfspace::{Context, Pose, Shape};
    ///
    /// let context = Context::new()?;
    /// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// let pose = Pose::at([3.0, 0.0, 0.0]);
    /// let hit = square.at(&pose).cast_ray([0.0, 0.25, 0.0], [1.0, 0.0, 0.0], 100.0)?.unwrap();
    /// assert_eq!((hit.distance, hit.normal, hit.face), (2.5, [-1.0, 0.0, 0.0], Some(3)));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn cast_ray(
        &self,
        origin: [f64; 3],
        direction: [f64; 3],
        max_distance: f64,
    ) -> Result<Option<RayHit>> {
        let hit: sys::hs_ray_hit = written(
            |hit, _| call!(self.shape => hs_shape_cast_ray(self.pose, &origin, &direction, max_distance, hit)),
        )?;
        Ok((hit.is_hit != 0).then(|| hit.into()))
    }
}

/// # Rays
impl World {
    /// Casts a ray of a length, in m, and returns the first block that it meets: fixed ones, parts of
    /// compounds, and cells at the surfaces of meshes, as they are deformed now.
    pub fn cast_ray(
        &self,
        origin: [f64; 3],
        direction: [f64; 3],
        max_distance: f64,
    ) -> Result<Option<RayHit>> {
        let hit: sys::hs_ray_hit = written(
            |hit, _| call!(self => hs_world_cast_ray(&origin, &direction, max_distance, hit)),
        )?;
        Ok((hit.is_hit != 0).then(|| hit.into()))
    }
}

/// Broad phase alone: finds all pairs of overlapping boxes, at any ratio of sizes, in time linear in
/// boxes and pairs. Boxes are given by their lower and upper corners, in 2D or 3D. Each pair has two
/// indices in ascending order; the order of the pairs depends on the boxes only.
///
/// ```
/// use halfspace::{find_box_pairs, Context};
///
/// let lower = [[0.0, 0.0], [0.5, 0.5], [3.0, 0.0]];
/// let upper = lower.map(|[x, y]| [x + 1.0, y + 1.0]);
/// assert_eq!(find_box_pairs(&Context::new()?, &lower, &upper)?, [[0, 1]]);
/// # Ok::<(), halfspace::Error>(())
/// ```
pub fn find_box_pairs<'a>(
    context: &Context,
    lower: impl Into<View<'a>>,
    upper: impl Into<View<'a>>,
) -> Result<Vec<[i32; 2]>> {
    let (lower, upper) = (lower.into(), upper.into());
    let dimension = lower.dimension().min(upper.dimension());
    let mut pairs = vec![[0; 2]; lower.count()];
    loop {
        let count = counted(
            |count| call!(context => hs_boxes_find_pairs(dimension, lower, upper, [mut pairs], count)),
        )?;
        let is_whole = count <= pairs.len();
        pairs.resize(count, [0; 2]);
        if is_whole {
            return Ok(pairs);
        }
    }
}

/// Orders points along a Hilbert curve through their box: returns their indices, the first along the curve
/// first. Blocks that are added in this order have their neighbours close in memory, so that steps of large
/// worlds take less time. Points in one place keep their order.
///
/// ```
/// use halfspace::{order_along_curve, Context};
///
/// let corners = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
/// assert_eq!(order_along_curve(&Context::new()?, &corners)?, [0, 3, 1, 2]);
/// # Ok::<(), halfspace::Error>(())
/// ```
pub fn order_along_curve<'a>(context: &Context, points: impl Into<View<'a>>) -> Result<Vec<i32>> {
    let points = points.into();
    let (dimension, mut order) = (points.dimension(), vec![0; points.count()]);
    // SAFETY: there is one index per point.
    call!(context => hs_points_order_along_curve(dimension, points, unsafe order.as_mut_ptr()))?;
    Ok(order)
}
