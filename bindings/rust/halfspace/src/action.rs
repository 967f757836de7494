//! Motions and loads in time: tables that blocks and nodes follow, force control, and held axes.

use halfspace_sys as sys;

use crate::block::Block;
use crate::body::{Axes, Body};
use crate::call::{call, defaults};
use crate::error::require_entries;
use crate::mesh::indices;
use crate::view::View;
use crate::world::World;
use crate::Result;

/// A table of a world: values at times, linear between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Table(i32);

impl Table {
    /// The table of an index, e.g. in a restored world. Indices start at 0, in the order of
    /// creation.
    pub fn from_index(index: i32) -> Self {
        Self(index)
    }

    /// The index, from 0, in the order of creation.
    pub fn index(self) -> i32 {
        self.0
    }
}

/// A motion or load that follows a table. Loads of one block add up; a motion ends the
/// earlier ones along its axes. A force acts at the centroid, unless it is given another place.
///
/// Within a step a load is constant, the mean of its table, and a prescribed block moves by the
/// integral of its velocity. So impulses and displacements are exact for any time step.
///
/// ```
/// # use halfspace::{BlockDef, Context, Shape, World, WorldDef};
/// use halfspace::Action;
///
/// # let context = Context::new()?;
/// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// # let mut world = World::new(&context, &WorldDef::in_plane().gravity([0.0; 3]).time_step(0.01))?;
/// # let stone = world.add_material(2000.0)?;
/// let block = world.add_block(&square, &BlockDef::rigid(stone))?;
/// let pulse = world.add_table(&[0.0, 0.02, 0.02], &[[0.0, 0.0], [500.0, 0.0], [0.0, 0.0]])?;
/// world.add_action(block, &Action::force(pulse))?;
/// world.step(10)?;
/// let momentum = 2000.0 * world.block_state(block)?.velocity[0];
/// assert!((momentum - 5.0).abs() < 1e-12);
/// # Ok::<(), halfspace::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Action {
    pub(crate) raw: sys::hs_action_def,
}

impl Action {
    /// Force control: a prescribed block, or a rigid one along held axes, moves so that it presses
    /// on its contacts with the force of the table, in N, along the scale as a vector. It moves at
    /// most with `max_speed`, in m/s. The contacts need springs.
    pub fn servo(table: Table, max_speed: f64) -> Self {
        Self::of_kind(sys::HS_ACTION_SERVO, table).max_speed(max_speed)
    }

    /// The force acts at a point of the block, which moves with it: `point` is where it is now, in
    /// m.
    pub fn at_carried(self, point: [f64; 3]) -> Self {
        self.at(sys::HS_PLACE_CARRIED, point)
    }

    /// The force acts at a point in space, in m.
    pub fn at_fixed(self, point: [f64; 3]) -> Self {
        self.at(sys::HS_PLACE_FIXED, point)
    }

    /// The force acts at the centroid: the default.
    pub fn at_centroid(self) -> Self {
        self.at(sys::HS_PLACE_CENTROID, [0.0; 3])
    }

    fn at(mut self, place: i32, point: [f64; 3]) -> Self {
        self.raw.place = place;
        self.raw.point = point;
        self
    }

    pub(crate) fn of_kind(kind: i32, table: Table) -> Self {
        let mut raw = defaults(sys::hs_action_def_init);
        raw.kind = kind;
        raw.table = table.0;
        Self { raw }
    }
}

/// Motions and loads in time, and held axes.
impl World {
    /// Adds a table. Before its first and after its last time it is constant.
    ///
    /// `times` has one entry per row, in s, in ascending order; two equal ones are a jump. Values
    /// without z have z = 0. [`View::components`] of the same array for all components makes a
    /// table of numbers.
    pub fn add_table<'a>(&mut self, times: &[f64], values: impl Into<View<'a>>) -> Result<Table> {
        let (name, values) = ("World::add_table: times", values.into());
        require_entries(name, times.len(), values.count(), "rows")?;
        let mut table = 0;
        // SAFETY: there is one time per row.
        call!(mut self => hs_world_add_table(unsafe times.as_ptr(), values, &mut table))?;
        Ok(Table(table))
    }

    /// Adds an action on a block, or with `None` on all blocks that move freely, which only take
    /// [`Action::acceleration`].
    ///
    /// # Errors
    /// [`ErrorKind::State`](crate::ErrorKind::State) for a kind of block that cannot follow it,
    /// [`ErrorKind::StaleId`](crate::ErrorKind::StaleId) for a block or table that the world does
    /// not have.
    pub fn add_action(&mut self, block: impl Into<Option<Block>>, action: &Action) -> Result<()> {
        call!(mut self => hs_world_add_action(block.into(), &action.raw))
    }

    /// Ends all actions on a block, or with `None` those on all blocks. A prescribed block keeps
    /// its last velocity.
    pub fn end_actions(&mut self, block: impl Into<Option<Block>>) -> Result<()> {
        call!(mut self => hs_world_end_actions(block.into()))
    }

    /// Adds an action on nodes of a body: a force, or a velocity or acceleration along axes held by
    /// [`World::hold_nodes`]. `scales` has the factors of each node instead of [`Action::scale`],
    /// e.g. its share of the area of a traction.
    pub fn add_node_action<'a>(
        &mut self,
        body: Body,
        nodes: &[usize],
        scales: impl Into<View<'a>>,
        action: &Action,
    ) -> Result<()> {
        let (name, scales) = ("World::add_node_action: nodes", scales.into());
        require_entries(name, nodes.len(), scales.count(), "scales")?;
        let (nodes, action) = (indices(nodes, name)?, &action.raw);
        // SAFETY: there is one node per scale.
        call!(mut self => hs_world_add_node_action(body, unsafe nodes.as_ptr(), scales, action))
    }

    /// Ends all actions on the nodes of a body. Held nodes keep their last velocity.
    pub fn end_node_actions(&mut self, body: Body) -> Result<()> {
        call!(mut self => hs_world_end_node_actions(body))
    }

    /// Sets the viscosity of nodes of a body, in N s/m: a dashpot connects each with the ground. With
    /// the impedance of a face, waves leave the body there. 0 removes the dashpots.
    pub fn set_node_viscosity(
        &mut self,
        body: Body,
        nodes: &[usize],
        viscosity: [[f64; 3]; 3],
    ) -> Result<()> {
        let nodes = indices(nodes, "World::set_node_viscosity: nodes")?;
        call!(mut self => hs_world_set_node_viscosity(body, [nodes], &viscosity))
    }

    /// Holds axes of a rigid block: the velocity along them stays, whatever the forces, and with
    /// [`Axes::ROTATION`] it does not rotate. [`Axes::NONE`] frees the block. Its contacts of
    /// laws without springs are points, without restitution.
    pub fn hold_block(&mut self, block: Block, axes: Axes) -> Result<()> {
        call!(mut self => hs_world_hold_block(block, axes))
    }

    /// Sets the velocities of prescribed blocks between steps, one per block, in m/s, and their
    /// angular velocities, in rad/s, which have three components; an empty view keeps the current
    /// ones. Contacts and forces are kept, so it may be called at each step. After an error none
    /// has changed.
    pub fn prescribe_velocities<'a, 'b>(
        &mut self,
        blocks: &[Block],
        velocities: impl Into<View<'a>>,
        angular_velocities: impl Into<View<'b>>,
    ) -> Result<()> {
        let (velocities, angular) = (velocities.into(), angular_velocities.into());
        let name = "World::prescribe_velocities: blocks";
        require_entries(name, blocks.len(), velocities.count(), "velocities")?;
        let blocks = blocks.as_ptr().cast();
        // SAFETY: a Block is a u64, and there is one per velocity.
        call!(mut self => hs_world_prescribe_velocities(unsafe blocks, velocities, angular))
    }
}
