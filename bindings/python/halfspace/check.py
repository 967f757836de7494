"""Unusual settings of a world that are allowed."""
from __future__ import annotations

import copy
import ctypes
import dataclasses
from typing import TYPE_CHECKING, Dict, Iterator, List, Set

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import library
from .constants import Setting, StiffnessKind
from .records import Note, WorldReport

if TYPE_CHECKING:
    from .properties import Bond
    from .world import World

_BOND_SETTINGS = {
    "normal_stiffness": Setting.BOND_NORMAL_STIFFNESS,
    "shear_stiffness": Setting.BOND_SHEAR_STIFFNESS,
    "tensile_strength": Setting.TENSILE_STRENGTH,
    "cohesion": Setting.COHESION,
    "friction_angle": Setting.FRICTION_ANGLE,
    "residual_cohesion": Setting.COHESION,
    "residual_friction_angle": Setting.FRICTION_ANGLE,
    "tensile_fracture_energy": Setting.TENSILE_FRACTURE_ENERGY,
    "shear_fracture_energy": Setting.SHEAR_FRACTURE_ENERGY,
}
_WORLD_SETTINGS = (Setting.GRAVITY, Setting.MASS_DAMPING, Setting.PARALLEL_ANGLE)
_TOLD_FRACTION = 0.01  # fraction of the thickness of the thinnest block
_SIZE_RATIO = 1e5
_USUAL_RESIDUAL = 0.01  # fraction of the released energy
_ROUNDING = 1e-9  # fraction of the ledger's entries, over many steps
_OF_IMPULSES = ("impulse_tolerance", "max_impulse_iterations", "locate_impacts")
_MOST_BLOCKS = 5000  # limit of a comparison of all pairs


class Given:
    """What a world was given that the library does not return."""

    def __init__(self) -> None:
        self.held: Dict[int, str] = {}  # axes along which nodes of a body are held
        self.bonds: Dict[str, Bond] = {}  # by the calls that made them
        self.empty_bonds: List[str] = []
        self.beyond_scenes: Set[str] = set()  # parts that no table of a scene describes, in words
        self.is_of_snapshot = True  # which may have had any of these

    def copy(self) -> "Given":
        return copy.deepcopy(self)


def notes_on_values(world: "World") -> Iterator[str]:
    """Notes on values outside their usual range, e.g. in a wrong unit."""
    for note in world.unusual_settings():
        yield _unusual(_name_of(note), note.value, note.setting)
    for call, bond in world._given.bonds.items():
        for name, setting in _BOND_SETTINGS.items():
            low, high = ctypes.c_double(), ctypes.c_double()
            library.hs_setting_get_usual(setting, ctypes.byref(low), ctypes.byref(high))
            value = abs(getattr(bond, name))
            if value > 0 and not low.value <= value <= high.value:
                yield _unusual(f"{call}.{name}", value, setting)


def _unusual(name: str, value: float, setting: int) -> str:
    return f"{name}: {value:g} is unusual; usual: {library.hs_setting_usual_text(setting).decode()}"


def _name_of(note: Note) -> str:
    setting = note.setting.name.lower()
    if note.block:
        return f"block {note.block}.{setting}"
    if note.material_b >= 0:
        return f"law[{note.material_a}, {note.material_b}].{setting}"
    if note.material_a >= 0:
        return f"material[{note.material_a}].{setting}"
    return setting if note.setting in _WORLD_SETTINGS else f"default_law.{setting}"


def _shown(value: ArrayLike) -> str:
    array = np.asarray(value, float)
    return f"{float(array):g}" if array.ndim == 0 else "[" + ", ".join(f"{x:g}" for x in array) + "]"


@dataclasses.dataclass
class Boxes:
    """Axis-aligned bounding boxes of all blocks."""

    ids: NDArray[np.uint64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    moves: NDArray[np.bool_]
    holds: NDArray[np.bool_]
    deforms: NDArray[np.bool_]

    @property
    def sizes(self) -> NDArray[np.float64]:
        """The shortest side of each box."""
        result: NDArray[np.float64] = (self.high - self.low).min(axis=1)
        return result


def notes_on_gravity(gravity: NDArray[np.float64], dimension: int) -> Iterator[str]:
    up = "xyz"[dimension - 1]
    if gravity[: dimension].any() and gravity[dimension - 1] >= 0:
        where = "points upwards" if gravity[dimension - 1] > 0 else f"has no part along {up}"
        yield f"gravity: {_shown(gravity[: dimension])} {where}; usual: along -{up}, as {up} is up"


def notes_on_support(boxes: Boxes, gravity: NDArray[np.float64], velocities: NDArray[np.float64]) -> Iterator[str]:
    """Notes on blocks without support, as far as their boxes show it."""
    if not boxes.moves.any() or not gravity.any():
        return
    if not boxes.holds.any():
        yield (
            "all blocks fall: none is fixed or prescribed, and no mesh is held along gravity; "
            "usual: a floor of BlockKind.FIXED, or hold_nodes()"
        )
        return
    if len(boxes.ids) > _MOST_BLOCKS:
        return
    axis = int(np.argmax(np.abs(gravity[: boxes.low.shape[1]])))
    across = [k for k in range(boxes.low.shape[1]) if k != axis]
    down = gravity[axis] > 0
    bottom = boxes.high[:, axis] if down else -boxes.low[:, axis]
    falling = []
    for i in np.flatnonzero(boxes.moves & ~boxes.holds & ~velocities.any(axis=1)):
        beside = np.all(
            (boxes.low[:, across] < boxes.high[i, across]) & (boxes.high[:, across] > boxes.low[i, across]), axis=1
        )
        touches = np.all((boxes.low <= boxes.high[i]) & (boxes.high >= boxes.low[i]), axis=1)
        touches[i] = False
        if not touches.any() and not (beside & (bottom > bottom[i])).any():
            falling.append(int(boxes.ids[i]))
    if falling:
        more = f" and {len(falling) - 1} more" if len(falling) > 1 else ""
        yield f"block {falling[0]}{more} out of the world: nothing is below; usual: a block of BlockKind.FIXED"


def notes_on_sizes(boxes: Boxes, sleep_tolerance: float) -> Iterator[str]:
    if not len(boxes.ids):
        return
    least, most = boxes.sizes.min(), boxes.sizes.max()
    if most > _SIZE_RATIO * least:
        yield (
            f"block {boxes.ids[boxes.sizes.argmin()]} is {least:g} m thick and block "
            f"{boxes.ids[boxes.sizes.argmax()]} {most:g} m; usual: up to {_SIZE_RATIO:g} times as much"
        )
    if boxes.moves.any():
        thinnest = boxes.sizes[boxes.moves].min()
        if sleep_tolerance > _TOLD_FRACTION * thinnest:
            yield (
                f"sleep_tolerance: {sleep_tolerance:g} m beside a block {thinnest:g} m thick; "
                f"usual: below {_TOLD_FRACTION:.0%} of it"
            )


def notes_on_impulses(world: "World", boxes: Boxes) -> Iterator[str]:
    """Notes on settings of the impulses between rigid blocks where these have no such impulses."""
    own, default, count = world.laws, world.default_law, len(world.materials)
    pairs = [(a, b) for b in range(count) for a in range(b + 1)]
    if not pairs:
        return
    without = [law for law in (own.get(pair, default) for pair in pairs) if StiffnessKind.NONE == law.stiffness_kind]
    if not without:
        reason = "all laws have springs; usual: a law of StiffnessKind.NONE"
    elif not (boxes.moves & ~boxes.deforms).any():
        reason = "contacts without springs of blocks that deform are points; usual: rigid blocks"
    elif all(law.cohesion > 0 or law.tensile_strength > 0 for law in without):
        reason = ("contacts by a law without springs that has cohesion or tensile_strength are points; "
                  "usual: these in laws with springs only")
    else:
        return
    named = {"default_law": default, **{f"law[{a}, {b}]": law for (a, b), law in own.items()}}
    rebounds = [f"{name}.restitution" for name, law in named.items() if law.restitution > 0]
    for name in [name for name in _OF_IMPULSES if name in world._chosen_settings()] + rebounds:
        yield f"{name}: no effect: {reason}"


def notes_on_energy(report: WorldReport, fracture_loss: float) -> Iterator[str]:
    """A note on an energy residual above 1 % of the released energy, and above rounding errors of the ledger's sums."""
    energy = report.energy
    released = fracture_loss + report.impact_loss + report.bolt_loss + report.block_strain_energy
    released += report.block_damping_loss + energy.kinetic + energy.strain + energy.friction_loss
    released += energy.contact_damping_loss + energy.local_damping_loss + energy.mass_damping_loss
    scale = abs(energy.gravity) + abs(energy.outer_work) + abs(report.water_energy) + abs(released)
    if abs(energy.residual) > max(_USUAL_RESIDUAL * abs(released), _ROUNDING * scale):
        yield (
            f"energy residual: the numerical method has {'created' if energy.residual > 0 else 'lost'} "
            f"{abs(energy.residual / released):.2g} of the energy released; usual: below {_USUAL_RESIDUAL}, at a "
            "shorter time_step"
        )


def notes_on_time_step(time_step: float, stable: float) -> Iterator[str]:
    if time_step > 0 and stable > 0:
        if time_step > stable:
            yield f"time_step: {time_step:g} s is above the stable one, {stable:.4g} s"
        elif time_step < 1e-4 * stable:
            yield f"time_step: {time_step:g} s is far below the stable one, {stable:.4g} s; usual: a tenth of it or more"
