//! A world: blocks, materials, laws and time.

use halfspace_sys as sys;

use crate::block::{Block, BlockDef, Material};
use crate::call::{call, create, filled, initial, known, sure, written};
use crate::context::Context;
use crate::error::Error;
use crate::law::Law;
use crate::object::Object;
use crate::records::{Plan, Report};
use crate::shape::Shape;
use crate::Result;

/// Settings of a world.
///
/// ```
/// use halfspace::WorldDef;
/// let def = WorldDef::in_space().local_damping(0.1);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct WorldDef {
    pub(crate) raw: sys::hs_world_def,
}

impl WorldDef {
    /// 2D: polygons.
    pub fn in_plane() -> Self {
        Self::of_dimension(2)
    }

    /// 3D: polyhedra.
    pub fn in_space() -> Self {
        Self::of_dimension(3)
    }

    /// Dimension 2 or 3, chosen at run time.
    pub fn of_dimension(dimension: i32) -> Self {
        let known = if dimension == 3 { 3 } else { 2 };
        // SAFETY: the size is that of the struct.
        let mut raw: sys::hs_world_def =
            initial(|def, size| unsafe { sys::hs_world_def_init(def, size, known) });
        raw.dimension = dimension; // World::new refuses values other than 2 or 3
        Self { raw }
    }

    /// Continuous collision: true (default) divides a step in which touching blocks would move by
    /// more than a quarter of the thinner one's thickness; false refuses it with
    /// [`ErrorKind::TooFast`](crate::ErrorKind::TooFast).
    pub fn divide_fast_blocks(mut self, is_divided: bool) -> Self {
        self.raw.fast_blocks = if is_divided {
            sys::HS_FAST_DIVIDE
        } else {
            sys::HS_FAST_REFUSE
        };
        self
    }
}

impl Default for WorldDef {
    fn default() -> Self {
        Self::in_plane()
    }
}

/// Blocks, materials, laws and time. Use [`World::step`], or [`World::detect`] and
/// [`World::forces`] with an integrator of the host.
///
/// Arrays of all blocks have the order of [`World::blocks`], which is the order of creation as long
/// as none is removed.
#[derive(Debug)]
pub struct World {
    pub(crate) object: Object<sys::hs_world>,
    /// Cached, so that checks of array lengths are cheap.
    pub(crate) block_count: usize,
    /// The length of a row of loads, cached likewise; `None` before the first and after a change of materials.
    pub(crate) load_length: Option<usize>,
}

impl World {
    /// Creates an empty world.
    pub fn new(context: &Context, def: &WorldDef) -> Result<Self> {
        create!(context => hs_world_create(&def.raw)).map(Self::of)
    }

    /// Creates a world from a snapshot of [`World::save`], with the same ids, materials and laws.
    /// It continues bit for bit.
    pub fn restore(context: &Context, bytes: &[u8]) -> Result<Self> {
        create!(context => hs_world_restore([bytes])).map(Self::of)
    }

    /// Returns a snapshot of the complete state.
    pub fn save(&self) -> Vec<u8> {
        let get =
            |room: &mut [u8], size: &mut usize| call!(self => hs_world_save([mut room], size));
        let size: usize = known(|size, _| get(&mut [], size));
        sure(filled(size, |room| get(room, &mut 0)))
    }

    /// Adds a material with a density above 0, in kg/m3.
    pub fn add_material(&mut self, density: f64) -> Result<Material> {
        let index = written(|index, _| call!(mut self => hs_world_add_material(density, index)))?;
        Ok(Material(index))
    }

    /// Sets the law of all pairs of materials without a law of their own.
    pub fn set_default_law(&mut self, law: &Law) -> Result<()> {
        call!(mut self => hs_world_set_default_law(&law.raw))
    }

    /// Sets the law of two materials, in either order; they may be the same.
    pub fn set_law(&mut self, a: Material, b: Material, law: &Law) -> Result<()> {
        call!(mut self => hs_world_set_law(a, b, &law.raw))
    }

    /// Adds a block. The world copies the shape, which may be of any context of this thread.
    pub fn add_block(&mut self, shape: &Shape, def: &BlockDef) -> Result<Block> {
        let def = def.raw(shape);
        let id = written(|id, _| call!(mut self => hs_world_add_block(shape, &def, id)))?;
        self.block_count += 1;
        Block::from_id(id)
            .ok_or_else(|| Error::argument("World::add_block: the library returned the id 0"))
    }

    /// Removes a block; its id becomes stale. The cost is proportional to the size of the world.
    pub fn remove_block(&mut self, block: Block) -> Result<()> {
        let parts = self.compound_parts(block).map_or(0, |parts| parts.len());
        call!(mut self => hs_world_remove_block(block))?;
        self.block_count -= 1 + parts;
        Ok(())
    }

    /// Steps the world. After an error it keeps the last valid state, and can be read or saved.
    pub fn step(&mut self, steps: u64) -> Result<()> {
        call!(mut self => hs_world_step(steps))
    }

    /// Returns time, time step, counts and energies. After a change of the world it detects
    /// contacts and evaluates forces first, without any effect on the run.
    pub fn report(&mut self) -> Result<Report> {
        written(|report, size| call!(mut self => hs_world_get_report(report, size)))
    }

    /// Returns the active parts of the world, the limit of its step, and times of `steps` steps of
    /// a copy.
    ///
    /// # Errors
    /// [`ErrorKind::OutOfMemory`](crate::ErrorKind::OutOfMemory).
    pub fn plan(&self, steps: usize) -> Result<Plan> {
        written(|plan, size| call!(self => hs_world_get_plan(steps, plan, size)))
    }

    /// Number of living blocks.
    pub fn block_count(&self) -> usize {
        self.block_count
    }

    /// The context of the world.
    pub fn context(&self) -> Context {
        Context::of(self.object.owner())
    }

    pub(crate) fn of(object: Object<sys::hs_world>) -> Self {
        let mut world = Self {
            object,
            block_count: 0,
            load_length: None,
        };
        world.recount_blocks();
        world
    }

    /// Bodies add and remove blocks.
    pub(crate) fn recount_blocks(&mut self) {
        self.block_count = self.count_blocks();
    }
}
