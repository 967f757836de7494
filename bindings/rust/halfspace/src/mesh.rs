//! Meshes: nodes, and cells that share them.

use std::mem::size_of;
use std::ptr::{self, NonNull};
use std::rc::Rc;

use halfspace_sys as sys;

use crate::context::{Context, Owner};
use crate::error::Error;
use crate::view::View;
use crate::Result;

/// A cell of a mesh: its nodes, counted from 0 and in the order of Gmsh and VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Cell {
    /// Three in the plane, counter-clockwise.
    Triangle([usize; 3]),
    /// Four in the plane, convex and counter-clockwise.
    Quad([usize; 4]),
    /// Four in space: the last lies where the first three run counter-clockwise seen from the other
    /// side.
    Tetrahedron([usize; 4]),
    /// Six in space: those at the bottom, counter-clockwise seen from above, then those above them.
    Prism([usize; 6]),
    /// Eight in space: those at the bottom, counter-clockwise seen from above, then those above
    /// them.
    Hexahedron([usize; 8]),
}

impl Cell {
    /// Its nodes.
    pub fn nodes(&self) -> &[usize] {
        match self {
            Self::Triangle(nodes) => nodes,
            Self::Quad(nodes) => nodes,
            Self::Tetrahedron(nodes) => nodes,
            Self::Prism(nodes) => nodes,
            Self::Hexahedron(nodes) => nodes,
        }
    }

    fn kind(&self) -> i32 {
        match self {
            Self::Triangle(_) => sys::HS_CELL_TRIANGLE,
            Self::Quad(_) => sys::HS_CELL_QUAD,
            Self::Tetrahedron(_) => sys::HS_CELL_TETRAHEDRON,
            Self::Prism(_) => sys::HS_CELL_PRISM,
            Self::Hexahedron(_) => sys::HS_CELL_HEXAHEDRON,
        }
    }
}

/// Numbers of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshProperties {
    /// 2 or 3.
    pub dimension: usize,
    /// Nodes.
    pub node_count: usize,
    /// Cells.
    pub cell_count: usize,
    /// Faces, in the plane edges, that only one cell has.
    pub surface_face_count: usize,
    /// That of all cells, in the plane their area.
    pub volume: f64,
}

/// Nodes, and cells that share them. It never changes and may be put into any number of worlds,
/// where it is a body of finite elements: see [`World::add_mesh`](crate::World::add_mesh).
///
/// Nothing is repaired: faulty input is refused with its reason.
///
/// ```
/// use halfspace::{Cell, Context, Mesh};
///
/// let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0]];
/// let cells = [Cell::Quad([0, 1, 2, 3]), Cell::Triangle([1, 4, 2])];
/// let mesh = Mesh::in_plane(&Context::new()?, &nodes, &cells)?;
/// assert!((mesh.properties().volume - 1.5).abs() < 1e-15);
/// # Ok::<(), halfspace::Error>(())
/// ```
#[derive(Debug)]
pub struct Mesh {
    handle: NonNull<sys::hs_mesh>,
    owner: Rc<Owner>,
    properties: MeshProperties,
}

impl Mesh {
    /// A mesh of triangles and quads.
    ///
    /// # Errors
    /// [`ErrorKind::Geometry`](crate::ErrorKind::Geometry) when a node is named twice in a cell or
    /// belongs to none, a cell is inside out or flat somewhere, or an edge is in more than two
    /// cells; [`ErrorKind::Argument`](crate::ErrorKind::Argument) when there is no cell, or a cell
    /// names a node that is not there or is one of space.
    pub fn in_plane<'a>(
        context: &Context,
        nodes: impl Into<View<'a>>,
        cells: &[Cell],
    ) -> Result<Self> {
        Self::make(context, 2, &nodes.into(), cells)
    }

    /// A mesh of tetrahedra, prisms and hexahedra.
    ///
    /// # Errors
    /// As for [`Mesh::in_plane`], with faces for edges.
    pub fn in_space<'a>(
        context: &Context,
        nodes: impl Into<View<'a>>,
        cells: &[Cell],
    ) -> Result<Self> {
        Self::make(context, 3, &nodes.into(), cells)
    }

    /// Numbers of nodes and cells, and the volume.
    pub fn properties(&self) -> MeshProperties {
        self.properties
    }

    /// The context the mesh was made from.
    pub fn context(&self) -> Context {
        Context::of(&self.owner)
    }

    fn make(context: &Context, dimension: i32, nodes: &View<'_>, cells: &[Cell]) -> Result<Self> {
        let kinds: Vec<i32> = cells.iter().map(Cell::kind).collect();
        let cell_nodes = indices(cells.iter().flat_map(Cell::nodes), "a mesh: cells")?;
        let mut handle = ptr::null_mut();
        // SAFETY: the context lives, the view borrows what it says, and both arrays are as long as
        // said.
        context.owner().check(unsafe {
            sys::hs_mesh_create(
                context.handle(),
                dimension,
                nodes.raw(),
                kinds.as_ptr(),
                kinds.len() as i64,
                cell_nodes.as_ptr(),
                cell_nodes.len() as i64,
                &mut handle,
            )
        })?;
        let mut mesh = Self {
            handle: NonNull::new(handle).ok_or_else(|| Error::argument("no mesh was made"))?,
            owner: Rc::clone(context.owner()),
            properties: MeshProperties::default(),
        };
        mesh.properties = mesh.get_properties()?;
        Ok(mesh)
    }

    /// It takes memory to find the faces at the surface, so that it can fail.
    fn get_properties(&self) -> Result<MeshProperties> {
        let mut raw = sys::hs_mesh_properties::default();
        let size = size_of::<sys::hs_mesh_properties>();
        // SAFETY: the mesh lives, and the size is that of the struct.
        self.owner
            .check(unsafe { sys::hs_mesh_get_properties(self.handle(), &mut raw, size) })?;
        Ok(MeshProperties {
            dimension: raw.dimension as usize,
            node_count: raw.node_count as usize,
            cell_count: raw.cell_count as usize,
            surface_face_count: raw.surface_face_count as usize,
            volume: raw.volume,
        })
    }

    pub(crate) fn handle(&self) -> *const sys::hs_mesh {
        self.handle.as_ptr()
    }

    pub(crate) fn owner(&self) -> &Rc<Owner> {
        &self.owner
    }
}

impl Drop for Mesh {
    fn drop(&mut self) {
        // SAFETY: it is the only owner of the handle, and the context lives as long as `owner`.
        unsafe { sys::hs_mesh_destroy(self.handle.as_ptr()) }
    }
}

/// Indices as the library takes them. `name` says whose they are.
pub(crate) fn indices<'a>(
    values: impl IntoIterator<Item = &'a usize>,
    name: &str,
) -> Result<Vec<i32>> {
    values
        .into_iter()
        .map(|&value| i32::try_from(value))
        .collect::<Result<_, _>>()
        .map_err(|_| Error::argument(&format!("{name}: an index is above 2^31 - 1")))
}
