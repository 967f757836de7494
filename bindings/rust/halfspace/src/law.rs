//! Contact laws between materials.

use std::mem::{size_of, MaybeUninit};

use halfspace_sys as sys;

use crate::constants::setters;

/// Normal force with Mohr-Coulomb friction: a penalty spring (Wang et al. 2021, section 3) or a
/// potential (Zheng et al. 2020, section 3).
///
/// ```
/// use halfspace::Law;
/// let friction_angle = 15f64.to_radians();
/// let joint = Law::default().normal_stiffness(1e10).friction_angle(friction_angle);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Law {
    raw: sys::hs_law_def,
}

impl Law {
    setters! {
        /// Above 0; N/m, Pa/m of [`Law::per_area`] or Pa of [`Law::potential`]; by default 1e9.
        normal_stiffness: f64,
        /// At least 0; N/m, or Pa/m of [`Law::per_area`]; 0, the default, stands for the number of the
        /// normal one.
        shear_stiffness: f64,
        /// In radians, at least 0 and below pi/2; by default 0.
        friction_angle: f64,
        /// Pa, at least 0; of contacts that exist when a block's first step begins, until they
        /// fail; by default 0.
        cohesion: f64,
        /// Pa, at least 0; likewise; by default 0.
        tensile_strength: f64,
        /// Share of critical viscous damping, at least 0; by default 0.1.
        normal_damping: f64,
        /// Share of critical viscous damping, at least 0; by default 0.1.
        shear_damping: f64,
    }

    /// The stiffnesses are of the whole contact, shared over the points of its region: the default.
    pub fn per_contact(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_PER_CONTACT;
        self
    }

    /// The normal force is the stiffness times the overlap area behind the contact plane.
    pub fn per_area(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_PER_AREA;
        self
    }

    /// A point inside a block has its distance to the nearest face as potential, times the
    /// stiffness over the world's [`potential_length`](crate::WorldDef::potential_length); what two
    /// blocks share is pushed down both. The force is the gradient of an energy, whichever way the
    /// blocks meet. It takes neither cohesion nor tensile strength.
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

    /// No spring: blocks are kept apart by just the force that does, from the moment of their touch
    /// on. Stiffnesses and dampings count for nothing. See [`World::contacts`](crate::World::contacts).
    pub fn without_spring(mut self) -> Self {
        self.raw.stiffness_kind = sys::HS_STIFFNESS_NONE;
        self
    }

    pub(crate) fn raw(&self) -> *const sys::hs_law_def {
        &self.raw
    }
}

impl Default for Law {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_law_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_law_def_init(raw.as_mut_ptr(), size_of::<sys::hs_law_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}
