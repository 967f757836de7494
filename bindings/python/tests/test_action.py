"""Motions and loads in time, against analysis."""
import numpy as np
import pytest

import halfspace as hs


def make_world(**settings):
    world = hs.World(2, gravity=(0, 0), time_step=0.01, **settings)
    world.add_material(2000)
    return world


def test_an_impulse_gives_its_momentum():
    world = make_world()
    block = world.add_block(hs.Shape.rectangle(1, 1), position=(0, 0))
    table = world.add_table([0, 0.013, 0.013, 0.05], [[0, 0], [300, -100], [0, 50], [0, 0]])
    world.act(block, "force", table)
    world.act(block, "torque", world.add_table([0, 0.1, 0.1], [0, 40, 0]))
    world.step(20)
    state = world.state(block)
    assert state["velocity"][0] * 2000 == pytest.approx(0.013 * 150, rel=1e-12)
    assert state["velocity"][1] * 2000 == pytest.approx(-0.013 * 50 + 0.037 * 25, rel=1e-12)
    assert state["angular_velocity"][2] * 2000 / 6 == pytest.approx(2, rel=1e-12)


def test_a_prescribed_block_follows_its_table():
    world = make_world()
    ground = world.add_block(hs.Shape.rectangle(1, 1), kind="prescribed", position=(0, 0))
    world.act(ground, "acceleration", world.add_table([0, 0.1], [0, 6]), scale=(1, 0))
    world.step(10)
    assert world.state(ground)["velocity"][:2] == pytest.approx([0.3, 0], abs=1e-12)
    assert world.state(ground)["pose"]["position"][0] == pytest.approx(0.01, rel=1e-12)
    world.end_actions(ground)
    world.prescribe_velocities([ground], [[2, 1]], [0.5])
    world.step(10)
    assert world.state(ground)["pose"]["position"][:2] == pytest.approx([0.21, 0.1], rel=1e-12)
    assert world.state(ground)["angle"] == pytest.approx(0.05, rel=1e-12)


def test_held_axes_and_places_of_forces():
    world = make_world()
    block = world.add_block(hs.Shape.rectangle(1, 1), position=(0, 0))
    world.hold(block, "xr")
    world.act(block, "force", world.add_table([0], [[5, 7]]), at=(0.5, 0))
    world.step(10)
    state = world.state(block)
    assert state["velocity"][0] == 0 and state["angular_velocity"][2] == 0
    assert state["velocity"][1] == pytest.approx(7 / 2000 * 0.1, rel=1e-12)
    world.hold(block, "")
    world.step(1)
    assert world.state(block)["angular_velocity"][2] == pytest.approx(0.5 * 7 / (2000 / 6) * 0.01, rel=1e-5)


def test_what_cannot_be_is_refused():
    world = make_world()
    block = world.add_block(hs.Shape.rectangle(1, 1))
    table = world.add_table([0, 1], [0, 1])
    with pytest.raises(hs.StateError, match="not prescribed"):
        world.act(block, "velocity", table)
    with pytest.raises(hs.ArgumentError, match="only HS_ACTION_ACCELERATION"):
        world.act(None, "force", table)
    with pytest.raises(hs.StaleIdError, match="def.table is 3"):
        world.act(block, "force", 3)
    with pytest.raises(hs.ArgumentError, match=r"times\[1\] is 0"):
        world.add_table([1, 0], [0, 1])
    with pytest.raises(ValueError, match="2 rows"):
        world.add_table([1], [0, 1])
    with pytest.raises(ValueError, match="x, y, z and r"):
        world.hold(block, "q")
    with pytest.raises(hs.StateError, match="not prescribed"):
        world.prescribe_velocities([block], np.zeros((1, 2)))
