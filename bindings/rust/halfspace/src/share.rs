//! Shares of a world, for hosts that spread one world over processes.

use std::ptr;

use halfspace_sys as sys;

use crate::call::{call, create, known, sure, written};
use crate::error::require;
use crate::kinds::Role;
use crate::records::{ShareInfo, SharePlan};
use crate::world::World;
use crate::Result;

/// Energies and losses of a share, in J and W, that add up over shares to those of the whole world.
pub type Sums = [f64; sys::HS_SUM_COUNT as usize];

/// A block of a share to be assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Packed<'a> {
    /// Name of the block in all shares.
    pub key: i64,
    /// The role of the block in the share.
    pub role: Role,
    /// From [`World::pack`] of the share that owns the block; `None`: as the world that assembles the
    /// share has it, of which the block is its own or everywhere.
    pub bytes: Option<&'a [u8]>,
}

impl Packed<'_> {
    fn raw(&self) -> sys::hs_packed {
        sys::hs_packed {
            key: self.key,
            bytes: self
                .bytes
                .map_or(ptr::null(), |bytes| bytes.as_ptr().cast()),
            size: self.bytes.map_or(0, <[u8]>::len),
            role: self.role.value(),
            reserved: 0,
        }
    }
}

/// Shares: each process has a world of its own blocks, of copies of their neighbours, and of the
/// fixed and prescribed blocks, which are everywhere. All processes make the same calls, and the
/// host carries packed blocks and loads between them:
///
/// ```text
/// plan ──▶ does any need a list or an assembly? ── yes: pack, carry, assemble, plan; renew the lists
///   └────▶ move ──▶ loads, carry, set the loads ──▶ end the step
/// ```
///
/// The motion has the same bits as by [`World::step`] of the whole world, for any number of shares.
/// Shares hold rigid and affine blocks, laws with springs and potential laws, water and applied
/// forces; the world needs a given time step.
impl World {
    /// Names the blocks of a whole world, in the order of [`World::blocks`]: ascending. By default a
    /// block's key is its place there. Blocks that are added or removed later end these keys.
    pub fn set_keys(&mut self, keys: &[i64]) -> Result<()> {
        call!(mut self => hs_world_set_keys([keys]))
    }

    /// Returns the keys of all blocks, in the order of [`World::blocks`], which is ascending.
    pub fn keys(&self) -> Vec<i64> {
        self.of_blocks(|room| call!(self => hs_world_get_keys([mut room], &mut 0)))
    }

    /// Returns the roles of all blocks, in the order of [`World::blocks`]. In a whole world fixed and
    /// prescribed blocks are everywhere, all others own.
    pub fn roles(&self) -> Vec<Role> {
        let roles: Vec<i32> = self
            .of_blocks(|room: &mut [i32]| call!(self => hs_world_get_roles([mut room], &mut 0)));
        roles.into_iter().map(Role::from_value).collect()
    }

    /// Returns numbers of blocks, and how far copies must reach, after [`World::plan_motion`].
    pub fn share_info(&mut self) -> ShareInfo {
        known(|info, size| call!(mut self => hs_world_get_share_info(info, size)))
    }

    /// Packs own blocks, or blocks that are everywhere, in any order: their motion, and the memory of
    /// their pairs, in the machine's format of numbers; with their outlines for shares that do not
    /// have the block. Returns the bytes of all blocks, and per key where its bytes end.
    ///
    /// # Errors
    /// [`ErrorKind::StaleId`](crate::ErrorKind::StaleId) if no such block has a key.
    pub fn pack(&mut self, keys: &[i64], with_shapes: bool) -> Result<(Vec<u8>, Vec<usize>)> {
        let (mut bytes, mut ends) = (Vec::new(), vec![0; keys.len()]);
        let size = self.pack_into(keys, with_shapes, &mut bytes, &mut ends)?;
        bytes.resize(size, 0);
        self.pack_into(keys, with_shapes, &mut bytes, &mut ends)?;
        Ok((bytes, ends))
    }

    /// Packs as many blocks as fit, and returns the number of bytes of all.
    fn pack_into(
        &mut self,
        keys: &[i64],
        with_shapes: bool,
        bytes: &mut [u8],
        ends: &mut [usize],
    ) -> Result<usize> {
        let ends = ends.as_mut_ptr();
        // SAFETY: there is an end per key.
        written(
            |needed, _| call!(mut self => hs_world_pack([keys], with_shapes, [mut bytes], unsafe ends, needed)),
        )
    }

    /// Makes a world of blocks, in the same context: a share, or the whole world again where all its
    /// blocks are own ones. Settings, laws, clock, list of pairs and losses are those of this world,
    /// which does not change. The blocks are in ascending order of keys: all own blocks of the share,
    /// copies of all blocks within its halo, packed in the present motion, and all blocks that are
    /// everywhere.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Pose, Shape, World, WorldDef};
    /// use halfspace::{Packed, Role};
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane().time_step(1e-4))?;
    /// # let stone = world.add_material(2000.0)?;
    /// # world.add_block(&square, &BlockDef::rigid(stone))?;
    /// # world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(3.0, 0.5, 0.0)))?;
    /// let (bytes, _) = world.pack(&[1], true)?;
    /// let mut left = world.assemble(&[
    ///     Packed { key: 0, role: Role::Own, bytes: None },
    ///     Packed { key: 1, role: Role::Neighbor, bytes: Some(&bytes) },
    /// ])?;
    /// assert_eq!((left.share_info().own_count, left.share_info().is_whole), (1, false));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::State`](crate::ErrorKind::State) if this world has something that shares cannot
    /// hold, [`ErrorKind::Format`](crate::ErrorKind::Format) for damaged bytes.
    pub fn assemble(&mut self, blocks: &[Packed]) -> Result<World> {
        let raw: Vec<_> = blocks.iter().map(Packed::raw).collect();
        let context = &self.context();
        create!(context => hs_world_assemble(self, [raw])).map(World::of)
    }

    /// Returns the share's energies and losses (16, J), powers (5, W), linear momentum (3, N s) and angular
    /// momentum about the origin (3, N m s).
    pub fn sums(&self) -> Sums {
        let mut sums = Sums::default();
        sure(call!(self => hs_world_get_sums(&mut sums)));
        sums
    }

    /// Sets them, all but the momentum: to the sums over the shares whose blocks the world has taken over.
    pub fn set_sums(&mut self, sums: &Sums) -> Result<()> {
        call!(mut self => hs_world_set_sums(sums))
    }

    /// Begins after blocks were added, or laws, velocities or forces changed: computes contacts and
    /// forces where blocks are. Then loads are carried, and [`World::end_begin`] follows.
    pub fn begin(&mut self) -> Result<()> {
        call!(mut self => hs_world_begin())
    }

    /// Computes accelerations and energies of the beginning, from the loads.
    pub fn end_begin(&mut self) -> Result<()> {
        call!(mut self => hs_world_end_begin())
    }

    /// Plans the motion of a step, without moving any block. The host combines the plans of all
    /// shares: a list or an assembly is needed if any share needs it, and any refusal counts.
    pub fn plan_motion(&mut self) -> Result<SharePlan> {
        written(|plan, _| call!(mut self => hs_world_plan_motion(plan)))
    }

    /// Renews the list of pairs for the planned motion, in all shares if the plan of any needs it.
    /// Returns the plan with the new list, whose refusal counts.
    pub fn renew_list(&mut self) -> Result<SharePlan> {
        written(|plan, _| call!(mut self => hs_world_renew_list(plan)))
    }

    /// Makes the planned motion, which must be without a refusal, and computes contacts and forces
    /// after it.
    pub fn move_blocks(&mut self) -> Result<()> {
        call!(mut self => hs_world_move())
    }

    /// Numbers per key of [`World::loads`].
    fn load_length(&mut self) -> usize {
        let length = self
            .load_length
            .unwrap_or_else(|| self.share_info().load_length);
        self.load_length = Some(length);
        length
    }

    /// Returns the loads of the contacts on own blocks, for the shares that have copies:
    /// [`ShareInfo::load_length`] numbers per key, which are force, torque, and in worlds with elastic
    /// materials the virial.
    pub fn loads(&mut self, keys: &[i64]) -> Result<Vec<f64>> {
        let mut loads = vec![0.0; keys.len() * self.load_length()];
        // SAFETY: there is room for the loads of all keys.
        call!(self => hs_world_get_loads([keys], unsafe loads.as_mut_ptr()))?;
        Ok(loads)
    }

    /// Sets the loads of the contacts on copies, as [`World::loads`] of their owner returned them.
    pub fn set_loads(&mut self, keys: &[i64], loads: &[f64]) -> Result<()> {
        let (count, keys_count) = (loads.len(), keys.len());
        let needed = keys_count * self.load_length();
        require(count == needed, || {
            format!("World::set_loads: loads has {count} numbers; {keys_count} keys take {needed}")
        })?;
        // SAFETY: there are loads of all keys.
        call!(mut self => hs_world_set_loads([keys], unsafe loads.as_ptr()))
    }

    /// Ends the step: computes velocities and energies at the end of the motion, from the loads.
    pub fn end_step(&mut self) -> Result<()> {
        call!(mut self => hs_world_end_step())
    }
}
