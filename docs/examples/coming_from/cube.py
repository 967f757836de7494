import halfspace as hs

law = hs.Law(normal_stiffness=1e7, shear_stiffness=5e6, friction_angle=0.6, normal_damping=0.3)
world = hs.World(dimension=3, law=law)
world.add_material(density=2600)
world.add_block(hs.Shape.box(4, 4, 1), (0, 0, -0.5), kind=hs.BlockKind.FIXED)
world.add_block(hs.Shape.box(1, 1, 1), (0, 0, 2))

while world.time < 3:
    world.step(100)
print(f"height {world.positions[-1][2]:.3f} m, {len(world.contacts())} contact")
print(f"force {world.contacts()[0].normal_force:.0f} N, weight {2600 * 9.81:.0f} N")
