//! Bonds: breakable connections of blocks along their common faces (Wang et al. 2021, section 3).

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::call::{call, counted, known, known_list, sure};
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
        call!(mut self => hs_world_bond_blocks(a, b, &bond.raw))
    }

    /// Bonds all pairs of blocks of two materials, which may be the same, along their common faces.
    /// Existing bonds do not change. Returns the number of bonds made.
    pub fn bond_materials(&mut self, a: Material, b: Material, bond: &Bond) -> Result<usize> {
        counted(|count| call!(mut self => hs_world_bond_materials(a, b, &bond.raw, count)))
    }

    /// Suspends (`true`) or resumes (`false`) the failure of all bonds, e.g. while a world settles.
    pub fn hold_bonds(&mut self, are_held: bool) {
        sure(call!(mut self => hs_world_hold_bonds(are_held)))
    }

    /// Returns all bonds made so far, in their order of creation.
    pub fn bonds(&self) -> Vec<BondState> {
        known_list(|room, count| call!(self => hs_world_get_bonds([mut room], count)))
    }

    /// Returns the failures of bond points so far, in order of time, from index `first` on.
    pub fn bond_events(&self, first: usize) -> Vec<BondEvent> {
        known_list(|room, count| call!(self => hs_world_get_bond_events(first, [mut room], count)))
    }

    /// Returns a summary of all bonds, as of the last step.
    pub fn bond_report(&self) -> BondReport {
        known(|report, size| call!(self => hs_world_get_bond_report(report, size)))
    }
}
