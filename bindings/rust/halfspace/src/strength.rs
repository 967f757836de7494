//! Factor of safety by strength reduction (Zienkiewicz, Humpheson and Lewis 1975).

use std::ptr;

use halfspace_sys as sys;

use crate::call::{call, written};
use crate::object::Object;
use crate::records::StrengthFound;
use crate::world::World;
use crate::Result;

/// Settings of the search for the factor of safety.
///
/// ```
/// use halfspace::StrengthSearch;
/// let coarse = StrengthSearch::default().low(1.0).high(3.0).resolution(0.05);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct StrengthSearch {
    pub(crate) raw: sys::hs_strength_def,
}

/// Strength.
impl World {
    /// Divides the given friction (tangent of its angle), cohesion and tensile strength of all laws
    /// and bonds by a factor from 1e-75 to 1e75. Calls do not accumulate; 1 restores the given
    /// values, to rounding.
    pub fn set_strength_factor(&mut self, factor: f64) -> Result<()> {
        call!(mut self => hs_world_set_strength_factor(factor))
    }

    /// Computes the factor of safety by bisection. Each trial relaxes a copy of the world with
    /// reduced strength, as [`World::relax`], in which bonds can fail. The world, which should be
    /// in equilibrium, does not change.
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
        let mut fallen = ptr::null_mut();
        let raw = written(
            |report, size| call!(self => hs_world_find_strength_factor(&search.raw, report, size, &mut fallen)),
        )?;
        // SAFETY: the library has created it in the context of this world, for this caller.
        let fallen = unsafe { Object::own(self.object.owner(), fallen) };
        Ok(StrengthFound::new(raw, fallen.map(World::of)))
    }
}
