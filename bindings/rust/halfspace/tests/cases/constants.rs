//! The constants that cases name, as the safe layer shows them, with their values in the C headers.

use halfspace::{BlockKind, ContactType, ErrorKind, ImpactState, PairKind};
use halfspace_sys as sys;

macro_rules! values {
    ($word:expr, $($name:ident,)*) => {
        match $word {
            $(stringify!($name) => Some(f64::from(sys::$name)),)*
            _ => None,
        }
    };
}

/// A decimal number or a constant.
pub fn parse(word: &str) -> Option<f64> {
    let constant = values!(
        word,
        HS_CONTACT_NONE,
        HS_CONTACT_VERTEX_VERTEX,
        HS_CONTACT_VERTEX_EDGE,
        HS_CONTACT_EDGE_EDGE,
        HS_CONTACT_EDGE_FACE,
        HS_CONTACT_FACE_FACE,
        HS_CONTACT_VERTEX_FACE,
        HS_PAIR_FACE_VERTEX,
        HS_PAIR_VERTEX_FACE,
        HS_PAIR_EDGE_EDGE,
        HS_PAIR_VERTEX_VERTEX,
        HS_IMPACT_NEVER,
        HS_IMPACT_AT_START,
        HS_IMPACT_TOUCH,
        HS_STIFFNESS_PER_CONTACT,
        HS_STIFFNESS_PER_AREA,
        HS_STIFFNESS_POTENTIAL,
        HS_PLANE_STRAIN,
        HS_PLANE_STRESS,
        HS_BLOCK_FIXED,
        HS_BLOCK_PRESCRIBED,
        HS_BLOCK_RIGID,
        HS_BLOCK_AFFINE,
        HS_BLOCK_MESH,
        HS_FAST_DIVIDE,
        HS_FAST_REFUSE,
    );
    constant.or_else(|| word.parse().ok())
}

pub fn contact_type(kind: ContactType) -> i32 {
    match kind {
        ContactType::None => sys::HS_CONTACT_NONE,
        ContactType::VertexVertex => sys::HS_CONTACT_VERTEX_VERTEX,
        ContactType::VertexEdge => sys::HS_CONTACT_VERTEX_EDGE,
        ContactType::EdgeEdge => sys::HS_CONTACT_EDGE_EDGE,
        ContactType::EdgeFace => sys::HS_CONTACT_EDGE_FACE,
        ContactType::FaceFace => sys::HS_CONTACT_FACE_FACE,
        ContactType::VertexFace => sys::HS_CONTACT_VERTEX_FACE,
        other => panic!("{other:?} is not known to the cases"),
    }
}

pub fn pair_kind(kind: PairKind) -> i32 {
    match kind {
        PairKind::FaceVertex => sys::HS_PAIR_FACE_VERTEX,
        PairKind::VertexFace => sys::HS_PAIR_VERTEX_FACE,
        PairKind::EdgeEdge => sys::HS_PAIR_EDGE_EDGE,
        PairKind::VertexVertex => sys::HS_PAIR_VERTEX_VERTEX,
        other => panic!("{other:?} is not known to the cases"),
    }
}

pub fn impact_state(state: ImpactState) -> i32 {
    match state {
        ImpactState::Never => sys::HS_IMPACT_NEVER,
        ImpactState::AtStart => sys::HS_IMPACT_AT_START,
        ImpactState::Touch => sys::HS_IMPACT_TOUCH,
        other => panic!("{other:?} is not known to the cases"),
    }
}

pub fn block_kind(word: &str) -> BlockKind {
    match word {
        "HS_BLOCK_FIXED" => BlockKind::Fixed,
        "HS_BLOCK_PRESCRIBED" => BlockKind::Prescribed,
        "HS_BLOCK_RIGID" => BlockKind::Rigid,
        "HS_BLOCK_AFFINE" => BlockKind::Affine,
        other => panic!("{other} is no kind of block"),
    }
}

pub fn error_kind(word: &str) -> ErrorKind {
    match word {
        "HS_ERROR_ARGUMENT" => ErrorKind::Argument,
        "HS_ERROR_GEOMETRY" => ErrorKind::Geometry,
        "HS_ERROR_STALE_ID" => ErrorKind::StaleId,
        "HS_ERROR_STATE" => ErrorKind::State,
        "HS_ERROR_UNSTABLE" => ErrorKind::Unstable,
        "HS_ERROR_TOO_FAST" => ErrorKind::TooFast,
        "HS_ERROR_INVERTED" => ErrorKind::Inverted,
        "HS_ERROR_FORMAT" => ErrorKind::Format,
        other => panic!("{other} is no error that cases know"),
    }
}
