//! Contacts by a law without a spring: the points that are kept apart, and by which force (Li et al.
//! 2015, sections 3 and 4).

use std::mem::size_of;

use halfspace_sys as sys;

use crate::block::Block;
use crate::contact::PairKind;
use crate::world::World;

/// Two points that are in touch by a law without a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reaction {
    /// The block whose corner it is, and the one whose face; or those of two edges.
    pub blocks: Option<(Block, Block)>,
    /// A corner at a face, or two edges.
    pub pair_kind: PairKind,
    /// Index of the first block's vertex or edge.
    pub feature_a: usize,
    /// Index of the second block's face, in the plane its edge.
    pub feature_b: usize,
    /// The place where they touch, in m.
    pub point: [f64; 3],
    /// Unit, outwards from the second block.
    pub normal: [f64; 3],
    /// On the first block at the end of the last step, in N. In the step of the touch it is that of
    /// the blow.
    pub force: [f64; 3],
    /// Above 0 apart: the rest that rounding and turning have left.
    pub gap: f64,
    /// Time of the touch, inside of a step.
    pub touched_at: f64,
}

impl From<sys::hs_reaction> for Reaction {
    fn from(raw: sys::hs_reaction) -> Self {
        Self {
            blocks: Block::from_raw(raw.block_a).zip(Block::from_raw(raw.block_b)),
            pair_kind: PairKind::from_raw(raw.pair_kind),
            feature_a: raw.feature_a as usize,
            feature_b: raw.feature_b as usize,
            point: raw.point,
            normal: raw.normal,
            force: raw.force,
            gap: raw.gap,
            touched_at: raw.touched_at,
        }
    }
}

/// Contacts without springs in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ReactionReport {
    /// Contacts now.
    pub reaction_count: usize,
    /// Touches so far; a corner that slides from face to face touches anew.
    pub touch_count: usize,
    /// Rounds through all contacts of a kick so far, until none changed any more.
    pub round_count: usize,
    /// Energy lost so far where points met, in J; counts in the residual.
    pub impact_loss: f64,
}

impl From<sys::hs_reaction_report> for ReactionReport {
    fn from(raw: sys::hs_reaction_report) -> Self {
        Self {
            reaction_count: raw.reaction_count as usize,
            touch_count: raw.touch_count as usize,
            round_count: raw.round_count as usize,
            impact_loss: raw.impact_loss,
        }
    }
}

/// Contacts without springs.
impl World {
    /// Those at the end of the last step, sorted by their blocks.
    pub fn reactions(&self) -> Vec<Reaction> {
        let mut all = vec![sys::hs_reaction::default(); self.reaction_report().reaction_count];
        let (room, capacity) = (all.as_mut_ptr(), all.len() as i64);
        let mut count = 0;
        // SAFETY: the world lives, and the array is as long as said.
        self.owner().expect(unsafe {
            sys::hs_world_get_reactions(self.handle(), room, capacity, &mut count)
        });
        all.into_iter().map(Into::into).collect()
    }

    /// Their numbers, as of the last step.
    pub fn reaction_report(&self) -> ReactionReport {
        let mut raw = sys::hs_reaction_report::default();
        let size = size_of::<sys::hs_reaction_report>();
        // SAFETY: the world lives, and the size is that of the struct.
        self.owner()
            .expect(unsafe { sys::hs_world_get_reaction_report(self.handle(), &mut raw, size) });
        raw.into()
    }
}
