import math

import halfspace as hs

RISE, SPAN, THICKNESS, COUNT = 3, 10, 0.25, 50
radius = (SPAN**2 / 4 + RISE**2) / (2 * RISE)
half = math.asin(SPAN / 2 / radius)


def corner(r, angle):
    return r * math.sin(angle), r * math.cos(angle) - radius + RISE


world = hs.World(law=hs.Law(stiffness_kind=hs.StiffnessKind.NONE, friction_angle=0.7), time_step=1 / 60)
world.add_material(density=2400)
blocks = []
for i in range(COUNT):
    a, b = (half * (2 * (i + k) / COUNT - 1) for k in (0, 1))
    outline = [corner(radius, a), corner(radius, b), corner(radius + THICKNESS, b), corner(radius + THICKNESS, a)]
    shape = hs.Shape.polygon(outline)
    is_support = i in (0, COUNT - 1)
    kind = hs.BlockKind.FIXED if is_support else hs.BlockKind.RIGID
    blocks.append(world.add_block(shape, shape.centroid, kind=kind))

start = world.positions.copy()
world.step(300)
thrust = [contact.force[0] for contact in world.contacts() if contact.block_b == blocks[COUNT // 2]]
print(f"moved by {abs(world.positions - start).max():.0e} m in 5 s")
print(f"thrust {thrust[0] / 1000:.1f} kN per metre")
