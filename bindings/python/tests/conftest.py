import pytest

import halfspace as hs


@pytest.fixture
def square():
    return hs.Shape.rectangle(1, 1)


@pytest.fixture
def resting_world(square):
    """A square of 2000 kg above a floor; it lands within 0.1 s."""
    world = hs.World(law=hs.Law(normal_stiffness=1e7, friction_angle=0.5, normal_damping=0.3), time_step=1e-3)
    world.add_material(2000)
    world.add_block(hs.Shape.rectangle(4, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    world.add_block(square, (0.125, 0.51))
    return world
