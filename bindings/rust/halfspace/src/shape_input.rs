//! Validation of the input of shapes, and cleaning of polygons.

use halfspace_sys as sys;

use crate::call::{call, written};
use crate::context::Context;
use crate::error::Error;
use crate::mutable_view::ViewMut;
use crate::records::{Cleaned, Fault};
use crate::view::View;
use crate::Result;

fn fault_of(raw: sys::hs_fault) -> Option<Fault> {
    (raw.kind != sys::HS_FAULT_NONE).then(|| raw.into())
}

impl Context {
    /// Validates the vertices of a polygon without making a shape. `None` if there is no fault.
    ///
    /// ```
    /// use halfspace::{Context, FaultKind};
    /// let dented = [[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]];
    /// let fault = Context::new()?.check_polygon(&dented)?.unwrap();
    /// assert_eq!((fault.kind, fault.vertex), (FaultKind::NotConvex, Some(2)));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn check_polygon<'a>(&self, vertices: impl Into<View<'a>>) -> Result<Option<Fault>> {
        written(|fault, _| call!(self => hs_polygon_check(vertices.into(), fault))).map(fault_of)
    }

    /// Validates the vertices and faces of a polyhedron without making a shape; arguments as for
    /// [`Shape::polyhedron`](crate::Shape::polyhedron).
    pub fn check_polyhedron<'a, F: AsRef<[usize]>>(
        &self,
        vertices: impl Into<View<'a>>,
        faces: &[F],
    ) -> Result<Option<Fault>> {
        let faces = FaceLists::new(faces)?;
        let fault = written(
            |fault, _| call!(self => hs_polyhedron_check(vertices.into(), [faces.sizes], &faces, fault)),
        )?;
        Ok(fault_of(fault))
    }

    /// Cleans the vertices of a polygon: removes repeated and collinear vertices, within a
    /// tolerance, and reverses a clockwise order. It moves no vertex.
    pub fn clean_polygon<'a>(
        &self,
        vertices: impl Into<View<'a>>,
        tolerance: f64,
    ) -> Result<Cleaned> {
        let given = vertices.into();
        let mut vertices = vec![[0.0; 2]; given.count()];
        let room = ViewMut::from(&mut vertices);
        let (mut count, mut report) = (0, sys::hs_clean_report::default());
        call!(self => hs_polygon_clean(given, tolerance, room, &mut count, &mut report))?;
        vertices.truncate(count as usize);
        Ok(Cleaned::new(report, vertices))
    }
}

/// Faces in the layout of the library, face after face.
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
            // Called once: as_ref() may return different slices, and the library relies on the sum
            // of the sizes being the number of vertices.
            let face = face.as_ref();
            lists.sizes.push(narrow(face.len())?);
            for &vertex in face {
                lists.vertices.push(narrow(vertex)?);
            }
        }
        Ok(lists)
    }

    /// The lists from `first` and `vertices` of hs_shape_get_faces().
    pub(crate) fn split(first: &[i32], vertices: &[i32]) -> Vec<Vec<usize>> {
        let face = |ends: &[i32]| &vertices[ends[0] as usize..ends[1] as usize];
        first
            .windows(2)
            .map(|ends| face(ends).iter().map(|&vertex| vertex as usize).collect())
            .collect()
    }
}
