//! Queries without contact: rays, closest points, and pairs of overlapping boxes.

use halfspace_sys as sys;

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
    let mut points = sys::hs_closest_points::default();
    // SAFETY: the shapes live and nobody changes them, all else are references.
    let status = unsafe {
        sys::hs_pair_distance(
            a.shape.handle(),
            a.pose.raw(),
            b.shape.handle(),
            b.pose.raw(),
            &mut points,
        )
    };
    // The error text is in the context of the first shape.
    a.shape.owner().check(status)?;
    Ok(points.into())
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
        let mut hit = sys::hs_ray_hit::default();
        // SAFETY: the shape lives and nobody changes it, all else are references.
        let status = unsafe {
            sys::hs_shape_cast_ray(
                self.shape.handle(),
                self.pose.raw(),
                &origin,
                &direction,
                max_distance,
                &mut hit,
            )
        };
        self.shape.owner().check(status)?;
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
        let mut hit = sys::hs_ray_hit::default();
        // SAFETY: the world lives.
        self.check(unsafe {
            sys::hs_world_cast_ray(self.handle(), &origin, &direction, max_distance, &mut hit)
        })?;
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
    let (lower, upper) = (lower.into().raw(), upper.into().raw());
    let is_in_plane = lower.z.is_null() || upper.z.is_null();
    let mut pairs = vec![[0; 2]; lower.count as usize];
    loop {
        let (capacity, mut count) = (pairs.len() as i64, 0);
        // SAFETY: the views borrow what they say, and the array is as long as said.
        let status = unsafe {
            sys::hs_boxes_find_pairs(
                context.handle(),
                if is_in_plane { 2 } else { 3 },
                lower,
                upper,
                pairs.as_mut_ptr().cast(),
                capacity,
                &mut count,
            )
        };
        context.owner().check(status)?;
        pairs.resize(count as usize, [0; 2]);
        if count <= capacity {
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
    let points = points.into().raw();
    let mut order = vec![0; points.count as usize];
    // SAFETY: the view borrows what it says, and the array is as long.
    let status = unsafe {
        sys::hs_points_order_along_curve(
            context.handle(),
            if points.z.is_null() { 2 } else { 3 },
            points,
            order.as_mut_ptr(),
        )
    };
    context.owner().check(status)?;
    Ok(order)
}
