"""The tables of a scene that describe a world."""
from __future__ import annotations

import dataclasses
import math
from typing import TYPE_CHECKING, Any, Dict, List, Mapping

import numpy as np

from .constants import BlockKind, Plane, StiffnessKind
from .properties import Elasticity, Law

if TYPE_CHECKING:
    from .world import World


def _law_keys(law: Law) -> Dict[str, Any]:
    """The keys of a law. Scenes do not know those that do not belong to its kind."""
    keys = dataclasses.asdict(law)
    kind = StiffnessKind(keys.pop("stiffness_kind"))
    keys["friction_angle"] = math.degrees(law.friction_angle)
    belongs = law._belongs()
    return {"stiffness": kind.name.lower().replace("_", " "),
            **{name: value for name, value in keys.items() if belongs.get(name, True)}}


def _material_tables(world: "World") -> List[Dict[str, Any]]:
    tables: List[Dict[str, Any]] = []
    for i, material in enumerate(world.materials):
        table: Dict[str, Any] = {"name": f"material{i}", "density": material.density}
        if material.elasticity is not None:
            table.update(_elasticity_keys(material.elasticity, world.dimension))
        tables.append(table)
    return tables


def _elasticity_keys(elasticity: Elasticity, dimension: int) -> Dict[str, Any]:
    keys = dataclasses.asdict(elasticity)
    plane = Plane(keys.pop("plane"))
    return {**keys, "plane": plane.name.lower()} if dimension == 2 else keys


def _world_keys(world: "World", duration: float) -> Dict[str, Any]:
    keys = {**world._chosen_settings(), "gravity": world.definition["gravity"]}
    if "parallel_angle" in keys:
        keys["parallel_angle"] = math.degrees(keys["parallel_angle"])
    if "fast_blocks" in keys:
        keys["fast_blocks"] = keys["fast_blocks"].name.lower()
    return {"duration": duration, **keys}


def _block_tables(world: "World") -> List[Dict[str, Any]]:
    tables = []
    for name, block, state in zip(world.names, world.blocks.tolist(), world.states()):
        kind = BlockKind(int(state.kind))
        table = {
            "name": name,
            "material": f"material{state.material}",
            "kind": kind.name.lower(),
            "vertices": world.block_vertices(block),
        }
        if kind != BlockKind.FIXED:
            turn = np.degrees(state.angular_velocity)
            table["velocity"] = state.velocity[: world.dimension]
            table["angular_velocity"] = turn[2] if world.dimension == 2 else turn
        tables.append(table)
    return tables


def unwritten_parts(world: "World") -> List[str]:
    """The parts of a world that no table describes, in words; empty if `tables_of` describes it all."""
    parts = sorted(world._given.beyond_scenes)
    kinds = world.states()["kind"]
    if (kinds == BlockKind.MESH).any():
        parts.append("meshes")
    if world.bond_report.bond_count > 0:
        parts.append("bonds")
    if world._given.is_of_snapshot:
        parts.append("loads of a snapshot")
    return parts


def tables_of(world: "World", duration: float) -> Mapping[str, Any]:
    """The tables of a world at its current state.

    Raises
    ------
    ValueError
        The world has parts that no table describes.
    """
    unwritten = unwritten_parts(world)
    if unwritten:
        raise ValueError(f"the world has {', '.join(unwritten)}; a scene of a world has blocks, materials and laws only")
    laws = [{"between": [f"material{a}", f"material{b}"], **_law_keys(law)} for (a, b), law in world.laws.items()]
    return {
        "dimension": world.dimension,
        "world": _world_keys(world, duration),
        "default_law": _law_keys(world.default_law),
        "material": _material_tables(world),
        **({"law": laws} if laws else {}),
        "block": _block_tables(world),
    }
