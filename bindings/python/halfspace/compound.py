"""Compounds: concave blocks of several convex parts."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _raw
from ._arrays import as_pose, block_id, index, pose, shaped, turn_vector, vector
from ._choice import choice
from ._library import library
from .constants import BlockKind
from .context import held, pointers_of
from .query import QueriedBlocks
from .shape import Shape


def set_start(
    definition: _raw.hs_block_def,
    position: Optional[ArrayLike],
    angle: Optional[float],
    rotation: Optional[ArrayLike],
    kind: Union[BlockKind, str],
    material: int,
    velocity: Optional[ArrayLike],
    angular_velocity: Optional[ArrayLike],
) -> None:
    """Writes the arguments of a new block into its definition; None keeps the default."""
    definition.kind, definition.material = choice(kind, BlockKind, "kind"), index(material, "material")
    if position is not None or angle is not None or rotation is not None:
        centroid = definition.pose.position[:] if position is None else position
        definition.pose = as_pose(pose(centroid, angle, rotation=rotation), "pose")
    if velocity is not None:
        definition.velocity = vector(velocity, "velocity")
    if angular_velocity is not None:
        definition.angular_velocity = turn_vector(angular_velocity, "angular_velocity")


class CompoundBlocks(QueriedBlocks):
    """The compounds of a world."""

    def add_compound(
        self,
        shapes: Sequence[Shape],
        poses: Optional[ArrayLike] = None,
        position: Optional[ArrayLike] = None,
        angle: Optional[float] = None,
        *,
        rotation: Optional[ArrayLike] = None,
        kind: Union[BlockKind, str] = BlockKind.RIGID,
        material: int = 0,
        velocity: Optional[ArrayLike] = None,
        angular_velocity: Optional[ArrayLike] = None,
    ) -> int:
        """Adds a concave block of convex parts, with one mass and one inertia. Parts may touch, but not overlap.

        Parameters
        ----------
        shapes : sequence of Shape
            Of the parts, of the world's dimension.
        poses : array_like, shape (n, 7), optional
            Of the parts in one frame, see `pose`; by default in the coordinates of their vertices.
        position : array_like, optional
            Position of the centroid of all parts, m; by default in the frame of `poses`.
        angle, rotation, material, velocity, angular_velocity : optional
            As in `add_block`, for all parts together.
        kind : BlockKind or its name
            Rigid, fixed or prescribed.

        Returns
        -------
        int
            Id of the compound. Contacts report the ids of its parts, see `compound_parts`.

        Examples
        --------
        >>> from halfspace import Shape, World
        >>> world = World()
        >>> stone = world.add_material(density=2000)
        >>> corner = [Shape.polygon([(0, 0), (3, 0), (3, 1), (0, 1)]), Shape.polygon([(0, 1), (1, 1), (1, 2), (0, 2)])]
        >>> block = world.add_compound(corner)
        >>> float(world.state(block).mass), len(world.compound_parts(block))
        (8000.0, 2)
        """
        owners = tuple(shapes)  # a copy, as the sequence may change
        if len(owners) == 0:
            raise ValueError("shapes is empty; a compound has at least one part")
        places = None
        if poses is not None:
            places = shaped(np.ascontiguousarray(poses, np.float64), "poses", (len(owners), 7))
        definition = _raw.hs_block_def()
        with held(self, *owners):
            given = pointers_of(owners), None if places is None else places.ctypes.data, len(owners)
            initialise = library.hs_compound_def_init
            owners[0]._keeper.call(initialise, ctypes.byref(definition), ctypes.sizeof(definition), *given)
            set_start(definition, position, angle, rotation, kind, material, velocity, angular_velocity)
            self._given.beyond_scenes.add("compounds")
            return self._value(library.hs_world_add_compound, *given, definition)

    def compound_parts(self, block: int) -> Any:
        """Returns the ids of the parts of a compound, in the order of its shapes; none for other blocks."""
        return self._array(np.uint64, library.hs_world_get_compound_parts, block_id(block, "block"))

    def compound_of_block(self, block: int) -> Tuple[int, int]:
        """Returns the compound and the index of a part; 0 and -1 for a block that is none."""
        return self._whole_of(library.hs_world_get_compound_of_block, block)
