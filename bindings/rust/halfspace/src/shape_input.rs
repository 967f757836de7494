//! What a shape is made from: what can be wrong with it, and cleaning it up.

use halfspace_sys as sys;

use crate::constants::constants;
use crate::context::Context;
use crate::error::Error;
use crate::mutable_view::ViewMut;
use crate::view::View;
use crate::Result;

constants! {
    /// What can be wrong with what a shape is to be made from.
    FaultKind {
        /// Polygon: fewer than 3 vertices.
        TooFewVertices = HS_FAULT_TOO_FEW_VERTICES,
        /// Polygon: NaN, infinite, or too large or small to compute with.
        NotFinite = HS_FAULT_NOT_FINITE,
        /// Polygon: two neighbours at the same place.
        RepeatedVertex = HS_FAULT_REPEATED_VERTEX,
        /// Polygon: a vertex on the line of its neighbours, to rounding.
        CollinearVertex = HS_FAULT_COLLINEAR_VERTEX,
        /// Polygon: a corner that turns the other way.
        NotConvex = HS_FAULT_NOT_CONVEX,
        /// Polygon: the outline winds more than once or crosses itself.
        SelfCrossing = HS_FAULT_SELF_CROSSING,
        /// Polygon: all vertices on one line.
        ZeroArea = HS_FAULT_ZERO_AREA,
        /// Polyhedron: fewer than four vertices or faces.
        FewerThanFour = HS_FAULT_FEWER_THAN_FOUR,
        /// Polyhedron: a face of fewer than 3 vertices.
        FaceTooShort = HS_FAULT_FACE_TOO_SHORT,
        /// Polyhedron: a face refers to a vertex that is not there.
        NoSuchVertex = HS_FAULT_NO_SUCH_VERTEX,
        /// Polyhedron: a face goes through the same vertex twice.
        VertexTwiceInFace = HS_FAULT_VERTEX_TWICE_IN_FACE,
        /// Polyhedron: a vertex that belongs to no face.
        UnusedVertex = HS_FAULT_UNUSED_VERTEX,
        /// Polyhedron: an edge not shared by two faces in opposite directions.
        UnmatchedEdge = HS_FAULT_UNMATCHED_EDGE,
        /// Polyhedron: a vertex of two faces only: not a corner.
        VertexInsideEdge = HS_FAULT_VERTEX_INSIDE_EDGE,
        /// Polyhedron: several surfaces, or one with holes.
        NotOneSurface = HS_FAULT_NOT_ONE_SURFACE,
        /// Polyhedron: not finite, or beyond 1e50, or the whole smaller than 1e-50.
        OutOfRange = HS_FAULT_OUT_OF_RANGE,
        /// Polyhedron: two vertices at the same place.
        CoincidingVertices = HS_FAULT_COINCIDING_VERTICES,
        /// Polyhedron: all vertices in one plane, to rounding.
        ZeroVolume = HS_FAULT_ZERO_VOLUME,
        /// Polyhedron: a face with all vertices on one line, to rounding.
        FaceWithoutArea = HS_FAULT_FACE_WITHOUT_AREA,
        /// Polyhedron: a vertex off the plane of its face by more than rounding.
        FaceNotPlane = HS_FAULT_FACE_NOT_PLANE,
        /// Polyhedron: a vertex before a face's plane: not convex.
        VertexOutsideFace = HS_FAULT_VERTEX_OUTSIDE_FACE,
        /// Polyhedron: a face in one plane with a neighbour, to rounding.
        CoplanarFaces = HS_FAULT_COPLANAR_FACES,
        /// Points so close to degenerate that rounding hides their hull.
        HullFailed = HS_FAULT_HULL_FAILED,
        /// A half-space whose normal is 0.
        NoDirection = HS_FAULT_NO_DIRECTION,
        /// Half-spaces that do not bound a region.
        Unbounded = HS_FAULT_UNBOUNDED,
        /// Half-spaces without a region, or with one flat to rounding.
        NoCommonPoint = HS_FAULT_NO_COMMON_POINT,
        /// Facets to be fitted: a dent deeper than the tolerance.
        BeyondTolerance = HS_FAULT_BEYOND_TOLERANCE,
    }
}

/// The first fault of what a shape was to be made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Fault {
    /// What is wrong.
    pub kind: FaultKind,
    /// Index of the offending vertex, `None` if it is the whole.
    pub vertex: Option<usize>,
    /// Index of the offending face, `None` if there is none.
    pub face: Option<usize>,
}

impl Fault {
    fn from_raw(raw: &sys::hs_fault) -> Option<Self> {
        (raw.kind != sys::HS_FAULT_NONE).then(|| Self {
            kind: FaultKind::from_raw(raw.kind),
            vertex: usize::try_from(raw.vertex).ok(),
            face: usize::try_from(raw.face).ok(),
        })
    }
}

/// What [`Context::clean_polygon`] left, and what it changed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cleaned {
    /// The vertices that remain, counter-clockwise.
    pub vertices: Vec<[f64; 2]>,
    /// Vertices dropped because they lay within the tolerance of the one before.
    pub welded: usize,
    /// Vertices dropped because they lay within it of their neighbours' line.
    pub straightened: usize,
    /// Was the order turned?
    pub reversed: bool,
}

/// The changes that [`Shape::polyhedron_fitted`](crate::Shape::polyhedron_fitted) made.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FitReport {
    /// Facets given beyond the faces made.
    pub merged: usize,
    /// Largest distance of a vertex from the fitted plane of its face.
    pub deviation: f64,
    /// Largest distance of a corner from where it was given.
    pub moved: f64,
}

impl FitReport {
    pub(crate) fn from_raw(raw: &sys::hs_fit_report) -> Self {
        Self {
            merged: raw.merged as usize,
            deviation: raw.deviation,
            moved: raw.moved,
        }
    }
}

impl Context {
    /// Says what is wrong with a polygon's vertices without making a shape.
    ///
    /// ```
    /// use halfspace::{Context, FaultKind};
    /// let dented = [[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]];
    /// let fault = Context::new()?.check_polygon(&dented)?.unwrap();
    /// assert_eq!((fault.kind, fault.vertex), (FaultKind::NotConvex, Some(2)));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn check_polygon<'a>(&self, vertices: impl Into<View<'a>>) -> Result<Option<Fault>> {
        let mut fault = sys::hs_fault::default();
        // SAFETY: the view borrows what it says.
        let status =
            unsafe { sys::hs_polygon_check(self.handle(), vertices.into().raw(), &mut fault) };
        self.owner().check(status)?;
        Ok(Fault::from_raw(&fault))
    }

    /// Says what is wrong with a polyhedron's vertices and faces without making a shape; they are
    /// given as for [`Shape::polyhedron`](crate::Shape::polyhedron).
    pub fn check_polyhedron<'a, F: AsRef<[usize]>>(
        &self,
        vertices: impl Into<View<'a>>,
        faces: &[F],
    ) -> Result<Option<Fault>> {
        let faces = FaceLists::new(faces)?;
        let mut fault = sys::hs_fault::default();
        // SAFETY: the view borrows what it says, and the lists are as long as the sizes add up to.
        let status = unsafe {
            sys::hs_polyhedron_check(
                self.handle(),
                vertices.into().raw(),
                faces.sizes.as_ptr(),
                faces.sizes.len() as i64,
                faces.vertices.as_ptr(),
                &mut fault,
            )
        };
        self.owner().check(status)?;
        Ok(Fault::from_raw(&fault))
    }

    /// Cleans up a polygon's vertices: drops repeated ones and those on the line of their
    /// neighbours, within a tolerance, and turns the order counter-clockwise. It never moves a
    /// vertex.
    pub fn clean_polygon<'a>(
        &self,
        vertices: impl Into<View<'a>>,
        tolerance: f64,
    ) -> Result<Cleaned> {
        let given = vertices.into();
        let mut vertices = vec![[0.0; 2]; given.count()];
        let mut count = 0;
        let mut report = sys::hs_clean_report::default();
        // SAFETY: both views are of memory that is there.
        let status = unsafe {
            sys::hs_polygon_clean(
                self.handle(),
                given.raw(),
                tolerance,
                ViewMut::from(&mut vertices).raw(),
                &mut count,
                &mut report,
            )
        };
        self.owner().check(status)?;
        vertices.truncate(count as usize);
        Ok(Cleaned {
            vertices,
            welded: report.welded as usize,
            straightened: report.straightened as usize,
            reversed: report.reversed != 0,
        })
    }
}

/// Faces one after the other, as the library takes them.
pub(crate) struct FaceLists {
    pub(crate) sizes: Vec<i32>,
    pub(crate) vertices: Vec<i32>,
}

impl FaceLists {
    pub(crate) fn new<F: AsRef<[usize]>>(faces: &[F]) -> Result<Self> {
        let narrow = |value: usize| {
            i32::try_from(value).map_err(|_| Error::argument("faces: an index is above 2^31 - 1"))
        };
        let mut lists = Self {
            sizes: Vec::with_capacity(faces.len()),
            vertices: Vec::new(),
        };
        for face in faces {
            // Asked once: nothing binds as_ref() to the same answer twice, and the library trusts the
            // sizes to add up to the number of vertices.
            let face = face.as_ref();
            lists.sizes.push(narrow(face.len())?);
            for &vertex in face {
                lists.vertices.push(narrow(vertex)?);
            }
        }
        Ok(lists)
    }

    /// The lists that `first` and `vertices` of hs_shape_get_faces() describe.
    pub(crate) fn split(first: &[i32], vertices: &[i32]) -> Vec<Vec<usize>> {
        let face = |ends: &[i32]| &vertices[ends[0] as usize..ends[1] as usize];
        first
            .windows(2)
            .map(|ends| face(ends).iter().map(|&vertex| vertex as usize).collect())
            .collect()
    }
}
