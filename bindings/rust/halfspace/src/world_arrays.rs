//! Motion, forces and contacts of a world's blocks: one by one, and in arrays over all of them.

use std::mem::MaybeUninit;
use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, BlockState};
use crate::contact::Contact;
use crate::error::Error;
use crate::mutable_view::ViewMut;
use crate::pose::Pose;
use crate::view::View;
use crate::world::World;
use crate::Result;

/// One block.
impl World {
    /// A block's motion.
    pub fn block_state(&self, block: Block) -> Result<BlockState> {
        let mut raw = sys::hs_block_state::default();
        // SAFETY: the world lives.
        self.check(unsafe { sys::hs_world_get_block_state(self.handle(), block.id(), &mut raw) })?;
        Ok(raw.into())
    }

    /// A block's vertices where they are now, counter-clockwise.
    pub fn block_vertices(&self, block: Block) -> Result<Vec<[f64; 3]>> {
        let count = self.block_vertices_into(block, ViewMut::none())?;
        let mut vertices = vec![[0.0; 3]; count];
        self.block_vertices_into(block, &mut vertices)?;
        Ok(vertices)
    }

    /// The same into memory that is there already: as many as there is room for. Returns how many
    /// the block has.
    pub fn block_vertices_into<'a>(
        &self,
        block: Block,
        vertices: impl Into<ViewMut<'a>>,
    ) -> Result<usize> {
        let room = vertices.into().raw();
        let mut count = 0;
        // SAFETY: the world lives, and the view borrows what it says.
        self.check(unsafe {
            sys::hs_world_get_block_vertices(self.handle(), block.id(), room, &mut count)
        })?;
        Ok(count as usize)
    }

    /// Puts a block elsewhere.
    pub fn set_pose(&mut self, block: Block, pose: &Pose) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_set_pose(self.handle(), block.id(), pose.raw()) })
    }

    /// Sets a block's velocity and angular velocity, in the plane of z alone. A fixed block takes
    /// none.
    pub fn set_velocity(
        &mut self,
        block: Block,
        velocity: [f64; 3],
        angular_velocity: [f64; 3],
    ) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe {
            sys::hs_world_set_velocity(self.handle(), block.id(), &velocity, &angular_velocity)
        })
    }

    /// Sets the force at the centroid and the torque about it, in the plane z alone, that act on a
    /// rigid or affine block from outside until set again.
    pub fn set_applied_force(
        &mut self,
        block: Block,
        force: [f64; 3],
        torque: [f64; 3],
    ) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe {
            sys::hs_world_set_applied_force(self.handle(), block.id(), &force, &torque)
        })
    }
}

/// All blocks.
impl World {
    /// The names of all blocks, in the order of the arrays below.
    pub fn blocks(&self) -> Vec<Block> {
        let mut ids = vec![0; self.block_count()];
        // SAFETY: the world lives, and the array is as long as said.
        self.owner().expect(unsafe {
            sys::hs_world_get_blocks(
                self.handle(),
                ids.as_mut_ptr(),
                ids.len() as i64,
                ptr::null_mut(),
            )
        });
        ids.into_iter().filter_map(Block::from_raw).collect()
    }

    /// The poses of all blocks.
    pub fn poses(&self) -> Vec<Pose> {
        let mut poses = vec![Pose::default(); self.block_count()];
        self.owner().expect(self.get_poses(&mut poses));
        poses
    }

    /// The same into memory that is there already, one pose per block.
    pub fn poses_into(&self, poses: &mut [Pose]) -> Result<()> {
        self.require_one_per_block("World::poses_into: poses", poses.len())?;
        self.check(self.get_poses(poses))
    }

    fn get_poses(&self, poses: &mut [Pose]) -> sys::hs_status {
        // SAFETY: the world lives, the array is as long as said, and a Pose is laid out as the
        // library's.
        unsafe {
            sys::hs_world_get_poses(
                self.handle(),
                poses.as_mut_ptr().cast(),
                poses.len() as i64,
                ptr::null_mut(),
            )
        }
    }

    /// Sets the poses of all blocks. On an error none has moved.
    pub fn set_poses(&mut self, poses: &[Pose]) -> Result<()> {
        // SAFETY: the world lives, the array is as long as said, and a Pose is laid out as the
        // library's.
        self.check(unsafe {
            sys::hs_world_set_poses(self.handle(), poses.as_ptr().cast(), poses.len() as i64)
        })
    }

    /// The velocities and angular velocities of all blocks, one each per block or
    /// [`ViewMut::none`]. Angular ones have three components; in the plane x and y are 0.
    pub fn velocities_into<'a, 'b>(
        &self,
        velocities: impl Into<ViewMut<'a>>,
        angular_velocities: impl Into<ViewMut<'b>>,
    ) -> Result<()> {
        let (mut velocities, mut angular) = (velocities.into(), angular_velocities.into());
        self.require_one_per_block_or_none(
            "World::velocities_into: velocities",
            velocities.count(),
        )?;
        self.require_one_per_block_or_none(
            "World::velocities_into: angular_velocities",
            angular.count(),
        )?;
        // SAFETY: the world lives, and the views borrow what they say.
        self.check(unsafe {
            sys::hs_world_get_velocities(self.handle(), velocities.raw(), angular.raw())
        })
    }

    /// Sets the velocities and angular velocities of all blocks, the latter of three components; an
    /// empty view of them leaves the angular ones as they are. Entries of fixed blocks are ignored.
    /// On an error none has changed.
    pub fn set_velocities<'a, 'b>(
        &mut self,
        velocities: impl Into<View<'a>>,
        angular_velocities: impl Into<View<'b>>,
    ) -> Result<()> {
        let (velocities, angular) = (velocities.into().raw(), angular_velocities.into().raw());
        // SAFETY: the world lives, and the views borrow what they say.
        self.check(unsafe { sys::hs_world_set_velocities(self.handle(), velocities, angular) })
    }

    /// Stage: neighbour search and detection at the present poses. Returns how many pairs are in
    /// contact.
    pub fn detect(&mut self) -> Result<usize> {
        let mut touching = 0;
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe { sys::hs_world_detect(self.handle(), &mut touching) })?;
        Ok(touching as usize)
    }

    /// Stage: contact forces at the present poses and velocities, after [`World::detect`].
    /// `elapsed` is the time since the last call: shear springs grow by velocity times this.
    /// Forces, and torques about the centroids of three components, come one per block or, for
    /// [`ViewMut::none`], not at all.
    pub fn forces<'a, 'b>(
        &mut self,
        elapsed: f64,
        forces: impl Into<ViewMut<'a>>,
        torques: impl Into<ViewMut<'b>>,
    ) -> Result<()> {
        let (mut forces, mut torques) = (forces.into(), torques.into());
        self.require_one_per_block_or_none("World::forces: forces", forces.count())?;
        self.require_one_per_block_or_none("World::forces: torques", torques.count())?;
        // SAFETY: the world lives, and the views borrow what they say.
        self.check(unsafe {
            sys::hs_world_forces(self.handle(), elapsed, forces.raw(), torques.raw())
        })
    }

    /// The contacts of the last detection, sorted by block, a before b; none after a change of
    /// poses, blocks or laws. Forces are 0 until they are evaluated.
    pub fn contacts(&self) -> Vec<Contact> {
        let mut contacts = Vec::new();
        self.contacts_into(&mut contacts);
        contacts
    }

    /// The same into a buffer, whose memory serves again from call to call.
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

    /// Writes as many contacts as there is room for and returns how many there are.
    fn get_contacts(&self, room: &mut [MaybeUninit<Contact>]) -> usize {
        let mut count = 0;
        // SAFETY: the world lives, there is room for as many as said, and a Contact is laid out as
        // the library's.
        self.owner().expect(unsafe {
            sys::hs_world_get_contacts(
                self.handle(),
                room.as_mut_ptr().cast(),
                room.len() as i64,
                &mut count,
            )
        });
        count as usize
    }

    /// Preloads the shear spring of a contact, as to start from equilibrium: the force on
    /// `block_b`, of which counts what lies in the contact plane. After [`World::detect`] or a
    /// step.
    pub fn set_shear_force(
        &mut self,
        block_a: Block,
        block_b: Block,
        shear_force: [f64; 3],
    ) -> Result<()> {
        // SAFETY: the world lives and is borrowed mutably.
        self.check(unsafe {
            sys::hs_world_set_shear_force(self.handle(), block_a.id(), block_b.id(), &shear_force)
        })
    }

    pub(crate) fn count_blocks(&self) -> usize {
        let mut count = 0;
        // SAFETY: there is room for nothing, and nothing is written.
        self.owner().expect(unsafe {
            sys::hs_world_get_blocks(self.handle(), ptr::null_mut(), 0, &mut count)
        });
        count as usize
    }

    pub(crate) fn require_one_per_block(&self, name: &str, count: usize) -> Result<()> {
        if count == self.block_count() {
            return Ok(());
        }
        Err(Error::argument(&format!(
            "{name} has {count} entries; the world has {} blocks",
            self.block_count()
        )))
    }

    fn require_one_per_block_or_none(&self, name: &str, count: usize) -> Result<()> {
        if count == 0 {
            return Ok(());
        }
        self.require_one_per_block(name, count)
    }
}
