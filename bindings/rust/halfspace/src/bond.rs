//! Bonds: blocks of any kind hold together along their common faces until their strength is reached
//! (Wang et al. 2021, section 3).

use std::mem::{size_of, MaybeUninit};

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::constants::{constants, setters};
use crate::world::World;
use crate::Result;

/// Springs that hold two blocks together along a common face. Each of its integration points fails by
/// itself, by Mohr and Coulomb's criterion with a tension cut-off.
///
/// A point that has failed bears no tension; pressed together it slides with the residual cohesion
/// and friction. As long as any point of a bond holds or is closed, the bond stands in for the
/// contact of its two blocks.
///
/// Springs make a body softer: a row of blocks of size a and modulus E by the share 1 / (1 + kn a /
/// E).
///
/// ```
/// use halfspace::Bond;
/// let mortar = Bond::default().normal_stiffness(1e10).tensile_strength(2e5).cohesion(4e5);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Bond {
    raw: sys::hs_bond_def,
}

impl Bond {
    setters! {
        /// Pa/m, above 0; by default 1e11.
        normal_stiffness: f64,
        /// Pa/m, above 0; or 0, the default: as the normal one.
        shear_stiffness: f64,
        /// Pa, at least 0; by default 0.
        tensile_strength: f64,
        /// Pa, at least 0; by default 0.
        cohesion: f64,
        /// Radians, at least 0 and below pi/2, of what holds; by default 0.
        friction_angle: f64,
        /// Pa, from 0 to the cohesion, of what has failed and is pressed together; by default 0.
        residual_cohesion: f64,
        /// Radians, at least 0 and below pi/2, likewise; by default 0.
        residual_friction_angle: f64,
        /// J/m2, at least 0: tension fades linearly with opening and takes so much from its peak on;
        /// by default 0: at once.
        tensile_fracture_energy: f64,
        /// J/m2, at least 0: likewise what shear strength loses with slip; by default 0: at once.
        shear_fracture_energy: f64,
    }
}

impl Default for Bond {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_bond_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_bond_def_init(raw.as_mut_ptr(), size_of::<sys::hs_bond_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}

/// A bond now.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BondState {
    /// Both blocks; `None` when one of them has been removed.
    pub blocks: Option<(Block, Block)>,
    /// Whether the blocks are still joined; otherwise it has come apart and contact has taken over.
    pub is_joint: bool,
    /// Integration points.
    pub point_count: usize,
    /// Those of them that have failed.
    pub broken_count: usize,
    /// That of the common face, in the plane its length.
    pub area: f64,
    /// Mean over the area: 0 whole, 1 failed.
    pub damage: f64,
    /// Above 0 in tension.
    pub normal_force: f64,
    /// On the second block.
    pub shear_force: [f64; 3],
}

impl From<sys::hs_bond> for BondState {
    fn from(raw: sys::hs_bond) -> Self {
        Self {
            blocks: Block::from_raw(raw.block_a).zip(Block::from_raw(raw.block_b)),
            is_joint: raw.is_joint != 0,
            point_count: raw.point_count as usize,
            broken_count: raw.broken_count as usize,
            area: raw.area,
            damage: raw.damage,
            normal_force: raw.normal_force,
            shear_force: raw.shear_force,
        }
    }
}

constants! {
    /// The way a point of a bond has failed.
    BondFailure {
        /// It holds.
        None = HS_BOND_HOLDS,
        /// It has opened.
        Tension = HS_BOND_TENSION,
        /// It has slid.
        Shear = HS_BOND_SHEAR,
    }
}

/// A point of a bond that has failed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BondEvent {
    /// Its place in [`World::bonds`].
    pub bond: usize,
    /// Index of the bond's point.
    pub point: usize,
    /// Whether it has opened or slid.
    pub failure: BondFailure,
    /// Steps done before.
    pub steps: u64,
    /// Time then, in s.
    pub time: f64,
    /// Its place then, in m.
    pub position: [f64; 3],
    /// Normal of the face, from the first block to the second.
    pub normal: [f64; 3],
    /// Its share of the face, in the plane a length.
    pub area: f64,
    /// Pa, above 0 in tension, at the end of the step before.
    pub normal_traction: f64,
    /// Pa, likewise.
    pub shear_traction: f64,
    /// Energy lost in this step, in J.
    pub energy: f64,
}

impl From<sys::hs_bond_event> for BondEvent {
    fn from(raw: sys::hs_bond_event) -> Self {
        Self {
            bond: raw.bond as usize,
            point: raw.point as usize,
            failure: BondFailure::from_raw(raw.failure),
            steps: raw.step as u64,
            time: raw.time,
            position: raw.position,
            normal: raw.normal,
            area: raw.area,
            normal_traction: raw.normal_traction,
            shear_traction: raw.shear_traction,
            energy: raw.energy,
        }
    }
}

/// The bonds of a world in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BondReport {
    /// Bonds made so far.
    pub bond_count: usize,
    /// Bonds that have not come apart.
    pub joint_count: usize,
    /// Points that have failed so far.
    pub event_count: usize,
    /// Area of these points, in the plane their length.
    pub crack_area: f64,
    /// Energy in the springs of bonds now; part of [`Energy::strain`](crate::Energy::strain).
    pub strain_energy: f64,
    /// Energy lost so far; counts in the residual.
    pub fracture_loss: f64,
}

impl From<sys::hs_bond_report> for BondReport {
    fn from(raw: sys::hs_bond_report) -> Self {
        Self {
            bond_count: raw.bond_count as usize,
            joint_count: raw.joint_count as usize,
            event_count: raw.event_count as usize,
            crack_area: raw.crack_area,
            strain_energy: raw.strain_energy,
            fracture_loss: raw.fracture_loss,
        }
    }
}

/// Bonds.
impl World {
    /// Bonds two blocks along their largest common face, as they are now: both faces lie in one
    /// plane but for rounding.
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
    /// [`ErrorKind::State`](crate::ErrorKind::State) when they have no common face, hold together
    /// already, or neither moves.
    pub fn bond_blocks(&mut self, a: Block, b: Block, bond: &Bond) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the bond is valid.
        self.check(unsafe { sys::hs_world_bond_blocks(self.handle(), a.id(), b.id(), &bond.raw) })
    }

    /// Bonds all pairs of blocks of two materials, which may be the same, along their common faces.
    /// Those that hold together already stay as they are. Returns how many bonds were made.
    pub fn bond_materials(&mut self, a: Material, b: Material, bond: &Bond) -> Result<usize> {
        let mut count = 0;
        // SAFETY: the world lives and is borrowed mutably, the bond is valid.
        self.check(unsafe {
            sys::hs_world_bond_materials(self.handle(), a.0, b.0, &bond.raw, &mut count)
        })?;
        Ok(count as usize)
    }

    /// Holds all bonds, which then never fail, while a world comes to rest; or lets them fail again.
    pub fn hold_bonds(&mut self, are_held: bool) {
        // SAFETY: the world lives and is borrowed mutably.
        let status = unsafe { sys::hs_world_hold_bonds(self.handle(), are_held.into()) };
        self.owner().expect(status);
    }

    /// All bonds made so far, in their order.
    pub fn bonds(&self) -> Vec<BondState> {
        let mut bonds = vec![sys::hs_bond::default(); self.bond_report().bond_count];
        let (room, capacity) = (bonds.as_mut_ptr(), bonds.len() as i64);
        let mut count = 0;
        // SAFETY: the world lives, and the array is as long as said.
        self.owner()
            .expect(unsafe { sys::hs_world_get_bonds(self.handle(), room, capacity, &mut count) });
        bonds.into_iter().map(Into::into).collect()
    }

    /// The points that have failed so far, in order of time, but for so many at the beginning.
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

    /// The bonds in numbers, as of the last step.
    pub fn bond_report(&self) -> BondReport {
        let mut raw = sys::hs_bond_report::default();
        let size = size_of::<sys::hs_bond_report>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.owner()
            .expect(unsafe { sys::hs_world_get_bond_report(self.handle(), &mut raw, size) });
        raw.into()
    }
}
