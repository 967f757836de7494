"""Affine blocks: tensors are arrays of rows."""
import copy

import numpy as np
import pytest

import halfspace as hs

#: By 1.25 along x, then turned by a right angle: what was x goes along y.
STRETCHED_AND_TURNED = np.array([(0, -1.0, 0), (1.25, 0, 0), (0, 0, 1)])


@pytest.fixture
def affine_world(square):
    """An affine square whose material has 1e6 for both of Lame's constants, and a rigid one."""
    world = hs.World(gravity=(0, 0), time_step=1e-3)
    rubber = world.add_material(1000)
    world.set_elasticity(rubber, hs.Elasticity(young_modulus=2.5e6))
    world.add_block(square, (3, 4), kind=hs.BlockKind.AFFINE)
    world.add_block(square, (9, 9), 0.5)
    return world


def test_a_gradient_is_rows_first(affine_world):
    block = int(affine_world.blocks[0])
    rate = np.array([(1.0, 2), (3, 4)])
    affine_world.set_deformation(block, STRETCHED_AND_TURNED[:2, :2], rate)
    # The vertex (1/2, -1/2) of the shape goes to (1/2, 5/8) from the centroid.
    assert affine_world.block_vertices(block)[1].tolist() == [3.5, 4.625]
    deformation = affine_world.deformation(block)
    assert np.array_equal(deformation.gradient, STRETCHED_AND_TURNED)
    assert np.array_equal(deformation.rate[:2, :2], rate) and not deformation.rate[2].any()
    affine_world.set_deformation(block, STRETCHED_AND_TURNED.T.copy("F").T)
    assert np.array_equal(affine_world.deformation(block).gradient, STRETCHED_AND_TURNED)
    assert not affine_world.deformation(block).rate.any()


def test_strain_and_stress_are_those_of_the_gradient(affine_world):
    """Green strain and the stress by Hooke's law, computed here."""
    block = int(affine_world.blocks[0])
    gradient = np.array([(1.25, 0.5), (-0.125, 0.875)])
    affine_world.set_deformation(block, gradient)
    strain = (gradient.T @ gradient - np.eye(2)) / 2
    inner = 1e6 * np.trace(strain) * np.eye(2) + 2e6 * strain
    deformation = affine_world.deformation(block)
    assert deformation.strain[:2, :2] == pytest.approx(strain, abs=1e-15)
    stress = gradient @ inner @ gradient.T / np.linalg.det(gradient)
    assert deformation.stress[:2, :2] == pytest.approx(stress, rel=1e-13, abs=1e-8)
    assert deformation.strain_energy == pytest.approx(np.sum(strain * inner) / 2, rel=1e-13)
    assert affine_world.report.block_strain_energy == deformation.strain_energy


def test_all_blocks_are_those_one_by_one(affine_world):
    affine, rigid = map(int, affine_world.blocks)
    affine_world.set_deformation(affine, STRETCHED_AND_TURNED)
    deformations = affine_world.deformations()
    assert deformations["gradient"].shape == (2, 3, 3)
    assert deformations[0] == affine_world.deformation(affine)
    assert deformations[1] == affine_world.deformation(rigid)
    turned = [(np.cos(0.5), -np.sin(0.5)), (np.sin(0.5), np.cos(0.5))]
    assert deformations["gradient"][1, :2, :2] == pytest.approx(np.array(turned), abs=1e-15)
    assert deformations["strain_energy"][1] == 0
    assert hs.World().deformations().shape == (0,)


def test_a_strained_world_goes_on_bit_for_bit(affine_world):
    affine = int(affine_world.blocks[0])
    affine_world.set_stress(affine, np.diag([-1e3, 0]))
    affine_world.add_surface_load(affine, 0, (0, 1e3))
    affine_world.step(10)
    twin = copy.copy(affine_world)
    affine_world.step(10)
    twin.step(10)
    assert affine_world.deformation(affine).rate.any()
    assert np.array_equal(affine_world.deformations(), twin.deformations())


def test_loads_on_faces_are_taken_off_again(affine_world):
    affine = int(affine_world.blocks[0])
    affine_world.add_surface_load(affine, 1, (1e3, 0))
    affine_world.clear_surface_loads(affine)
    affine_world.step()
    assert not affine_world.velocities.any() and not affine_world.deformation(affine).rate.any()
    affine_world.add_surface_load(affine, 1, (1e3, 0))
    affine_world.step()
    assert affine_world.velocities[0] == pytest.approx([1e-3, 0])  # 1000 N on 1000 kg


@pytest.mark.parametrize("wrong", [np.eye(4), np.ones((2, 3)), [1, 0, 0, 1], 1.0])
def test_a_tensor_has_two_rows_of_two_or_three_of_three(affine_world, wrong):
    block = int(affine_world.blocks[0])
    with pytest.raises(ValueError, match="gradient has the shape"):
        affine_world.set_deformation(block, wrong)
    with pytest.raises(ValueError, match="rate has the shape"):
        affine_world.set_deformation(block, np.eye(2), wrong)
    with pytest.raises(ValueError, match="stress has the shape"):
        affine_world.set_stress(block, wrong)


def test_what_is_not_affine_is_not_strained(affine_world):
    affine, rigid = map(int, affine_world.blocks)
    for refused in (
        lambda: affine_world.set_deformation(rigid, np.eye(2)),
        lambda: affine_world.set_stress(rigid, np.eye(2)),
        lambda: affine_world.add_surface_load(rigid, 0, (1, 0)),
        lambda: affine_world.clear_surface_loads(rigid),
    ):
        with pytest.raises(hs.StateError, match="is not affine"):
            refused()
    with pytest.raises(hs.ArgumentError, match="face is 4; the block has 4"):
        affine_world.add_surface_load(affine, 4, (1, 0))
    with pytest.raises(ValueError, match="face is 4294967296"):
        affine_world.add_surface_load(affine, 2**32, (1, 0))
    with pytest.raises(hs.ArgumentError, match="plane is 1; it must be HS_PLANE_STRAIN in 3D"):
        world = hs.World(3)
        world.set_elasticity(world.add_material(1), hs.Elasticity(plane=hs.Plane.STRESS))
