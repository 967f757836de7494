"""Small scenes with a known solution, each with parameters that can be varied: a bounce, a stack at rest, a release.

All parameters are dimensionless: lengths in sizes of a block, speeds in units of the impact speed at which the spring
deflects by a thousandth of that size. A scene returns its relative error."""
import dataclasses
import math

import numpy as np

import halfspace as hs

DENSITY = 1000.0
GRAVITY = 10.0


class Reported(Exception):
    """The report of a run shows that its result is invalid."""


@dataclasses.dataclass(frozen=True)
class Way:
    """The dimension and the law that a scene is run with."""

    dimension: int
    law: hs.StiffnessKind

    @property
    def name(self):
        law = {0: "per contact", 1: "per area", 2: "potential"}[int(self.law)]
        return f"{self.dimension}D, {law}"

    def make_law(self, per_face, size, damping, friction=0.0, area=None):
        """The law with a stiffness of `per_face` N/m for a face of this area, by default that of a box."""
        per_area = per_face / (area or size ** (self.dimension - 1))
        stiffness = {0: per_face, 1: per_area, 2: per_area * size / 2}[int(self.law)]
        return hs.Law(normal_stiffness=stiffness, shear_stiffness=per_face if self.law == 2 else stiffness,
                      normal_damping=damping, shear_damping=damping, friction_angle=friction,
                      stiffness_kind=self.law)

    def box(self, width, height):
        if self.dimension == 2:
            return hs.Shape.rectangle(width, height)
        return hs.Shape.box(width, width, height)

    def prism(self, corners):
        """A polygon; in 3D the prism on it, of unit length."""
        if self.dimension == 2:
            return hs.Shape.polygon(corners)
        return hs.Shape.hull([(x, y, z) for x, z in corners for y in (-0.5, 0.5)])

    def at(self, height, sideways=0.0, origin=0.0):
        """A position at this height; `origin` displaces the whole scene along every axis."""
        place = np.zeros(self.dimension)
        place[0], place[-1] = sideways, height
        return place + origin

    def world(self, gravity, law, size, **settings):
        down = np.zeros(3)
        down[self.dimension - 1] = -gravity
        return hs.World(self.dimension, gravity=down, law=law, potential_length=size, **settings)

    def tilted(self, angle):
        """A rotation about a horizontal axis."""
        if self.dimension == 2:
            return {"angle": angle}
        return {"rotation": (0, math.sin(angle / 2), 0, math.cos(angle / 2))}


def largest_move(way, world, steps):
    """The max vertical displacement of free blocks over so many steps; the first block is the plate."""
    start = world.positions.copy()
    world.step(steps)
    return float(np.abs(world.positions - start)[1:, way.dimension - 1].max())


def bounce(way, *, unit=1.0, origin=0.0, speed=1.0, step=0.02, plate=4.0):
    """A block bounces off a fixed plate, face to face, at its own speed: no damping, no gravity.

    `unit` is the size of the block in m. `origin` is in sizes. The plate is `plate` times as wide as the block. `step`
    is a fraction of the stable one."""
    mass = DENSITY * unit ** way.dimension
    per_face = 1e7 * unit ** (way.dimension - 1)
    pace = 1e-3 * unit * math.sqrt(per_face / mass) * speed
    away = 1e-2 * unit * speed

    def build(**step_settings):
        world = way.world(0, way.make_law(per_face, unit, damping=0), unit, **step_settings)
        stone = world.add_material(DENSITY)
        world.add_block(way.box(plate * unit, unit), way.at(-0.5 * unit, origin=origin * unit),
                        kind=hs.BlockKind.FIXED)
        block = world.add_block(way.box(unit, unit), way.at(0.5 * unit + away, origin=origin * unit), material=stone,
                                velocity=way.at(-pace))
        return world, block

    world, block = build(safety=min(step, 1.0))
    world.step(1)
    if step > 1:
        world, block = build(time_step=step * float(world.report.time_step))
    time = 2 * away / pace + math.pi * math.sqrt(mass / per_face)
    world.step(max(1, int(1.2 * time / world.report.time_step)))
    if world.report.max_penetration_ratio > 0.5:
        raise Reported(f"springs allow a penetration of {world.report.max_penetration_ratio:.2g} thicknesses")
    out = world.state(block).velocity[way.dimension - 1]
    return abs(out - pace) / pace


def rest(way, *, count=1, light=1.0, steps=2000, corner=0.0, tilt=0.0, stiffness=1.0):
    """A stack of blocks, placed in static equilibrium on its springs, stays at rest.

    The first block's density is `light` times that of the others; `corner` is the length of the edges that are cut
    off on both sides; `tilt` rotates the blocks. Returns the displacement over the static deflection of the springs."""
    sag = 1e-4 / stiffness
    shapes = [cut_box(way, corner)] + [cut_box(way, 0)] * (count - 1)
    densities = [DENSITY * light] + [DENSITY] * (count - 1)
    weights = [GRAVITY * density * shape.volume for density, shape in zip(densities, shapes)]
    per_face = sum(weights) / sag
    law = way.make_law(per_face, 1.0, damping=0.3, friction=0.5, area=1 - 2 * corner)
    world = way.world(GRAVITY, law, 1.0)
    materials = [world.add_material(density) for density in densities]
    world.add_block(way.box(8, 1), way.at(-0.5), kind=hs.BlockKind.FIXED)
    top = 0.0
    for i, shape in enumerate(shapes):
        top -= sum(weights[i:]) / per_face
        world.add_block(shape, shape.centroid + way.at(top), material=materials[i], **way.tilted(tilt))
        top += 1
    return largest_move(way, world, steps) / sag


def cut_box(way, corner):
    """A box on a horizontal plane, with its two lower edges cut off."""
    top = [(0.5, 1), (-0.5, 1)]
    if corner == 0:
        return way.prism(top + [(-0.5, 0), (0.5, 0)])
    return way.prism(top + [(-0.5, corner), (-0.5 + corner, 0), (0.5 - corner, 0), (0.5, corner)])


def needle(way, *, angle=0.1):
    """A wedge with a corner of this angle lies on its long face, on springs of uniform stiffness."""
    height = math.tan(angle)
    shape = way.prism([(0, 0), (1, 0), (1, height)])
    sag = 1e-4 * height
    weight = GRAVITY * DENSITY * shape.volume
    world = way.world(GRAVITY, way.make_law(weight / sag, 1.0, damping=0.3, friction=0.5), 1.0)
    stone = world.add_material(DENSITY)
    world.add_block(way.box(8, 1), way.at(-0.5), kind=hs.BlockKind.FIXED)
    block = world.add_block(shape, material=stone)
    world.step(2000)
    high = world.state(block).pose.position[way.dimension - 1]
    # The mean penetration is the static deflection, more below the heavier end. It neither lifts off nor tunnels.
    sunk = (shape.centroid[way.dimension - 1] - high) / sag
    return 0.0 if -1e-9 <= sunk <= 6 else abs(sunk)


def release(way, *, overlap=1e-3):
    """A block is released from an overlap with a plate; the energy of the spring is conserved."""
    per_face, mass = 1e7, DENSITY
    world = way.world(0, way.make_law(per_face, 1.0, damping=0), 1.0, safety=0.05)
    stone = world.add_material(DENSITY)
    world.add_block(way.box(4, 4), way.at(-2), kind=hs.BlockKind.FIXED)
    world.add_block(way.box(1, 1), way.at(0.5 - overlap), material=stone)
    world.step(1)
    held = world.energy.strain + world.energy.kinetic
    steps = int(math.pi * math.sqrt(mass / per_face) / world.report.time_step)
    world.step(max(steps, 10))
    return abs(float(world.energy.residual)) / held


def crowd(way, *, count=100):
    """A plate supports this many small blocks, each placed in static equilibrium on its spring."""
    small, gap, sag = 1e-2, 1.5e-2, 1e-6
    weight = GRAVITY * DENSITY * small ** way.dimension
    world = way.world(GRAVITY, way.make_law(weight / sag, small, damping=0.3), small)
    stone = world.add_material(DENSITY)
    across = count if way.dimension == 2 else math.ceil(math.sqrt(count))
    width = gap * (across + 1)
    world.add_block(way.box(2 * width, 1), way.at(-0.5), kind=hs.BlockKind.FIXED)
    shape = way.box(small, small)
    for i in range(count):
        place = way.at(0.5 * small - sag, sideways=gap * (i % across) - width / 2)
        if way.dimension == 3:
            place[1] = gap * (i // across) - width / 2
        world.add_block(shape, place, material=stone)
    return largest_move(way, world, 20) / sag
