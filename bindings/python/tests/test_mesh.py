"""Bodies of finite elements: arguments and results, and equilibrium compared with theory."""
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
    # The second Piola-Kirchhoff stress is linear in the Green strain: the force divided by the area is E e (1 + e) (1
    # + e / 2).
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
        ([(0, 0), (1, 0), (0, 1)], [[(0, 1, 1)]], "has node 1 twice"),
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


DENSITY, MODULUS, GRAVITY, HEIGHT = 2000, 1e8, 10, 4


def hexahedra(counts, size):
    """A box of equal hexahedra about the origin."""
    axes = [np.linspace(-0.5, 0.5, n + 1) * length for n, length in zip(counts, size)]
    z, y, x = np.meshgrid(*reversed(axes), indexing="ij")
    names = np.arange(x.size).reshape(x.shape)
    low = [names[:-1, :-1, :-1], names[:-1, :-1, 1:], names[:-1, 1:, 1:], names[:-1, 1:, :-1]]
    high = [names[1:, :-1, :-1], names[1:, :-1, 1:], names[1:, 1:, 1:], names[1:, 1:, :-1]]
    cells = np.stack([corner.ravel() for corner in low + high], axis=1)
    return hs.Mesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), [cells])


@pytest.fixture(params=["plane", "space"])
def ground(request):
    """Ground in equilibrium under its own weight from the start, held at its sides and its bottom; its top is at 0."""
    in_plane = request.param == "plane"
    dimension = 2 if in_plane else 3
    world = hs.World(dimension, gravity=(0, -GRAVITY) if in_plane else (0, 0, -GRAVITY))
    world.add_material(DENSITY)
    world.set_elasticity(0, hs.Elasticity(young_modulus=MODULUS, poisson_ratio=0))
    mesh = hs.Mesh.rectangle(4, HEIGHT, 4, 8) if in_plane else hexahedra((2, 2, 8), (2, 2, HEIGHT))
    body = world.add_mesh(mesh, (0, -HEIGHT / 2) if in_plane else (0, 0, -HEIGHT / 2))
    nodes = world.node_positions(body)
    up = dimension - 1
    for axis in range(dimension):
        ends = [nodes[:, axis].min()] + ([nodes[:, axis].max()] if axis != up else [])
        world.hold_nodes(body, np.flatnonzero(np.isin(nodes[:, axis], ends)), "xyz"[axis])
    gradient = np.zeros((3, 3, 3))
    gradient[up] = np.diag([0.5, 0.5, 1.0]) if up == 2 else np.diag([0.5, 1.0, 0.0])
    world.set_body_stress(body, np.zeros((3, 3)), DENSITY * GRAVITY * gradient)
    return world, body, nodes, up


def test_ground_is_at_rest_under_the_stress_that_it_was_given(ground):
    world, body, nodes, up = ground
    assert world.balance["mean"] < 1e-12
    stress = world.cells(body)["stress"]
    assert stress[:, up, up].min() == pytest.approx(-DENSITY * GRAVITY * (HEIGHT - 0.25))
    assert stress[:, 0, 0] == pytest.approx(0.5 * stress[:, up, up])
    world.step(200)
    assert np.abs(world.node_positions(body) - nodes).max() < 1e-12
    assert world.cells(body)["stress"] == pytest.approx(stress, rel=1e-6, abs=1e-2)


def heights_of_cells(world, body, up):
    """Heights of the centers of cells, from their initial stress."""
    return world.cells(body)["stress"][:, up, up] / (DENSITY * GRAVITY)


def test_what_is_excavated_lets_the_ground_heave(ground):
    world, body, nodes, up = ground
    upper = np.flatnonzero(heights_of_cells(world, body, up) > -HEIGHT / 2)
    released = world.remove_cells(body, upper)
    # The upper half loaded the lower one by its weight.
    width = world.body_state(body).mass / (DENSITY * HEIGHT / 2)
    at_cut = np.flatnonzero(np.abs(nodes[:, up] + HEIGHT / 2) < 1e-9)
    assert released[at_cut, up].sum() == pytest.approx(-width * DENSITY * GRAVITY * HEIGHT / 2)
    assert not world.cells(body)["stress"][upper].any()
    # Gradual and sudden release have the same result.
    twin = copy.copy(world)
    for share in (0.5, 0):
        for node in at_cut:
            twin.set_node_force(body, [node], share * released[node])
        assert twin.relax(1e-9)[0]
    assert world.relax(1e-9)[0]
    # The lower half expands by the removed weight divided by its modulus; the strain is 4e-4.
    heave = DENSITY * GRAVITY * (HEIGHT / 2) ** 2 / MODULUS
    for one in (world, twin):
        assert (one.node_positions(body) - nodes)[at_cut, up] == pytest.approx(heave, rel=1e-3)
    left = np.setdiff1d(np.arange(len(world.cells(body))), upper)
    assert world.cells(body)["stress"][left, up, up].max() == pytest.approx(-DENSITY * GRAVITY * 0.25, rel=1e-2)


def test_a_block_falls_onto_what_has_become_surface(ground):
    world, body, nodes, up = ground
    upper = np.flatnonzero(heights_of_cells(world, body, up) > -HEIGHT / 2)
    world.remove_cells(body, upper)
    world.set_default_law(hs.Law(stiffness_kind=hs.StiffnessKind.PER_AREA, normal_stiffness=1e9))
    shape = hs.Shape.rectangle(0.5, 0.5) if up == 1 else hs.Shape.box(0.5, 0.5, 0.5)
    block = world.add_block(shape, (*[0.1] * up, -HEIGHT / 2 + 0.26))
    assert world.relax(1e-6)[0]
    weight = world.state(block).mass * GRAVITY
    assert world.state(block).force[up] == pytest.approx(weight, rel=1e-4)
    assert world.state(block).pose[0][up] == pytest.approx(-HEIGHT / 2 + 0.25, abs=2e-3)
