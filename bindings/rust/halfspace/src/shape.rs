//! Convex shapes.

use std::mem::size_of;
use std::ptr::{self, NonNull};
use std::rc::Rc;

use halfspace_sys as sys;

use crate::context::{Context, Owner};
use crate::error::Error;
use crate::mutable_view::ViewMut;
use crate::shape_input::{FaceLists, FitReport};
use crate::view::View;
use crate::Result;

/// A convex polygon (in the plane) or polyhedron (in space). It never changes and may be used by
/// any number of blocks.
///
/// Its own frame has the centroid at the origin; [`ShapeProperties::centroid`] says where that was
/// in the coordinates it was made from. Nothing is welded or repaired: faulty input is refused with
/// its reason. Small edges and small angles are legal.
#[derive(Debug)]
pub struct Shape {
    handle: NonNull<sys::hs_shape>,
    owner: Rc<Owner>,
}

/// Geometry of a shape and its mass per unit density.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ShapeProperties {
    /// 2 or 3.
    pub dimension: usize,
    /// At least 3; in space at least 4.
    pub vertex_count: usize,
    /// At least 3; in space at least 6.
    pub edge_count: usize,
    /// Half-spaces: edges in the plane, faces in space.
    pub face_count: usize,
    /// Area times unit thickness in the plane.
    pub volume: f64,
    /// In the coordinates the shape was made from.
    pub centroid: [f64; 3],
    /// About the centroid: xx, yy, zz, xy, yz, zx of the integral of r r^T; in the plane xx, yy, 0,
    /// xy, 0, 0. The moment of inertia about z is the density times (xx + yy), and so on.
    pub second_moment: [f64; 6],
    /// Farthest vertex from the centroid.
    pub bounding_radius: f64,
    /// Its length.
    pub shortest_edge: f64,
}

/// A point p is inside when `dot(normal, p) <= offset`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HalfSpace {
    /// Outer normal.
    pub normal: [f64; 3],
    /// Where the plane is along the normal.
    pub offset: f64,
}

/// The two parts of a cut shape.
#[derive(Debug)]
pub struct Cut {
    /// The part against the normal.
    pub behind: Option<Shape>,
    /// The part along the normal.
    pub ahead: Option<Shape>,
}

impl Shape {
    /// A convex polygon from its vertices, clockwise or counter-clockwise.
    pub fn polygon<'a>(context: &Context, vertices: impl Into<View<'a>>) -> Result<Self> {
        let vertices = vertices.into().raw();
        // SAFETY: the view borrows what it says.
        Self::make(context, |shape| unsafe {
            sys::hs_polygon_create(context.handle(), vertices, shape)
        })
    }

    /// The convex hull of points as a polygon. Any order; inner and repeated points are allowed.
    pub fn polygon_hull<'a>(context: &Context, points: impl Into<View<'a>>) -> Result<Self> {
        let points = points.into().raw();
        // SAFETY: the view borrows what it says.
        Self::make(context, |shape| unsafe {
            sys::hs_polygon_create_hull(context.handle(), points, shape)
        })
    }

    /// A boundary segment from the first to the second of two ends: the virtual polygon of which it
    /// is an edge, for a fixed or prescribed block. The inside is at the left on the way: a floor
    /// under blocks runs towards -x, the walls of a container run clockwise. A line is a segment
    /// that reaches beyond the scene. `depth` is how far the polygon reaches behind the segment:
    /// above twice the deepest overlap.
    ///
    /// Of a segment in a chain, `neighbours` are the other ends of the one before and the one after,
    /// under which the polygon's flanks go, if there are any.
    ///
    /// ```
    /// use halfspace::{Context, Shape};
    ///
    /// let context = Context::new()?;
    /// let floor = Shape::boundary(&context, [[5.0, 0.0], [-5.0, 0.0]], 1.0, [None, None])?;
    /// let flank = 1.0 / f64::sqrt(3.0);
    /// assert!((floor.properties().volume - (10.0 + flank)).abs() < 1e-14);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn boundary(
        context: &Context,
        ends: [[f64; 2]; 2],
        depth: f64,
        neighbours: [Option<[f64; 2]>; 2],
    ) -> Result<Self> {
        let three = |[x, y]: [f64; 2]| [x, y, 0.0];
        let [first, second] = ends.map(three);
        let [before, after] = neighbours.map(|end| end.map(three));
        let pointer = |end: &Option<[f64; 3]>| {
            end.as_ref()
                .map_or(ptr::null(), |end| end as *const [f64; 3])
        };
        // SAFETY: all are references or null where that is allowed.
        Self::make(context, |shape| unsafe {
            sys::hs_polygon_create_boundary(
                context.handle(),
                pointer(&before),
                &first,
                &second,
                pointer(&after),
                depth,
                shape,
            )
        })
    }

    /// A convex polyhedron from its vertices and faces. A face lists its vertices in the order of
    /// its outline, all faces counter-clockwise seen from outside, or all clockwise. Vertices and
    /// faces keep their order.
    ///
    /// ```
    /// use halfspace::{Context, Shape};
    ///
    /// let context = Context::new()?;
    /// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    /// let corner = Shape::polyhedron(&context, &vertices, &faces)?;
    /// assert!((corner.properties().volume - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn polyhedron<'a, F: AsRef<[usize]>>(
        context: &Context,
        vertices: impl Into<View<'a>>,
        faces: &[F],
    ) -> Result<Self> {
        let vertices = vertices.into().raw();
        let faces = FaceLists::new(faces)?;
        // SAFETY: the view borrows what it says, and the lists are as long as the sizes add up to.
        Self::make(context, |shape| unsafe {
            sys::hs_polyhedron_create(
                context.handle(),
                vertices,
                faces.sizes.as_ptr(),
                faces.sizes.len() as i64,
                faces.vertices.as_ptr(),
                shape,
            )
        })
    }

    /// A polyhedron of facets that are plane and convex within a tolerance, such as a file states
    /// them by a few digits. Facets in a common plane within the tolerance are one face, and the
    /// planes are fitted. Without facets those of the convex hull are taken. The error of a dent
    /// names its place and a tolerance that takes it.
    pub fn polyhedron_fitted<'a, F: AsRef<[usize]>>(
        context: &Context,
        vertices: impl Into<View<'a>>,
        faces: &[F],
        tolerance: f64,
    ) -> Result<(Self, FitReport)> {
        let vertices = vertices.into().raw();
        let faces = FaceLists::new(faces)?;
        let mut report = sys::hs_fit_report::default();
        // SAFETY: the view borrows what it says, and the lists are as long as the sizes add up to.
        let shape = Self::make(context, |shape| unsafe {
            sys::hs_polyhedron_create_fitted(
                context.handle(),
                vertices,
                faces.sizes.as_ptr(),
                faces.sizes.len() as i64,
                faces.vertices.as_ptr(),
                tolerance,
                shape,
                &mut report,
            )
        })?;
        Ok((shape, FitReport::from_raw(&report)))
    }

    /// The convex hull of points as a polyhedron with whole faces: what is in one plane to rounding
    /// is one face.
    pub fn polyhedron_hull<'a>(context: &Context, points: impl Into<View<'a>>) -> Result<Self> {
        let points = points.into().raw();
        // SAFETY: the view borrows what it says.
        Self::make(context, |shape| unsafe {
            sys::hs_polyhedron_create_hull(context.handle(), points, shape)
        })
    }

    /// The polyhedron that half-spaces have in common, with normals of any length but 0. A
    /// half-space that cuts nothing off but rounding makes no face.
    pub fn polyhedron_from_halfspaces(context: &Context, halfspaces: &[HalfSpace]) -> Result<Self> {
        let normals = View::of(halfspaces, |halfspace| &halfspace.normal).raw();
        let offsets: Vec<f64> = halfspaces
            .iter()
            .map(|halfspace| halfspace.offset)
            .collect();
        // SAFETY: there are as many offsets as normals.
        Self::make(context, |shape| unsafe {
            sys::hs_polyhedron_create_from_halfspaces(
                context.handle(),
                normals,
                offsets.as_ptr(),
                shape,
            )
        })
    }

    /// Cuts by a plane (in the plane a line) through a point, with a normal of any length but 0.
    /// Coordinates are those the shape was made from. A part that the plane touches only to
    /// rounding is none; the other one is then a copy of the whole.
    pub fn cut(&self, point: [f64; 3], normal: [f64; 3]) -> Result<Cut> {
        let (mut behind, mut ahead) = (ptr::null_mut(), ptr::null_mut());
        // SAFETY: the shape lives, all else are references.
        let status =
            unsafe { sys::hs_shape_cut(self.handle(), &point, &normal, &mut behind, &mut ahead) };
        self.owner.check(status)?;
        let part = |handle| {
            NonNull::new(handle).map(|handle| Self {
                handle,
                owner: Rc::clone(&self.owner),
            })
        };
        Ok(Cut {
            behind: part(behind),
            ahead: part(ahead),
        })
    }

    /// Geometry and mass properties.
    pub fn properties(&self) -> ShapeProperties {
        let mut raw = sys::hs_shape_properties::default();
        // SAFETY: the shape lives, and the size is that of the struct.
        self.owner.expect(unsafe {
            sys::hs_shape_get_properties(
                self.handle(),
                &mut raw,
                size_of::<sys::hs_shape_properties>(),
            )
        });
        ShapeProperties {
            dimension: raw.dimension as usize,
            vertex_count: raw.vertex_count as usize,
            edge_count: raw.edge_count as usize,
            face_count: raw.face_count as usize,
            volume: raw.volume,
            centroid: raw.centroid,
            second_moment: raw.second_moment,
            bounding_radius: raw.bounding_radius,
            shortest_edge: raw.shortest_edge,
        }
    }

    /// The vertices in the coordinates the shape was made from; in the plane counter-clockwise.
    pub fn vertices(&self) -> Vec<[f64; 3]> {
        let mut vertices = vec![[0.0; 3]; self.properties().vertex_count];
        // SAFETY: the shape lives, and the view borrows what it says.
        self.owner.expect(unsafe {
            sys::hs_shape_get_vertices(
                self.handle(),
                ViewMut::from(&mut vertices).raw(),
                ptr::null_mut(),
            )
        });
        vertices
    }

    /// The faces as lists of vertices, counter-clockwise seen from outside; in the plane each edge
    /// with its two ends.
    pub fn faces(&self) -> Vec<Vec<usize>> {
        let properties = self.properties();
        let mut first = vec![0; properties.face_count + 1];
        let mut vertices = vec![0; 2 * properties.edge_count];
        // SAFETY: the shape lives, and both arrays are as long as said.
        self.owner.expect(unsafe {
            sys::hs_shape_get_faces(
                self.handle(),
                first.as_mut_ptr(),
                first.len() as i64,
                vertices.as_mut_ptr(),
                vertices.len() as i64,
                ptr::null_mut(),
                ptr::null_mut(),
            )
        });
        FaceLists::split(&first, &vertices)
    }

    /// The edges in the order that [`Contact::features`](crate::Contact::features) counts them in:
    /// the vertices at their two ends.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let mut ends = vec![[0i32; 2]; self.properties().edge_count];
        // SAFETY: the shape lives, and the array is as long as said.
        self.owner.expect(unsafe {
            sys::hs_shape_get_edges(
                self.handle(),
                ends.as_mut_ptr().cast(),
                ends.len() as i64,
                ptr::null_mut(),
            )
        });
        ends.iter()
            .map(|ends| ends.map(|vertex| vertex as usize))
            .collect()
    }

    /// The half-spaces, with outer unit normals, in the shape's own frame with the centroid at the
    /// origin. One for each face; in the plane for the edge from vertex i to vertex i + 1.
    pub fn halfspaces(&self) -> Vec<HalfSpace> {
        let mut halfspaces = vec![HalfSpace::default(); self.properties().face_count];
        let mut offsets = vec![0.0; halfspaces.len()];
        let mut normals = ViewMut::of(&mut halfspaces, |halfspace| &mut halfspace.normal);
        // SAFETY: the shape lives, and there are as many offsets as normals.
        self.owner.expect(unsafe {
            sys::hs_shape_get_halfspaces(
                self.handle(),
                normals.raw(),
                offsets.as_mut_ptr(),
                ptr::null_mut(),
            )
        });
        for (halfspace, offset) in halfspaces.iter_mut().zip(offsets) {
            halfspace.offset = offset;
        }
        halfspaces
    }

    /// The context the shape was made from.
    pub fn context(&self) -> Context {
        Context::of(&self.owner)
    }

    fn make(
        context: &Context,
        create: impl FnOnce(*mut *mut sys::hs_shape) -> sys::hs_status,
    ) -> Result<Self> {
        let mut handle = ptr::null_mut();
        let status = create(&mut handle);
        context.owner().check(status)?;
        let handle = NonNull::new(handle).ok_or_else(|| Error::argument("no shape was made"))?;
        Ok(Self {
            handle,
            owner: Rc::clone(context.owner()),
        })
    }

    #[inline]
    pub(crate) fn handle(&self) -> *const sys::hs_shape {
        self.handle.as_ptr()
    }

    #[inline]
    pub(crate) fn owner(&self) -> &Rc<Owner> {
        &self.owner
    }
}

impl Drop for Shape {
    fn drop(&mut self) {
        // SAFETY: it is the only owner of the handle, and the context lives as long as `owner`.
        unsafe { sys::hs_shape_destroy(self.handle.as_ptr()) }
    }
}
