//! Contact laws between materials.

use halfspace_sys as sys;

/// Contact law: normal force by a penalty spring (Wang et al. 2021, section 3), a potential (Zheng
/// et al. 2020, section 3) or a unilateral constraint, with Mohr-Coulomb friction.
///
/// ```
/// use halfspace::Law;
/// let friction_angle = 15f64.to_radians();
/// let joint = Law::default().normal_stiffness(1e10).friction_angle(friction_angle);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Law {
    pub(crate) raw: sys::hs_law_def,
}

impl Law {
    /// Stiffness per contact, distributed over springs at the corners of the region: the default.
    pub fn per_contact(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_PER_CONTACT;
        self
    }

    /// Stiffness per area: the normal force is the stiffness times the overlap area (in 3D the
    /// volume) behind the contact plane.
    pub fn per_area(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_PER_AREA;
        self
    }

    /// The force is the gradient of the energy of the overlap. The potential inside a block is the
    /// distance to the nearest face times the stiffness divided by the world's
    /// [`potential_length`](crate::WorldDef::potential_length). Cohesion and tensile strength must
    /// be 0.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Pose, Shape, ViewMut, World, WorldDef};
    /// use halfspace::Law;
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # let stone = world.add_material(2000.0)?;
    /// world.set_default_law(&Law::default().potential().normal_stiffness(1e6))?;
    /// for (x, y) in [(0.0, 0.0), (0.875, 0.875)] {
    ///     world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(x, y, 0.0)))?;
    /// }
    /// world.detect()?;
    /// let mut forces = [[0.0; 2]; 2];
    /// world.forces(0.0, &mut forces, ViewMut::none())?;
    /// assert_eq!(forces[1], [15625.0, 15625.0], "along the diagonal");
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn potential(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_POTENTIAL;
        self
    }

    /// No spring: a unilateral constraint keeps blocks apart. Stiffnesses and damping are ignored.
    /// See [`World::contacts`](crate::World::contacts).
    pub fn without_spring(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_NONE;
        self
    }
}
