"""Notes on unusual input of a world: those of the command, where a scene can describe the world."""
from __future__ import annotations

import re
from typing import TYPE_CHECKING, Iterator, List

import numpy as np

from .check import (
    Boxes,
    notes_on_energy,
    notes_on_gravity,
    notes_on_impulses,
    notes_on_sizes,
    notes_on_support,
    notes_on_time_step,
    notes_on_values,
)
from .constants import BlockKind
from .context import held
from .world_tables import unwritten_parts

if TYPE_CHECKING:
    from .world import World

_PLACE = re.compile(r"^scene:\d+:\d+: note: ")
_OF_START = " at the start by "
_OF_NO_WORLD = ("world.duration: ", "output.")


def notes_on(world: "World") -> List[str]:
    """The notes of the scene that the world was made of; else those of the scene that describes it."""
    with held(world):
        energy = list(notes_on_energy(world.report, world.bond_report.fracture_loss))
        if world._notes_of_scene is not None:
            return [*world._notes_of_scene, *energy]
        start = _notes_by_tables(world) if unwritten_parts(world) else _notes_of_command(world)
    bonds = [f"{name} made no bond; usual: blocks with a common face" for name in world._given.empty_bonds]
    return [*start, *bonds, *energy]


def _notes_of_command(world: "World") -> List[str]:
    from .scene import Scene  # which knows worlds

    if len(world) == 0:
        return list(notes_on_values(world))
    notes = [_PLACE.sub("", note) for note in Scene.from_world(world).check()]
    if world.report.steps > 0:  # contacts overlap then
        notes = [note for note in notes if _OF_START not in note]
    return [note for note in notes if not note.startswith(_OF_NO_WORLD)]


def _notes_by_tables(world: "World") -> Iterator[str]:
    definition, boxes, report = world.definition, _boxes(world), world.report
    gravity = np.asarray(definition["gravity"])
    yield from notes_on_values(world)
    yield from notes_on_gravity(gravity, world.dimension)
    if not world._given.is_of_snapshot:  # whose supports are not known
        yield from notes_on_support(boxes, gravity, world.velocities)
    yield from notes_on_sizes(boxes, definition["sleep_tolerance"])
    yield from notes_on_impulses(world, boxes)
    yield from notes_on_time_step(definition["time_step"], float(report.stable_time_step))


def _boxes(world: "World") -> Boxes:
    ids, outlines = world._outlined()
    along = "xyz"[int(np.argmax(np.abs(world.definition["gravity"])))]
    low, high = np.empty((2, len(ids), world.dimension))
    moves, holds, deforms = np.zeros((3, len(ids)), bool)
    for i, block in enumerate(ids):
        low[i], high[i] = outlines[i].min(axis=0), outlines[i].max(axis=0)
        kind = BlockKind(world.state(int(block)).kind)
        moves[i] = kind not in (BlockKind.FIXED, BlockKind.PRESCRIBED)
        deforms[i] = kind in (BlockKind.AFFINE, BlockKind.MESH)
        body = world.body_of_block(int(block))[0] if kind is BlockKind.MESH else 0
        holds[i] = not moves[i] or along in world._given.held.get(body, "")
    return Boxes(ids, low, high, moves, holds, deforms)
