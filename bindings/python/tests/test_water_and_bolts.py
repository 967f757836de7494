"""Water and bolts of a world: draught, tension, numbers and refusals."""
import numpy as np
import pytest

import halfspace as hs


def raft(dimension):
    world = hs.World(dimension, law=hs.Law(1e7))
    wood = world.add_material(600.0)
    shape = hs.Shape.rectangle(4, 1) if dimension == 2 else hs.Shape.box(4, 4, 1)
    return world, world.add_block(shape, material=wood)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_raft_floats_at_its_draught(dimension):
    world, block = raft(dimension)
    world.set_water(2.0)
    is_at_rest, _ = world.relax(1e-8)
    assert is_at_rest
    assert world.state(block).pose.position[dimension - 1] == pytest.approx(1.9, abs=1e-6)
    forces, torques = world.water_loads()
    assert forces[0, dimension - 1] == pytest.approx(world.state(block).mass * 9.81, rel=1e-6)
    assert np.abs(torques).max() < 1e-6
    world.set_water([])
    assert world.water_loads()[0].max() == 0


def test_a_sloping_table_pushes_along_its_slope():
    world, _ = raft(2)
    world.set_water([[-10, 11], [10, 9]], density=1030, factor=0.5)
    assert world.water_loads()[0][0] == pytest.approx([4 * 515 * 9.81 * 0.1, 4 * 515 * 9.81, 0])


def test_a_height_map_that_is_plane_is_a_plane():
    world, _ = raft(3)
    world.set_water([[0, 0, 1], [1, 0, 1.2], [0, 1, 1]])
    forces, torques = world.water_loads()
    x, y = np.meshgrid([-1, 0.3, 1.7], [-2.5, 0.1, 1, 4])
    # Beyond the border heights are those at the border, so the map covers the raft.
    x[:, 0], x[:, -1], y[0], y[-1] = -9, 9, -9, 9
    world.set_water(np.dstack([x, y, 1 + 0.2 * x]))
    by_map = world.water_loads()
    assert by_map[0] == pytest.approx(forces, rel=1e-12, abs=1e-9 * np.abs(forces).max())
    assert by_map[1] == pytest.approx(torques, rel=1e-9, abs=1e-9 * np.abs(forces).max())


def test_a_cable_carries_its_block():
    world, block = raft(2)
    weight = world.state(block).mass * 9.81
    cable = hs.Bolt(stiffness=1e7, pretension=weight)
    assert world.block_at([1, 0.2]) == block
    assert world.block_at([1, 3]) is None
    number = world.add_bolt_at(cable, [0, 3], [0, 0])
    world.step(100)
    assert world.bolts().number.tolist() == [number]
    assert world.bolts().tension == pytest.approx(weight, rel=1e-9)
    assert world.report.bolt_strain_energy == pytest.approx(weight**2 / 2e7, rel=1e-9)
    world.remove_bolt(number)
    assert len(world.bolts()) == 0
    with pytest.raises(hs.StaleIdError, match="number is 0"):
        world.remove_bolt(number)


def test_bad_bolts_and_tables_are_refused():
    world, block = raft(2)
    with pytest.raises(hs.ArgumentError, match="def.pretension is -1"):
        world.add_bolt(hs.Bolt(pretension=-1.0), [0, 0], [0, 3], block, None)
    with pytest.raises(hs.StateError, match="neither"):
        world.add_bolt(hs.Bolt(), [0, 0], [0, 3], None, None)
    with pytest.raises(hs.ArgumentError, match=r"table\[1\]"):
        world.set_water([[1, 0], [0, 0]])
