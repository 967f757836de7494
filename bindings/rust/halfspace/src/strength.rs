//! The factor of safety by strength reduction: how many times weaker all materials could be until
//! something moves (Zienkiewicz, Humpheson and Lewis 1975).

use std::mem::{size_of, MaybeUninit};
use std::ptr;

use halfspace_sys as sys;

use crate::constants::setters;
use crate::world::World;
use crate::Result;

/// A search for the factor of safety.
///
/// ```
/// use halfspace::StrengthSearch;
/// let coarse = StrengthSearch::default().low(1.0).high(3.0).resolution(0.05);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct StrengthSearch {
    raw: sys::hs_strength_def,
}

impl StrengthSearch {
    setters! {
        /// A factor at which the world should stand, above 0; by default 0.5.
        low: f64,
        /// A factor at which it should fall, above the other; by default 5.
        high: f64,
        /// The bracket that is narrow enough, above 0; by default 0.005.
        resolution: f64,
        /// Unbalanced forces at which a world stands, see
        /// [`Relaxation::ratio`](crate::Relaxation::ratio); by default 1e-5.
        ratio: f64,
        /// Share of its size by which a block that moves has fallen, above 0; by default 0.1.
        max_displacement: f64,
    }

    /// Steps after which a world that is not at rest falls as well, at least 1; by default 100000.
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.raw.max_steps = i64::try_from(steps).unwrap_or(i64::MAX);
        self
    }
}

impl Default for StrengthSearch {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_strength_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_strength_def_init(raw.as_mut_ptr(), size_of::<sys::hs_strength_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}

/// A factor of safety.
#[derive(Debug)]
#[non_exhaustive]
pub struct StrengthFound {
    /// The middle of the bracket.
    pub factor: f64,
    /// The world stands at it, if `stands_at_low`.
    pub low: f64,
    /// The world falls at it, if `falls_at_high`.
    pub high: f64,
    /// Whether it stands at the lowest factor; otherwise nothing else was tried.
    pub stands_at_low: bool,
    /// Whether it falls at the highest factor.
    pub falls_at_high: bool,
    /// Worlds tried.
    pub trials: usize,
    /// The copy that fell last, as it was then; `None` where none did. Its velocities and
    /// [`bond events`](World::bond_events) show how.
    pub fallen: Option<World>,
}

/// Strength.
impl World {
    /// Divides friction (its tangent), cohesion and tensile strength of all laws and bonds, as they
    /// were given, by a factor from 1e-75 to 1e75, from now on. A factor of 1 gives them back but for rounding.
    pub fn set_strength_factor(&mut self, factor: f64) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_set_strength_factor(self.handle(), factor) })
    }

    /// Looks for the factor of safety by bisection. Each trial relaxes a copy of the world with
    /// bonds that may fail, as by [`World::relax`]; the world itself stays as it is, and should be at
    /// rest.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Law, Pose, Shape, World, WorldDef};
    /// use halfspace::{Relaxation, StrengthSearch};
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let def = WorldDef::in_plane().gravity([3.0, -9.0, 0.0]); // a slope
    /// # let mut world = World::new(&context, &def)?;
    /// # world.set_default_law(&Law::default().per_area().friction_angle(2f64.atan2(3.0)))?;
    /// # let stone = world.add_material(2000.0)?;
    /// # world.add_block(&square, &BlockDef::fixed(stone))?;
    /// # world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(0.5, 1.5, 0.0)))?;
    /// assert!(world.relax(&Relaxation::default())?.is_at_rest);
    /// let found = world.find_strength_factor(&StrengthSearch::default().resolution(0.1))?;
    /// assert!(found.low < 2.0 && 2.0 < found.high && found.fallen.is_some());
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`World::step`] for a trial that cannot be stepped.
    pub fn find_strength_factor(&self, search: &StrengthSearch) -> Result<StrengthFound> {
        let mut raw = sys::hs_strength_report::default();
        let size = size_of::<sys::hs_strength_report>();
        let mut fallen = ptr::null_mut();
        // SAFETY: the world lives, the search is valid, and the size is that of the struct.
        self.check(unsafe {
            sys::hs_world_find_strength_factor(
                self.handle(),
                &search.raw,
                &mut raw,
                size,
                &mut fallen,
            )
        })?;
        Ok(StrengthFound {
            factor: raw.factor,
            low: raw.low,
            high: raw.high,
            stands_at_low: raw.stands_at_low != 0,
            falls_at_high: raw.falls_at_high != 0,
            trials: raw.trials as usize,
            // SAFETY: the library has made it in the context of this world, for this caller.
            fallen: unsafe { World::own(self.owner(), fallen) },
        })
    }
}
