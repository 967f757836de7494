//! Borrowed strided arrays of points to write.

use std::marker::PhantomData;
use std::mem::size_of;
use std::ptr;

use halfspace_sys as sys;

use crate::view::{from_points, require_one_length, require_within, FieldPlace, Point};

/// Points that the library writes in place, without a copy. Types that convert to a
/// [`View`](crate::View) convert, borrowed mutably, to a `ViewMut`.
///
/// ```
/// use halfspace::{BlockDef, Context, Shape, ViewMut, World, WorldDef};
///
/// #[derive(Clone, Default)]
/// struct Body { velocity: [f64; 2], spin: [f64; 3] }
///
/// # let context = Context::new()?;
/// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let mut world = World::new(&context, &WorldDef::in_plane())?;
/// let stone = world.add_material(2000.0)?;
/// world.add_block(&square, &BlockDef::rigid(stone).velocity([3.0, 4.0, 0.0]))?;
///
/// let mut bodies = vec![Body::default(); world.block_count()];
/// world.velocities_into(ViewMut::of(&mut bodies, |body| &mut body.velocity), ViewMut::none())?;
/// assert_eq!(bodies[0].velocity, [3.0, 4.0]);
/// # Ok::<(), halfspace::Error>(())
/// ```
///
/// The points are borrowed exclusively:
///
/// ```compile_fail,E0502
/// let mut points = vec![[0.0; 3]; 4];
/// let view = halfspace::ViewMut::from(&mut points);
/// println!("{:?}", points[0]);
/// drop(view);
/// ```
#[derive(Debug)]
pub struct ViewMut<'a> {
    raw: sys::hs_mutable_view,
    borrowed: PhantomData<&'a mut [f64]>,
}

// SAFETY: a view is an exclusive reference to numbers and nothing else.
unsafe impl Send for ViewMut<'_> {}
// SAFETY: likewise; a shared reference only returns the count.
unsafe impl Sync for ViewMut<'_> {}

impl<'a> ViewMut<'a> {
    /// The points that are a field of each item, or the items themselves.
    ///
    /// # Panics
    /// If the field does not have the same offset in all items, e.g. behind a pointer.
    pub fn of<T, const D: usize>(
        items: &'a mut [T],
        field: impl Fn(&mut T) -> &mut [f64; D],
    ) -> Self
    where
        [f64; D]: Point,
    {
        let mut place = FieldPlace::<T, D>::new();
        for item in items.iter_mut() {
            let address: *const T = item;
            place.look_at(address, field(item));
        }
        Self::of_place(items.as_mut_ptr(), items.len(), &place)
    }

    /// Two fields of each item, e.g. forces and torques of the same bodies.
    ///
    /// # Panics
    /// If a field does not have the same offset in all items.
    pub fn of_two<T, const D: usize, const E: usize>(
        items: &'a mut [T],
        fields: impl Fn(&mut T) -> (&mut [f64; D], &mut [f64; E]),
    ) -> (Self, Self)
    where
        [f64; D]: Point,
        [f64; E]: Point,
    {
        let (mut one, mut other) = (FieldPlace::<T, D>::new(), FieldPlace::<T, E>::new());
        for item in items.iter_mut() {
            let address: *const T = item;
            let fields = fields(item);
            one.look_at(address, fields.0);
            other.look_at(address, fields.1);
        }
        let (first, count) = (items.as_mut_ptr(), items.len());
        (
            Self::of_place(first, count, &one),
            Self::of_place(first, count, &other),
        )
    }

    /// Points with a separate array per component.
    ///
    /// # Panics
    /// If the arrays differ in length.
    pub fn components<const D: usize>(components: [&'a mut [f64]; D]) -> Self
    where
        [f64; D]: Point,
    {
        let parts = components.map(|component| (component.as_mut_ptr(), component.len()));
        require_one_length(parts.map(|(_, length)| length));
        Self::new::<D>(|k| parts[k].0, size_of::<f64>() as i64, parts[0].1)
    }

    /// Points in a strided array: component k of point i is `values[first[k] + i * stride]`. The
    /// stride may be negative.
    ///
    /// # Panics
    /// If a point is outside the array, or the stride is 0 with more than one point.
    pub fn strided<const D: usize>(
        values: &'a mut [f64],
        first: [usize; D],
        stride: isize,
        count: usize,
    ) -> Self
    where
        [f64; D]: Point,
    {
        require_within(values.len(), &first, stride, count);
        let stride = (stride as i64).wrapping_mul(size_of::<f64>() as i64);
        let values = values.as_mut_ptr();
        Self::new::<D>(|k| values.wrapping_add(first[k]), stride, count)
    }

    /// An empty view: the library skips this output.
    pub fn none() -> Self {
        Self::new::<3>(|_| ptr::null_mut(), 0, 0)
    }

    /// Capacity in points.
    pub fn count(&self) -> usize {
        self.raw.count as usize
    }

    fn of_place<T, const D: usize>(items: *mut T, count: usize, place: &FieldPlace<T, D>) -> Self {
        let first = items
            .cast::<u8>()
            .wrapping_add(place.offset())
            .cast::<f64>();
        Self::new::<D>(|k| first.wrapping_add(k), size_of::<T>() as i64, count)
    }

    /// All callers ensure that the points are within memory that 'a borrows.
    fn new<const D: usize>(first: impl Fn(usize) -> *mut f64, stride: i64, count: usize) -> Self {
        let z = if D == 3 { first(2) } else { ptr::null_mut() };
        let raw = sys::hs_mutable_view {
            x: first(0),
            y: first(1),
            z,
            stride,
            count: count as i64,
        };
        Self {
            raw,
            borrowed: PhantomData,
        }
    }

    pub(crate) fn raw(self) -> sys::hs_mutable_view {
        self.raw
    }
}

from_points!(ViewMut, as_mut_slice, mut);
