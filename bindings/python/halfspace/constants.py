"""The library's constants as enumerations."""
from enum import IntEnum, IntFlag
from typing import Type, Union

from . import _raw
from ._arrays import index


def choice(value: Union[int, str], choices: Type[IntEnum], name: str) -> int:
    """One of the constants: itself, its number, or its name in any case and with spaces, as "per area". A number that
    is none of them is left for the library to refuse."""
    words = {member.name.lower().replace("_", " "): member for member in choices}
    if isinstance(value, str):
        found = words.get(value.lower().replace("_", " ").replace("-", " "))
    else:
        try:
            number = index(value, name)
        except TypeError:
            found = None
        else:
            found = next((member for member in choices if member == number), None)
            if found is None:
                return number
    if found is None:
        allowed = ", ".join(f'"{word}"' for word in words)
        raise ValueError(f"{name} is {value!r}; it must be one of {allowed}, or a {choices.__name__}")
    return found


class ContactType(IntEnum):
    """How two blocks touch (`contact["type"]`)."""

    NONE = _raw.HS_CONTACT_NONE
    VERTEX_VERTEX = _raw.HS_CONTACT_VERTEX_VERTEX
    VERTEX_EDGE = _raw.HS_CONTACT_VERTEX_EDGE
    EDGE_EDGE = _raw.HS_CONTACT_EDGE_EDGE
    EDGE_FACE = _raw.HS_CONTACT_EDGE_FACE
    FACE_FACE = _raw.HS_CONTACT_FACE_FACE
    VERTEX_FACE = _raw.HS_CONTACT_VERTEX_FACE


class PairKind(IntEnum):
    """Which features make the pair behind a contact or its absence (`contact["pair_kind"]`)."""

    FACE_VERTEX = _raw.HS_PAIR_FACE_VERTEX
    VERTEX_FACE = _raw.HS_PAIR_VERTEX_FACE
    EDGE_EDGE = _raw.HS_PAIR_EDGE_EDGE
    VERTEX_VERTEX = _raw.HS_PAIR_VERTEX_VERTEX


class ImpactState(IntEnum):
    """What comes of two motions (`impact["state"]`)."""

    NEVER = _raw.HS_IMPACT_NEVER
    AT_START = _raw.HS_IMPACT_AT_START
    TOUCH = _raw.HS_IMPACT_TOUCH


class BlockKind(IntEnum):
    """How a block moves."""

    FIXED = _raw.HS_BLOCK_FIXED
    PRESCRIBED = _raw.HS_BLOCK_PRESCRIBED
    RIGID = _raw.HS_BLOCK_RIGID
    AFFINE = _raw.HS_BLOCK_AFFINE
    MESH = _raw.HS_BLOCK_MESH


class CellKind(IntEnum):
    """The kinds of cells of a mesh."""

    TRIANGLE = _raw.HS_CELL_TRIANGLE
    QUAD = _raw.HS_CELL_QUAD
    TETRAHEDRON = _raw.HS_CELL_TETRAHEDRON
    PRISM = _raw.HS_CELL_PRISM
    HEXAHEDRON = _raw.HS_CELL_HEXAHEDRON


class BondFailure(IntEnum):
    """The ways in which a point of a bond has failed (`event["failure"]`)."""

    HOLDS = _raw.HS_BOND_HOLDS
    TENSION = _raw.HS_BOND_TENSION
    SHEAR = _raw.HS_BOND_SHEAR


class Unbalanced(IntEnum):
    """The ratio of forces that is compared: all unbalanced ones over all, or the largest of a block or node."""

    MEAN = _raw.HS_UNBALANCED_MEAN
    LARGEST = _raw.HS_UNBALANCED_LARGEST


class StiffnessKind(IntEnum):
    """What a law's stiffnesses refer to: the whole contact (N/m), its area (Pa/m), or a potential within the
    blocks (Pa), of which the force is the gradient. NONE stands for a law without a spring."""

    PER_CONTACT = _raw.HS_STIFFNESS_PER_CONTACT
    PER_AREA = _raw.HS_STIFFNESS_PER_AREA
    POTENTIAL = _raw.HS_STIFFNESS_POTENTIAL
    NONE = _raw.HS_STIFFNESS_NONE


class FastBlocks(IntEnum):
    """What becomes of a step in which blocks meet that move far against the thinner of them: more than a quarter of
    its thickness."""

    DIVIDE = _raw.HS_FAST_DIVIDE
    REFUSE = _raw.HS_FAST_REFUSE


class Plane(IntEnum):
    """What 2D is a section of: a body that cannot strain across it, or a sheet without stress across it."""

    STRAIN = _raw.HS_PLANE_STRAIN
    STRESS = _raw.HS_PLANE_STRESS


class Fault(IntEnum):
    """What can be wrong with what a shape is to be made from (`fault["kind"]`)."""

    NONE = _raw.HS_FAULT_NONE
    TOO_FEW_VERTICES = _raw.HS_FAULT_TOO_FEW_VERTICES
    NOT_FINITE = _raw.HS_FAULT_NOT_FINITE
    REPEATED_VERTEX = _raw.HS_FAULT_REPEATED_VERTEX
    COLLINEAR_VERTEX = _raw.HS_FAULT_COLLINEAR_VERTEX
    NOT_CONVEX = _raw.HS_FAULT_NOT_CONVEX
    SELF_CROSSING = _raw.HS_FAULT_SELF_CROSSING
    ZERO_AREA = _raw.HS_FAULT_ZERO_AREA
    FEWER_THAN_FOUR = _raw.HS_FAULT_FEWER_THAN_FOUR
    FACE_TOO_SHORT = _raw.HS_FAULT_FACE_TOO_SHORT
    NO_SUCH_VERTEX = _raw.HS_FAULT_NO_SUCH_VERTEX
    VERTEX_TWICE_IN_FACE = _raw.HS_FAULT_VERTEX_TWICE_IN_FACE
    UNUSED_VERTEX = _raw.HS_FAULT_UNUSED_VERTEX
    UNMATCHED_EDGE = _raw.HS_FAULT_UNMATCHED_EDGE
    VERTEX_INSIDE_EDGE = _raw.HS_FAULT_VERTEX_INSIDE_EDGE
    NOT_ONE_SURFACE = _raw.HS_FAULT_NOT_ONE_SURFACE
    OUT_OF_RANGE = _raw.HS_FAULT_OUT_OF_RANGE
    COINCIDING_VERTICES = _raw.HS_FAULT_COINCIDING_VERTICES
    ZERO_VOLUME = _raw.HS_FAULT_ZERO_VOLUME
    FACE_WITHOUT_AREA = _raw.HS_FAULT_FACE_WITHOUT_AREA
    FACE_NOT_PLANE = _raw.HS_FAULT_FACE_NOT_PLANE
    VERTEX_OUTSIDE_FACE = _raw.HS_FAULT_VERTEX_OUTSIDE_FACE
    COPLANAR_FACES = _raw.HS_FAULT_COPLANAR_FACES
    HULL_FAILED = _raw.HS_FAULT_HULL_FAILED
    NO_DIRECTION = _raw.HS_FAULT_NO_DIRECTION
    UNBOUNDED = _raw.HS_FAULT_UNBOUNDED
    NO_COMMON_POINT = _raw.HS_FAULT_NO_COMMON_POINT
    BEYOND_TOLERANCE = _raw.HS_FAULT_BEYOND_TOLERANCE


class WorldPart(IntFlag):
    """The parts of a step besides detection and normal forces of rigid blocks (`plan.parts`)."""

    FRICTION = _raw.HS_PART_FRICTION
    BONDS = _raw.HS_PART_BONDS
    CONTACT_DAMPING = _raw.HS_PART_CONTACT_DAMPING
    AREA = _raw.HS_PART_AREA
    POTENTIAL = _raw.HS_PART_POTENTIAL
    STRAIN = _raw.HS_PART_STRAIN
    LOCAL_DAMPING = _raw.HS_PART_LOCAL_DAMPING
    MASS_DAMPING = _raw.HS_PART_MASS_DAMPING
    HARD_CONTACTS = _raw.HS_PART_HARD_CONTACTS
