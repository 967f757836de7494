//! Blocks: their names, how they are made and how they move.

use std::mem::{size_of, MaybeUninit};
use std::num::NonZeroU64;

use halfspace_sys as sys;

use crate::constants::constants;
use crate::pose::Pose;
use crate::shape::Shape;

/// Names a block of a world. The name of a removed block never names another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Block(NonZeroU64);

impl Block {
    /// The block that [`Block::id`] gave a number for, as when it was kept in a file. `None` for 0.
    pub fn from_id(id: u64) -> Option<Self> {
        Self::from_raw(id)
    }

    /// A number to keep elsewhere: the `hs_block` of the C interface, never 0.
    pub fn id(self) -> u64 {
        self.0.get()
    }

    pub(crate) fn from_raw(id: sys::hs_block) -> Option<Self> {
        NonZeroU64::new(id).map(Self)
    }
}

/// Names a material of a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Material(pub(crate) i32);

impl Material {
    /// The material of that index, as when a world was restored: they count from 0 as they were
    /// added.
    pub fn from_index(index: i32) -> Self {
        Self(index)
    }

    /// Counted from 0 as they were added.
    pub fn index(self) -> i32 {
        self.0
    }
}

constants! {
    /// How a block moves.
    BlockKind {
        /// Never.
        Fixed = HS_BLOCK_FIXED,
        /// With the velocity and spin given, whatever the forces.
        Prescribed = HS_BLOCK_PRESCRIBED,
        /// By Newton's law.
        Rigid = HS_BLOCK_RIGID,
        /// By Newton's law, and straining as a whole.
        Affine = HS_BLOCK_AFFINE,
        /// As the nodes of its mesh do: see [`World::add_mesh`](crate::World::add_mesh).
        Mesh = HS_BLOCK_MESH,
    }
}

/// How a block is made: rigid, affine, fixed or prescribed; where and how fast.
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

    /// Moves by Newton's law and strains as a whole. Its material must be elastic: see
    /// [`World::set_elasticity`](crate::World::set_elasticity).
    pub fn affine(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_AFFINE, material)
    }

    /// Never moves.
    pub fn fixed(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_FIXED, material)
    }

    /// Moves with the velocity and spin given, whatever the forces.
    pub fn prescribed(material: Material) -> Self {
        Self::of_kind(sys::HS_BLOCK_PRESCRIBED, material)
    }

    /// Where the block is. By default, where the shape's vertices were given.
    pub fn at(mut self, pose: Pose) -> Self {
        self.pose = Some(pose);
        self
    }

    /// Of the centroid; by default 0.
    pub fn velocity(mut self, velocity: [f64; 3]) -> Self {
        self.velocity = velocity;
        self
    }

    /// In rad/s, in the plane of z alone; by default 0.
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
        let mut raw = MaybeUninit::<sys::hs_block_def>::zeroed();
        // SAFETY: the size is that of the struct, for which all zero is valid, and the shape lives.
        let mut raw = unsafe {
            sys::hs_block_def_init(
                raw.as_mut_ptr(),
                size_of::<sys::hs_block_def>(),
                shape.handle(),
            );
            raw.assume_init()
        };
        raw.kind = self.kind;
        raw.material = self.material.0;
        raw.pose = self.pose.map_or(raw.pose, Into::into);
        raw.velocity = self.velocity;
        raw.angular_velocity = self.angular_velocity;
        raw
    }
}

/// A block's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BlockState {
    /// How it moves.
    pub kind: BlockKind,
    /// What it is made of.
    pub material: Material,
    /// Of the centroid.
    pub pose: Pose,
    /// In the plane: the angle of the pose, in radians, counting whole turns.
    pub angle: f64,
    /// Of the centroid.
    pub velocity: [f64; 3],
    /// In the plane: z.
    pub angular_velocity: [f64; 3],
    /// Contact force of the last force evaluation.
    pub force: [f64; 3],
    /// Contact torque about the centroid, likewise.
    pub torque: [f64; 3],
    /// In the plane per unit thickness.
    pub mass: f64,
}

impl From<sys::hs_block_state> for BlockState {
    fn from(raw: sys::hs_block_state) -> Self {
        Self {
            kind: BlockKind::from_raw(raw.kind),
            material: Material(raw.material),
            pose: raw.pose.into(),
            angle: raw.angle,
            velocity: raw.velocity,
            angular_velocity: raw.angular_velocity,
            force: raw.force,
            torque: raw.torque,
            mass: raw.mass,
        }
    }
}
