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
from inspect import ismodule as _is_module

from ._arrays import pose as pose
from ._attributes import guard_attributes as _guard_attributes
from ._help import wrap_signatures as _wrap_signatures
from ._library import status_text as status_text, version as version
from .constants import *
from .context import Context as Context, default_context as default_context
from .definition import Action as Action, Material as Material
from .errors import (
    ArgumentError as ArgumentError,
    ClosedError as ClosedError,
    FormatError as FormatError,
    GeometryError as GeometryError,
    HalfspaceError as HalfspaceError,
    InternalError as InternalError,
    InterruptedCallError as InterruptedCallError,
    InvertedError as InvertedError,
    OutOfMemoryError as OutOfMemoryError,
    SceneError as SceneError,
    StaleIdError as StaleIdError,
    StateError as StateError,
    TooFastError as TooFastError,
    UnstableError as UnstableError,
)
from .generators import (
    arch as arch,
    jointed_rock as jointed_rock,
    stack as stack,
    triangulated as triangulated,
    voronoi as voronoi,
    wall as wall,
)
from .impact import Motion as Motion, pair_time_of_impact as pair_time_of_impact
from .mesh import Mesh as Mesh
from .pair import (
    PairCache as PairCache,
    pair_caches as pair_caches,
    pair_detect as pair_detect,
    pairs_detect as pairs_detect,
)
from .progress import ProgressBar as ProgressBar
from .properties import *
from .query import (
    boxes_find_pairs as boxes_find_pairs,
    pair_distance as pair_distance,
    points_order_along_curve as points_order_along_curve,
)
from .records import (
    BALANCE as BALANCE,
    BLOCK_STATE as BLOCK_STATE,
    BODY_STATE as BODY_STATE,
    BOLT as BOLT,
    BOND as BOND,
    BOND_EVENT as BOND_EVENT,
    BOND_REPORT as BOND_REPORT,
    CELL_STATE as CELL_STATE,
    CLOSEST_POINTS as CLOSEST_POINTS,
    CONTACT as CONTACT,
    DEFORMATION as DEFORMATION,
    IMPACT as IMPACT,
    NOTE as NOTE,
    PAIR_CACHE as PAIR_CACHE,
    RAY_HIT as RAY_HIT,
    SHAPE_PROPERTIES as SHAPE_PROPERTIES,
    SHARE_INFO as SHARE_INFO,
    SHARE_PLAN as SHARE_PLAN,
    STRENGTH_REPORT as STRENGTH_REPORT,
    WORLD_REPORT as WORLD_REPORT,
)
from .page import View as View, view as view
from .recording import Recording as Recording
from .results import LimitResult as LimitResult, RunResult as RunResult, SafetyResult as SafetyResult
from .scene import Scene as Scene
from .shape import (
    Shape as Shape,
    check_polygon as check_polygon,
    check_polyhedron as check_polyhedron,
    clean_polygon as clean_polygon,
)
from .share import Packed as Packed
from .sweep import Sweep as Sweep
from .world import World as World

__version__ = version()
__all__ = sorted(name for name, each in globals().items() if not (name.startswith("_") or _is_module(each)))

_wrap_signatures(globals()[name] for name in __all__)
_guard_attributes(globals()[name] for name in __all__)
