//! Contact of one pair of blocks: type, region and force.

use std::fmt;

use halfspace_sys as sys;

use crate::block::Block;
use crate::kinds::ContactType;

/// One contact, or the proof of separation. Points and directions are in the frame of the poses.
#[derive(Clone, Copy, Default)]
#[repr(transparent)]
pub struct Contact {
    pub(crate) raw: sys::hs_contact,
}

impl Contact {
    /// Type of the contact; [`ContactType::None`] if the blocks are separated.
    pub fn kind(&self) -> ContactType {
        ContactType::from_value(self.raw.r#type)
    }

    /// Are the blocks in contact?
    pub fn is_touching(&self) -> bool {
        self.raw.r#type != sys::HS_CONTACT_NONE
    }

    /// Blocks a and b, of a contact in a world.
    pub fn blocks(&self) -> Option<(Block, Block)> {
        Block::from_id(self.raw.block_a).zip(Block::from_id(self.raw.block_b))
    }

    /// Indices of block a's and b's vertex, edge or face in that pair; `None` for the vertex if a
    /// face separates the blocks, as no vertex is behind it.
    pub fn features(&self) -> (Option<usize>, Option<usize>) {
        (
            usize::try_from(self.raw.feature_a).ok(),
            usize::try_from(self.raw.feature_b).ok(),
        )
    }

    /// Corners of the region, on the contact plane; in 3D counter-clockwise about the normal. Empty
    /// if separated.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.raw.points[..self.point_count()]
    }

    /// Gap at each point.
    pub fn gaps(&self) -> &[f64] {
        &self.raw.gaps[..self.point_count()]
    }

    /// A field that detection does not write if the blocks are separated; the default then.
    pub(crate) fn of_region<T: Default>(&self, value: T) -> T {
        if self.is_touching() {
            value
        } else {
            T::default()
        }
    }

    fn point_count(&self) -> usize {
        usize::try_from(self.raw.point_count)
            .unwrap_or(0)
            .min(self.raw.points.len())
    }
}

impl fmt::Debug for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contact")
            .field("kind", &self.kind())
            .field("blocks", &self.blocks())
            .field("pair_kind", &self.pair_kind())
            .field("features", &self.features())
            .field("normal", &self.normal())
            .field("gap", &self.gap())
            .field("points", &self.points())
            .field("force", &self.force())
            .finish_non_exhaustive()
    }
}
