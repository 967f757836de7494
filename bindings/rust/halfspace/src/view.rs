//! Borrowed strided arrays of points to read.

use std::marker::PhantomData;
use std::mem::size_of;
use std::ptr;

use halfspace_sys as sys;

/// A point in memory: `[f64; 2]` in 2D, `[f64; 3]` in 2D or 3D.
pub trait Point: sealed::Point {}

impl Point for [f64; 2] {}
impl Point for [f64; 3] {}

mod sealed {
    pub trait Point {}
    impl Point for [f64; 2] {}
    impl Point for [f64; 3] {}
}

/// Points that the library reads in place, without a copy.
///
/// Slices, vectors and arrays of points convert to views. Other layouts:
///
/// ```
/// use halfspace::{Context, Shape, View};
///
/// let context = Context::new()?;
/// let (x, y) = (vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0]);
/// let from_separate_arrays = Shape::polygon(&context, View::components([&x, &y]))?;
///
/// struct Node { mass: f64, position: [f64; 2] }
/// let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|position| Node { mass: 1.0, position });
/// let from_structs = Shape::polygon(&context, View::of(&nodes, |node| &node.position))?;
///
/// // All x, then all y, as in a Fortran array x(n,2), of which every other point is taken.
/// let values = [0.0, 9.0, 1.0, 9.0, 0.0, 9.0, 0.0, 9.0, 0.0, 9.0, 1.0, 9.0];
/// let from_a_section = Shape::polygon(&context, View::strided(&values, [0, 6], 2, 3))?;
///
/// assert_eq!(from_separate_arrays.vertices(), from_structs.vertices());
/// assert_eq!(from_separate_arrays.vertices(), from_a_section.vertices());
/// # Ok::<(), halfspace::Error>(())
/// ```
///
/// A view borrows its points:
///
/// ```compile_fail,E0506
/// let mut points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let view = halfspace::View::from(&points);
/// points[0] = [0.5, 0.5];
/// drop(view);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    raw: sys::hs_view,
    borrowed: PhantomData<&'a [f64]>,
}

// SAFETY: a view is a shared reference to numbers and nothing else.
unsafe impl Send for View<'_> {}
// SAFETY: likewise.
unsafe impl Sync for View<'_> {}

impl<'a> View<'a> {
    /// The points that are a field of each item, or the items themselves.
    ///
    /// # Panics
    /// If the field does not have the same offset in all items, e.g. behind a pointer.
    pub fn of<T, const D: usize>(items: &'a [T], field: impl Fn(&T) -> &[f64; D]) -> Self
    where
        [f64; D]: Point,
    {
        let mut place = FieldPlace::<T, D>::new();
        for item in items {
            place.look_at(item, field(item));
        }
        let first = items
            .as_ptr()
            .cast::<u8>()
            .wrapping_add(place.offset())
            .cast::<f64>();
        Self::new::<D>(
            |k| first.wrapping_add(k),
            size_of::<T>() as i64,
            items.len(),
        )
    }

    /// Points with a separate array per component.
    ///
    /// # Panics
    /// If the arrays differ in length.
    pub fn components<const D: usize>(components: [&'a [f64]; D]) -> Self
    where
        [f64; D]: Point,
    {
        require_one_length(components.map(<[f64]>::len));
        Self::new::<D>(
            |k| components[k].as_ptr(),
            size_of::<f64>() as i64,
            components[0].len(),
        )
    }

    /// Points in a strided array: component k of point i is `values[first[k] + i * stride]`. The
    /// stride may be negative.
    ///
    /// # Panics
    /// If a point is outside the array, or the stride is 0 with more than one point.
    pub fn strided<const D: usize>(
        values: &'a [f64],
        first: [usize; D],
        stride: isize,
        count: usize,
    ) -> Self
    where
        [f64; D]: Point,
    {
        require_within(values.len(), &first, stride, count);
        let stride = (stride as i64).wrapping_mul(size_of::<f64>() as i64);
        Self::new::<D>(|k| values.as_ptr().wrapping_add(first[k]), stride, count)
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.raw.count as usize
    }

    /// All callers ensure that the points are within memory that 'a borrows.
    fn new<const D: usize>(first: impl Fn(usize) -> *const f64, stride: i64, count: usize) -> Self {
        let z = if D == 3 { first(2) } else { ptr::null() };
        let raw = sys::hs_view {
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

    pub(crate) fn dimension(&self) -> i32 {
        if self.raw.z.is_null() {
            2
        } else {
            3
        }
    }

    pub(crate) fn raw(self) -> sys::hs_view {
        self.raw
    }
}

/// Slices, arrays and vectors of points convert to views.
macro_rules! from_points {
    ($view:ident, $as_slice:ident $(, $mutable:tt)?) => {
        impl<'a, const D: usize> From<&'a $($mutable)? [[f64; D]]> for $view<'a>
        where
            [f64; D]: Point,
        {
            fn from(points: &'a $($mutable)? [[f64; D]]) -> Self {
                Self::of(points, |point| point)
            }
        }

        impl<'a, const D: usize, const N: usize> From<&'a $($mutable)? [[f64; D]; N]> for $view<'a>
        where
            [f64; D]: Point,
        {
            fn from(points: &'a $($mutable)? [[f64; D]; N]) -> Self {
                Self::from(points.$as_slice())
            }
        }

        impl<'a, const D: usize> From<&'a $($mutable)? Vec<[f64; D]>> for $view<'a>
        where
            [f64; D]: Point,
        {
            fn from(points: &'a $($mutable)? Vec<[f64; D]>) -> Self {
                Self::from(points.$as_slice())
            }
        }
    };
}

from_points!(View, as_slice);
pub(crate) use from_points;

/// Computes the offset of a field of D numbers in its item, in bytes. It checks all items, as enums
/// have the field in some only. For plain fields the compiler removes the loop.
pub(crate) struct FieldPlace<T, const D: usize> {
    offset: Option<usize>,
    item: PhantomData<T>,
}

impl<T, const D: usize> FieldPlace<T, D> {
    pub(crate) fn new() -> Self {
        Self {
            offset: None,
            item: PhantomData,
        }
    }

    #[inline]
    pub(crate) fn look_at(&mut self, item: *const T, field: &[f64; D]) {
        let offset = (field.as_ptr() as usize).wrapping_sub(item as usize);
        let room = size_of::<T>().checked_sub(size_of::<[f64; D]>());
        assert!(
            room.map_or(false, |room| offset <= room),
            "the field is outside its item"
        );
        assert!(
            *self.offset.get_or_insert(offset) == offset,
            "the field has different offsets in the items"
        );
    }

    pub(crate) fn offset(&self) -> usize {
        self.offset.unwrap_or(0)
    }
}

pub(crate) fn require_one_length<const D: usize>(lengths: [usize; D]) {
    assert!(
        lengths.iter().all(|length| *length == lengths[0]),
        "components of different lengths: {lengths:?}"
    );
}

pub(crate) fn require_within(length: usize, first: &[usize], stride: isize, count: usize) {
    if count == 0 {
        return;
    }
    assert!(
        stride != 0 || count == 1,
        "the stride of {count} points is 0"
    );
    let length = length as i128;
    for start in first {
        let start = *start as i128;
        let end = start + stride as i128 * (count as i128 - 1);
        assert!(
            start < length && 0 <= end && end < length,
            "points from {start} to {end} in an array of {length} values"
        );
    }
}
