//! The calls in C.

use halfspace_sys::*;

extern "C" {
    pub fn c_thread_seconds() -> f64;
    pub fn c_detect_pairs(
        square: *const hs_shape,
        lower: *const hs_pose,
        uppers: *const hs_pose,
        count: i64,
        contact: *mut hs_contact,
    ) -> hs_status;
    pub fn c_detect_pairs_cached(
        square: *const hs_shape,
        lower: *const hs_pose,
        uppers: *const hs_pose,
        count: i64,
        cache: *mut hs_pair_cache,
        contact: *mut hs_contact,
    ) -> hs_status;
    pub fn c_step(world: *mut hs_world) -> hs_status;
    pub fn c_detect(world: *mut hs_world, poses: *const hs_pose, count: i64) -> hs_status;
    pub fn c_forces(
        world: *mut hs_world,
        forces: hs_mutable_view,
        torques: hs_mutable_view,
    ) -> hs_status;
    pub fn c_poses(world: *const hs_world, poses: *mut hs_pose, count: i64) -> hs_status;
    pub fn c_contacts(
        world: *const hs_world,
        contacts: *mut hs_contact,
        capacity: i64,
    ) -> hs_status;
}

pub fn require_ok(status: hs_status) {
    assert_eq!(status, HS_OK, "a call of the benchmark failed");
}
