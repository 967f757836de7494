import copy
import pickle
import signal
import threading

import numpy as np
import pytest

import halfspace as hs


def test_a_square_comes_to_rest(resting_world):
    resting_world.step(3000)
    state = resting_world.state(int(resting_world.blocks[1]))
    assert state.pose.position[1] == pytest.approx(0.5 - 2000 * 9.81 / 1e7, abs=1e-9)
    contact = resting_world.contacts()[0]
    assert hs.ContactType(contact.type) is hs.ContactType.EDGE_EDGE
    assert contact.normal_force == pytest.approx(2000 * 9.81, rel=1e-6)
    report = resting_world.report
    assert (report.steps, report.block_count, report.contact_count) == (3000, 2, 1)
    assert resting_world.time == pytest.approx(3)
    energy = resting_world.energy
    # The potential energy of the fall of 0.01 m and of the static deflection goes into dashpot and spring; the impact
    # begins within a step.
    fallen = 2000 * 9.81 * (0.51 - state.pose.position[1])
    assert energy.contact_damping_loss + energy.strain == pytest.approx(fallen, rel=0.05)
    assert repr(resting_world) == "<halfspace.World, 2D: 2 blocks>"


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_snapshot_goes_on_bit_for_bit(dimension):
    shape = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    world = hs.World(dimension, law=hs.Law(normal_stiffness=1e7, friction_angle=0.5), time_step=1e-3)
    world.add_material(2000)
    for i in range(4):
        world.add_block(shape, (0.1 * i, 1.05 * i, 0), kind=hs.BlockKind.RIGID if i else hs.BlockKind.FIXED)
    world.step(300)
    copies = [
        hs.World.restore(world.save()),
        hs.World.restore(bytearray(world.save()), context=hs.Context()),
        pickle.loads(pickle.dumps(world)),
        copy.copy(world),
    ]
    world.step(300)
    for other in copies:
        assert other.dimension == dimension
        other.step(300)
        assert np.array_equal(other.poses, world.poses)
        assert np.array_equal(other.blocks, world.blocks)
        assert other.positions.shape == (4, dimension)
    with pytest.raises(hs.FormatError, match="checksum"):
        damaged = bytearray(world.save())
        damaged[-1] ^= 1
        hs.World.restore(damaged)


def test_a_copy_is_in_the_same_context():
    with hs.Context() as context:
        world = hs.World(context=context)
        copies = copy.copy(world), copy.deepcopy([world])[0]
        assert all(other.context is context and other is not world for other in copies)
        assert pickle.loads(pickle.dumps(world)).context is hs.default_context()
    assert all(other.closed for other in copies)


def test_stages_are_what_a_step_does(resting_world):
    """Velocity Verlet by hand, in the order of the library's own step."""
    world, twin = resting_world, copy.copy(resting_world)
    step, mass, gravity = 1e-3, 2000.0, np.array([0, -9.81])
    twin.set_default_law(hs.Law(normal_stiffness=1e7, normal_damping=0))
    world.set_default_law(hs.Law(normal_stiffness=1e7, normal_damping=0))
    world.detect()
    acceleration = gravity + world.forces(0.0)[0][1] / mass
    position, velocity = world.positions[1].copy(), np.zeros(2)
    for _ in range(500):
        velocity += 0.5 * step * acceleration
        position += step * velocity
        world.set_pose(int(world.blocks[1]), position)
        world.detect()
        acceleration = gravity + world.forces(step)[0][1] / mass
        velocity += 0.5 * step * acceleration
    twin.step(500)
    assert position == pytest.approx(twin.positions[1], abs=1e-10)
    assert velocity == pytest.approx(twin.velocities[1], abs=1e-8)


def test_many_steps_are_so_many_single_ones(resting_world):
    twin = copy.copy(resting_world)
    resting_world.step(1000)
    for _ in range(1000):
        twin.step()
    assert np.array_equal(resting_world.poses, twin.poses)
    resting_world.step(0)
    assert resting_world.report.steps == 1000
    with pytest.raises(hs.ArgumentError, match="hs_world_step: steps is -1"):
        resting_world.step(-1)


def test_a_plan_says_what_is_active_and_limits_the_step(resting_world):
    resting_world.step(1000)
    plan = resting_world.plan(steps=10)
    parts = hs.WorldPart(int(plan.parts))
    assert hs.WorldPart.FRICTION in parts and hs.WorldPart.STRAIN not in parts
    assert (plan.fixed_count, plan.rigid_count, plan.contact_count, plan.measured_steps) == (1, 1, 1, 10)
    assert plan.limiting_block == resting_world.blocks[1] and plan.limiting_neighbor == resting_world.blocks[0]
    assert plan.stable_time_step == resting_world.report.stable_time_step
    assert plan.pair_seconds > 0
    assert resting_world.report.steps == 1000


def test_a_long_run_can_be_interrupted(resting_world):
    main = threading.main_thread().ident
    timer = threading.Timer(0.3, signal.pthread_kill, (main, signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        resting_world.step(10**9)
    steps = resting_world.report.steps
    assert steps > 0
    resting_world.step(1)
    assert resting_world.report.steps == steps + 1


def test_a_relaxation_can_be_interrupted(resting_world):
    timer = threading.Timer(0.3, signal.pthread_kill, (threading.main_thread().ident, signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        resting_world.relax(1e-300, max_steps=10**8)
    timer.join()
    steps = resting_world.report.steps
    assert 0 < steps < 10**8


def test_a_relaxation_counts_all_its_steps(resting_world):
    steps = resting_world.report.steps
    is_at_rest, balance = resting_world.relax(1e-300, max_steps=50001)
    assert not is_at_rest and balance.steps == 50001 == resting_world.report.steps - steps


def test_setting_poses(resting_world):
    poses = resting_world.poses
    poses[1, :2] += 3
    resting_world.poses = poses
    assert np.array_equal(resting_world.positions[1], [3.125, 3.51])
    resting_world.set_pose(int(resting_world.blocks[1]), (1, 2), 0.5)
    assert resting_world.poses[1, 5] == pytest.approx(np.sin(0.25))
    block = int(resting_world.blocks[1])
    for twice in (dict(angle=0.5), dict(rotation=(0, 0, 0, 1))):
        with pytest.raises(ValueError, match="position has 7 numbers"):
            resting_world.set_pose(block, hs.pose((1, 2)), **twice)
    with pytest.raises(ValueError, match=r"poses has the shape \(2, 3\)"):
        resting_world.poses = poses[:, :3]
    with pytest.raises(hs.ArgumentError, match="count is 1; the world has 2 blocks"):
        resting_world.poses = poses[:1]


def test_where_a_block_is_added():
    world = hs.World()
    world.add_material(1)
    triangle = hs.Shape.polygon([(3, 0), (6, 0), (3, 3)])
    as_given = world.add_block(triangle)
    turned = world.add_block(triangle, angle=np.pi / 2, velocity=(1, 2), angular_velocity=3)
    assert world.block_vertices(as_given) == pytest.approx(np.array([(3, 0), (6, 0), (3, 3)]))
    assert world.block_vertices(turned) == pytest.approx(np.array([(5, 0), (5, 3), (2, 0)]))
    state = world.state(turned)
    assert state.velocity.tolist() == [1, 2, 0] and state.angular_velocity[2] == 3
    many = hs.Shape.polygon([(np.cos(a), np.sin(a)) for a in np.arange(100) * 2 * np.pi / 100])
    assert world.block_vertices(world.add_block(many)).shape == (100, 2)


def test_a_prescribed_block_moves_as_told():
    world = hs.World(3, time_step=0.25)
    world.add_material(1)
    block = world.add_block(
        hs.Shape.box(1, 1, 1), (0, 0, 0), kind=hs.BlockKind.PRESCRIBED, velocity=(0, 0, 2)
    )
    world.step(4)
    assert world.positions.tolist() == [[0, 0, 2]]
    world.set_velocity(block, (0, 0, 0), (1, 0, 0))
    assert world.angular_velocities.tolist() == [[1, 0, 0]]


def test_an_applied_force_and_a_preloaded_spring(resting_world):
    floor, block = map(int, resting_world.blocks)
    resting_world.set_pose(block, (0, 0.499))
    resting_world.set_applied_force(block, (0, 2000 * 9.81 - 1e4), torque=0.0)
    resting_world.detect()
    resting_world.set_shear_force(floor, block, (1000, 0))
    assert resting_world.forces(0.0)[0][1] == pytest.approx([1000, 1e4])


def test_an_empty_world():
    world = hs.World()
    assert len(world) == 0 and world
    assert world.poses.shape == (0, 7) and world.velocities.shape == (0, 2) and len(world.contacts()) == 0
    assert world.detect() == 0
    assert world.forces(0.0)[0].shape == (0, 2)
