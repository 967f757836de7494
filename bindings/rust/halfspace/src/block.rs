//! Blocks and materials: ids and definitions.

use std::num::NonZeroU64;

use halfspace_sys as sys;

use crate::call::initial;
use crate::pose::Pose;
use crate::shape::Shape;

/// Id of a block of a world. Ids of removed blocks are not reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Block(NonZeroU64);

impl Block {
    /// The block of a number from [`Block::id`], e.g. read from a file. `None` for 0.
    pub fn from_id(id: u64) -> Option<Self> {
        NonZeroU64::new(id).map(Self)
    }

    /// The `hs_block` of the C interface; never 0.
    pub fn id(self) -> u64 {
        self.0.get()
    }
}

/// A material of a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Material(pub(crate) i32);

impl Material {
    /// The material of an index, e.g. in a restored world. Indices start at 0, in the order of
    /// creation.
    pub fn from_index(index: i32) -> Self {
        Self(index)
    }

    /// The index, from 0, in the order of creation.
    pub fn index(self) -> i32 {
        self.0
    }
}

/// Definition of a block: kind, material, pose and velocity.
///
/// ```
/// use halfspace::{BlockDef, Material, Pose};
/// let stone = Material::from_index(0);
/// let above = Pose::in_plane(0.0, 5.0, 0.1);
/// let falling = BlockDef::rigid(stone).at(above).velocity([0.0, -2.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct BlockDef {
    kind: i32,
    material: Material,
    pose: Option<Pose>,
    velocity: [f64; 3],
    angular_velocity: [f64; 3],
}

impl BlockDef {
    /// Moves by Newton's law.
    pub fn rigid(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_RIGID, material)
    }

    /// Moves by Newton's law, with uniform strain. Its material must have an elasticity: see
    /// [`World::set_elasticity`](crate::World::set_elasticity).
    pub fn affine(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_AFFINE, material)
    }

    /// Does not move.
    pub fn fixed(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_FIXED, material)
    }

    /// Moves with the given velocity, whatever the forces.
    pub fn prescribed(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_PRESCRIBED, material)
    }

    /// Pose of the block; by default that of the coordinates of the shape's vertices.
    pub fn at(mut self, pose: Pose) -> Self {
        self.pose = Some(pose);
        self
    }

    /// Velocity of the centroid, in m/s; by default 0.
    pub fn velocity(mut self, velocity: [f64; 3]) -> Self {
        self.velocity = velocity;
        self
    }

    /// Angular velocity, in rad/s; 2D uses z; by default 0.
    pub fn angular_velocity(mut self, angular_velocity: [f64; 3]) -> Self {
        self.angular_velocity = angular_velocity;
        self
    }

    fn of_kind(kind: i32, material: Material) -> Self {
        Self {
            kind,
            material,
            pose: None,
            velocity: [0.0; 3],
            angular_velocity: [0.0; 3],
        }
    }

    pub(crate) fn raw(&self, shape: &Shape) -> sys::hs_block_def {
        // SAFETY: the size is that of the struct, and the shape lives.
        self.changed(initial(|def, size| unsafe {
            sys::hs_block_def_init(def, size, shape.handle())
        }))
    }

    /// A definition with these values.
    pub(crate) fn changed(&self, mut raw: sys::hs_block_def) -> sys::hs_block_def {
        raw.kind = self.kind;
        raw.material = self.material.0;
        raw.pose = self.pose.map_or(raw.pose, Into::into);
        raw.velocity = self.velocity;
        raw.angular_velocity = self.angular_velocity;
        raw
    }
}
