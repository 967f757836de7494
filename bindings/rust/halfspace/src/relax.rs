//! Dynamic relaxation to static equilibrium, and changes of gravity, damping and time step of an
//! existing world.

use std::mem::size_of;

use halfspace_sys as sys;

use crate::call::{call, written};
use crate::records::Balance;
use crate::world::World;
use crate::Result;

/// Settings of a dynamic relaxation.
///
/// ```
/// use halfspace::Relaxation;
/// let careful = Relaxation::default().by_largest().ratio(1e-6).max_steps(50_000);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Relaxation {
    pub(crate) raw: sys::hs_relaxation_def,
}

impl Relaxation {
    /// Measure: sum of all unbalanced forces over the sum of all forces (cells, contacts, bonds,
    /// weight, loads). The default.
    pub fn by_mean(mut self) -> Self {
        self.raw.measure = sys::HS_UNBALANCED_MEAN;
        self
    }

    /// Measure: largest ratio of a single block or node; for negligible forces relative to the mean
    /// force.
    pub fn by_largest(mut self) -> Self {
        self.raw.measure = sys::HS_UNBALANCED_LARGEST;
        self
    }
}

/// The result of a relaxation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Relaxed {
    /// True in equilibrium; false: forces are still unbalanced after the max number of steps.
    pub is_at_rest: bool,
    /// Number of steps.
    pub steps: u64,
    /// Final balance of forces.
    pub balance: Balance,
}

/// Relaxation, and changes of settings.
impl World {
    /// Steps the world under strong damping until static equilibrium, then sets all velocities to
    /// 0. Damping and the state of [`World::hold_bonds`] are restored afterwards. The time of the
    /// relaxation has no physical meaning.
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
    /// Those of [`World::step`]; the world keeps its last state.
    pub fn relax(&mut self, relaxation: &Relaxation) -> Result<Relaxed> {
        let (mut raw, size) = (sys::hs_balance::default(), size_of::<sys::hs_balance>());
        let world = self.object.handle_mut();
        // SAFETY: the world lives and is borrowed mutably, the relaxation is valid, and the size is
        // that of the struct.
        let status = unsafe { sys::hs_world_relax(world, &relaxation.raw, &mut raw, size) };
        self.object.owner().check(status)?;
        Ok(Relaxed {
            is_at_rest: status != sys::HS_NOTE_NOT_AT_REST,
            steps: raw.steps as u64,
            balance: raw.into(),
        })
    }

    /// Returns the current balance of forces. It costs as much as a step.
    pub fn balance(&mut self) -> Result<Balance> {
        written(|balance, size| call!(mut self => hs_world_get_balance(balance, size)))
    }

    /// Sets gravity, in m/s2. The change of potential energy counts as external work.
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<()> {
        call!(mut self => hs_world_set_gravity(&gravity))
    }

    /// Sets local and mass damping: see [`WorldDef::local_damping`](crate::WorldDef::local_damping)
    /// and [`WorldDef::mass_damping`](crate::WorldDef::mass_damping).
    pub fn set_damping(&mut self, local_damping: f64, mass_damping: f64) -> Result<()> {
        call!(mut self => hs_world_set_damping(local_damping, mass_damping))
    }

    /// Sets the time step, in s; 0: a fraction of the stable time step, see
    /// [`WorldDef::time_step`](crate::WorldDef::time_step).
    pub fn set_time_step(&mut self, time_step: f64) -> Result<()> {
        call!(mut self => hs_world_set_time_step(time_step))
    }
}
