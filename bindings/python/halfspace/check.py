"""Unusual settings of a world that are allowed."""
from __future__ import annotations

import dataclasses
import math
from typing import Any, Dict, Iterator, List, Optional, Set, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .constants import StiffnessKind
from .law import Law
from .records import WorldReport

#: The usual range of a setting (absolute value or norm), and its text in a note. 0 is usual, too.
_USUAL: Dict[str, Tuple[float, float, str]] = {
    "gravity": (1, 25, "9.81 m/s2, 1.62 on the moon"),
    "density": (50, 19500, "50 to 19500 kg/m3, 2700 of rock"),
    "young_modulus": (1e6, 2e12, "1e6 to 2e12 Pa, 5e10 of rock"),
    "poisson_ratio": (0, 0.495, "0 to 0.49"),
    "damping_time": (0, 0.02, "up to 0.02 s"),
    "normal_damping": (0, 1, "0 to 1, a fraction of critical damping"),
    "shear_damping": (0, 1, "0 to 1, a fraction of critical damping"),
    "mass_damping": (0, 100, "up to 100 1/s"),
    "friction_angle": (0.035, 1.31, "0, or 0.035 to 1.3 rad, which is 2 to 75 degrees"),
    "residual_friction_angle": (0.035, 1.31, "0, or 0.035 to 1.3 rad, which is 2 to 75 degrees"),
    "cohesion": (100, 1e9, "0, or 100 to 1e9 Pa"),
    "residual_cohesion": (100, 1e9, "0, or 100 to 1e9 Pa"),
    "tensile_strength": (100, 1e9, "0, or 100 to 1e9 Pa"),
    "tensile_fracture_energy": (0.1, 1e6, "0, or 0.1 to 1e6 J/m2"),
    "shear_fracture_energy": (0.1, 1e6, "0, or 0.1 to 1e6 J/m2"),
    "normal_stiffness": (1e3, 1e17, "1e3 to 1e14 in N/m, Pa/m or Pa"),
    "shear_stiffness": (1e2, 1e17, "0, or 1e2 to 1e14 in N/m or Pa/m"),
}
_TOLD_FRACTION = 0.01  # fraction of the thickness of the thinnest block
_SIZE_RATIO = 1e5
_USUAL_RESIDUAL = 0.01  # fraction of the released energy
_ROUNDING = 1e-9  # fraction of the ledger's entries, over many steps
_MOST_BLOCKS = 5000  # limit of a comparison of all pairs


class Given:
    """Settings of a world by name, with their last values."""

    def __init__(self) -> None:
        self.values: Dict[str, Any] = {}
        self.held: Dict[int, str] = {}  # axes along which nodes of a body are held
        self.empty_bonds: List[str] = []
        self.laws: Dict[str, Law] = {}
        self.elasticities: Dict[str, Any] = {}  # of materials
        self.settings: Dict[str, Any] = {}  # of the world
        self.beyond_scenes: Set[str] = set()  # parts that no table of a scene describes, in words
        self.of_impulses: List[str] = []  # settings of the impulses between rigid blocks

    def copy(self) -> "Given":
        other = Given()
        other.values, other.held = dict(self.values), dict(self.held)
        other.empty_bonds = list(self.empty_bonds)
        other.laws, other.of_impulses = dict(self.laws), list(self.of_impulses)
        other.elasticities, other.settings = dict(self.elasticities), dict(self.settings)
        other.beyond_scenes = set(self.beyond_scenes)
        return other

    def see(self, name: str, value: Any) -> None:
        """Stores a number, a vector, or the fields of a dataclass."""
        if isinstance(value, Law):
            self.laws[name] = value
        if dataclasses.is_dataclass(value):
            for field in dataclasses.fields(value):
                if field.name in _USUAL:
                    self.values[f"{name}.{field.name}"] = getattr(value, field.name)
        else:
            self.values[name] = value

    def unusual(self) -> Iterator[str]:
        """Notes on values outside their usual range, e.g. in a wrong unit."""
        for name, value in self.values.items():
            low, high, usual = _USUAL.get(name.rsplit(".", 1)[-1], (0, math.inf, ""))
            size = float(np.linalg.norm(value))
            below_zero = name.endswith("poisson_ratio") and value < 0
            if size > 0 and (not low <= size <= high or below_zero):
                yield f"{name}: {_shown(value)} is unusual; usual: {usual}"


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


def notes_on_impulses(given: Given, boxes: Boxes) -> Iterator[str]:
    """Notes on settings of the impulses between rigid blocks where these have no such impulses."""
    count = sum(name.endswith("].density") for name in given.values)
    if "default_law" not in given.laws or not count:
        return
    pairs = [f"law[{a}, {b}]" for b in range(count) for a in range(b + 1)]
    without = [law for law in (given.laws.get(pair, given.laws["default_law"]) for pair in pairs)
               if StiffnessKind.NONE == law.stiffness_kind]
    if not without:
        reason = "all laws have springs; usual: a law of StiffnessKind.NONE"
    elif not (boxes.moves & ~boxes.deforms).any():
        reason = "contacts without springs of blocks that deform are points; usual: rigid blocks"
    elif all(law.cohesion > 0 or law.tensile_strength > 0 for law in without):
        reason = ("contacts by a law without springs that has cohesion or tensile_strength are points; "
                  "usual: these in laws with springs only")
    else:
        return
    rebounds = [f"{name}.restitution" for name, law in given.laws.items() if law.restitution > 0]
    for name in given.of_impulses + rebounds:
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


def notes_on_time_step(time_step: Optional[float], stable: float) -> Iterator[str]:
    if time_step and stable > 0:
        if time_step > stable:
            yield f"time_step: {time_step:g} s is above the stable one, {stable:.4g} s"
        elif time_step < 1e-4 * stable:
            yield f"time_step: {time_step:g} s is far below the stable one, {stable:.4g} s; usual: a tenth of it or more"
