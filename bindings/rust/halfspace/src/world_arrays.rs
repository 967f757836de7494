//! Motion, forces and contacts of blocks: of one block, and arrays of all blocks.

use std::mem::MaybeUninit;

use halfspace_sys as sys;

use crate::block::Block;
use crate::call::{call, counted, filled, listed_points, sure, written};
use crate::contact::Contact;
use crate::error::require;
use crate::mutable_view::ViewMut;
use crate::pose::Pose;
use crate::records::BlockState;
use crate::view::View;
use crate::world::World;
use crate::Result;

/// One block.
impl World {
    /// Returns the motion of a block.
    pub fn block_state(&self, block: Block) -> Result<BlockState> {
        written(|state, _| call!(self => hs_world_get_block_state(block, state)))
    }

    /// Returns the current positions of a block's vertices, in m, in 2D counter-clockwise.
    pub fn block_vertices(&self, block: Block) -> Result<Vec<[f64; 3]>> {
        listed_points(|vertices| self.block_vertices_into(block, vertices))
    }

    /// Likewise, into existing memory: as many as fit. Returns the number of vertices.
    pub fn block_vertices_into<'a>(
        &self,
        block: Block,
        vertices: impl Into<ViewMut<'a>>,
    ) -> Result<usize> {
        counted(|count| call!(self => hs_world_get_block_vertices(block, vertices.into(), count)))
    }

    /// Sets the pose of a block.
    pub fn set_pose(&mut self, block: Block, pose: &Pose) -> Result<()> {
        call!(mut self => hs_world_set_pose(block, pose))
    }

    /// Sets the velocity, in m/s, and angular velocity, in rad/s, of a block; 2D uses z. Fixed
    /// blocks are refused.
    pub fn set_velocity(
        &mut self,
        block: Block,
        velocity: [f64; 3],
        angular_velocity: [f64; 3],
    ) -> Result<()> {
        call!(mut self => hs_world_set_velocity(block, &velocity, &angular_velocity))
    }

    /// Sets the external force at the centroid, in N, and torque about it, in N m, of a rigid or
    /// affine block, until set again; 2D uses z of the torque.
    pub fn set_applied_force(
        &mut self,
        block: Block,
        force: [f64; 3],
        torque: [f64; 3],
    ) -> Result<()> {
        call!(mut self => hs_world_set_applied_force(block, &force, &torque))
    }
}

/// All blocks.
impl World {
    /// Returns the ids of all blocks. All arrays of blocks have this order.
    pub fn blocks(&self) -> Vec<Block> {
        let ids = self.of_blocks(|room| call!(self => hs_world_get_blocks([mut room], &mut 0)));
        ids.into_iter().filter_map(Block::from_id).collect()
    }

    /// Returns the poses of all blocks.
    pub fn poses(&self) -> Vec<Pose> {
        self.of_blocks(|room| self.get_poses(room))
    }

    /// Likewise, into existing memory, one pose per block.
    pub fn poses_into(&self, poses: &mut [Pose]) -> Result<()> {
        self.require_one_per_block("World::poses_into: poses", poses.len())?;
        self.get_poses(poses)
    }

    fn get_poses(&self, poses: &mut [Pose]) -> Result<()> {
        call!(self => hs_world_get_poses([mut poses], &mut 0))
    }

    /// Sets the poses of all blocks. After an error no block has moved.
    pub fn set_poses(&mut self, poses: &[Pose]) -> Result<()> {
        call!(mut self => hs_world_set_poses([poses]))
    }

    /// Writes the velocities, in m/s, and angular velocities, in rad/s, of all blocks; one per
    /// block, or [`ViewMut::none`]. Angular velocities have three components; in 2D x and y are 0.
    pub fn velocities_into<'a, 'b>(
        &self,
        velocities: impl Into<ViewMut<'a>>,
        angular_velocities: impl Into<ViewMut<'b>>,
    ) -> Result<()> {
        let (velocities, angular) = (velocities.into(), angular_velocities.into());
        self.require_one_per_block_or_none(
            "World::velocities_into: velocities",
            velocities.count(),
        )?;
        self.require_one_per_block_or_none(
            "World::velocities_into: angular_velocities",
            angular.count(),
        )?;
        call!(self => hs_world_get_velocities(velocities, angular))
    }

    /// Sets the velocities and angular velocities of all blocks; the latter have three components,
    /// and an empty view keeps the current ones. Entries of fixed blocks are ignored. After an
    /// error none has changed.
    pub fn set_velocities<'a, 'b>(
        &mut self,
        velocities: impl Into<View<'a>>,
        angular_velocities: impl Into<View<'b>>,
    ) -> Result<()> {
        call!(mut self => hs_world_set_velocities(velocities.into(), angular_velocities.into()))
    }

    /// Returns the motion of all blocks.
    pub fn block_states(&self) -> Vec<BlockState> {
        let states =
            self.of_blocks(|room| call!(self => hs_world_get_block_states([mut room], &mut 0)));
        states.into_iter().map(Into::into).collect()
    }

    /// Sets the external forces at the centroids, in N, and torques about them, in N m, of all rigid
    /// and affine blocks, until set again; torques have three components, and an empty view sets
    /// them to 0. Entries of other blocks are ignored. After an error none has changed.
    pub fn set_applied_forces<'a, 'b>(
        &mut self,
        forces: impl Into<View<'a>>,
        torques: impl Into<View<'b>>,
    ) -> Result<()> {
        call!(mut self => hs_world_set_applied_forces(forces.into(), torques.into()))
    }

    /// Stage: neighbour search and detection at the current poses. Returns the number of pairs in
    /// contact.
    pub fn detect(&mut self) -> Result<usize> {
        counted(|count| call!(mut self => hs_world_detect(count)))
    }

    /// Stage: contact forces at the current poses and velocities, after [`World::detect`].
    /// `elapsed` is the time since the last call, in s: shear springs extend by velocity times
    /// this. Writes one force and one torque about the centroid (three components) per block;
    /// [`ViewMut::none`] skips them.
    pub fn forces<'a, 'b>(
        &mut self,
        elapsed: f64,
        forces: impl Into<ViewMut<'a>>,
        torques: impl Into<ViewMut<'b>>,
    ) -> Result<()> {
        let (forces, torques) = (forces.into(), torques.into());
        self.require_one_per_block_or_none("World::forces: forces", forces.count())?;
        self.require_one_per_block_or_none("World::forces: torques", torques.count())?;
        call!(mut self => hs_world_forces(elapsed, forces, torques))
    }

    /// Returns the contacts of the last detection, sorted by block, a before b; none after a change
    /// of poses, blocks or laws. Forces are 0 until they are evaluated.
    pub fn contacts(&self) -> Vec<Contact> {
        let mut contacts = Vec::new();
        self.contacts_into(&mut contacts);
        contacts
    }

    /// Likewise, into a buffer that is reused from call to call.
    ///
    /// ```
    /// # use halfspace::{Context, World, WorldDef};
    /// # let mut world = World::new(&Context::new()?, &WorldDef::in_plane().time_step(1e-3))?;
    /// let mut buffer = Vec::new();
    /// let mut weight = 0.0;
    /// for _ in 0..10 {
    ///     world.step(1)?;
    ///     let contacts = world.contacts_into(&mut buffer);
    ///     weight += contacts.iter().map(|contact| contact.normal_force()).sum::<f64>();
    /// }
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn contacts_into<'b>(&self, buffer: &'b mut Vec<Contact>) -> &'b [Contact] {
        buffer.clear();
        let count = self.get_contacts(buffer.spare_capacity_mut());
        if count > buffer.capacity() {
            buffer.reserve(count);
            self.get_contacts(buffer.spare_capacity_mut());
        }
        // SAFETY: there was room for all contacts, and all have been written.
        unsafe { buffer.set_len(count) };
        buffer
    }

    /// Writes as many contacts as fit and returns their total number.
    fn get_contacts(&self, room: &mut [MaybeUninit<Contact>]) -> usize {
        sure(counted(
            |count| call!(self => hs_world_get_contacts([mut room], count)),
        ))
    }

    /// Preloads the shear spring of a contact, e.g. to start from equilibrium, with the force on
    /// `block_b`, in N; only the component in the contact plane is used. Call it after
    /// [`World::detect`] or a step.
    pub fn set_shear_force(
        &mut self,
        block_a: Block,
        block_b: Block,
        shear_force: [f64; 3],
    ) -> Result<()> {
        call!(mut self => hs_world_set_shear_force(block_a, block_b, &shear_force))
    }

    /// A list with one entry per block.
    pub(crate) fn of_blocks<Raw: Clone + Default>(
        &self,
        fill: impl FnOnce(&mut [Raw]) -> Result<()>,
    ) -> Vec<Raw> {
        sure(filled(self.block_count(), fill))
    }

    pub(crate) fn count_blocks(&self) -> usize {
        let none: &mut [sys::hs_block] = &mut [];
        sure(counted(
            |count| call!(self => hs_world_get_blocks([mut none], count)),
        ))
    }

    pub(crate) fn require_one_per_block(&self, name: &str, count: usize) -> Result<()> {
        let blocks = self.block_count();
        require(count == blocks, || {
            format!("{name} has {count} entries; the world has {blocks} blocks")
        })
    }

    fn require_one_per_block_or_none(&self, name: &str, count: usize) -> Result<()> {
        if count == 0 {
            return Ok(());
        }
        self.require_one_per_block(name, count)
    }
}
