"""Python interface of libhalfspace: contact detection of convex blocks by half-space inclusion, contact forces, time
integration.

Conventions: SI or any consistent units; angles in radians; right-handed axes; quaternions x, y, z, w; a
normal points from a to b; a gap below 0 is an overlap; indices start at 0; in 2D the thickness is 1.

Examples
--------
>>> import halfspace as hs
>>> square = hs.Shape.rectangle(1, 1)
>>> print(hs.pair_detect(square, (0, 0), square, (0.25, 0.875)).gap)
-0.125
"""
from ._arrays import pose
from ._attributes import guard_attributes
from ._help import wrap_signatures
from ._library import status_text, version
from .constants import (
    ActionKind,
    BlockKind,
    BondFailure,
    CellKind,
    ContactType,
    FastBlocks,
    Fault,
    ForcePlace,
    ImpactState,
    PairKind,
    Plane,
    Role,
    Setting,
    StiffnessKind,
    Unbalanced,
    WorldPart,
)
from .context import Context, default_context
from .definition import Action, Material
from .errors import (
    ArgumentError,
    ClosedError,
    FormatError,
    GeometryError,
    HalfspaceError,
    InternalError,
    InterruptedCallError,
    InvertedError,
    OutOfMemoryError,
    SceneError,
    StaleIdError,
    StateError,
    TooFastError,
    UnstableError,
)
from .generators import arch, jointed_rock, stack, triangulated, voronoi, wall
from .impact import Motion, pair_time_of_impact
from .mesh import Mesh
from .pair import PairCache, pair_caches, pair_detect, pairs_detect
from .progress import ProgressBar
from .properties import Bolt, Bond, Elasticity, Law
from .query import boxes_find_pairs, pair_distance, points_order_along_curve
from .records import (
    BALANCE,
    BLOCK_STATE,
    BODY_STATE,
    BOLT,
    BOND,
    BOND_EVENT,
    BOND_REPORT,
    CELL_STATE,
    CLOSEST_POINTS,
    CONTACT,
    DEFORMATION,
    IMPACT,
    NOTE,
    PAIR_CACHE,
    RAY_HIT,
    SHAPE_PROPERTIES,
    SHARE_INFO,
    SHARE_PLAN,
    STRENGTH_REPORT,
    WORLD_REPORT,
)
from .page import View, view
from .recording import Recording
from .results import LimitResult, RunResult, SafetyResult
from .scene import Scene
from .shape import Shape, check_polygon, check_polyhedron, clean_polygon
from .share import Packed
from .sweep import Sweep
from .world import World

__version__ = version()

__all__ = [
    "BALANCE",
    "BLOCK_STATE",
    "BODY_STATE",
    "BOLT",
    "BOND",
    "BOND_EVENT",
    "BOND_REPORT",
    "CELL_STATE",
    "CLOSEST_POINTS",
    "CONTACT",
    "DEFORMATION",
    "IMPACT",
    "NOTE",
    "PAIR_CACHE",
    "RAY_HIT",
    "SHAPE_PROPERTIES",
    "SHARE_INFO",
    "SHARE_PLAN",
    "STRENGTH_REPORT",
    "WORLD_REPORT",
    "Action",
    "ActionKind",
    "ArgumentError",
    "BlockKind",
    "Bolt",
    "Bond",
    "BondFailure",
    "CellKind",
    "ClosedError",
    "ContactType",
    "Context",
    "Elasticity",
    "FastBlocks",
    "Fault",
    "ForcePlace",
    "FormatError",
    "GeometryError",
    "HalfspaceError",
    "ImpactState",
    "InternalError",
    "InterruptedCallError",
    "InvertedError",
    "Law",
    "LimitResult",
    "Material",
    "Mesh",
    "Motion",
    "OutOfMemoryError",
    "Packed",
    "PairCache",
    "PairKind",
    "Plane",
    "ProgressBar",
    "Recording",
    "Role",
    "RunResult",
    "SafetyResult",
    "Scene",
    "SceneError",
    "Setting",
    "Shape",
    "StaleIdError",
    "StateError",
    "StiffnessKind",
    "Sweep",
    "TooFastError",
    "Unbalanced",
    "UnstableError",
    "View",
    "World",
    "WorldPart",
    "arch",
    "boxes_find_pairs",
    "points_order_along_curve",
    "check_polygon",
    "check_polyhedron",
    "clean_polygon",
    "default_context",
    "jointed_rock",
    "pair_caches",
    "pair_detect",
    "pair_distance",
    "pair_time_of_impact",
    "pairs_detect",
    "pose",
    "stack",
    "status_text",
    "triangulated",
    "version",
    "view",
    "voronoi",
    "wall",
]

wrap_signatures(globals()[name] for name in __all__)
guard_attributes(globals()[name] for name in __all__)
