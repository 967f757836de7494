//! Affine blocks: blocks with uniform strain and stress (Zheng et al. 2020, section 2).

use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::error::Error;
use crate::records::Deformation;
use crate::world::World;
use crate::Result;

/// A tensor, as an array of rows. In 2D only xx, xy, yx and yy are read; in results the other
/// components are 0, except zz of a gradient, which is 1.
pub type Tensor = [[f64; 3]; 3];

/// Elasticity of a material. It is isotropic: the second Piola-Kirchhoff stress is linear in the
/// Green strain, so a rotation of any size causes neither strain nor energy.
///
/// ```
/// use halfspace::Elasticity;
/// let granite = Elasticity::default().young_modulus(5e10).damping_time(1e-5);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Elasticity {
    pub(crate) raw: sys::hs_elasticity_def,
}

impl Elasticity {
    /// 2D: no strain perpendicular to the plane; the default.
    pub fn plane_strain(mut self) -> Self {
        self.raw.plane = sys::HS_PLANE_STRAIN;
        self
    }

    /// 2D: no stress perpendicular to the plane.
    pub fn plane_stress(mut self) -> Self {
        self.raw.plane = sys::HS_PLANE_STRESS;
        self
    }
}

/// The components, row by row.
fn nine(tensor: &Tensor) -> *const [f64; 9] {
    (tensor as *const Tensor).cast()
}

/// Strain and stress.
impl World {
    /// Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep
    /// their strain.
    pub fn set_elasticity(&mut self, material: Material, elasticity: &Elasticity) -> Result<()> {
        // Virials are loads, too.
        self.load_length = None;
        // SAFETY: the world lives and is borrowed mutably, the elasticity is valid.
        self.check(unsafe {
            sys::hs_world_set_elasticity(self.handle(), material.0, &elasticity.raw)
        })
    }

    /// Returns deformation and stress of a block of any kind.
    pub fn deformation(&self, block: Block) -> Result<Deformation> {
        let mut deformation = Deformation::default();
        let room = (&mut deformation as *mut Deformation).cast();
        // SAFETY: the world lives, and a Deformation is laid out as the library's.
        self.check(unsafe { sys::hs_world_get_deformation(self.handle(), block.id(), room) })?;
        Ok(deformation)
    }

    /// Returns deformation and stress of all blocks, in the order of [`World::blocks`].
    pub fn deformations(&self) -> Vec<Deformation> {
        let mut deformations = vec![Deformation::default(); self.block_count()];
        self.owner()
            .expect(self.get_deformations(&mut deformations));
        deformations
    }

    /// Likewise, into existing memory, one entry per block.
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

    /// Sets the deformation gradient of an affine block, with a determinant above 0, and its rate,
    /// in 1/s. Centroid and velocity do not change.
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

    /// Sets the current Cauchy stress of an affine block, e.g. the in situ stress; symmetric, in
    /// Pa, tension above 0. Later strain adds to it.
    pub fn set_stress(&mut self, block: Block, stress: &Tensor) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably; a tensor is nine numbers.
        self.check(unsafe { sys::hs_world_set_stress(self.handle(), block.id(), nine(stress)) })
    }

    /// Adds a permanent load on one face of an affine block, in 2D on the edge that starts at the
    /// vertex of that index. The traction is the force per area of the face as it was given, in Pa.
    /// Its direction does not change as the block moves, nor its magnitude as the face is strained.
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

    /// Removes all surface loads of an affine block.
    pub fn clear_surface_loads(&mut self, block: Block) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_clear_surface_loads(self.handle(), block.id()) })
    }
}
