//! Affine blocks: they turn and strain as a whole (Zheng et al. 2020, section 2).

use std::mem::{align_of, size_of, MaybeUninit};
use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::constants::setters;
use crate::error::Error;
use crate::world::World;
use crate::Result;

/// Its rows. In the plane xx, xy, yx and yy count; of those that come out, the others are 0, but zz
/// of a gradient 1.
pub type Tensor = [[f64; 3]; 3];

/// Elasticity of a material. It is isotropic: the second Piola stress is linear in Green's strain,
/// so that a rotation, however large, neither strains a block nor costs energy.
///
/// ```
/// use halfspace::Elasticity;
/// let granite = Elasticity::default().young_modulus(5e10).damping_time(1e-5);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Elasticity {
    raw: sys::hs_elasticity_def,
}

impl Elasticity {
    setters! {
        /// Pa, above 0; by default 1e9.
        young_modulus: f64,
        /// Above -1 and below 0.5; by default 0.25.
        poisson_ratio: f64,
        /// In s, at least 0: viscous stress is the elastic one of the strain rate times this
        /// (Rayleigh's beta); by default 0.
        damping_time: f64,
    }

    /// In the plane: of a body that cannot strain across it; the default.
    pub fn plane_strain(mut self) -> Self {
        self.raw.plane = sys::HS_PLANE_STRAIN;
        self
    }

    /// In the plane: of a sheet without stress across it.
    pub fn plane_stress(mut self) -> Self {
        self.raw.plane = sys::HS_PLANE_STRESS;
        self
    }
}

impl Default for Elasticity {
    fn default() -> Self {
        let mut raw = MaybeUninit::<sys::hs_elasticity_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid.
        let raw = unsafe {
            sys::hs_elasticity_def_init(raw.as_mut_ptr(), size_of::<sys::hs_elasticity_def>());
            raw.assume_init()
        };
        Self { raw }
    }
}

/// How a block is turned and strained.
///
/// The memory is that of the C interface, so that a slice of deformations is written where it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Deformation {
    /// From places in the shape's frame, relative to its centroid, to places about the block's; of
    /// other than affine blocks a rotation.
    pub gradient: Tensor,
    /// Of the gradient, in 1/s.
    pub rate: Tensor,
    /// Green's, from the shape as it was given, in the shape's frame; of other than affine blocks 0.
    pub strain: Tensor,
    /// Cauchy's, elastic, in space, in Pa, tension above 0; of other than affine blocks 0.
    pub stress: Tensor,
    /// In J, in the plane per unit thickness; 0 without stress.
    pub strain_energy: f64,
}

const _: () = assert!(size_of::<Deformation>() == size_of::<sys::hs_deformation>());
const _: () = assert!(align_of::<Deformation>() == align_of::<sys::hs_deformation>());

/// Rows one after the other.
fn nine(tensor: &Tensor) -> *const [f64; 9] {
    (tensor as *const Tensor).cast()
}

/// Strain and stress.
impl World {
    /// Makes a material elastic, for affine blocks and meshes; others do not read it. Blocks that
    /// have the material keep their strain.
    pub fn set_elasticity(&mut self, material: Material, elasticity: &Elasticity) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably, the elasticity is valid.
        self.check(unsafe {
            sys::hs_world_set_elasticity(self.handle(), material.0, &elasticity.raw)
        })
    }

    /// How a block of any kind is turned and strained.
    pub fn deformation(&self, block: Block) -> Result<Deformation> {
        let mut deformation = Deformation::default();
        let room = (&mut deformation as *mut Deformation).cast();
        // SAFETY: the world lives, and a Deformation is laid out as the library's.
        self.check(unsafe { sys::hs_world_get_deformation(self.handle(), block.id(), room) })?;
        Ok(deformation)
    }

    /// How all blocks are turned and strained, in the order of [`World::blocks`].
    pub fn deformations(&self) -> Vec<Deformation> {
        let mut deformations = vec![Deformation::default(); self.block_count()];
        self.owner()
            .expect(self.get_deformations(&mut deformations));
        deformations
    }

    /// The same into memory that is there already, one deformation per block.
    pub fn deformations_into(&self, deformations: &mut [Deformation]) -> Result<()> {
        self.require_one_per_block("World::deformations_into: deformations", deformations.len())?;
        self.check(self.get_deformations(deformations))
    }

    fn get_deformations(&self, deformations: &mut [Deformation]) -> sys::hs_status {
        // SAFETY: the world lives, the array is as long as said, and a Deformation is laid out as
        // the library's.
        unsafe {
            sys::hs_world_get_deformations(
                self.handle(),
                deformations.as_mut_ptr().cast(),
                deformations.len() as i64,
                ptr::null_mut(),
            )
        }
    }

    /// Turns and strains an affine block by a gradient with a determinant above 0, and sets how
    /// fast it goes on, in 1/s. Its centroid and velocity stay.
    pub fn set_deformation(
        &mut self,
        block: Block,
        gradient: &Tensor,
        rate: &Tensor,
    ) -> Result<()> {
        let (gradient, rate) = (nine(gradient), nine(rate));
        // SAFETY: the world lives and is borrowed mutably; a tensor is nine numbers.
        self.check(unsafe {
            sys::hs_world_set_deformation(self.handle(), block.id(), gradient, rate)
        })
    }

    /// Says how an affine block is stressed as it is now, as in situ: Cauchy's, symmetric, in Pa,
    /// tension above 0. What the block is strained by from now on adds to that.
    pub fn set_stress(&mut self, block: Block, stress: &Tensor) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably; a tensor is nine numbers.
        self.check(unsafe { sys::hs_world_set_stress(self.handle(), block.id(), nine(stress)) })
    }

    /// Adds a load that acts on one face of an affine block from now on, in the plane on the edge
    /// that starts at the vertex of that index. The traction is the force per area of the face as
    /// it was given, in Pa. It keeps its direction as the block moves, and its size as the face is
    /// strained.
    pub fn add_surface_load(
        &mut self,
        block: Block,
        face: usize,
        traction: [f64; 3],
    ) -> Result<()> {
        let face = i32::try_from(face)
            .map_err(|_| Error::argument("World::add_surface_load: face is above 2^31 - 1"))?;
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe {
            sys::hs_world_add_surface_load(self.handle(), block.id(), face, &traction)
        })
    }

    /// Takes all surface loads off an affine block.
    pub fn clear_surface_loads(&mut self, block: Block) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_clear_surface_loads(self.handle(), block.id()) })
    }
}
