//! What a world computes, what that costs, and what limits its time step.

use halfspace_sys as sys;

use crate::block::Block;
use crate::body::Body;

/// The account of a world. What is not active is neither stored nor computed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Plan {
    /// A law resists shear: each pair keeps a shear spring.
    pub friction: bool,
    /// A law has cohesion or tensile strength.
    pub bonds: bool,
    /// A law has dashpots.
    pub contact_damping: bool,
    /// A law is per area: overlaps are measured.
    pub area: bool,
    /// A law is one of potentials: overlaps are divided.
    pub potential: bool,
    /// A block is affine or a cell of a mesh.
    pub strain: bool,
    /// The world has local damping.
    pub local_damping: bool,
    /// The world has mass damping.
    pub mass_damping: bool,
    /// A law has no spring: impulses are found for all contacts together.
    pub hard_contacts: bool,
    /// Blocks at rest may sleep.
    pub sleep: bool,
    /// Blocks that never move.
    pub fixed_count: usize,
    /// Blocks that move as they are told.
    pub prescribed_count: usize,
    /// Blocks that move by Newton's law.
    pub rigid_count: usize,
    /// Blocks that strain.
    pub affine_count: usize,
    /// Pairs in the neighbour list.
    pub candidate_count: usize,
    /// Pairs in contact.
    pub contact_count: usize,
    /// State of all blocks with their shapes, as a snapshot holds it.
    pub block_bytes: usize,
    /// State of all pairs: neighbour list, shear springs, plans of potentials; likewise.
    pub pair_bytes: usize,
    /// As in the report; 0 without blocks that move freely.
    pub stable_time_step: f64,
    /// The block that sets it: the stiffest for its mass.
    pub limiting_block: Option<Block>,
    /// Its neighbour at its stiffest contact or bond; none while it has none: then contacts that it may get
    /// limit the step.
    pub limiting_neighbor: Option<Block>,
    /// Done on a copy to measure the times below.
    pub measured_steps: u64,
    /// Time of a step, in s: building neighbour lists.
    pub search_seconds: f64,
    /// Time of a step: detecting pairs and loading contacts.
    pub pair_seconds: f64,
    /// Time of a step: adding up the forces on blocks.
    pub gather_seconds: f64,
    /// Time of a step: moving, turning and straining blocks.
    pub motion_seconds: f64,
    /// Time of a step: the energy ledger.
    pub ledger_seconds: f64,
    /// Bodies of finite elements.
    pub body_count: usize,
    /// Cells of all of them.
    pub cell_count: usize,
    /// Nodes of all of them.
    pub node_count: usize,
    /// Bonds made, those that have come apart among them.
    pub bond_count: usize,
    /// Part of the bytes of blocks: bodies with their nodes and cells.
    pub mesh_bytes: usize,
    /// Likewise: bonds with their points and events.
    pub bond_bytes: usize,
    /// Index of the bond to the limiting neighbour; none where it is a contact.
    pub limiting_bond: Option<usize>,
    /// Body that the limiting block is of, where its elements have the greater part in the limit, and its cell
    /// that is the stiffest for its mass.
    pub limiting_cell: Option<(Body, usize)>,
    /// Time of a step: loading blocks by bonds.
    pub bond_seconds: f64,
    /// Time of a step: finding the impulses of contacts without springs.
    pub hard_contact_seconds: f64,
}

impl From<sys::hs_world_plan> for Plan {
    fn from(raw: sys::hs_world_plan) -> Self {
        let has = |part: i32| raw.parts & part != 0;
        Self {
            friction: has(sys::HS_PART_FRICTION),
            bonds: has(sys::HS_PART_BONDS),
            contact_damping: has(sys::HS_PART_CONTACT_DAMPING),
            area: has(sys::HS_PART_AREA),
            potential: has(sys::HS_PART_POTENTIAL),
            strain: has(sys::HS_PART_STRAIN),
            local_damping: has(sys::HS_PART_LOCAL_DAMPING),
            mass_damping: has(sys::HS_PART_MASS_DAMPING),
            hard_contacts: has(sys::HS_PART_HARD_CONTACTS),
            sleep: has(sys::HS_PART_SLEEP),
            fixed_count: raw.fixed_count as usize,
            prescribed_count: raw.prescribed_count as usize,
            rigid_count: raw.rigid_count as usize,
            affine_count: raw.affine_count as usize,
            candidate_count: raw.candidate_count as usize,
            contact_count: raw.contact_count as usize,
            block_bytes: raw.block_bytes as usize,
            pair_bytes: raw.pair_bytes as usize,
            stable_time_step: raw.stable_time_step,
            limiting_block: Block::from_id(raw.limiting_block),
            limiting_neighbor: Block::from_id(raw.limiting_neighbor),
            measured_steps: raw.measured_steps as u64,
            search_seconds: raw.search_seconds,
            pair_seconds: raw.pair_seconds,
            gather_seconds: raw.gather_seconds,
            motion_seconds: raw.motion_seconds,
            ledger_seconds: raw.ledger_seconds,
            body_count: raw.body_count as usize,
            cell_count: raw.cell_count as usize,
            node_count: raw.node_count as usize,
            bond_count: raw.bond_count as usize,
            mesh_bytes: raw.mesh_bytes as usize,
            bond_bytes: raw.bond_bytes as usize,
            limiting_bond: usize::try_from(raw.limiting_bond).ok(),
            limiting_cell: Body::from_id(raw.limiting_body)
                .map(|body| (body, raw.limiting_cell as usize)),
            bond_seconds: raw.bond_seconds,
            hard_contact_seconds: raw.hard_contact_seconds,
        }
    }
}
