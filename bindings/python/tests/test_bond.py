"""Bonds, relaxation, and the factor of safety."""
import numpy as np
import pytest

import halfspace as hs


def pulled(force, **bond):
    """A square bonded to a fixed one below, and pulled up; without gravity."""
    world = hs.World(gravity=(0, 0))
    world.add_material(2000)
    floor = world.add_block(hs.Shape.rectangle(1, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    block = world.add_block(hs.Shape.rectangle(1, 1), (0, 0.5))
    world.bond_blocks(floor, block, hs.Bond(normal_stiffness=1e10, cohesion=1e6, **bond))
    world.set_applied_force(block, (0, force))
    return world, block


def test_a_bond_holds_up_to_its_strength():
    world, _ = pulled(0.99e5, tensile_strength=1e5)
    assert world.relax(1e-7)[0]
    world.step(10)
    bond = world.bonds()[0]
    assert bond["is_joint"] and bond["damage"] == 0 and bond["normal_force"] == pytest.approx(0.99e5, rel=1e-4)
    assert len(world.bond_events()) == 0


def test_a_bond_fails_beyond_its_strength():
    world, block = pulled(1.01e5, tensile_strength=1e5)
    assert world.relax(1e-7)[0]  # failure is suspended during relaxation
    world.step(200)
    events = world.bond_events()
    assert list(events["failure"]) == [hs.BondFailure.TENSION] * 3
    assert events["energy"].sum() == pytest.approx(world.bond_report.fracture_loss, rel=1e-9)
    assert not world.bonds()[0]["is_joint"] and world.bond_report.crack_area == pytest.approx(1)
    assert world.state(block).velocity[1] > 0


def test_materials_are_bonded_along_common_faces():
    world = hs.World()
    stone, clay = world.add_material(2000), world.add_material(1500)
    for i in range(3):
        world.add_block(hs.Shape.rectangle(1, 1), (i, 0.5), material=stone)
    world.add_block(hs.Shape.rectangle(1, 1), (5, 0.5), material=stone)
    world.add_block(hs.Shape.rectangle(1, 1), (1, 1.5), material=clay)
    bond = hs.Bond(tensile_strength=1e6, cohesion=1e6)
    assert world.bond_materials(stone, stone, bond) == 2
    assert world.bond_materials(stone, stone, bond) == 0
    assert world.bond_materials(clay, stone, bond) == 1
    with pytest.raises(hs.ArgumentError, match="def.residual_cohesion is 2"):
        world.bond_materials(stone, stone, hs.Bond(cohesion=1, residual_cohesion=2))


def slope(angle, friction_angle):
    world = hs.World(
        gravity=(-9.81 * np.sin(angle), -9.81 * np.cos(angle)),
        law=hs.Law(normal_stiffness=1e9, friction_angle=friction_angle, stiffness_kind=hs.StiffnessKind.PER_AREA),
    )
    world.add_material(2500)
    world.add_block(hs.Shape.rectangle(20, 2), (0, -1), kind=hs.BlockKind.FIXED)
    world.add_block(hs.Shape.rectangle(2, 1), (0, 0.5))
    return world


def test_the_factor_of_safety_of_a_block_on_a_slope():
    world = slope(np.radians(20), np.radians(30))
    assert world.relax()[0]
    found = world.find_strength_factor(1, 3, 0.01)
    assert found.stands_at_low and found.falls_at_high
    assert found.factor == pytest.approx(np.tan(np.radians(30)) / np.tan(np.radians(20)), abs=0.015)
    world.set_strength_factor(1.3)
    assert world.relax()[0]


def test_what_slides_does_not_come_to_rest():
    at_rest, balance = slope(np.radians(40), np.radians(30)).relax(max_steps=2000)
    assert not at_rest and balance["mean"] > 1e-3 and balance.steps == 2000


def test_settings_change_while_a_world_lives():
    world = slope(0, 0.5)
    world.set_gravity((0, -20))
    world.set_damping(local_damping=0.5)
    world.set_time_step(1e-5)
    assert world.relax(measure=hs.Unbalanced.LARGEST)[0]
    assert world.balance.largest < 1e-4
    contact = world.contacts()[0]
    assert contact["normal_force"] == pytest.approx(2 * 2500 * 20, rel=1e-3)
    assert world.report.time_step == 1e-5
