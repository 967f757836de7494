#!/usr/bin/python3
"""The cost of each part of a world: a brick wall in the plane and in space, bare and with one part at a time.

Usage: tests/benchmarks/ablations.py     in the root of the repository, after a release build

Bare is rigid, without friction and damping, by springs per contact. Times are those of `World.plan`, the fastest of
several passes that take turns; bytes are those that a snapshot holds.
"""
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings/python"))
os.environ.setdefault("HALFSPACE_LIBRARY", str(ROOT / "build/release/capi/libhalfspace.so"))

import halfspace as hs  # noqa: E402

STIFFNESS, SINK = 1e9, 1e-5
PASSES, STEPS = 7, 60

BARE = {"normal_damping": 0, "shear_damping": 0, "friction_angle": 0}
PARTS = {
    "bare": {},
    "friction": {"law": {"friction_angle": 0.5}},
    "bonds": {"law": {"cohesion": 1e5, "tensile_strength": 1e5}},
    "damping of contacts": {"law": {"normal_damping": 0.1, "shear_damping": 0.1}},
    "areas": {"law": {"stiffness_kind": hs.StiffnessKind.PER_AREA}},
    "potentials": {"law": {"stiffness_kind": hs.StiffnessKind.POTENTIAL}},
    "strain": {"kind": hs.BlockKind.AFFINE},
    "local damping": {"world": {"local_damping": 0.1}},
    "mass damping": {"world": {"mass_damping": 0.1}},
    "friction, all asleep": {"law": {"friction_angle": 0.5}, "world": {"mass_damping": 100, "sleep_tolerance": 1e-6},
                             "falls_asleep": True},
}


def wall(dimension, part):
    """Bricks in bond on a plate, each pressed a little into those below."""
    law = hs.Law(normal_stiffness=STIFFNESS, **(BARE | part.get("law", {})))
    world = hs.World(dimension, law=law, potential_length=1, time_step=1e-5, **part.get("world", {}))
    stone = world.add_material(2000)
    if "kind" in part:
        world.set_elasticity(stone, hs.Elasticity(young_modulus=1e10))
    kind = part.get("kind", hs.BlockKind.RIGID)
    across, deep, up = (40, 1, 40) if dimension == 2 else (10, 10, 10)
    brick = hs.Shape.rectangle(1, 0.5) if dimension == 2 else hs.Shape.box(1, 1, 0.5)
    plate = hs.Shape.rectangle(90, 1) if dimension == 2 else hs.Shape.box(90, 90, 1)

    def at(x, y, z):
        return (x, z) if dimension == 2 else (x, y, z)

    world.add_block(plate, at(0, 0, -0.5), kind=hs.BlockKind.FIXED)
    for k in range(up):
        for j in range(deep):
            for i in range(across):
                half = 0.5 * (k % 2)
                world.add_block(brick, at(1.1 * i + half, 1.1 * j + half, 0.25 + (0.5 - SINK) * k - SINK),
                                material=stone, kind=kind)
    return world


def fall_asleep(world):
    for _ in range(1000):
        world.step(256)
        if world.report.sleeping_count == world.report.block_count - 1:
            return
    sys.exit(f"{world.report.sleeping_count} of {world.report.block_count - 1} blocks sleep")


def seconds(plan):
    return float(plan.search_seconds + plan.pair_seconds + plan.gather_seconds + plan.bond_seconds
                 + plan.motion_seconds + plan.hard_contact_seconds + plan.ledger_seconds)


def main():
    for dimension, name in ((2, "plane"), (3, "space")):
        worlds = {part: wall(dimension, settings) for part, settings in PARTS.items()}
        for part, world in worlds.items():
            if PARTS[part].get("falls_asleep"):
                fall_asleep(world)
        best = dict.fromkeys(worlds, float("inf"))
        for _ in range(PASSES):
            for part, world in worlds.items():
                best[part] = min(best[part], seconds(world.plan(STEPS)))
        for part, world in worlds.items():
            plan = world.plan()
            blocks = plan.fixed_count + plan.rigid_count + plan.affine_count
            print(f"{name}, {part}: {1e9 * best[part] / blocks:.0f} ns a block-step, "
                  f"{best[part] / best['bare']:.2f} of bare, {plan.block_bytes / blocks:.0f} B a block, "
                  f"{plan.pair_bytes / plan.candidate_count:.0f} B a pair, "
                  f"{plan.contact_count / blocks:.2f} contacts a block", flush=True)


if __name__ == "__main__":
    main()
