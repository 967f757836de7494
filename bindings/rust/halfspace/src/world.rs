//! A world: blocks, materials, laws and time.

use std::mem::{size_of, MaybeUninit};
use std::os::raw::c_void;
use std::ptr::{self, NonNull};
use std::rc::Rc;

use halfspace_sys as sys;

use crate::block::{Block, BlockDef, Material};
use crate::constants::setters;
use crate::context::{Context, Owner};
use crate::error::Error;
use crate::law::Law;
use crate::plan::Plan;
use crate::report::Report;
use crate::shape::Shape;
use crate::Result;

/// How a world is made.
///
/// ```
/// use halfspace::WorldDef;
/// let def = WorldDef::in_space().local_damping(0.1);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct WorldDef {
    raw: sys::hs_world_def,
}

impl WorldDef {
    /// Of polygons.
    pub fn in_plane() -> Self {
        Self::of_dimension(2)
    }

    /// Of polyhedra.
    pub fn in_space() -> Self {
        Self::of_dimension(3)
    }

    /// Of 2 or 3 dimensions, where that is not known when the program is written.
    pub fn of_dimension(dimension: i32) -> Self {
        let mut raw = MaybeUninit::<sys::hs_world_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let mut raw = unsafe {
            let known = if dimension == 3 { 3 } else { 2 };
            sys::hs_world_def_init(raw.as_mut_ptr(), size_of::<sys::hs_world_def>(), known);
            raw.assume_init()
        };
        raw.dimension = dimension; // any other than 2 or 3 is refused when the world is made
        Self { raw }
    }

    setters! {
        /// Acceleration; by default 9.81 downwards: along -y in the plane, along -z in space.
        gravity: [f64; 3],
        /// Above 0; or 0, the default: safety times the stable time step, found when the first step
        /// begins and again after each change of the world from outside.
        time_step: f64,
        /// Share of the stable time step, above 0 and at most 1; by default 0.5.
        safety: f64,
        /// Force opposing each velocity component, share of the force, at least 0 and below 1; by
        /// default 0.
        local_damping: f64,
        /// In 1/s, at least 0: force `-mass_damping * mass * velocity`; by default 0.
        mass_damping: f64,
        /// Reach of the neighbour list, share of a block's size, above 0 and at most 1; by default
        /// 0.1.
        skin: f64,
        /// See [`Detector::parallel_angle`](crate::Detector::parallel_angle).
        parallel_angle: f64,
        /// See [`Detector::vertex_zone`](crate::Detector::vertex_zone).
        vertex_zone: f64,
        /// The length H of [`Law::potential`], one for all blocks, above 0; or 0, the default: the
        /// mean length of all blocks' edges when forces are first used.
        potential_length: f64,
        /// The way, in m, at least 0, that any block may miss over a whole run as it stands still
        /// in time while nothing reaches it; by default 0: none does.
        sleep_tolerance: f64,
    }

    /// Whether a step is divided in which blocks meet that move by more than a quarter of the
    /// thinner one's thickness; by default it is. Otherwise it ends with
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

/// Blocks, materials, laws and time; used whole ([`World::step`]) or stage by stage
/// ([`World::detect`], [`World::forces`]).
///
/// Arrays over all blocks are in the order of [`World::blocks`], which is the order in which they
/// were added as long as none is removed.
#[derive(Debug)]
pub struct World {
    handle: NonNull<sys::hs_world>,
    owner: Rc<Owner>,
    /// Kept here, so that the length of an array over all blocks is checked for nothing.
    block_count: usize,
}

impl World {
    /// An empty world.
    pub fn new(context: &Context, def: &WorldDef) -> Result<Self> {
        // SAFETY: the context lives and the definition is valid.
        Self::make(context, |world| unsafe {
            sys::hs_world_create(context.handle(), &def.raw, world)
        })
    }

    /// A world from what [`World::save`] gave, with its blocks, ids, materials and laws. It goes on
    /// bit for bit.
    pub fn restore(context: &Context, bytes: &[u8]) -> Result<Self> {
        // SAFETY: the context lives and the bytes are as many as said.
        Self::make(context, |world| unsafe {
            sys::hs_world_restore(context.handle(), bytes.as_ptr().cast(), bytes.len(), world)
        })
    }

    /// The whole state of motion and contact.
    pub fn save(&self) -> Vec<u8> {
        let mut size = 0;
        let mut bytes = Vec::<u8>::new();
        // SAFETY: there is room for nothing, and nothing is written.
        self.owner
            .expect(unsafe { sys::hs_world_save(self.handle(), ptr::null_mut(), 0, &mut size) });
        bytes.reserve_exact(size);
        let room = bytes.as_mut_ptr().cast::<c_void>();
        // SAFETY: there is room for as many bytes as the world said.
        self.owner
            .expect(unsafe { sys::hs_world_save(self.handle(), room, size, &mut size) });
        // SAFETY: all of them have been written.
        unsafe { bytes.set_len(size) };
        bytes
    }

    /// Adds a material of a density above 0.
    pub fn add_material(&mut self, density: f64) -> Result<Material> {
        let mut index = 0;
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_add_material(self.handle(), density, &mut index) })?;
        Ok(Material(index))
    }

    /// Sets the law of all pairs of materials that have none of their own.
    pub fn set_default_law(&mut self, law: &Law) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the law is valid.
        self.check(unsafe { sys::hs_world_set_default_law(self.handle(), law.raw()) })
    }

    /// Sets the law between two materials, in either order; the same one twice is legal.
    pub fn set_law(&mut self, a: Material, b: Material, law: &Law) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the law is valid.
        self.check(unsafe { sys::hs_world_set_law(self.handle(), a.0, b.0, law.raw()) })
    }

    /// Adds a block. The world copies the shape, which may be of any context of this thread.
    pub fn add_block(&mut self, shape: &Shape, def: &BlockDef) -> Result<Block> {
        let def = def.raw(shape);
        let mut id = 0;
        // SAFETY: world and shape live, the definition is valid.
        self.check(unsafe {
            sys::hs_world_add_block(self.handle(), shape.handle(), &def, &mut id)
        })?;
        self.block_count += 1;
        Block::from_raw(id)
            .ok_or_else(|| Error::argument("World::add_block: the library gave the id of no block"))
    }

    /// Removes a block; its name becomes stale. The cost grows with the size of the world.
    pub fn remove_block(&mut self, block: Block) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_remove_block(self.handle(), block.id()) })?;
        self.block_count -= 1;
        Ok(())
    }

    /// Steps the world. When a run becomes unstable, or a cell of a mesh would be turned inside out,
    /// it stays at the last good step and can be read or saved.
    pub fn step(&mut self, steps: u64) -> Result<()> {
        let steps = i64::try_from(steps).unwrap_or(i64::MAX);
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_step(self.handle(), steps) })
    }

    /// Time, time step, counts and energies. After a change of the world it detects and evaluates
    /// forces first, as a step would; that leaves no trace in the run.
    pub fn report(&mut self) -> Result<Report> {
        let mut raw = sys::hs_world_report::default();
        let size = size_of::<sys::hs_world_report>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.check(unsafe { sys::hs_world_get_report(self.handle(), &mut raw, size) })?;
        Ok(raw.into())
    }

    /// The parts that the world computes and the limit of its step. Times are those of so many steps of a
    /// copy.
    ///
    /// # Errors
    /// [`ErrorKind::OutOfMemory`](crate::ErrorKind::OutOfMemory).
    pub fn plan(&self, steps: usize) -> Result<Plan> {
        let mut raw = sys::hs_world_plan::default();
        let size = size_of::<sys::hs_world_plan>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.check(unsafe { sys::hs_world_get_plan(self.handle(), steps as i64, &mut raw, size) })?;
        Ok(raw.into())
    }

    /// How many blocks live.
    pub fn block_count(&self) -> usize {
        self.block_count
    }

    /// The context the world was made from.
    pub fn context(&self) -> Context {
        Context::of(&self.owner)
    }

    fn make(
        context: &Context,
        create: impl FnOnce(*mut *mut sys::hs_world) -> sys::hs_status,
    ) -> Result<Self> {
        let mut handle = ptr::null_mut();
        let status = create(&mut handle);
        context.owner().check(status)?;
        // SAFETY: the library has just made it in this context, for this caller.
        unsafe { Self::own(context.owner(), handle) }
            .ok_or_else(|| Error::argument("no world was made"))
    }

    /// `None` of no world.
    ///
    /// # Safety
    /// The handle is NULL, or of a world of that context which nothing else owns.
    pub(crate) unsafe fn own(owner: &Rc<Owner>, handle: *mut sys::hs_world) -> Option<Self> {
        let mut world = Self {
            handle: NonNull::new(handle)?,
            owner: Rc::clone(owner),
            block_count: 0,
        };
        world.recount_blocks();
        Some(world)
    }

    /// A body brings its blocks, and takes them along when it is removed.
    pub(crate) fn recount_blocks(&mut self) {
        self.block_count = self.count_blocks();
    }

    pub(crate) fn check(&self, status: sys::hs_status) -> Result<()> {
        self.owner.check(status)
    }

    /// Functions that change the world are called from `&mut self` only.
    pub(crate) fn handle(&self) -> *mut sys::hs_world {
        self.handle.as_ptr()
    }

    pub(crate) fn owner(&self) -> &Rc<Owner> {
        &self.owner
    }
}

impl Drop for World {
    fn drop(&mut self) {
        // SAFETY: it is the only owner of the handle, and the context lives as long as `owner`.
        unsafe { sys::hs_world_destroy(self.handle.as_ptr()) }
    }
}
