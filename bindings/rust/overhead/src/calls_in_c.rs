//! The calls in C, of bindings/calls_in_c.c.

use halfspace_sys::*;

extern "C" {
    pub fn thread_seconds() -> f64;
    pub fn seconds_of_step(world: *mut hs_world, calls: i64) -> f64;
    pub fn seconds_of_detect(
        world: *mut hs_world,
        calls: i64,
        poses: *const hs_pose,
        count: i64,
    ) -> f64;
    pub fn seconds_of_forces(
        world: *mut hs_world,
        calls: i64,
        forces: hs_mutable_view,
        torques: hs_mutable_view,
    ) -> f64;
    pub fn seconds_of_poses(
        world: *const hs_world,
        calls: i64,
        poses: *mut hs_pose,
        count: i64,
    ) -> f64;
    pub fn seconds_of_contacts(
        world: *const hs_world,
        calls: i64,
        contacts: *mut hs_contact,
        capacity: i64,
    ) -> f64;
    pub fn seconds_of_pairs(
        shape: *const hs_shape,
        lower: *const hs_pose,
        uppers: *const hs_pose,
        count: i64,
        cache: *mut hs_pair_cache,
        contact: *mut hs_contact,
    ) -> f64;
}

pub fn require_ok(status: hs_status) {
    assert_eq!(status, HS_OK, "a call of the benchmark failed");
}
