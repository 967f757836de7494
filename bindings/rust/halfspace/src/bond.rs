//! Bonds: breakable connections of blocks along their common faces (Wang et al. 2021, section 3).

use std::mem::size_of;

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::records::{BondEvent, BondReport, BondState};
use crate::world::World;
use crate::Result;

/// Properties of a bond: normal and shear springs between two blocks along a common face. Each
/// integration point fails on its own, by the Mohr-Coulomb criterion with a tension cut-off.
///
/// A failed point transmits no tension; under compression it slides with residual cohesion and
/// friction. While any point is intact or closed, the bond replaces the contact of its two blocks.
///
/// Bonds make a body more compliant: a row of blocks of size a and modulus E, with bonds of normal
/// stiffness kn, has the modulus `E / (1 + E / (kn a))`.
///
/// ```
/// use halfspace::Bond;
/// let mortar = Bond::default().normal_stiffness(1e10).tensile_strength(2e5).cohesion(4e5);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Bond {
    pub(crate) raw: sys::hs_bond_def,
}

/// Bonds.
impl World {
    /// Bonds two blocks along their common faces in their current positions: every pair of faces
    /// that is coplanar to rounding.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Pose, Shape, World, WorldDef};
    /// use halfspace::Bond;
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # let stone = world.add_material(2000.0)?;
    /// let wall = world.add_block(&square, &BlockDef::fixed(stone).at(Pose::in_plane(0.5, 0.5, 0.0)))?;
    /// let bracket = world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(1.5, 0.5, 0.0)))?;
    /// world.bond_blocks(wall, bracket, &Bond::default().tensile_strength(1e6).cohesion(1e6))?;
    /// world.step(100)?;
    /// assert_eq!(world.bond_report().joint_count, 1);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::State`](crate::ErrorKind::State) if they have no common face, are bonded
    /// already, or neither moves.
    pub fn bond_blocks(&mut self, a: Block, b: Block, bond: &Bond) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the bond is valid.
        self.check(unsafe { sys::hs_world_bond_blocks(self.handle(), a.id(), b.id(), &bond.raw) })
    }

    /// Bonds all pairs of blocks of two materials, which may be the same, along their common faces.
    /// Existing bonds do not change. Returns the number of bonds made.
    pub fn bond_materials(&mut self, a: Material, b: Material, bond: &Bond) -> Result<usize> {
        let mut count = 0;
        // SAFETY: the world lives and is borrowed mutably, the bond is valid.
        self.check(unsafe {
            sys::hs_world_bond_materials(self.handle(), a.0, b.0, &bond.raw, &mut count)
        })?;
        Ok(count as usize)
    }

    /// Suspends (`true`) or resumes (`false`) the failure of all bonds, e.g. while a world settles.
    pub fn hold_bonds(&mut self, are_held: bool) {
        // SAFETY: the world lives and is borrowed mutably.
        let status = unsafe { sys::hs_world_hold_bonds(self.handle(), are_held.into()) };
        self.owner().expect(status);
    }

    /// Returns all bonds made so far, in their order of creation.
    pub fn bonds(&self) -> Vec<BondState> {
        let mut bonds = vec![sys::hs_bond::default(); self.bond_report().bond_count];
        let (room, capacity) = (bonds.as_mut_ptr(), bonds.len() as i64);
        let mut count = 0;
        // SAFETY: the world lives, and the array is as long as said.
        self.owner()
            .expect(unsafe { sys::hs_world_get_bonds(self.handle(), room, capacity, &mut count) });
        bonds.into_iter().map(Into::into).collect()
    }

    /// Returns the failures of bond points so far, in order of time, from index `first` on.
    pub fn bond_events(&self, first: usize) -> Vec<BondEvent> {
        let left = self.bond_report().event_count.saturating_sub(first);
        let mut events = vec![sys::hs_bond_event::default(); left];
        let (room, capacity) = (events.as_mut_ptr(), left as i64);
        let first = i64::try_from(first).unwrap_or(i64::MAX);
        let mut count = 0;
        // SAFETY: the world lives, and the array is as long as said.
        self.owner().expect(unsafe {
            sys::hs_world_get_bond_events(self.handle(), first, room, capacity, &mut count)
        });
        events.into_iter().map(Into::into).collect()
    }

    /// Returns a summary of all bonds, as of the last step.
    pub fn bond_report(&self) -> BondReport {
        let mut raw = sys::hs_bond_report::default();
        let size = size_of::<sys::hs_bond_report>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.owner()
            .expect(unsafe { sys::hs_world_get_bond_report(self.handle(), &mut raw, size) });
        raw.into()
    }
}
