//! What detection and force say of one pair of blocks.

use std::fmt;

use halfspace_sys as sys;

use crate::block::Block;
use crate::constants::constants;

constants! {
    /// How two blocks meet (Wang et al. 2021, section 2.5).
    ContactType {
        /// Separated: one violated potential pair, or a plane between, proves it.
        None = HS_CONTACT_NONE,
        /// A vertex meets a vertex; in the plane an end of the edge.
        VertexVertex = HS_CONTACT_VERTEX_VERTEX,
        /// A vertex meets an edge between its ends.
        VertexEdge = HS_CONTACT_VERTEX_EDGE,
        /// Plane: edges parallel within the parallel angle. Space: edges that cross.
        EdgeEdge = HS_CONTACT_EDGE_EDGE,
        /// Space: an edge and a face parallel within the parallel angle.
        EdgeFace = HS_CONTACT_EDGE_FACE,
        /// Space: two faces parallel within the parallel angle.
        FaceFace = HS_CONTACT_FACE_FACE,
        /// Space: a vertex meets a face between its edges.
        VertexFace = HS_CONTACT_VERTEX_FACE,
    }
}

constants! {
    /// Which features of blocks a and b make a potential contact pair. In the plane an edge is what
    /// a face is in space.
    PairKind {
        /// A face of a, a vertex of b.
        FaceVertex = HS_PAIR_FACE_VERTEX,
        /// A vertex of a, a face of b.
        VertexFace = HS_PAIR_VERTEX_FACE,
        /// Space: an edge of each.
        EdgeEdge = HS_PAIR_EDGE_EDGE,
        /// Space, separated only: the vertices nearest to a plane between the blocks.
        VertexVertex = HS_PAIR_VERTEX_VERTEX,
    }
}

/// One contact, or the proof that there is none. Points are in the frame of the poses, directions
/// in its orientation.
#[derive(Clone, Copy, Default)]
#[repr(transparent)]
pub struct Contact {
    raw: sys::hs_contact,
}

impl Contact {
    /// How the blocks meet; [`ContactType::None`] when they are separated.
    pub fn kind(&self) -> ContactType {
        ContactType::from_raw(self.raw.r#type)
    }

    /// Are the blocks in contact, not separated?
    pub fn is_touching(&self) -> bool {
        self.raw.r#type != sys::HS_CONTACT_NONE
    }

    /// The blocks a and b, of a contact in a world.
    pub fn blocks(&self) -> Option<(Block, Block)> {
        Block::from_raw(self.raw.block_a).zip(Block::from_raw(self.raw.block_b))
    }

    /// Of the pair whose half-space is the contact plane; when separated, of the violated pair.
    pub fn pair_kind(&self) -> PairKind {
        PairKind::from_raw(self.raw.pair_kind)
    }

    /// Indices of block a's and b's vertex, edge or face in that pair. `None` stands for the vertex
    /// when a face separates the blocks: no vertex is behind the face, which is all of the proof.
    pub fn features(&self) -> (Option<usize>, Option<usize>) {
        (
            usize::try_from(self.raw.feature_a).ok(),
            usize::try_from(self.raw.feature_b).ok(),
        )
    }

    /// Unit, from a to b.
    pub fn normal(&self) -> [f64; 3] {
        self.raw.normal
    }

    /// Of the pair along the normal, or at the deepest point of the region; below 0 is an overlap.
    /// When separated it is the separation that proves it: a lower bound of the distance.
    pub fn gap(&self) -> f64 {
        self.raw.gap
    }

    /// Plane: overlap length of an edge-edge region times unit thickness. Space: of a face-face
    /// region. Else 0.
    pub fn area(&self) -> f64 {
        self.of_region(self.raw.area)
    }

    /// Overlap length: of an edge-edge region in the plane, of an edge-face region in space. Else
    /// 0.
    pub fn length(&self) -> f64 {
        self.of_region(self.raw.length)
    }

    /// Centroid of the region, on the contact plane; 0 when separated.
    pub fn center(&self) -> [f64; 3] {
        self.of_region(self.raw.center)
    }

    /// The gap there; 0 when separated.
    pub fn center_gap(&self) -> f64 {
        self.of_region(self.raw.center_gap)
    }

    /// Points of the region, on the contact plane; in space its corners, counter-clockwise about
    /// the normal. Empty when separated.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.raw.points[..self.point_count()]
    }

    /// The gap at each of the points.
    pub fn gaps(&self) -> &[f64] {
        &self.raw.gaps[..self.point_count()]
    }

    /// The force on block b, normal and shear together, of a contact in a world.
    pub fn force(&self) -> [f64; 3] {
        self.raw.force
    }

    /// Where the force acts.
    pub fn force_point(&self) -> [f64; 3] {
        self.raw.force_point
    }

    /// The couple on block b besides the force, about the force point.
    pub fn torque(&self) -> [f64; 3] {
        self.raw.torque
    }

    /// Compression is above 0.
    pub fn normal_force(&self) -> f64 {
        self.raw.normal_force
    }

    /// On block b, in the contact plane.
    pub fn shear_force(&self) -> [f64; 3] {
        self.raw.shear_force
    }

    /// Space: the torque about the normal, on block b.
    pub fn twist(&self) -> f64 {
        self.raw.twist
    }

    /// Time of the touch, inside of a step, by a law without springs; else 0.
    pub fn touched_at(&self) -> f64 {
        self.raw.touched_at
    }

    /// What detection leaves as it was when the blocks are separated.
    fn of_region<T: Default>(&self, value: T) -> T {
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

    pub(crate) fn raw_mut(&mut self) -> *mut sys::hs_contact {
        &mut self.raw
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
