"""Rays, closest points, pairs of boxes, and shapes that deform."""
import numpy as np
import pytest

import halfspace as hs


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_ray_meets_the_nearest_block(dimension):
    shape = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    world = hs.World(dimension)
    stone = world.add_material(2000.0)
    world.add_block(shape, (9, 0), material=stone)
    near = world.add_block(shape, (4, 0), material=stone)
    hit = world.cast_ray((0, 0.25), (2, 0))
    assert hit.block == near
    assert hit.distance == 3.5
    assert hit.normal.tolist() == [-1, 0, 0]
    assert world.cast_ray((0, 0.25), (2, 0), 3.4) is None
    assert world.cast_ray((0, 0.25), (-2, 0)) is None
    inside = shape.cast_ray((4, 0), (4.25, 0), (0, 1))
    assert (inside.distance, inside.face, inside.block) == (0, -1, 0)
    assert shape.cast_ray((4, 0), (0, 2), (1, 0)) is None
    with pytest.raises(hs.ArgumentError, match="direction"):
        world.cast_ray((0, 0), (0, 0))


@pytest.mark.parametrize("dimension", [2, 3])
def test_closest_points(dimension):
    shape = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    closest = hs.pair_distance(shape, (0, 0), shape, (4, 5))
    assert closest.distance == 5
    assert closest.normal == pytest.approx([0.6, 0.8, 0])
    assert closest.point_a[:2].tolist() == [0.5, 0.5]
    assert closest.point_b[:2].tolist() == [3.5, 4.5]
    assert hs.pair_distance(shape, (0, 0), shape, (0.5, 0.5)).distance == 0


def test_pairs_of_boxes_are_those_of_all_combinations():
    random = np.random.default_rng(1)
    lower = random.uniform(0, 10, (200, 3))
    upper = lower + random.uniform(0, 2, (200, 3))
    for dimension in (2, 3):
        low, high = lower[:, :dimension], upper[:, :dimension]
        overlap = ((low[:, None] <= high) & (low <= high[:, None])).all(2)
        expected = np.argwhere(np.triu(overlap, 1))
        found = hs.boxes_find_pairs(low, high)
        assert sorted(map(tuple, found)) == list(map(tuple, expected))
    assert len(hs.boxes_find_pairs(np.empty((0, 2)), np.empty((0, 2)))) == 0
    with pytest.raises(hs.ArgumentError, match="lower.0."):
        hs.boxes_find_pairs([(1, 1)], [(0, 2)])


def test_points_that_follow_each_other_along_the_curve_are_neighbours():
    grid = np.stack(np.meshgrid(np.arange(8), np.arange(8), np.arange(8)), -1).reshape(-1, 3)
    points = np.random.default_rng(1).permutation(grid)
    order = hs.points_order_along_curve(points)
    assert sorted(order) == list(range(len(points)))
    assert (np.abs(np.diff(points[order], axis=0)).sum(1) == 1).all()
    assert len(hs.points_order_along_curve(np.empty((0, 2)))) == 0


def test_a_shape_deforms_in_place():
    body = hs.Shape.box(1, 1, 1)
    vertices, faces = body.vertices, body.faces
    body.set_vertices(vertices * [2, 1, 1] + [5, 0, 0])
    assert body.volume == pytest.approx(2)
    assert body.centroid == pytest.approx([5, 0, 0])
    assert all((a == b).all() for a, b in zip(body.faces, faces))
    bent = vertices.copy()
    bent[0, 2] -= 0.1
    with pytest.raises(hs.GeometryError, match="hs_shape_set_vertices: face"):
        body.set_vertices(bent)
    assert body.volume == pytest.approx(2)
    with pytest.raises(hs.ArgumentError, match="vertices.count is 7"):
        body.set_vertices(vertices[:7])
