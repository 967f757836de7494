//! A host whose calls are in C.

use std::ptr;

use halfspace::Pose;
use halfspace_sys as sys;

use crate::calls_in_c::{
    require_ok, seconds_of_contacts, seconds_of_detect, seconds_of_forces, seconds_of_poses,
    seconds_of_step,
};

/// A world with the arrays of its host.
pub struct HostInC {
    context: *mut sys::hs_context,
    world: *mut sys::hs_world,
    poses: Vec<sys::hs_pose>,
    forces: Vec<[f64; 3]>,
    torques: Vec<[f64; 3]>,
    contacts: Vec<sys::hs_contact>,
}

// In all blocks below the world lives, and arrays are as long as said.
impl HostInC {
    pub fn restore(bytes: &[u8]) -> Self {
        let (mut context, mut world) = (ptr::null_mut(), ptr::null_mut());
        let (mut blocks, mut touching) = (0, 0);
        // SAFETY: the bytes are as many as said, all else are places to write to.
        unsafe {
            require_ok(sys::hs_context_create(ptr::null(), &mut context));
            require_ok(sys::hs_world_restore(
                context,
                bytes.as_ptr().cast(),
                bytes.len(),
                &mut world,
            ));
            require_ok(sys::hs_world_detect(world, &mut touching));
            sys::hs_world_get_blocks(world, ptr::null_mut(), 0, &mut blocks);
        }
        let none = vec![[0.0; 3]; blocks as usize];
        let mut host = Self {
            context,
            world,
            poses: vec![sys::hs_pose::default(); none.len()],
            forces: none.clone(),
            torques: none,
            contacts: vec![sys::hs_contact::default(); touching as usize],
        };
        host.get_poses(1);
        host
    }

    /// Setting poses, also equal ones, requires a new detection.
    pub fn detect(&mut self, calls: i64) {
        let (poses, count) = (self.poses.as_ptr(), self.poses.len() as i64);
        // SAFETY: see above.
        unsafe { seconds_of_detect(self.world, calls, poses, count) };
    }

    pub fn forces(&mut self, calls: i64) {
        let (forces, torques) = (view_of(&mut self.forces), view_of(&mut self.torques));
        // SAFETY: see above.
        unsafe { seconds_of_forces(self.world, calls, forces, torques) };
    }

    pub fn get_poses(&mut self, calls: i64) {
        let (poses, count) = (self.poses.as_mut_ptr(), self.poses.len() as i64);
        // SAFETY: see above.
        unsafe { seconds_of_poses(self.world, calls, poses, count) };
    }

    pub fn get_contacts(&mut self, calls: i64) {
        let (contacts, capacity) = (self.contacts.as_mut_ptr(), self.contacts.len() as i64);
        // SAFETY: see above.
        unsafe { seconds_of_contacts(self.world, calls, contacts, capacity) };
    }

    pub fn step(&mut self, calls: i64) {
        // SAFETY: see above.
        unsafe { seconds_of_step(self.world, calls) };
    }

    pub fn poses_are(&self, others: &[Pose]) -> bool {
        let same = |(mine, other): (&sys::hs_pose, &Pose)| Pose::from(*mine) == *other;
        self.poses.len() == others.len() && self.poses.iter().zip(others).all(same)
    }
}

impl Drop for HostInC {
    fn drop(&mut self) {
        // SAFETY: nothing else was made from the context.
        unsafe {
            sys::hs_world_destroy(self.world);
            sys::hs_context_destroy(self.context);
        }
    }
}

fn view_of(points: &mut [[f64; 3]]) -> sys::hs_mutable_view {
    let x = points.as_mut_ptr().cast::<f64>();
    let (y, z) = (x.wrapping_add(1), x.wrapping_add(2));
    sys::hs_mutable_view {
        x,
        y,
        z,
        stride: 24,
        count: points.len() as i64,
    }
}
