//! A world is brought to rest, and changed while it lives: settle under its loads, then excavate,
//! load or let go.

use std::mem::{size_of, MaybeUninit};

use halfspace_sys as sys;

use crate::block::Block;
use crate::constants::setters;
use crate::world::World;
use crate::Result;

/// A way to bring a world to rest.
///
/// ```
/// use halfspace::Relaxation;
/// let careful = Relaxation::default().by_largest().ratio(1e-6).max_steps(50_000);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Relaxation {
    raw: sys::hs_relaxation_def,
}

impl Relaxation {
    setters! {
        /// Share of unbalanced forces at which a world is at rest, above 0; by default 1e-5.
        ratio: f64,
        /// Local damping meanwhile, at least 0 and below 1; by default 0.1, beside adaptive damping.
        /// Without that, 0.8 does best.
        local_damping: f64,
    }

    /// All unbalanced forces are compared to all forces: of cells, contacts, bonds, weight and
    /// loads. The default.
    pub fn by_mean(mut self) -> Self {
        self.raw.measure = sys::HS_UNBALANCED_MEAN;
        self
    }

    /// The largest such ratio of a single block or node counts; where next to nothing acts, over the
    /// mean force.
    pub fn by_largest(mut self) -> Self {
        self.raw.measure = sys::HS_UNBALANCED_LARGEST;
        self
    }

    /// Steps after which it is given up, at least 1; by default 1000000.
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.raw.max_steps = i64::try_from(steps).unwrap_or(i64::MAX);
        self
    }

    /// Whether mass damping is twice as fast as the slowest motion that is left swings, found anew
    /// all the time; by default it is. Otherwise it is that of the world.
    pub fn adaptive(mut self, is_adaptive: bool) -> Self {
        self.raw.is_adaptive = is_adaptive.into();
        self
    }

    /// Whether bonds do not fail meanwhile; by default they do not.
    pub fn hold_bonds(mut self, are_held: bool) -> Self {
        self.raw.hold_bonds = are_held.into();
        self
    }
}

impl Default for Relaxation {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_relaxation_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_relaxation_def_init(raw.as_mut_ptr(), size_of::<sys::hs_relaxation_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}

/// The unbalanced forces of a world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Balance {
    /// Their share of all forces, see [`Relaxation::by_mean`]; 0 where no force acts.
    pub mean: f64,
    /// The largest share of a single block or node, see [`Relaxation::by_largest`].
    pub largest: f64,
    /// The largest of them, in N.
    pub largest_force: f64,
    /// The block that it acts on, of a node a cell; `None` if nothing is unbalanced.
    pub largest_force_block: Option<Block>,
}

impl From<sys::hs_balance> for Balance {
    fn from(raw: sys::hs_balance) -> Self {
        Self {
            mean: raw.mean,
            largest: raw.largest,
            largest_force: raw.largest_force,
            largest_force_block: Block::from_raw(raw.largest_force_block),
        }
    }
}

/// The end of a relaxation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Relaxed {
    /// Whether the world is at rest; otherwise forces are still unbalanced after as many steps as were
    /// allowed.
    pub is_at_rest: bool,
    /// Steps taken.
    pub steps: u64,
    /// Forces that are unbalanced then.
    pub balance: Balance,
}

/// Rest, and what leads away from it.
impl World {
    /// Steps the world under strong damping until no force is left unbalanced. Its own damping, and
    /// whether bonds are held, come back afterwards; velocities are set to 0. Time passes, but means
    /// nothing.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Law, Pose, Shape, World, WorldDef};
    /// use halfspace::Relaxation;
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # world.set_default_law(&Law::default().per_area())?;
    /// # let stone = world.add_material(2000.0)?;
    /// # world.add_block(&square, &BlockDef::fixed(stone))?;
    /// # world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(0.5, 1.5, 0.0)))?;
    /// assert!(world.relax(&Relaxation::default())?.is_at_rest);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`World::step`]: the world stays where it has come to.
    pub fn relax(&mut self, relaxation: &Relaxation) -> Result<Relaxed> {
        let mut raw = sys::hs_balance::default();
        let size = size_of::<sys::hs_balance>();
        // SAFETY: the world lives and is borrowed mutably, the relaxation is valid, and the size is
        // that of the struct.
        let status = unsafe { sys::hs_world_relax(self.handle(), &relaxation.raw, &mut raw, size) };
        self.check(status)?;
        Ok(Relaxed {
            is_at_rest: status != sys::HS_NOTE_NOT_AT_REST,
            steps: raw.steps as u64,
            balance: raw.into(),
        })
    }

    /// The forces that are unbalanced now. To measure them takes as long as a step.
    pub fn balance(&mut self) -> Result<Balance> {
        let mut raw = sys::hs_balance::default();
        let size = size_of::<sys::hs_balance>();
        // SAFETY: the world lives and is borrowed mutably, and the size is that of the struct.
        self.check(unsafe { sys::hs_world_get_balance(self.handle(), &mut raw, size) })?;
        Ok(raw.into())
    }

    /// Sets gravity from now on, in m/s2. What that changes of the energy is booked as outer work.
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_set_gravity(self.handle(), &gravity) })
    }

    /// Sets damping from now on: see [`WorldDef::local_damping`](crate::WorldDef::local_damping) and
    /// [`WorldDef::mass_damping`](crate::WorldDef::mass_damping).
    pub fn set_damping(&mut self, local_damping: f64, mass_damping: f64) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_set_damping(self.handle(), local_damping, mass_damping) })
    }

    /// Sets the time step from now on; 0: a share of the stable one, see
    /// [`WorldDef::time_step`](crate::WorldDef::time_step).
    pub fn set_time_step(&mut self, time_step: f64) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_set_time_step(self.handle(), time_step) })
    }
}
