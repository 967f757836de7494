import ctypes
import math

import numpy as np
import pytest

import halfspace as hs


def test_a_box_and_its_parts():
    box = hs.Shape.box(1, 2, 3)
    assert box.dimension == 3 and box.volume == pytest.approx(6)
    assert np.allclose(box.centroid, 0)
    assert len(box.faces) == 6 and all(len(face) == 4 for face in box.faces)
    assert box.edges.shape == (12, 2)
    normals, offsets = box.halfspaces
    assert (normals @ box.vertices.T <= offsets[:, None] + 1e-15).all()
    again = hs.Shape.from_halfspaces(normals, offsets)
    assert again.volume == pytest.approx(6)
    assert box.properties.second_moment[:3] == pytest.approx([0.5, 2, 4.5])
    assert "polyhedron of 8 vertices" in repr(box)


def test_faces_of_different_lengths():
    prism = hs.Shape.polyhedron(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 2), (1, 0, 2), (0, 1, 2)],
        [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    )
    assert prism.volume == pytest.approx(1)
    assert [len(face) for face in prism.faces] == [3, 3, 4, 4, 4]


def test_hull_by_the_number_of_columns():
    assert hs.Shape.hull([(0, 0), (1, 0), (0, 1), (0.2, 0.2)]).dimension == 2
    assert hs.Shape.hull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).dimension == 3


def test_cut_and_what_is_not_cut():
    square = hs.Shape.rectangle(2, 2)
    behind, ahead = square.cut((0.5, 0), (1, 0))
    assert (behind.volume, ahead.volume) == (3, 1)
    whole, none = square.cut((5, 0), (1, 0))
    assert whole.volume == 4 and none is None


def test_checking_and_cleaning():
    dented = [(0, 0), (2, 0), (1, 0.5), (2, 2), (0, 2)]
    fault = hs.check_polygon(dented)
    assert hs.Fault(fault.kind) is hs.Fault.NOT_CONVEX and fault.vertex == 2
    assert hs.check_polygon([(0, 0), (1, 0), (0, 1)]).kind == hs.Fault.NONE
    fault = hs.check_polyhedron(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2)]
    )
    assert hs.Fault(fault.kind) is hs.Fault.FEWER_THAN_FOUR
    cleaned, report = hs.clean_polygon([(0, 1), (1, 1), (1, 1), (1, 0), (0.5, 0), (0, 0)])
    assert len(cleaned) == 4 and hs.Shape.polygon(cleaned).volume == 1
    assert (report.welded, report.straightened, report.reversed) == (1, 1, 1)


def test_corners_of_few_digits_keep_their_faces():
    turned = np.array([[1, 2, 2], [2, 1, -2], [2, -2, 1]]) / 3
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) @ turned
    written = np.round(corners, 6)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    with pytest.raises(hs.GeometryError, match="not plane"):
        hs.Shape.polyhedron(written, faces)
    for shape in (
        hs.Shape.polyhedron(written, faces, tolerance=2e-6),
        hs.Shape.hull(written, tolerance=2e-6),
    ):
        assert len(shape.faces) == 6
        assert shape.volume == pytest.approx(1, abs=1e-5)
        report = shape.fit_report
        assert 0 < report.deviation < 2e-6
        assert 0 < report.moved < 1e-5
    assert hs.Shape.box(1, 1, 1).fit_report is None


def test_a_dent_beyond_the_tolerance_is_named():
    vertices = [(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 3), (1, 1, 0.1)]
    faces = [(0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 4, 1), (1, 4, 2), (2, 4, 0)]
    with pytest.raises(hs.GeometryError, match=r"dent 0.1 deep at vertices\[4\].*a tolerance of 0.0\d+ is sufficient"):
        hs.Shape.polyhedron(vertices, faces, tolerance=0.01)
    taken = hs.Shape.polyhedron(vertices, faces, tolerance=0.1)
    assert len(taken.faces) == 4
    assert taken.fit_report.merged == 2


def test_a_pose():
    assert hs.pose((1, 2)).tolist() == [1, 2, 0, 0, 0, 0, 1]
    turned = hs.pose((1, 2), math.pi / 2)
    assert turned[5:] == pytest.approx([math.sqrt(0.5)] * 2)
    assert hs.pose((1, 2, 3), rotation=(1, 0, 0, 0)).tolist() == [1, 2, 3, 1, 0, 0, 0]
    with pytest.raises(ValueError, match="not both"):
        hs.pose((1, 2), 0.5, rotation=(0, 0, 0, 1))


def test_a_cache_gives_the_same_answers(square):
    cache = hs.PairCache()
    assert "unknown" in repr(cache)
    for height in np.linspace(1.5, 0.9, 200):
        cold = hs.pair_detect(square, (0, 0), square, (0.25, height))
        warm = hs.pair_detect(square, (0, 0), square, (0.25, height), cache=cache)
        assert (cold.type == 0) == (warm.type == 0)
        if cold.type:
            assert (cold.gap, cold.area) == (warm.gap, warm.area)
    assert "in contact" in repr(cache)
    assert repr(hs.PairCache(cache)) == repr(cache)
    cache.clear()
    assert "unknown" in repr(cache)


def test_polygons_with_a_skin_touch_within_the_margin(square):
    places = square, (0, 0), square, (0.25, 1.25)
    assert hs.pair_detect(*places).type == 0
    contact = hs.pair_detect(*places, margin=0.5)
    assert (contact.type, contact.gap, contact.point_count) == (hs.ContactType.EDGE_EDGE, 0.25, 2)
    bare = hs.pair_detect(*places, margin=0.5, without_region=True)
    assert (bare.type, bare.gap, bare.point_count) == (hs.ContactType.VERTEX_EDGE, 0.25, 0)
    with pytest.raises(hs.ArgumentError, match="margin is -1"):
        hs.pair_detect(*places, margin=-1.0)


def test_many_pairs_are_what_single_pairs_are(square):
    generator = np.random.default_rng(1)
    shapes = [square, hs.Shape.hull([(0, 0), (1, 0), (0.3, 0.9)])] * 20
    poses = np.array(
        [hs.pose(p, a) for p, a in zip(generator.uniform(0, 3, (40, 2)), generator.uniform(0, 6, 40))]
    )
    pairs = np.array([(a, b) for a in range(40) for b in range(a)])
    contacts = hs.pairs_detect(shapes, poses, pairs)
    assert 10 < np.count_nonzero(contacts["type"]) < len(pairs)
    for (a, b), many in zip(pairs, contacts):
        assert hs.pair_detect(shapes[a], poses[a], shapes[b], poses[b]) == many

    caches, room = hs.pair_caches(len(pairs)), np.zeros(len(pairs), hs.CONTACT)
    assert hs.pairs_detect(shapes, poses, pairs, caches=caches, out=room) is room
    assert np.array_equal(room["type"], contacts["type"])
    assert set(caches["state"]) == {1, 2}
    with pytest.raises(ValueError, match="caches must be"):
        hs.pairs_detect(shapes, poses, pairs, caches=caches[1:])
    with pytest.raises(hs.ArgumentError, match=r"pairs\[1\] is 99; it must be >= 0 and below body_count, which is 40"):
        hs.pairs_detect(shapes, poses, [(0, 99)])
    assert len(hs.pairs_detect([], np.empty((0, 7)), np.empty((0, 2)))) == 0
    with pytest.raises(ValueError, match="pairs must be empty if shapes is empty"):
        hs.pairs_detect([], np.empty((0, 7)), [(0, 1)])


@pytest.mark.parametrize("name", ["law", "elasticity", "bond", "bolt"])
def test_properties_have_the_defaults_of_the_library(name):
    from halfspace import _raw
    from halfspace._library import library

    defaults = getattr(_raw, f"hs_{name}_def")()
    getattr(library, f"hs_{name}_def_init")(defaults, ctypes.sizeof(defaults))
    assert bytes(getattr(hs, name.capitalize())()._as_struct()) == bytes(defaults)


def test_laws_fill_a_struct():
    struct = hs.Law(cohesion=3, stiffness_kind=hs.StiffnessKind.PER_AREA)._as_struct()
    assert struct.cohesion == 3 and struct.stiffness_kind == 1


def test_names_of_constants_may_be_words():
    assert hs.Law(stiffness_kind="per area") == hs.Law(stiffness_kind=hs.StiffnessKind.PER_AREA)
    assert hs.Law(stiffness_kind="NONE")._as_struct().stiffness_kind == hs.StiffnessKind.NONE
    assert hs.Elasticity(plane="stress").plane is hs.Plane.STRESS
    assert hs.Mesh.rectangle(1, 1, 2, 2, kind="triangle").cell_count == 8
    world = hs.World(fast_blocks="refuse")
    stone = world.add_material(2000)
    block = world.add_block(hs.Shape.rectangle(1, 1), (0, 0), kind="fixed", material=stone)
    assert world.state(block).kind == hs.BlockKind.FIXED
    with pytest.raises(hs.StateError):  # there is nothing to relax
        world.relax(measure="largest")


@pytest.mark.parametrize(
    "call, text",
    [
        (
            lambda: hs.Law(stiffness_kind="per are"),
            "stiffness_kind is 'per are'; it must be one of "
            '"per contact", "per area", "potential", ',
        ),
        (lambda: hs.Law(stiffness_kind=1.0), 'stiffness_kind is 1.0; it must be one of "per contact"'),
        (lambda: hs.Elasticity(plane="plain"), "plane is 'plain'; it must be one of \"strain\", \"stress\""),
        (lambda: hs.Mesh.rectangle(1, 1, 1, 1, kind="prism"), 'it must be "quad" or "triangle"'),
        (lambda: hs.World(fast_blocks="stop"), "fast_blocks is 'stop'; it must be one of \"divide\", \"refuse\""),
        (lambda: hs.World().add_block(hs.Shape.rectangle(1, 1), kind="rigit"), "kind is 'rigit'; it must be one of \"fixed\""),
        (lambda: hs.World().relax(measure="most"), "measure is 'most'; it must be one of \"mean\", \"largest\""),
    ],
)
def test_a_word_that_is_no_name_is_answered_with_the_names(call, text):
    with pytest.raises(ValueError) as caught:
        call()
    assert text in str(caught.value)


def test_enumerations_are_whole():
    from halfspace import _raw

    enumerations = {
        "HS_CONTACT_": hs.ContactType,
        "HS_PAIR_": hs.PairKind,
        "HS_BLOCK_": hs.BlockKind,
        "HS_FAULT_": hs.Fault,
        "HS_STIFFNESS_": hs.StiffnessKind,
    }
    for prefix, enumeration in enumerations.items():
        constants = {
            name[len(prefix) :]: value for name, value in vars(_raw).items() if name.startswith(prefix)
        }
        constants.pop("POINTS", None)  # how many a contact has room for
        assert constants == dict(enumeration.__members__)
