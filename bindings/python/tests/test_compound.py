"""Compounds: arguments and results, and a hook at rest compared with theory."""
import numpy as np
import pytest

import halfspace as hs

FOOT = [(0, 0), (3, 0), (3, 1), (0, 1)]
ARM = [(0, 1), (1, 1), (1, 2), (0, 2)]


@pytest.fixture
def world():
    """On a floor, with damped springs."""
    world = hs.World(law=hs.Law(normal_stiffness=1e8, stiffness_kind="per area", normal_damping=0.3))
    world.add_material(2000)
    world.add_block(hs.Shape.rectangle(40, 1), (0, -0.5), kind="fixed")
    return world


def test_a_hook_has_the_mass_and_the_centroid_of_its_parts(world):
    hook = world.add_compound([hs.Shape.polygon(FOOT), hs.Shape.polygon(ARM)])
    state = world.state(hook)
    assert state.mass == pytest.approx(8000)
    assert state.pose.position[:2] == pytest.approx((1.25, 0.75))
    parts = world.compound_parts(hook)
    assert [world.compound_of_block(part) for part in parts] == [(hook, 0), (hook, 1)]
    assert world.compound_of_block(hook) == (0, -1)
    assert list(world.blocks[1:]) == [hook, *parts]
    assert len(world.block_vertices(hook)) == 0 and len(world.block_vertices(parts[0])) == 4


def test_a_hook_comes_to_rest_on_its_foot(world):
    hook = world.add_compound([hs.Shape.polygon(FOOT), hs.Shape.polygon(ARM)], position=(0, 0.75))
    at_rest, _ = world.relax(1e-7)
    assert at_rest
    assert world.state(hook).force[1] == pytest.approx(8000 * 9.81, rel=1e-5)
    touching = world.contacts()
    assert touching["block_b"].tolist() == [world.compound_parts(hook)[0]]
    assert world.plot() is not None


def test_poses_of_parts_are_in_one_frame(world):
    square = hs.Shape.rectangle(1, 1)
    poses = np.array([hs.pose((0, 0)), hs.pose((2, 0), np.pi / 4)])
    block = world.add_compound([square, square], poses, (5, 5), np.pi / 2, kind="prescribed", velocity=(0, 1))
    places = [world.state(part).pose.position[:2] for part in world.compound_parts(block)]
    assert places[0] == pytest.approx((5, 4)) and places[1] == pytest.approx((5, 6))


def test_what_cannot_be_a_compound_is_refused(world):
    square = hs.Shape.rectangle(1, 1)
    with pytest.raises(ValueError, match="shapes is empty"):
        world.add_compound([])
    with pytest.raises(ValueError, match=r"poses has the shape \(1, 7\); it must be \(2, 7\)"):
        world.add_compound([square, square], [hs.pose((0, 0))])
    with pytest.raises(hs.GeometryError, match="overlap by 0.5"):
        world.add_compound([square, square], [hs.pose((0, 0)), hs.pose((0.5, 0))])
    with pytest.raises(hs.ArgumentError, match="def.kind is 3"):
        world.add_compound([square], kind="affine")
    with pytest.raises(hs.StateError, match="only the compound can be changed"):
        world.remove_block(world.compound_parts(world.add_compound([square], position=(9, 9)))[0])
