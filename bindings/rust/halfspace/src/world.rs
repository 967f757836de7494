//! A world: blocks, materials, laws and time.

use std::mem::{size_of, MaybeUninit};
use std::os::raw::c_void;
use std::ptr::{self, NonNull};
use std::sync::Arc;

use halfspace_sys as sys;

use crate::block::{Block, BlockDef, Material};
use crate::context::{Context, Owner};
use crate::error::Error;
use crate::law::Law;
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
        let mut raw = MaybeUninit::<sys::hs_world_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let mut raw = unsafe {
            let known = if dimension == 3 { 3 } else { 2 };
            sys::hs_world_def_init(raw.as_mut_ptr(), size_of::<sys::hs_world_def>(), known);
            raw.assume_init()
        };
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
    handle: NonNull<sys::hs_world>,
    owner: Arc<Owner>,
    /// Cached, so that checks of array lengths are cheap.
    pub(crate) block_count: usize,
    /// The length of a row of loads, cached likewise; `None` before the first and after a change of materials.
    pub(crate) load_length: Option<usize>,
}

impl World {
    /// Creates an empty world.
    pub fn new(context: &Context, def: &WorldDef) -> Result<Self> {
        // SAFETY: the context lives and the definition is valid.
        Self::make(context, |world| unsafe {
            sys::hs_world_create(context.handle(), &def.raw, world)
        })
    }

    /// Creates a world from a snapshot of [`World::save`], with the same ids, materials and laws.
    /// It continues bit for bit.
    pub fn restore(context: &Context, bytes: &[u8]) -> Result<Self> {
        // SAFETY: the context lives and the bytes are as many as said.
        Self::make(context, |world| unsafe {
            sys::hs_world_restore(context.handle(), bytes.as_ptr().cast(), bytes.len(), world)
        })
    }

    /// Returns a snapshot of the complete state.
    pub fn save(&self) -> Vec<u8> {
        let mut size = 0;
        let mut bytes = Vec::<u8>::new();
        // SAFETY: the capacity is 0, so nothing is written.
        self.owner
            .expect(unsafe { sys::hs_world_save(self.handle(), ptr::null_mut(), 0, &mut size) });
        bytes.reserve_exact(size);
        let room = bytes.as_mut_ptr().cast::<c_void>();
        // SAFETY: the capacity is the reported size.
        self.owner
            .expect(unsafe { sys::hs_world_save(self.handle(), room, size, &mut size) });
        // SAFETY: all of them have been written.
        unsafe { bytes.set_len(size) };
        bytes
    }

    /// Adds a material with a density above 0, in kg/m3.
    pub fn add_material(&mut self, density: f64) -> Result<Material> {
        let mut index = 0;
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_add_material(self.handle(), density, &mut index) })?;
        Ok(Material(index))
    }

    /// Sets the law of all pairs of materials without a law of their own.
    pub fn set_default_law(&mut self, law: &Law) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the law is valid.
        self.check(unsafe { sys::hs_world_set_default_law(self.handle(), law.raw()) })
    }

    /// Sets the law of two materials, in either order; they may be the same.
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
            .ok_or_else(|| Error::argument("World::add_block: the library returned the id 0"))
    }

    /// Removes a block; its id becomes stale. The cost is proportional to the size of the world.
    pub fn remove_block(&mut self, block: Block) -> Result<()> {
        let parts = self.compound_parts(block).map_or(0, |parts| parts.len());
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_remove_block(self.handle(), block.id()) })?;
        self.block_count -= 1 + parts;
        Ok(())
    }

    /// Steps the world. After an error it keeps the last valid state, and can be read or saved.
    pub fn step(&mut self, steps: u64) -> Result<()> {
        let steps = i64::try_from(steps).unwrap_or(i64::MAX);
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_step(self.handle(), steps) })
    }

    /// Returns time, time step, counts and energies. After a change of the world it detects
    /// contacts and evaluates forces first, without any effect on the run.
    pub fn report(&mut self) -> Result<Report> {
        let mut raw = sys::hs_world_report::default();
        let size = size_of::<sys::hs_world_report>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.check(unsafe { sys::hs_world_get_report(self.handle(), &mut raw, size) })?;
        Ok(raw.into())
    }

    /// Returns the active parts of the world, the limit of its step, and times of `steps` steps of
    /// a copy.
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

    /// Number of living blocks.
    pub fn block_count(&self) -> usize {
        self.block_count
    }

    /// The context of the world.
    pub fn context(&self) -> Context {
        Context::of(&self.owner)
    }

    pub(crate) fn make(
        context: &Context,
        create: impl FnOnce(*mut *mut sys::hs_world) -> sys::hs_status,
    ) -> Result<Self> {
        let mut handle = ptr::null_mut();
        let status = create(&mut handle);
        context.owner().check(status)?;
        // SAFETY: the library has just created it in this context, for this caller.
        unsafe { Self::own(context.owner(), handle) }
            .ok_or_else(|| Error::argument("the library returned no world"))
    }

    /// Takes ownership of a world; `None` for NULL.
    ///
    /// # Safety
    /// The handle is NULL, or of a world of that context which nothing else owns.
    pub(crate) unsafe fn own(owner: &Arc<Owner>, handle: *mut sys::hs_world) -> Option<Self> {
        let mut world = Self {
            handle: NonNull::new(handle)?,
            owner: Arc::clone(owner),
            block_count: 0,
            load_length: None,
        };
        world.recount_blocks();
        Some(world)
    }

    /// Bodies add and remove blocks.
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

    pub(crate) fn owner(&self) -> &Arc<Owner> {
        &self.owner
    }
}

impl Drop for World {
    fn drop(&mut self) {
        // SAFETY: it is the only owner of the handle, and the context lives as long as `owner`.
        unsafe { sys::hs_world_destroy(self.handle.as_ptr()) }
    }
}
