"""Contacts without springs: the impact of bars, and a block at rest."""
import numpy as np
import pytest

import halfspace as hs

COLUMNS = 10


def test_bars_lose_what_theory_says_and_keep_their_momentum():
    world = hs.World(gravity=(0, 0), law=hs.Law(stiffness_kind=hs.StiffnessKind.NONE))
    world.add_material(1000)
    world.set_elasticity(0, hs.Elasticity(young_modulus=1e9, poisson_ratio=0))
    bar = hs.Mesh.rectangle(1, 1 / COLUMNS, COLUMNS, 1)
    striker = world.add_mesh(bar, (-0.501, 0), velocity=(1, 0, 0))
    struck = world.add_mesh(bar, (0.5, 0))
    assert len(world.contacts()) == 0
    touched = None
    while world.time < 4e-3:
        world.step()
        if touched is None and len(world.contacts()):
            touched = world.contacts()["touched_at"]
    assert touched == pytest.approx(1e-3)
    mass = world.body_state(striker).mass
    assert world.report.impact_loss == pytest.approx(0.5 * mass * 0.25 / COLUMNS, rel=1e-3)
    momentum = world.body_state(striker).momentum + world.body_state(struck).momentum
    assert momentum[0] == pytest.approx(mass, rel=1e-12)
    assert world.body_state(struck).momentum[0] > 0.95 * mass


def test_a_square_rests_with_its_weight():
    world = hs.World(gravity=(0, -10), time_step=1e-3, law=hs.Law(stiffness_kind=hs.StiffnessKind.NONE))
    world.add_material(2000)
    world.add_block(hs.Shape.rectangle(3, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    block = world.add_block(hs.Shape.rectangle(1, 1), (0, 0.55))
    world.step(200)
    contacts = world.contacts()
    sign = np.where(contacts["block_b"] == block, 1, -1)
    assert (sign * contacts["force"][:, 1]).sum() == pytest.approx(20000)
    # The impact loss uses the mean velocity of the step: gravity adds g dt / 2 to 1 m/s.
    assert world.report.impact_loss == pytest.approx(20000 * 0.05, rel=0.011)


def test_friction_opposes_the_sliding_of_a_slab_along_its_diagonal():
    world = hs.World(3, law=hs.Law(stiffness_kind="none", friction_angle=0.2), time_step=1 / 60)
    world.add_material(2500)
    world.add_block(hs.Shape.box(60, 60, 1), (0, 0, -0.5), kind="fixed")
    slab = world.add_block(hs.Shape.box(4, 1, 1), (0, 0, 0.5), velocity=(2, 2, 0))
    world.step(18)
    speed = 2 - np.tan(0.2) * 9.81 * 0.3 / np.sqrt(2)
    assert np.allclose(world.state(slab).velocity, (speed, speed, 0), atol=1e-10)
