//! Affine blocks: blocks with uniform strain and stress (Zheng et al. 2020, section 2).

use halfspace_sys as sys;

use crate::block::{Block, Material};
use crate::call::{call, written};
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

/// Strain and stress.
impl World {
    /// Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep
    /// their strain.
    pub fn set_elasticity(&mut self, material: Material, elasticity: &Elasticity) -> Result<()> {
        // Virials are loads, too.
        self.load_length = None;
        call!(mut self => hs_world_set_elasticity(material, &elasticity.raw))
    }

    /// Returns deformation and stress of a block of any kind.
    pub fn deformation(&self, block: Block) -> Result<Deformation> {
        written(
            |deformation: &mut Deformation, _| call!(self => hs_world_get_deformation(block, deformation)),
        )
    }

    /// Returns deformation and stress of all blocks, in the order of [`World::blocks`].
    pub fn deformations(&self) -> Vec<Deformation> {
        self.of_blocks(|room| self.get_deformations(room))
    }

    /// Likewise, into existing memory, one entry per block.
    pub fn deformations_into(&self, deformations: &mut [Deformation]) -> Result<()> {
        self.require_one_per_block("World::deformations_into: deformations", deformations.len())?;
        self.get_deformations(deformations)
    }

    fn get_deformations(&self, deformations: &mut [Deformation]) -> Result<()> {
        call!(self => hs_world_get_deformations([mut deformations], &mut 0))
    }

    /// Sets the deformation gradient of an affine block, with a determinant above 0, and its rate,
    /// in 1/s. Centroid and velocity do not change.
    pub fn set_deformation(
        &mut self,
        block: Block,
        gradient: &Tensor,
        rate: &Tensor,
    ) -> Result<()> {
        call!(mut self => hs_world_set_deformation(block, gradient, rate))
    }

    /// Sets the current Cauchy stress of an affine block, e.g. the in situ stress; symmetric, in
    /// Pa, tension above 0. Later strain adds to it.
    pub fn set_stress(&mut self, block: Block, stress: &Tensor) -> Result<()> {
        call!(mut self => hs_world_set_stress(block, stress))
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
        call!(mut self => hs_world_add_surface_load(block, face, &traction))
    }

    /// Removes all surface loads of an affine block.
    pub fn clear_surface_loads(&mut self, block: Block) -> Result<()> {
        call!(mut self => hs_world_clear_surface_loads(block))
    }
}
