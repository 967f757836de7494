"""What a world was given: settings, materials, laws, tables and actions."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import Any, Dict, List, Optional, Tuple, Type, TypeVar

import numpy as np

from . import _raw
from ._arrays import block_id, index, mutable_view_of
from ._definition import filled
from ._library import library
from ._record import Records
from .block_arrays import Floats
from .constants import ActionKind, FastBlocks, ForcePlace
from .context import held
from .properties import Elasticity, Law
from .records import Note
from .relax import Statics

_Definition = TypeVar("_Definition", Law, Elasticity)


@dataclasses.dataclass(frozen=True)
class Material:
    """A material of a world.

    Attributes
    ----------
    density : float
        kg/m3.
    elasticity : Elasticity or None
        None if it was given none.
    """

    density: float
    elasticity: Optional[Elasticity] = None


@dataclasses.dataclass(frozen=True)
class Action:
    """A motion or load in time, with the arguments of `World.act`: ``world.act(block, **vars(action))`` gives it again.

    Attributes
    ----------
    kind : ActionKind
        What it gives.
    table : int
        From `add_table`.
    scale : tuple
        Factor of each component. 0 where a later motion has ended it.
    at : tuple or None
        Place of a force, m; where it is now, if it moves with the block. None: the centroid.
    carried : bool
        The place moves with the block.
    start : float
        Time of the world at time 0 of the table, s.
    max_speed : float
        Of a servo, m/s.
    """

    kind: ActionKind
    table: int
    scale: Tuple[float, ...]
    at: Optional[Tuple[float, ...]]
    carried: bool
    start: float
    max_speed: float


def _value_of(kind: Type[_Definition], struct: Any) -> _Definition:
    return kind(**{field.name: getattr(struct, field.name) for field in dataclasses.fields(kind)})


def _settings_of(struct: Any) -> Dict[str, Any]:
    names = [name for name, *_ in struct._fields_ if name not in ("struct_size", "reserved")]
    settings = {name: getattr(struct, name) for name in names}
    settings["gravity"] = tuple(struct.gravity[: struct.dimension])
    settings["fast_blocks"] = FastBlocks(struct.fast_blocks)
    settings["locate_impacts"] = bool(struct.locate_impacts)
    return settings


class Definitions(Statics):
    """What a world was given, as it is at present, also after `World.restore`."""

    @property
    def definition(self) -> Dict[str, Any]:
        """Settings by their names in `World`, with gravity, damping and time step as they were set last:
        ``World(**world.definition)`` has the same."""
        struct = _raw.hs_world_def()
        self._call(library.hs_world_get_def, struct, ctypes.sizeof(struct))
        return _settings_of(struct)

    def _chosen_settings(self) -> Dict[str, Any]:
        """Those that are not the default."""
        defaults = _settings_of(filled(_raw.hs_world_def(), library.hs_world_def_init, self.dimension))
        return {name: value for name, value in self.definition.items() if value != defaults[name]}

    @property
    def materials(self) -> List[Material]:
        """All materials, by their index."""
        with held(self):
            densities = self._densities()
            return [Material(float(density), self._elasticity(i)) for i, density in enumerate(densities)]

    def material(self, material: int) -> Material:
        """Returns density and elasticity of a material."""
        with held(self):
            elasticity = self._elasticity(index(material, "material"))
            return Material(float(self._densities()[material]), elasticity)

    @property
    def default_law(self) -> Law:
        """The law of all pairs of materials without a law of their own. `set_default_law` sets it."""
        struct = _raw.hs_law_def()
        self._call(library.hs_world_get_default_law, struct, ctypes.sizeof(struct))
        return _value_of(Law, struct)

    def law(self, material_a: int, material_b: int) -> Law:
        """Returns the law of two materials, in either order: their own, or the default law. Its strengths are those
        that were given, before division by the factor of `set_strength_factor`."""
        struct = _raw.hs_law_def()
        materials = index(material_a, "material_a"), index(material_b, "material_b")
        self._call(library.hs_world_get_law, *materials, struct, ctypes.sizeof(struct))
        return _value_of(Law, struct)

    @property
    def laws(self) -> Dict[Tuple[int, int], Law]:
        """The laws of two materials that differ from the default law, by the indices of both."""
        with held(self):
            default, count = self.default_law, len(self._densities())
            laws = {(a, b): self.law(a, b) for b in range(count) for a in range(b + 1)}
        return {pair: law for pair, law in laws.items() if law != default}

    def table(self, table: int) -> Tuple[Floats, Floats]:
        """Returns the times, s, and the rows of three values of a table."""
        which = index(table, "table")
        with held(self):
            count = self._value(library.hs_world_get_table, which, None, _raw.hs_mutable_view())
            times, rows = np.empty(count), np.empty((count, 3))
            view = mutable_view_of(rows, 3, "rows")
            self._call(library.hs_world_get_table, which, times.ctypes.data, view, None)
        return times, rows

    def actions(self, block: Optional[int]) -> List[Action]:
        """Returns the actions on a block, or with None those on all blocks, in the order in which they were added."""
        name = 0 if block is None else block_id(block, "block")
        size = ctypes.sizeof(_raw.hs_action_def)
        with held(self):
            count = self._value(library.hs_world_get_actions, name, None, size, 0)
            structs = (_raw.hs_action_def * count)()
            self._call(library.hs_world_get_actions, name, structs, size, count, None)
        return [_action_of(struct) for struct in structs]

    def unusual_settings(self) -> Records:
        """Returns the settings with unusual values, which are probably in another unit: an array of `NOTE`. `check`
        has more, in words."""
        return self._records(Note, library.hs_world_check)

    def _densities(self) -> Floats:
        return self._array(np.float64, library.hs_world_get_densities)

    def _elasticity(self, material: int) -> Optional[Elasticity]:
        struct = _raw.hs_elasticity_def()
        self._call(library.hs_world_get_elasticity, material, struct, ctypes.sizeof(struct))
        return _value_of(Elasticity, struct) if struct.young_modulus > 0 else None


def _action_of(struct: Any) -> Action:
    place = ForcePlace(struct.place)
    return Action(
        kind=ActionKind(struct.kind),
        table=struct.table,
        scale=tuple(struct.scale),
        at=None if place == ForcePlace.CENTROID else tuple(struct.point),
        carried=place != ForcePlace.FIXED,
        start=struct.start,
        max_speed=struct.max_speed,
    )
