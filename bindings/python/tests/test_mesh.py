"""Bodies of finite elements: in and out, and at rest where theory wants them."""
import copy

import numpy as np
import pytest

import halfspace as hs


@pytest.fixture
def bar():
    """A bar of 4 x 1 squares along x, held at its left end, without gravity; its world, body and node places."""
    world = hs.World(gravity=(0, 0))
    world.add_material(2000)
    world.set_elasticity(0, hs.Elasticity(young_modulus=1e6, poisson_ratio=0))
    body = world.add_mesh(hs.Mesh.rectangle(4, 1, 4, 1))
    nodes = world.node_positions(body)
    world.hold_nodes(body, np.flatnonzero(nodes[:, 0] < -1.9))
    return world, body, nodes


def test_a_bar_is_stretched_as_hooke_says(bar):
    world, body, nodes = bar
    right = np.flatnonzero(nodes[:, 0] > 1.9)
    world.set_node_force(body, right, (500, 0))
    at_rest, balance = world.relax(1e-7)
    assert at_rest and balance["mean"] <= 1e-7
    stretch = (world.node_positions(body) - nodes)[right, 0]
    # The second Piola stress is linear in Green's strain: E e (1 + e) (1 + e / 2) is the force over the area.
    roots = np.roots([0.5, 1.5, 1, -1e-3])
    strain = float(roots[np.isreal(roots) & (roots.real > 0)][0].real)
    assert stretch == pytest.approx(4 * strain, rel=1e-5)
    assert world.cells(body)["stress"][:, 0, 0] == pytest.approx(1000, rel=2e-3)
    left = np.flatnonzero(nodes[:, 0] < -1.9)
    assert world.node_forces(body)[left, 0].sum() == pytest.approx(1000, rel=1e-5)
    assert world.body_state(body).mass == pytest.approx(8000)


def test_nodes_go_in_and_out(bar):
    world, body, nodes = bar
    velocities = np.arange(nodes.size, dtype=float).reshape(nodes.shape)
    world.set_node_velocities(body, velocities)
    assert np.array_equal(world.node_velocities(body), velocities)
    twin = copy.copy(world)
    world.step(10)
    twin.step(10)
    assert np.array_equal(world.node_positions(body), twin.node_positions(body))
    with pytest.raises(hs.ArgumentError, match="velocities.count is 3"):
        world.set_node_velocities(body, velocities[:3])
    with pytest.raises(hs.ArgumentError, match=r"nodes\[0\] is 99"):
        world.hold_nodes(body, [99])


def test_blocks_at_the_surface_know_their_body(bar):
    world, body, _ = bar
    assert {world.body_of_block(int(block))[0] for block in world.blocks} == {body}
    block = int(world.blocks[0])
    assert world.state(block).kind == hs.BlockKind.MESH
    with pytest.raises(hs.StateError, match="of a mesh"):
        world.remove_block(block)
    world.remove_body(body)
    assert len(world) == 0
    with pytest.raises(hs.StaleIdError):
        world.node_positions(body)


def test_every_kind_of_cell_has_its_volume():
    square, cube = [(0, 0), (1, 0), (1, 1), (0, 1)], []
    for z in (0, 1):
        cube += [(x, y, z) for x, y in square]
    assert hs.Mesh(square, [[(0, 1, 2), (0, 2, 3)]]).volume == pytest.approx(1)
    assert hs.Mesh(square, [[(0, 1, 2, 3)]]).volume == pytest.approx(1)
    assert hs.Mesh(cube, [[range(8)]]).volume == pytest.approx(1)
    prisms = [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]
    assert hs.Mesh(cube, [prisms]).volume == pytest.approx(1)
    mixed = hs.Mesh(square + [(2, 0)], [[(1, 4, 2)], [(0, 1, 2, 3)]])
    assert mixed.volume == pytest.approx(1.5) and mixed.cell_count == 2


@pytest.mark.parametrize(
    "nodes, cells, text",
    [
        ([(0, 0), (1, 0), (0, 1)], [[(0, 2, 1)]], "cell 0 is inside out"),
        ([(0, 0), (1, 0), (0, 1), (5, 5)], [[(0, 1, 2)]], r"nodes\[3\] = \(5, 5\) belongs to no cell"),
        ([(0, 0), (1, 0), (0, 1)], [[(0, 1, 1)]], "names node 1 twice"),
    ],
)
def test_what_is_no_mesh_is_refused(nodes, cells, text):
    with pytest.raises(hs.GeometryError, match=text):
        hs.Mesh(nodes, cells)


def test_a_cell_turned_inside_out_ends_the_run():
    world = hs.World(gravity=(0, 0), time_step=1e-3)
    world.add_material(2000)
    world.set_elasticity(0, hs.Elasticity())
    body = world.add_mesh(hs.Mesh([(0, 0), (1, 0), (0, 1)], [[(0, 1, 2)]]))
    world.hold_nodes(body, [0, 1])
    world.hold_nodes(body, [2], velocity=(0, -1500))
    with pytest.raises(hs.InvertedError, match="cell 0 of body"):
        world.step()
