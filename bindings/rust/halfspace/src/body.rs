//! Bodies: meshes in a world (Wang et al. 2021, section 2.1; Li et al. 2015, section 2).

use std::num::NonZeroU64;
use std::ops::BitOr;
use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::call::{call, counted, defaults, listed_points, written};
use crate::error::{require, Error};
use crate::mesh::{indices, Mesh};
use crate::mutable_view::ViewMut;
use crate::pose::Pose;
use crate::records::{BodyState, CellState};
use crate::view::View;
use crate::world::World;
use crate::Result;

/// Id of a body of a world: a mesh that was added to it. Ids of removed bodies are not reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Body(NonZeroU64);

impl Body {
    /// The body of a number from [`Body::id`], e.g. read from a file. `None` for 0.
    pub fn from_id(id: u64) -> Option<Self> {
        NonZeroU64::new(id).map(Self)
    }

    /// The `hs_body` of the C interface; never 0.
    pub fn id(self) -> u64 {
        self.0.get()
    }
}

/// Definition of a body: material, pose and velocity.
///
/// ```
/// use halfspace::{BodyDef, Material, Pose};
/// let rubber = Material::from_index(0);
/// let thrown = BodyDef::of(rubber).at(Pose::at([0.0, 5.0, 0.0])).velocity([3.0, 0.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct BodyDef<'a> {
    material: Material,
    cell_materials: Option<&'a [Material]>,
    pose: Option<Pose>,
    velocity: [f64; 3],
}

impl<'a> BodyDef<'a> {
    /// A body of one material, which must have an elasticity: see
    /// [`World::set_elasticity`](crate::World::set_elasticity).
    pub fn of(material: Material) -> Self {
        Self {
            material,
            cell_materials: None,
            pose: None,
            velocity: [0.0; 3],
        }
    }

    /// A body with one material per cell; all must have an elasticity.
    pub fn of_each(cell_materials: &'a [Material]) -> Self {
        Self {
            cell_materials: Some(cell_materials),
            ..Self::of(Material(0))
        }
    }

    /// Pose of the frame of the mesh; by default the identity.
    pub fn at(mut self, pose: Pose) -> Self {
        self.pose = Some(pose);
        self
    }

    /// Velocity of all nodes, in m/s; by default 0.
    pub fn velocity(mut self, velocity: [f64; 3]) -> Self {
        self.velocity = velocity;
        self
    }

    fn raw(&self) -> sys::hs_body_def {
        let mut raw = defaults(sys::hs_body_def_init);
        raw.material = self.material.0;
        raw.pose = self.pose.map_or(raw.pose, Into::into);
        raw.velocity = self.velocity;
        raw
    }
}

/// Axes along which nodes or rigid blocks are held.
///
/// ```
/// use halfspace::Axes;
/// let both = Axes::X | Axes::Y;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Axes(pub(crate) i32);

impl Axes {
    /// No axis: frees nodes or a block.
    pub const NONE: Self = Self(0);
    /// Along x.
    pub const X: Self = Self(sys::HS_AXIS_X);
    /// Along y.
    pub const Y: Self = Self(sys::HS_AXIS_Y);
    /// Along z, 3D only.
    pub const Z: Self = Self(sys::HS_AXIS_Z);
    /// The rotation of a rigid block, about all axes.
    pub const ROTATION: Self = Self(sys::HS_AXIS_ROTATION);
}

impl BitOr for Axes {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// Bodies. Arrays have the order of the nodes or cells of the mesh.
impl World {
    /// Adds a copy of a mesh to the world. The mesh may be of any context of this thread. Its
    /// surface cells become blocks of [`BlockKind::Mesh`](crate::BlockKind::Mesh), which are in
    /// contact with other blocks and in all lists of blocks.
    ///
    /// # Errors
    /// [`ErrorKind::State`](crate::ErrorKind::State) for a material without elasticity,
    /// [`ErrorKind::Geometry`](crate::ErrorKind::Geometry) if rounding at the pose inverts or
    /// flattens a cell, [`ErrorKind::Argument`](crate::ErrorKind::Argument) for a mesh of another
    /// dimension.
    pub fn add_mesh(&mut self, mesh: &Mesh, def: &BodyDef<'_>) -> Result<Body> {
        if let Some(materials) = def.cell_materials {
            let (count, cells) = (materials.len(), mesh.properties().cell_count);
            require(count == cells, || {
                format!("World::add_mesh: cell_materials has {count} entries; the mesh has {cells} cells")
            })?;
        }
        let materials = def
            .cell_materials
            .map_or(ptr::null(), |materials| materials.as_ptr());
        let (mut id, raw) = (0, def.raw());
        // SAFETY: a Material is an i32, and there is none or one for each cell.
        call!(mut self => hs_world_add_mesh(mesh, &raw, unsafe materials.cast(), &mut id))?;
        self.recount_blocks();
        Body::from_id(id)
            .ok_or_else(|| Error::argument("World::add_mesh: the library returned the id 0"))
    }

    /// Removes a body and its surface blocks from the world; its id becomes stale.
    pub fn remove_body(&mut self, body: Body) -> Result<()> {
        call!(mut self => hs_world_remove_body(body))?;
        self.recount_blocks();
        Ok(())
    }

    /// Returns motion and energy of a body.
    pub fn body_state(&self, body: Body) -> Result<BodyState> {
        written(|state, size| call!(self => hs_world_get_body_state(body, state, size)))
    }

    /// Returns the body and the index of the cell of a surface block; `None` for a block of another
    /// kind.
    pub fn body_of_block(&self, block: Block) -> Result<Option<(Body, usize)>> {
        let (mut id, mut cell) = (0, 0);
        call!(self => hs_world_get_body_of_block(block, &mut id, &mut cell))?;
        Ok(Body::from_id(id).map(|body| (body, cell as usize)))
    }

    /// Returns the positions of a body's nodes, in m.
    pub fn node_positions(&self, body: Body) -> Result<Vec<[f64; 3]>> {
        listed_points(|positions| self.node_positions_into(body, positions))
    }

    /// The same into memory that is there already: as many as there is room for. Returns how many
    /// nodes the body has.
    pub fn node_positions_into<'a>(
        &self,
        body: Body,
        positions: impl Into<ViewMut<'a>>,
    ) -> Result<usize> {
        counted(|count| call!(self => hs_world_get_node_positions(body, positions.into(), count)))
    }

    /// Returns the velocities of a body's nodes, in m/s.
    pub fn node_velocities(&self, body: Body) -> Result<Vec<[f64; 3]>> {
        listed_points(|velocities| self.node_velocities_into(body, velocities))
    }

    /// The same into memory that is there already, as for [`World::node_positions_into`].
    pub fn node_velocities_into<'a>(
        &self,
        body: Body,
        velocities: impl Into<ViewMut<'a>>,
    ) -> Result<usize> {
        counted(|count| call!(self => hs_world_get_node_velocities(body, velocities.into(), count)))
    }

    /// Returns the total forces on a body's nodes at the end of the last step (cells, contacts,
    /// gravity, applied), in N, in 2D per unit thickness. In equilibrium they are 0, except at held
    /// nodes: there they are the forces that press on the support.
    pub fn node_forces(&self, body: Body) -> Result<Vec<[f64; 3]>> {
        listed_points(|forces| self.node_forces_into(body, forces))
    }

    /// The same into memory that is there already, as for [`World::node_positions_into`].
    pub fn node_forces_into<'a>(
        &self,
        body: Body,
        forces: impl Into<ViewMut<'a>>,
    ) -> Result<usize> {
        counted(|count| call!(self => hs_world_get_node_forces(body, forces.into(), count)))
    }

    /// Sets the velocities of all nodes of a body, including held ones; one per node, in m/s.
    pub fn set_node_velocities<'a>(
        &mut self,
        body: Body,
        velocities: impl Into<View<'a>>,
    ) -> Result<()> {
        call!(mut self => hs_world_set_node_velocities(body, velocities.into()))
    }

    /// Prescribes a constant velocity of nodes along axes, in m/s, in addition to axes held before;
    /// components of `velocity` along other axes are ignored. [`Axes::NONE`] frees the nodes along
    /// all axes.
    pub fn hold_nodes(
        &mut self,
        body: Body,
        nodes: &[usize],
        axes: Axes,
        velocity: [f64; 3],
    ) -> Result<()> {
        let nodes = indices(nodes, "World::hold_nodes: nodes")?;
        call!(mut self => hs_world_hold_nodes(body, [nodes], axes, &velocity))
    }

    /// Sets the external force on each of these nodes, until set again, in N, in 2D per unit
    /// thickness.
    pub fn set_node_force(&mut self, body: Body, nodes: &[usize], force: [f64; 3]) -> Result<()> {
        let nodes = indices(nodes, "World::set_node_force: nodes")?;
        call!(mut self => hs_world_set_node_force(body, [nodes], &force))
    }

    /// Removes cells of a body (excavation). Indices of the other cells and nodes do not change.
    /// Returns the force that these cells exerted on each node, to be applied by
    /// [`World::set_node_force`] and reduced gradually.
    pub fn remove_cells(&mut self, body: Body, cells: &[usize]) -> Result<Vec<[f64; 3]>> {
        let cells = indices(cells, "World::remove_cells: cells")?;
        let mut released = vec![[0.0; 3]; self.body_state(body)?.node_count as usize];
        let room = ViewMut::from(&mut released);
        call!(mut self => hs_world_remove_cells(body, [cells], room))?;
        self.recount_blocks();
        Ok(released)
    }

    /// Sets the current stress of the cells of a body, linear in space: each cell gets the stress
    /// at its center. `stress` is the Cauchy stress at the origin, in Pa, tension above 0;
    /// `gradient` has its derivatives along x, y and z, in Pa/m.
    pub fn set_body_stress(
        &mut self,
        body: Body,
        stress: &[[f64; 3]; 3],
        gradient: &[[[f64; 3]; 3]; 3],
    ) -> Result<()> {
        call!(mut self => hs_world_set_body_stress(body, stress, gradient))
    }

    /// Returns strain and stress of a body's cells.
    pub fn cells(&self, body: Body) -> Result<Vec<CellState>> {
        let mut cells = vec![CellState::default(); self.cells_into(body, &mut [])?];
        self.cells_into(body, &mut cells)?;
        Ok(cells)
    }

    /// The same into memory that is there already: as many as there is room for. Returns how many
    /// cells the body has.
    pub fn cells_into(&self, body: Body, cells: &mut [CellState]) -> Result<usize> {
        counted(|count| call!(self => hs_world_get_cells(body, [mut cells], count)))
    }
}
