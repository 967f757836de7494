"""A world returns what it was given, also after changes and in a restored world."""
import math

import numpy as np
import pytest

import halfspace as hs

JOINT = hs.Law(normal_stiffness=1e8, friction_angle=0.6, cohesion=1.1e4, stiffness_kind="per area")
STEEL = hs.Elasticity(young_modulus=2.1e11, poisson_ratio=0.3, plane="stress")


def make_world(**settings):
    """Two materials, the second one elastic, with a law of their own."""
    world = hs.World(law=hs.Law(friction_angle=0.4), **settings)
    stone, steel = world.add_material(2700.1), world.add_material(7850.3)
    world.set_elasticity(steel, STEEL)
    world.set_law(stone, steel, JOINT)
    return world


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_world_of_the_same_definition(dimension):
    chosen = dict(time_step=1e-3, local_damping=0.7, fast_blocks=hs.FastBlocks.REFUSE, locate_impacts=True)
    world = hs.World(dimension, **chosen)
    gravity = (0.5, -1.0, 2.0)[:dimension]
    world.set_gravity(gravity)
    world.set_damping(0.1, 0.2)
    expected = {**chosen, "dimension": dimension, "gravity": gravity, "local_damping": 0.1, "mass_damping": 0.2}
    assert expected.items() <= world.definition.items()
    assert hs.World(**world.definition).definition == world.definition
    assert hs.World.restore(world.save()).definition == world.definition


def test_materials_and_laws():
    world = make_world()
    world.set_strength_factor(1.7)
    for each in (world, hs.World.restore(world.save())):
        assert each.materials == [hs.Material(2700.1), hs.Material(7850.3, STEEL)]
        assert each.material(1) == hs.Material(7850.3, STEEL)
        assert each.law(0, 1) == each.law(1, 0) == JOINT
        assert each.law(1, 1) == each.default_law == hs.Law(friction_angle=0.4)
        assert each.laws == {(0, 1): JOINT}
    for call in (lambda: world.law(0, 2), lambda: world.material(2), lambda: world.material(-1)):
        with pytest.raises(hs.StaleIdError):
            call()


def test_tables_and_actions():
    world = make_world(gravity=(0, 0))
    block = world.add_block(hs.Shape.rectangle(1, 1), kind="prescribed", position=(0, 0))
    pushed = world.add_block(hs.Shape.rectangle(1, 1), position=(5, 0))
    table = world.add_table([0, 0.5], [[1, 2, 3], [4, 5, 6]])
    world.act(block, "velocity", table, scale=(1, 0, 0), start=0.2)
    world.act(pushed, "force", table, at=(5.25, 0.25))
    world.act(None, "acceleration", table)
    times, rows = world.table(table)
    assert times.tolist() == [0, 0.5] and rows.tolist() == [[1, 2, 3], [4, 5, 6]]
    (motion,) = world.actions(block)
    assert motion == hs.Action(hs.ActionKind.VELOCITY, table, (1, 0, 0), None, True, 0.2, 0)
    (force,) = world.actions(pushed)
    assert force.at == (5.25, 0.25, 0) and force.carried
    world.set_pose(pushed, (5, 0), math.pi / 2)
    assert world.actions(pushed)[0].at == pytest.approx((4.75, 0.25, 0))
    world.end_actions(block)
    assert world.actions(block) == []
    world.act(block, **vars(motion))
    assert world.actions(block) == [motion]
    assert [action.kind for action in world.actions(None)] == [hs.ActionKind.ACCELERATION]
    with pytest.raises(hs.StaleIdError):
        world.table(1)


def test_unusual_settings():
    world = make_world()
    assert len(world.unusual_settings()) == 0
    world.set_law(0, 1, hs.Law(cohesion=5))
    world.add_material(2.7)
    notes = world.unusual_settings()
    assert [note.setting for note in notes] == [hs.Setting.DENSITY, hs.Setting.COHESION]
    assert notes.material_a.tolist() == [2, 0] and notes.material_b.tolist() == [-1, 1]
    assert np.array_equal(notes.value, [2.7, 5]) and np.array_equal(notes.usual_low, [50, 100])


def test_a_scene_of_a_world_has_its_settings():
    world = make_world(skin=0.2, parallel_angle=0.02)
    world.add_block(hs.Shape.rectangle(1, 1), kind="fixed")
    again = hs.Scene.from_world(world).world()
    assert again.definition["skin"] == 0.2
    assert again.definition["parallel_angle"] == pytest.approx(0.02)
    assert [material.density for material in again.materials] == [2700.1, 7850.3]
    assert again.law(0, 1).cohesion == JOINT.cohesion
    assert again.law(0, 1).friction_angle == pytest.approx(0.6)
