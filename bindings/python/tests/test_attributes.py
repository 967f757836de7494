"""Only attributes that exist can be assigned; the error of another names the right one."""
import copy
import dataclasses
import pickle

import pytest

import halfspace as hs
from halfspace import trade

RIGHT = [  # assigned to a world, named by the error
    ("gravity", "use set_gravity(gravity)"),
    ("gravty", "similar: set_gravity(gravity)"),
    ("velocites", "similar: velocities, "),
    ("angular_velocity", "use set_velocity(block, velocity, angular_velocity)"),
    ("time_step", "use set_time_step(time_step)"),
    ("local_damping", "use set_damping(local_damping, mass_damping)"),
    ("law", "use set_law(material_a, material_b, law)"),
    ("applied_force", "use set_applied_force(block, force, torque)"),
    ("skin", "use World(..., skin=...)"),
    ("step", "World.step cannot be assigned; use step(steps)"),
    ("positions", "World.positions cannot be assigned; similar: set_pose("),
    ("dt", "World has no attribute dt; to set: set_gravity, set_time_step, "),
]
RIGHT_OF_OTHERS = [
    (lambda world: hs.Law(), "friction_angle", "cannot be assigned; use dataclasses.replace(..., friction_angle=...)"),
    (lambda world: hs.Law(), "frictionangle", "similar: friction_angle"),
    (lambda world: hs.Bond(), "tensile_strenght", "similar: tensile_strength"),
    (lambda world: hs.Bolt(), "pretention", "similar: pretension"),
    (lambda world: hs.Elasticity(), "youngs_modulus", "similar: young_modulus"),
    (lambda world: world.state(world.blocks[0]), "velocty", "similar: velocity"),
    (lambda world: world.state(world.blocks[0]), "velocity", "cannot be assigned; use World.set_velocity("),
    (lambda world: world.states(), "velocty", "Records has no attribute velocty; similar: velocity"),
    (lambda world: world.report, "time", "WorldReport.time cannot be assigned"),
    (lambda world: world.relax(max_steps=1)[1], "men", "Balance has no attribute men; similar: mean"),
    (lambda world: hs.Shape.rectangle(1, 1), "vertices", "use set_vertices(vertices)"),
    (lambda world: world.context, "threads", "use Context(..., threads=...)"),
    (hs.Scene.from_world, "duration", "Scene.duration cannot be assigned; to set: with_settings"),
    (hs.Scene.from_world, "setting", "similar: with_settings(settings)"),
    (hs.Recording, "title", "use Recording(..., title=...)"),
    (lambda world: hs.PairCache(), "stat", "PairCache has no attribute stat"),
    (lambda world: trade.Trial({}, 1.0, 0.0, 1.0), "cots", "similar: cost"),
]


def is_settable(kind):
    return isinstance(kind, type) and not issubclass(kind, (int, Exception))


@pytest.mark.parametrize("name, right", RIGHT)
def test_an_unknown_attribute_of_a_world_names_the_right_one(resting_world, name, right):
    before = resting_world.save()
    with pytest.raises(AttributeError) as caught:
        setattr(resting_world, name, 0.5)
    assert right in str(caught.value)
    assert resting_world.save() == before and callable(resting_world.step)


@pytest.mark.parametrize("make, name, right", RIGHT_OF_OTHERS)
def test_an_unknown_attribute_of_other_objects_names_the_right_one(resting_world, make, name, right):
    with pytest.raises(AttributeError) as caught:
        setattr(make(resting_world), name, 0.5)
    assert right in str(caught.value)


@pytest.mark.parametrize("kind", filter(is_settable, map(vars(hs).get, hs.__all__)))
def test_no_class_takes_an_attribute_that_it_does_not_have(kind):
    with pytest.raises(AttributeError, match=f"{kind.__name__} has no attribute nothing_like_it"):
        kind.__new__(kind).nothing_like_it = 1


def test_a_misspelt_attribute_that_is_read_names_the_right_one(resting_world):
    with pytest.raises(AttributeError, match="World has no attribute velocites; similar: velocities"):
        resting_world.velocites
    with pytest.raises(AttributeError, match="Law has no attribute friction; similar: friction_angle"):
        hs.Law().friction
    with pytest.raises(AttributeError, match="BlockState has no attribute pos; similar: pose"):
        resting_world.state(resting_world.blocks[0]).pos
    resting_world.close()
    with pytest.raises(hs.ClosedError):  # of the property itself
        resting_world.velocities


def test_what_can_be_assigned_is(resting_world):
    resting_world.velocities = resting_world.velocities + 1
    resting_world.keys = [3, 5]
    assert resting_world.velocities[1].tolist() == [1, 1] and resting_world.keys.tolist() == [3, 5]


def test_classes_of_users_have_attributes_of_their_own():
    class Slope(hs.World):
        def __init__(self):
            super().__init__()
            self.base = self.add_material(2000)

    slope = Slope()
    assert slope.base == 0
    with pytest.raises(AttributeError, match=r"use set_gravity\(gravity\)"):
        slope.gravity = (0, 0)


def test_copies_are_made_as_before(resting_world):
    law = dataclasses.replace(hs.Law(), friction_angle=0.5)
    for other in (copy.copy(law), copy.deepcopy(law), pickle.loads(pickle.dumps(law))):
        assert other == law and other.friction_angle == 0.5
    for world in (copy.copy(resting_world), pickle.loads(pickle.dumps(resting_world))):
        assert world.poses.tolist() == resting_world.poses.tolist()
