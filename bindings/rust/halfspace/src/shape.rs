//! Convex shapes.

use std::ptr;

use halfspace_sys as sys;

use crate::call::{call, create, known, sure};
use crate::context::Context;
use crate::mutable_view::ViewMut;
use crate::object::Object;
use crate::records::{FitReport, ShapeProperties};
use crate::shape_input::FaceLists;
use crate::view::View;
use crate::Result;

/// A convex polygon (2D) or polyhedron (3D). It may be used by any number of blocks; only
/// [`Shape::set_vertices`] changes it.
///
/// The origin of its frame is its centroid; [`ShapeProperties::centroid`] is the centroid in the
/// coordinates that the shape was made from. Faulty input is refused, not repaired. Short edges and
/// small angles are allowed.
///
/// Several threads may use one shape at once, and any thread may own it:
///
/// ```
/// use halfspace::{closest_points, Context, Pose, Shape};
///
/// let context = Context::new()?;
/// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let distance = |x| {
///     let (here, there) = (Pose::default(), Pose::at([x, 0.0, 0.0]));
///     closest_points(square.at(&here), square.at(&there)).map(|closest| closest.distance)
/// };
/// std::thread::scope(|scope| {
///     let others = [2.0, 3.0].map(|x| scope.spawn(move || distance(x)));
///     let found = others.map(|other| other.join().unwrap());
///     assert_eq!(found, [Ok(1.0), Ok(2.0)]);
/// });
/// # Ok::<(), halfspace::Error>(())
/// ```
#[derive(Debug)]
pub struct Shape {
    pub(crate) object: Object<sys::hs_shape>,
}

// SAFETY: it is the only owner of its handle, and the thread rule of shape.h allows that a shape is
// destroyed while other threads use its context: they share only the text of the last error, which
// is written atomically, and the allocator, which any thread may call.
unsafe impl Send for Shape {}
// SAFETY: by the same rule, functions that do not change a shape may be called by several threads at
// once. Only `set_vertices` changes it, by an exclusive reference. No method returns the context.
unsafe impl Sync for Shape {}

/// A half-space: a point p is inside if `dot(normal, p) <= offset`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HalfSpace {
    /// Outer normal.
    pub normal: [f64; 3],
    /// Offset of the plane along the normal.
    pub offset: f64,
}

/// The two parts of a cut shape.
#[derive(Debug)]
pub struct Cut {
    /// The part on the negative side of the normal.
    pub behind: Option<Shape>,
    /// The part on the positive side.
    pub ahead: Option<Shape>,
}

impl Shape {
    /// Creates a convex polygon from its vertices, clockwise or counter-clockwise.
    pub fn polygon<'a>(context: &Context, vertices: impl Into<View<'a>>) -> Result<Self> {
        create!(context => hs_polygon_create(vertices.into())).map(Self::of)
    }

    /// Creates the convex hull of points as a polygon. Points are in any order; inner and repeated
    /// points are allowed.
    pub fn polygon_hull<'a>(context: &Context, points: impl Into<View<'a>>) -> Result<Self> {
        create!(context => hs_polygon_create_hull(points.into())).map(Self::of)
    }

    /// Creates a boundary segment between two ends for a fixed or prescribed block: a virtual
    /// polygon with the segment as one edge. Its inside is on the left of the direction from the
    /// first to the second end: a floor runs towards -x, the walls of a container run clockwise.
    /// `depth` is the depth of the polygon behind the segment, in m: more than twice the max
    /// overlap.
    ///
    /// In a chain, `neighbours` are the other ends of the previous and next segment; the flanks of
    /// the polygon lie under the neighbours.
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
        let (before, after) = (before.as_ref(), after.as_ref());
        create!(context => hs_polygon_create_boundary(before, &first, &second, after, depth))
            .map(Self::of)
    }

    /// Creates a convex polyhedron from its vertices and faces. A face is a list of vertex indices
    /// in outline order; all faces counter-clockwise seen from outside, or all clockwise. Vertices
    /// and faces keep their order.
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
        let (vertices, faces) = (vertices.into(), FaceLists::new(faces)?);
        create!(context => hs_polyhedron_create(vertices, [faces.sizes], &faces)).map(Self::of)
    }

    /// Creates a polyhedron from facets that are plane and convex within a tolerance, e.g. from a
    /// file with rounded coordinates. Facets within the tolerance of a common plane form one face
    /// with a fitted plane. Without facets, those of the convex hull are used. The error text of a
    /// dent names its vertex and a sufficient tolerance.
    pub fn polyhedron_fitted<'a, F: AsRef<[usize]>>(
        context: &Context,
        vertices: impl Into<View<'a>>,
        faces: &[F],
        tolerance: f64,
    ) -> Result<(Self, FitReport)> {
        let (vertices, faces) = (vertices.into(), FaceLists::new(faces)?);
        let mut report = sys::hs_fit_report::default();
        let shape = Object::make(context, |shape| {
            call!(context => hs_polyhedron_create_fitted(
                vertices, [faces.sizes], &faces, tolerance, shape, &mut report
            ))
        })?;
        Ok((Self::of(shape), report.into()))
    }

    /// Creates the convex hull of points as a polyhedron. Facets that are coplanar to rounding are
    /// one face.
    pub fn polyhedron_hull<'a>(context: &Context, points: impl Into<View<'a>>) -> Result<Self> {
        create!(context => hs_polyhedron_create_hull(points.into())).map(Self::of)
    }

    /// Creates the intersection of half-spaces as a polyhedron. Normals may have any length except
    /// 0. A half-space that is redundant to rounding makes no face.
    pub fn polyhedron_from_halfspaces(context: &Context, halfspaces: &[HalfSpace]) -> Result<Self> {
        let normals = View::of(halfspaces, |halfspace| &halfspace.normal);
        let offsets: Vec<f64> = halfspaces.iter().map(|each| each.offset).collect();
        let first = offsets.as_ptr();
        // SAFETY: there are as many offsets as normals.
        create!(context => hs_polyhedron_create_from_halfspaces(normals, unsafe first))
            .map(Self::of)
    }

    /// Cuts the shape by a plane (2D: a line) through a point, with a normal of any length except
    /// 0. Coordinates are those that the shape was made from. If a part is empty or degenerate to
    /// rounding, it is `None` and the other part is a copy of the shape.
    pub fn cut(&self, point: [f64; 3], normal: [f64; 3]) -> Result<Cut> {
        let (mut behind, mut ahead) = (ptr::null_mut(), ptr::null_mut());
        call!(self => hs_shape_cut(&point, &normal, &mut behind, &mut ahead))?;
        let part = |handle| {
            // SAFETY: the library has created it in the context of this shape, for this caller.
            let object = unsafe { Object::own(self.object.owner(), handle) };
            object.map(Self::of)
        };
        Ok(Cut {
            behind: part(behind),
            ahead: part(ahead),
        })
    }

    /// Moves the vertices in place, for hosts whose bodies deform: as many as [`Shape::vertices`]
    /// returns, in that order, in 2D also in the reverse order. In 3D faces must stay plane to
    /// rounding, and convex. Pair caches remain valid; worlds keep the copies that they have. After
    /// an error the shape has not changed.
    ///
    /// ```
    /// use halfspace::{Context, Shape};
    ///
    /// let context = Context::new()?;
    /// let mut body = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// body.set_vertices(&[[0.0, 0.0], [1.0, 0.0], [1.5, 1.0], [0.5, 1.0]])?;
    /// assert_eq!(body.properties().centroid, [0.75, 0.5, 0.0]);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn set_vertices<'a>(&mut self, vertices: impl Into<View<'a>>) -> Result<()> {
        call!(mut self => hs_shape_set_vertices(vertices.into()))
    }

    /// Returns geometry and mass properties.
    pub fn properties(&self) -> ShapeProperties {
        known(|properties, size| call!(self => hs_shape_get_properties(properties, size)))
    }

    /// Returns the vertices, in the coordinates that the shape was made from; in 2D
    /// counter-clockwise.
    pub fn vertices(&self) -> Vec<[f64; 3]> {
        let mut vertices = vec![[0.0; 3]; self.properties().vertex_count];
        let room = ViewMut::from(&mut vertices);
        sure(call!(self => hs_shape_get_vertices(room, &mut 0)));
        vertices
    }

    /// Returns the faces as lists of vertex indices, counter-clockwise seen from outside; in 2D the
    /// two ends of each edge.
    pub fn faces(&self) -> Vec<Vec<usize>> {
        let properties = self.properties();
        let mut first = vec![0; properties.face_count + 1];
        let mut vertices = vec![0; 2 * properties.edge_count];
        sure(call!(self => hs_shape_get_faces([mut first], [mut vertices], &mut 0, &mut 0)));
        FaceLists::split(&first, &vertices)
    }

    /// Returns the edges as pairs of vertex indices.
    /// [`Contact::features`](crate::Contact::features) uses their indices.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let mut ends = vec![[0; 2]; self.properties().edge_count];
        sure(call!(self => hs_shape_get_edges([mut ends], &mut 0)));
        ends.iter()
            .map(|ends| ends.map(|vertex| vertex as usize))
            .collect()
    }

    /// Returns the half-spaces, with outer unit normals, relative to the centroid. One per face; in
    /// 2D one per edge from vertex i to i + 1.
    pub fn halfspaces(&self) -> Vec<HalfSpace> {
        let mut halfspaces = vec![HalfSpace::default(); self.properties().face_count];
        let mut offsets = vec![0.0; halfspaces.len()];
        let normals = ViewMut::of(&mut halfspaces, |halfspace| &mut halfspace.normal);
        // SAFETY: there are as many offsets as normals.
        sure(call!(self => hs_shape_get_halfspaces(normals, unsafe offsets.as_mut_ptr(), &mut 0)));
        for (halfspace, offset) in halfspaces.iter_mut().zip(offsets) {
            halfspace.offset = offset;
        }
        halfspaces
    }

    #[inline]
    pub(crate) fn handle(&self) -> *const sys::hs_shape {
        self.object.handle()
    }

    fn of(object: Object<sys::hs_shape>) -> Self {
        Self { object }
    }
}
