"""Generated blocks fill their regions."""
import math

import numpy as np
import pytest

import halfspace as hs


def volume(shapes):
    return sum(shape.volume for shape in shapes)


def test_jointed_rock_fills_its_region():
    region = [(0, 0), (4, 0), (4, 2), (0, 2)]
    blocks = hs.jointed_rock(region, [dict(dip=0, spacing=1), dict(dip=90, spacing=1, offset=0.5)])
    assert len(blocks) == 10 and volume(blocks) == pytest.approx(8, rel=1e-12)
    corners = [(x, y, z) for x in (0, 2) for y in (0, 2) for z in (0, 2)]
    slabs = hs.jointed_rock(corners, [dict(dip=0, dip_direction=0, spacing=0.5)])
    assert len(slabs) == 4 and volume(slabs) == pytest.approx(8, rel=1e-12)
    large = hs.jointed_rock(region, [dict(dip=90, spacing=1.5)], smallest=2.5)  # of 3, 3 and 2 m2
    assert len(large) == 2 and volume(large) == pytest.approx(6)


def test_voronoi_cells_fill_their_region():
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    cells = hs.voronoi(corners, 30, relaxation=2, seed=4)
    assert len(cells) == 30 and volume(cells) == pytest.approx(1, rel=1e-12)
    assert volume(hs.voronoi(corners, 30, seed=5)) == pytest.approx(1, rel=1e-12)


def test_triangles_fill_their_rectangle():
    triangles = hs.triangulated((0, 0), (2, 1), 40)
    assert len(triangles) == 40 and volume(triangles) == pytest.approx(2, rel=1e-12)
    assert {len(triangle.vertices) for triangle in triangles} == {3}


def test_faults_of_generators_name_their_key():
    with pytest.raises(hs.SceneError, match=r"^jointed_rock\[0\].joint_set\[0\].spacing: "):
        hs.jointed_rock([(0, 0), (1, 0), (0, 1)], [dict(dip=0, spacing=-1)])
    with pytest.raises(hs.SceneError, match=r"^voronoi\[0\].count: out of range: 1"):
        hs.voronoi([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], 1)


def test_walls_are_in_running_bond():
    bricks = hs.wall(4, 3, (1, 0.5), at=(1, 2))
    assert len(bricks) == 4 + 5 + 4 and volume(bricks) == pytest.approx(6)
    assert min(brick.vertices[:, 0].min() for brick in bricks) == pytest.approx(1)
    assert max(brick.vertices[:, 1].max() for brick in bricks) == pytest.approx(3.5)
    assert volume(hs.wall(4, 2, (1, 0.3, 0.5))) == pytest.approx(4 * 0.3)


@pytest.mark.parametrize("depth", [None, 2.0])
def test_an_arch_is_a_ring_of_trapezia(depth):
    """A trapezium between two rays that enclose the angle a has the area of r t sin(a)."""
    ring = hs.arch(10, 1.2, 20, depth=depth)
    assert volume(ring) == pytest.approx(20 * 10 * 1.2 * math.sin(math.pi / 20) * (depth or 1))
    centroids = np.array([block.centroid for block in ring])
    assert centroids[:, 0] == pytest.approx(-centroids[::-1, 0])
    assert (centroids[:, -1] > 0).all()


def test_generated_blocks_stand():
    world = hs.World(law=hs.Law(normal_stiffness=1e8, friction_angle=0.6))
    stone = world.add_material(2000)
    world.add_block(hs.Shape.rectangle(6, 1), (0, -0.5), kind="fixed")
    ids = world.add_blocks(hs.stack((1, 1), 3), material=stone)
    assert len(ids) == 3
    world.relax()
    contacts = world.contacts()
    assert contacts.normal_force.max() == pytest.approx(3 * 2000 * 9.81, rel=1e-3)


@pytest.mark.parametrize("make, message", [
    (lambda: hs.stack((1, -1), 3), r"size is \(1, -1\); it must be above 0"),
    (lambda: hs.wall(0, 3, (1, 0.5)), "length is 0; it must be above 0"),
    (lambda: hs.wall(4, 3, (1, math.nan)), "brick is "),
    (lambda: hs.arch(10, 1.2, 20, angle=180), "angle is 180; it must be at most 2 pi"),
    (lambda: hs.arch(1, 2, 20), "thickness is 2; it must be below twice the radius, 2"),
    (lambda: hs.arch(10, 1.2, 0), "count is 0; it must be above 0"),
    (lambda: hs.Shape.rectangle(-1, 1), "width is -1; it must be above 0"),
    (lambda: hs.Shape.box(1, 0, 1), "depth is 0; it must be above 0"),
])
def test_sizes_are_above_0(make, message):
    with pytest.raises(ValueError, match=message):
        make()
