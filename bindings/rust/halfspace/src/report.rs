//! The state of a world in numbers.

use halfspace_sys as sys;

/// Where the energy is and where it went since the world was made, in J, in the plane per unit
/// thickness. Adding or removing blocks and setting a motion are booked as outer work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Energy {
    /// Now.
    pub kinetic: f64,
    /// Potential, zero at the origin, now.
    pub gravity: f64,
    /// Energy in the springs of contacts and bonds, now.
    pub strain: f64,
    /// By sliding and by breaking bonds, so far.
    pub friction_loss: f64,
    /// By viscous contact damping, so far.
    pub contact_damping_loss: f64,
    /// By local damping, so far.
    pub local_damping_loss: f64,
    /// By mass-proportional damping, so far.
    pub mass_damping_loss: f64,
    /// By prescribed blocks, applied forces, surface loads and edits, so far.
    pub outer_work: f64,
    /// All but the outer work, minus the outer work: what the numbers themselves made or lost.
    pub residual: f64,
}

/// The state of a world in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// 2 or 3.
    pub dimension: usize,
    /// Done so far.
    pub steps: u64,
    /// Passed so far.
    pub time: f64,
    /// In use.
    pub time_step: f64,
    /// Safe bound from stiffness, viscosity and mass; 0 without blocks that move freely.
    pub stable_time_step: f64,
    /// Living blocks.
    pub block_count: usize,
    /// Pairs in the neighbour list.
    pub candidate_count: usize,
    /// Pairs in contact.
    pub contact_count: usize,
    /// How often the neighbour list was built.
    pub list_builds: u64,
    /// Of the last detection.
    pub largest_overlap: f64,
    /// Of all blocks that move freely, now.
    pub largest_speed: f64,
    /// The ledger.
    pub energy: Energy,
    /// In use; 0 without a law of potentials.
    pub potential_length: f64,
    /// Strain energy of affine blocks and meshes, now; counts in the residual.
    pub block_strain_energy: f64,
    /// Energy damped in affine blocks and meshes, so far; counts in the residual.
    pub block_damping_loss: f64,
    /// Steps so far that fast blocks have divided.
    pub divided_steps: u64,
    /// Largest share of the thinner block's thickness up to which springs let two blocks come, the
    /// root of d^2 + v^2 m/k for those that approach at v where they are nearest and lie d deep: of
    /// all when they met, of those that divided a step in each part of it, and of those in the
    /// neighbour list now. Above 0.25 or so springs are too soft; from 0.5 on blocks may pass
    /// through each other.
    pub max_penetration_ratio: f64,
    /// Largest overlap so far, at every detection; by potentials in space, whose steps find no
    /// overlaps, now.
    pub peak_overlap: f64,
    /// Largest speed so far of all blocks that move freely, at the end of every step and part of
    /// one.
    pub peak_speed: f64,
    /// Blocks that sleep now.
    pub sleeping_count: usize,
    /// The most of its way, in m, that any block has missed by sleep so far.
    pub max_sleep_error: f64,
    /// Touches so far by laws without springs; a corner that slides from face to face touches anew.
    pub touch_count: usize,
    /// Iterations so far of the solver of laws without springs: sweeps over all of their contacts.
    pub iteration_count: usize,
    /// Energy lost so far by their touches, in J; counts in the residual.
    pub impact_loss: f64,
}

impl From<sys::hs_energy> for Energy {
    fn from(raw: sys::hs_energy) -> Self {
        Self {
            kinetic: raw.kinetic,
            gravity: raw.gravity,
            strain: raw.strain,
            friction_loss: raw.friction_loss,
            contact_damping_loss: raw.contact_damping_loss,
            local_damping_loss: raw.local_damping_loss,
            mass_damping_loss: raw.mass_damping_loss,
            outer_work: raw.outer_work,
            residual: raw.residual,
        }
    }
}

impl From<sys::hs_world_report> for Report {
    fn from(raw: sys::hs_world_report) -> Self {
        Self {
            dimension: raw.dimension as usize,
            steps: raw.steps as u64,
            time: raw.time,
            time_step: raw.time_step,
            stable_time_step: raw.stable_time_step,
            block_count: raw.block_count as usize,
            candidate_count: raw.candidate_count as usize,
            contact_count: raw.contact_count as usize,
            list_builds: raw.list_builds as u64,
            largest_overlap: raw.largest_overlap,
            largest_speed: raw.largest_speed,
            energy: raw.energy.into(),
            potential_length: raw.potential_length,
            block_strain_energy: raw.block_strain_energy,
            block_damping_loss: raw.block_damping_loss,
            divided_steps: raw.divided_steps as u64,
            max_penetration_ratio: raw.max_penetration_ratio,
            peak_overlap: raw.peak_overlap,
            peak_speed: raw.peak_speed,
            sleeping_count: raw.sleeping_count as usize,
            max_sleep_error: raw.max_sleep_error,
            touch_count: raw.touch_count as usize,
            iteration_count: raw.iteration_count as usize,
            impact_loss: raw.impact_loss,
        }
    }
}
