"""Small scenes whose outcome is known, each with numbers that can be stretched: a bounce, a stack at rest, a release.

All figures are without a dimension: lengths in sizes of a block, speeds in those at which the spring gives by a
thousandth of the size. A scene returns its error, a share of what it measures."""
import dataclasses
import math

import numpy as np

import halfspace as hs

DENSITY = 1000.0
GRAVITY = 10.0


class Told(Exception):
    """The report of a run says that it is not to be trusted."""


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
        """A face of this area, by default that of a box, is to have so many N/m."""
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
        """A polygon; in space the prism on it, one size long."""
        if self.dimension == 2:
            return hs.Shape.polygon(corners)
        return hs.Shape.hull([(x, y, z) for x, z in corners for y in (-0.5, 0.5)])

    def at(self, height, sideways=0.0, origin=0.0):
        """A place at this height; the whole scene is moved by `origin` along every axis."""
        place = np.zeros(self.dimension)
        place[0], place[-1] = sideways, height
        return place + origin

    def world(self, gravity, law, size, **settings):
        down = np.zeros(3)
        down[self.dimension - 1] = -gravity
        return hs.World(self.dimension, gravity=down, law=law, potential_length=size, **settings)

    def tilted(self, angle):
        """A turn about an axis that lies level."""
        if self.dimension == 2:
            return {"angle": angle}
        return {"rotation": (0, math.sin(angle / 2), 0, math.cos(angle / 2))}


def largest_move(way, world, steps):
    """The farthest up or down that free blocks go in so many steps; the first block is the plate."""
    start = world.positions.copy()
    world.step(steps)
    return float(np.abs(world.positions - start)[1:, way.dimension - 1].max())


def bounce(way, *, unit=1.0, origin=0.0, speed=1.0, step=0.02, plate=4.0):
    """A block meets a fixed plate squarely and comes back as fast as it came: no damping, no gravity.

    `unit` is the size of the block in m. `origin` is in sizes. The plate is `plate` times as wide as the block. `step`
    is a share of the stable one."""
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
        raise Told(f"springs so soft let the block come {world.report.max_penetration_ratio:.2g} of its thickness deep")
    out = world.state(block).velocity[way.dimension - 1]
    return abs(out - pace) / pace


def rest(way, *, count=1, light=1.0, steps=2000, corner=0.0, tilt=0.0, stiffness=1.0):
    """Blocks one on the other, put where their springs carry them, stay there.

    The first block's density is `light` times that of the others; `corner` cuts an edge of this length off at either
    side; `tilt` turns blocks from lying squarely. Returns how far they move, as a share of how far the springs give."""
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
    """A box on the level, its two lower edges cut off."""
    top = [(0.5, 1), (-0.5, 1)]
    if corner == 0:
        return way.prism(top + [(-0.5, 0), (0.5, 0)])
    return way.prism(top + [(-0.5, corner), (-0.5 + corner, 0), (0.5 - corner, 0), (0.5, corner)])


def needle(way, *, angle=0.1):
    """A wedge with a corner of this angle lies on its long face, which the spring carries evenly."""
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
    # It sinks in by the sag on average, deeper below its heavier end: never out of the plate, nor through it.
    sunk = (shape.centroid[way.dimension - 1] - high) / sag
    return 0.0 if -1e-9 <= sunk <= 6 else abs(sunk)


def release(way, *, overlap=1e-3):
    """A block set into a plate to this depth is pushed out; what the spring held has to be there again."""
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
    """One plate carries this many small blocks, each put where its spring carries it."""
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
