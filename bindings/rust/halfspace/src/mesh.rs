//! Meshes: nodes, and cells that share them.

use halfspace_sys as sys;

use crate::call::{call, create, written};
use crate::context::Context;
use crate::error::Error;
use crate::object::Object;
use crate::records::MeshProperties;
use crate::view::View;
use crate::Result;

/// A cell of a mesh: node indices, in the order of Gmsh and VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Cell {
    /// 3 nodes, 2D, counter-clockwise.
    Triangle([usize; 3]),
    /// 4 nodes, 2D, convex and counter-clockwise.
    Quad([usize; 4]),
    /// 4 nodes, 3D: the first three are counter-clockwise seen from the last.
    Tetrahedron([usize; 4]),
    /// 6 nodes, 3D: the bottom face, counter-clockwise seen from above, then the top face in the
    /// same order.
    Prism([usize; 6]),
    /// 8 nodes, 3D: the bottom face, counter-clockwise seen from above, then the top face in the
    /// same order.
    Hexahedron([usize; 8]),
}

impl Cell {
    /// The node indices.
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

/// Nodes, and cells that share them. A mesh is immutable and may be added to any number of worlds,
/// where it is a body of finite elements: see [`World::add_mesh`](crate::World::add_mesh).
///
/// Faulty input is refused, not repaired.
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
    pub(crate) object: Object<sys::hs_mesh>,
    properties: MeshProperties,
}

impl Mesh {
    /// Creates a mesh of triangles and quads.
    ///
    /// # Errors
    /// [`ErrorKind::Geometry`](crate::ErrorKind::Geometry) if a cell uses a node twice, a node
    /// belongs to no cell, a cell is inverted or flat anywhere, or an edge belongs to more than two
    /// cells; [`ErrorKind::Argument`](crate::ErrorKind::Argument) if there is no cell, a node index
    /// is out of range, or a cell is 3D.
    pub fn in_plane<'a>(
        context: &Context,
        nodes: impl Into<View<'a>>,
        cells: &[Cell],
    ) -> Result<Self> {
        Self::make(context, 2, &nodes.into(), cells)
    }

    /// Creates a mesh of tetrahedra, prisms and hexahedra.
    ///
    /// # Errors
    /// As for [`Mesh::in_plane`], with faces instead of edges.
    pub fn in_space<'a>(
        context: &Context,
        nodes: impl Into<View<'a>>,
        cells: &[Cell],
    ) -> Result<Self> {
        Self::make(context, 3, &nodes.into(), cells)
    }

    /// Returns the numbers of nodes and cells, and the volume.
    pub fn properties(&self) -> MeshProperties {
        self.properties
    }

    /// The context of the mesh.
    pub fn context(&self) -> Context {
        Context::of(self.object.owner())
    }

    fn make(context: &Context, dimension: i32, nodes: &View<'_>, cells: &[Cell]) -> Result<Self> {
        let kinds: Vec<i32> = cells.iter().map(Cell::kind).collect();
        let cell_nodes = indices(cells.iter().flat_map(Cell::nodes), "a mesh: cells")?;
        let mut mesh = Self {
            object: create!(context => hs_mesh_create(dimension, *nodes, [kinds], [cell_nodes]))?,
            properties: MeshProperties::default(),
        };
        // The search for surface faces allocates memory, so this can fail.
        mesh.properties =
            written(|properties, size| call!(mesh => hs_mesh_get_properties(properties, size)))?;
        Ok(mesh)
    }
}

/// Converts indices for the library. `name` is their name in the error text.
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
