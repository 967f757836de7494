"""Arrays are passed without a copy, and results are written into arrays of the caller."""
import tracemalloc

import numpy as np
import pytest

import halfspace as hs
from halfspace._arrays import indices, mutable_view_of, turns_view_of, view_of

OUTLINE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)])


def strided_versions(points):
    """The same points as slices, transposes, fields of structs and in reverse."""
    count, width = points.shape
    wide = np.zeros((2 * count, width + 3))
    wide[::2, 1 : 1 + width] = points
    struct = np.zeros(count, [("id", "i8"), ("x", "f8", (width,)), ("mass", "f8")])
    struct["x"] = points
    mirrored = np.ascontiguousarray(points[:, ::-1])
    return {
        "contiguous": points,
        "Fortran order": np.asfortranarray(points),
        "transpose of (d, n)": np.ascontiguousarray(points.T).T,
        "every second row, inner columns": wide[::2, 1 : 1 + width],
        "backwards": np.ascontiguousarray(points[::-1])[::-1],
        "columns backwards": mirrored[:, ::-1],
        "field of a structured array": struct["x"],
    }


@pytest.mark.parametrize("name", strided_versions(OUTLINE))
def test_strided_input_is_not_copied(name):
    array = strided_versions(OUTLINE)[name]
    view = view_of(array, 2, "points")
    assert view.array is array
    assert view.count == 4
    for i in range(4):
        x = np.ctypeslib.as_array(view.x, (1,)).__array_interface__["data"][0] + i * view.stride
        assert x == array[i, 0:1].__array_interface__["data"][0]
    assert np.array_equal(hs.Shape.polygon(array).vertices, OUTLINE)


def test_a_large_strided_array_takes_no_memory():
    poses = np.zeros((100_000, 5))
    poses[:, 0] = np.arange(100_000)
    poses[:, 1] = poses[:, 0] % 2
    points = poses[::2, 0:4:3]  # 50000 points of a stride of 80 bytes
    tracemalloc.start()
    view = view_of(points, 2, "points")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert view.array is points
    assert peak < 10_000  # a copy would take 800000 bytes


@pytest.mark.parametrize(
    "points",
    [OUTLINE.tolist(), OUTLINE.astype(np.float32), OUTLINE.astype(">f8"), OUTLINE.astype(int)],
    ids=["list", "float32", "big-endian", "int"],
)
def test_what_is_not_float64_is_converted(points):
    assert hs.Shape.polygon(points).volume == 2


def test_steps_that_are_not_whole_doubles_are_copied():
    packed = np.zeros(4, [("x", "f8", (2,)), ("flag", "i4")])  # 20 bytes each
    packed["x"] = OUTLINE
    assert hs.Shape.polygon(packed["x"]).volume == 2


def test_z_is_ignored_in_2d_and_needed_in_3d():
    with_z = np.column_stack((OUTLINE, np.full(4, np.nan)))
    assert hs.Shape.polygon(with_z).volume == 2
    with pytest.raises(ValueError, match=r"points has the shape \(4, 4\); it must be \(n, 2\)"):
        hs.Shape.hull(np.zeros((4, 4)))
    with pytest.raises(ValueError, match=r"vertices has the shape \(4, 2\); it must be \(n, 3\)"):
        hs.Shape.polyhedron(OUTLINE, [])


def test_angular_velocities_in_2d_are_one_number_each(resting_world):
    numbers = np.arange(8.0)[::4]
    assert turns_view_of(numbers, 2, "turns").array.base is not None
    resting_world.set_velocities(np.array([(9.0, 9.0), (1.0, 2.0)]), numbers)
    assert np.array_equal(resting_world.angular_velocities, [0, 4])
    assert np.array_equal(resting_world.velocities, [(0, 0), (1, 2)])
    resting_world.angular_velocities = [0, 5]
    assert resting_world.state(int(resting_world.blocks[1])).angular_velocity[2] == 5
    assert np.array_equal(resting_world.velocities, [(0, 0), (1, 2)])


def test_output_into_arrays_of_the_caller(resting_world):
    resting_world.step(3000)
    host = np.full((2, 6), np.nan, order="F")
    torques = np.full(2, np.nan)
    resting_world.detect()
    forces, turned = resting_world.forces(0.0, host[:, 1:3], torques)
    assert forces.base is host and turned is torques
    assert host[1, 2] == pytest.approx(2000 * 9.81, rel=1e-3)
    assert np.isnan(host[:, [0, 3, 4, 5]]).all() and np.isfinite(torques).all()
    fresh, fresh_torques = resting_world.forces(0.0)
    assert np.array_equal(fresh, forces) and np.array_equal(fresh_torques, torques)

    poses = np.zeros((2, 7))
    assert resting_world.get_poses(poses) is poses
    assert np.array_equal(poses, resting_world.poses)
    assert np.array_equal(poses[:, :2], resting_world.positions)


@pytest.mark.parametrize(
    "wrong",
    [
        np.zeros((2, 2), np.float32),
        np.broadcast_to(0.0, (2, 2)),
        [[0, 0], [0, 0]],
        np.zeros((2, 4)),
        np.zeros((1, 2)),
    ],
    ids=["float32", "one number in all places", "list", "4 columns", "1 row"],
)
def test_output_that_cannot_be_written_is_refused(resting_world, wrong):
    resting_world.detect()
    with pytest.raises(ValueError):
        resting_world.forces(0.0, wrong)


@pytest.mark.parametrize(
    "wrong",
    [np.zeros(2, np.float32), np.zeros(2, int), np.broadcast_to(0.0, 2), [0.0, 0.0], np.zeros(1)],
    ids=["float32", "int", "read-only", "list", "1 number"],
)
def test_torques_that_cannot_be_written_are_refused_before_the_call(resting_world, wrong):
    resting_world.step(200)  # in contact: a call would let the springs grow
    resting_world.set_velocities([(0, 0), (1, 0)], [0, 0])
    resting_world.detect()
    before = resting_world.save()
    with pytest.raises(ValueError, match="torques_out"):
        resting_world.forces(1e-3, None, wrong)
    assert resting_world.save() == before


@pytest.mark.parametrize("wrong", [(1, 2), (1, 2, 3, 4), [5], [[1, 2, 3]]])
def test_a_turn_is_one_number_or_three(resting_world, square, wrong):
    block = int(resting_world.blocks[1])
    with pytest.raises(ValueError, match="angular_velocity has the shape"):
        resting_world.set_velocity(block, (0, 0), wrong)
    with pytest.raises(ValueError, match="torque has the shape"):
        resting_world.set_applied_force(block, (0, 0), wrong)
    with pytest.raises(ValueError, match="angular_velocity has the shape"):
        resting_world.add_block(square, angular_velocity=wrong)


@pytest.mark.parametrize("add", [-(2**64), 2**64])
def test_a_number_of_more_than_64_bits_names_no_block(resting_world, add):
    floor, block = map(int, resting_world.blocks)
    resting_world.step(200)
    wrong = block + add  # the same 64 bits
    for use in (
        resting_world.remove_block,
        resting_world.state,
        resting_world.block_vertices,
        lambda block: resting_world.set_pose(block, (0, 0)),
        lambda block: resting_world.set_velocity(block, (0, 0)),
        lambda block: resting_world.set_applied_force(block, (0, 0)),
        lambda block: resting_world.set_shear_force(floor, block, (0, 0)),
        resting_world.deformation,
        lambda block: resting_world.set_deformation(block, np.eye(2)),
        lambda block: resting_world.set_stress(block, np.eye(2)),
        lambda block: resting_world.add_surface_load(block, 0, (0, 0)),
        resting_world.clear_surface_loads,
        lambda block: resting_world.set_shear_force(block, floor, (0, 0)),
    ):
        with pytest.raises(ValueError, match=f"is {wrong}; it must be an unsigned 64-bit integer"):
            use(wrong)


def test_whole_numbers_are_whole_and_fit(resting_world, square):
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    with pytest.raises(ValueError, match=r"faces\[0\] must be 32-bit integers"):
        hs.Shape.polyhedron(corners, [(0, 2, 1.5), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    with pytest.raises(ValueError, match="pairs must be 32-bit integers"):
        hs.pairs_detect([square] * 2, [hs.pose((0, 0))] * 2, [(0, 2**32 + 1)])
    with pytest.raises(ValueError, match="material is 4294967296"):
        resting_world.add_block(square, material=2**32)
    with pytest.raises(TypeError):
        resting_world.step(1e6)
    pairs = np.zeros((1, 2), np.int32)
    assert indices(pairs, "pairs") is pairs


def test_an_output_view_points_to_the_array():
    array = np.zeros((3, 3), order="F")
    view = mutable_view_of(array, 3, "out")
    view.z[0] = 7
    assert array[0, 2] == 7


def test_structured_arrays_have_their_fields_as_attributes(resting_world):
    resting_world.step(500)
    contacts = resting_world.contacts()
    assert len(contacts) > 0
    assert contacts.gap.shape == (len(contacts),) and (contacts.gap == contacts["gap"]).all()
    assert contacts.points.shape == (len(contacts), 8, 3)
    assert contacts[0].gap == contacts.gap[0]
    assert contacts[:0].gap.shape == (0,)


def test_structured_arrays_match_the_header():
    assert hs.CONTACT.itemsize == 496
    assert np.zeros(2, hs.CONTACT)["points"].shape == (2, 8, 3)
    assert hs.CONTACT.fields["normal"][1] == 40
    assert hs.PAIR_CACHE.itemsize == 120
    assert hs.DEFORMATION.itemsize == 296
    assert hs.DEFORMATION.fields["stress"][1] == 216


def test_ids_are_unsigned_64_bit_numbers(resting_world):
    blocks = resting_world.blocks
    assert blocks.dtype == np.uint64 and len(blocks) == 2
    resting_world.step(200)
    contact = resting_world.contacts()[0]
    assert contact.block_a == blocks[0] and contact.block_b == blocks[1]
    assert resting_world.state(contact.block_b).mass == pytest.approx(2000)


@pytest.mark.parametrize("dimension", [2, 3])
def test_forces_of_all_blocks_in_and_out(dimension):
    """Weights of 2000 kg are held by applied forces, and a torque turns a block by T t / I."""
    world = hs.World(dimension, time_step=1e-3)
    world.add_material(2000)
    size = (1,) * dimension
    box = hs.Shape.rectangle(*size) if dimension == 2 else hs.Shape.box(*size)
    up = np.eye(dimension)[-1]
    world.add_block(box, -5 * up, kind="fixed")
    for i in range(3):
        world.add_block(box, 2 * i * up)
    torques = np.zeros(4) if dimension == 2 else np.zeros((4, 3))
    torques[2] = 100
    world.set_applied_forces(np.tile(2000 * 9.81 * up, (4, 1)), torques)
    world.step(100)
    assert world.velocities == pytest.approx(np.zeros((4, dimension)), abs=1e-12)
    turned = world.angular_velocities[2]
    assert turned == pytest.approx(100 * 0.1 / (2000 / 6) * np.ones(np.shape(turned)), rel=1e-6)
    assert world.contact_forces.shape == (4, dimension) and not world.contact_forces.any()
    world.set_applied_forces(np.zeros((4, dimension)))
    world.step(10)
    assert world.velocities[1:, -1] == pytest.approx(-9.81 * 0.01, rel=1e-9)
    states = world.states()
    assert states.mass[1:].tolist() == [2000] * 3 and states.kind[0] == hs.BlockKind.FIXED
    assert all(state == world.state(block) for state, block in zip(states, world.blocks.tolist()))
    with pytest.raises(hs.ArgumentError, match="forces.count is 3; the world has 4 blocks"):
        world.set_applied_forces(np.zeros((3, dimension)))
    with pytest.raises(hs.ArgumentError, match="torques.count is 2"):
        world.set_applied_forces(np.zeros((4, dimension)), torques[:2])
    with pytest.raises(hs.ArgumentError, match="forces.1. is .*nan"):
        world.set_applied_forces(np.where(np.arange(4)[:, None] == 1, np.nan, np.ones((4, dimension))))


def test_contact_forces_balance_the_weight(resting_world):
    resting_world.relax()
    assert resting_world.contact_forces[1] == pytest.approx([0, 2000 * 9.81], rel=1e-3, abs=1)
    assert resting_world.contact_forces.sum(axis=0) == pytest.approx([0, 0], abs=1e-6)
    assert resting_world.contact_torques.shape == (2,)
