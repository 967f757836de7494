"""Recordings of worlds, and the pages that play them. The browser's part is in bindings/viewer/tests."""
import base64
import copy
import json
import pathlib
import pickle
import re
import zlib

import numpy as np
import pytest

import halfspace as hs

GRAVITY = 9.81


def header_of(page: pathlib.Path):
    text = page.read_text(encoding="utf-8")
    packed = re.search(r'<script type="text/plain" id="header">([^<]*)</script>', text).group(1)
    return json.loads(zlib.decompress(base64.b85decode(packed.translate(str.maketrans(",./", "&<>")))))


def columns_of(header, table):
    return {column["name"]: column for column in next(t for t in header["tables"] if t["name"] == table)["columns"]}


def falling(dimension):
    world = hs.World(dimension, time_step=1e-3, law=hs.Law(normal_stiffness=1e7))
    world.add_material(density=2000)
    shape = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    up = [0.0] * (dimension - 1) + [5.0]
    return world, world.add_block(shape, up)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_free_fall(dimension, tmp_path):
    world, block = falling(dimension)
    recording = hs.Recording(world, "A fall & more", names={block: "stone"}, materials=["rock"])
    for _ in range(5):
        recording.add()
        world.step(100)
    assert len(recording) == 5
    page = hs.view(recording, tmp_path / "fall.html")
    assert page.path == tmp_path / "fall.html"
    header = header_of(page.path)
    assert header["dimension"] == dimension and header["title"] == "A fall & more"
    assert header["names"] == ["stone"] and header["materials"] == ["rock"]
    np.testing.assert_allclose(header["times"], [0, 0.1, 0.2, 0.3, 0.4], atol=1e-12)
    height = columns_of(header, "blocks")["y" if dimension == 2 else "z"]
    assert height["high"] == 5.0
    assert height["low"] == pytest.approx(5 - 0.5 * GRAVITY * 0.4**2, abs=1e-12)
    assert columns_of(header, "blocks")["speed"]["high"] == pytest.approx(0.4 * GRAVITY, rel=1e-12)
    rows = header["history"].splitlines()
    assert rows[0].startswith("time,steps,contacts,largest_overlap,largest_speed,kinetic") and len(rows) == 6


@pytest.mark.parametrize("dimension", [2, 3])
def test_cracks(dimension, tmp_path):
    """Of three bonded blocks the middle one is fixed, and one of the others is pulled off, the other one pushed along."""
    law = hs.Law(normal_stiffness=1e8)
    world = hs.World(dimension, law=law, gravity=[0] * dimension)
    world.add_material(density=2000)
    shape = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    across = [0] * (dimension - 1)
    blocks = [world.add_block(shape, (x, *across), kind="fixed" if x == 0 else "rigid") for x in (-1, 0, 1)]
    for pair in (blocks[:2], blocks[1:]):
        world.bond_blocks(*pair, hs.Bond(normal_stiffness=1e9, shear_stiffness=1e9, tensile_strength=1e5, cohesion=1e5))
    world.set_applied_force(blocks[0], (-1e6, *across))
    recording = hs.Recording(world)
    recording.add()
    world.run(0.01, every=0.001, callback=recording.add)
    world.set_applied_force(blocks[2], (-1e6, 2e6, 0)[:dimension])
    world.run(0.01, every=0.001, callback=recording.add)
    events = world.bond_events()
    assert len(set(events["failure"])) == 2
    cracks = header_of(hs.view(recording, tmp_path / "cracks.html").path)["cracks"]
    assert len(cracks) == len(events)
    for crack, event in zip(cracks, events):
        assert crack["time"] == event["time"] and crack["area"] == event["area"]
        assert crack["blocks"] == ([0, 1] if event["bond"] == 0 else [1, 2])
        np.testing.assert_allclose(crack["normal"], event["normal"])
        np.testing.assert_allclose(crack["position"], event["position"], atol=1e-12)
        assert crack["is_shear"] == (event["failure"] == hs.BondFailure.SHEAR)
    world.remove_block(blocks[0])
    recording = hs.Recording(world)
    recording.add()
    assert {tuple(crack["blocks"]) for crack in header_of(hs.view(recording, tmp_path / "rest.html").path)["cracks"]} == {(0, 1)}


def test_blocks_come_and_go(tmp_path):
    world, block = falling(2)
    recording = hs.Recording(world)
    recording.add()
    other = world.add_block(hs.Shape.rectangle(1, 1), (3, 5))
    recording.add()
    world.remove_block(block)
    recording.add()
    header = header_of(hs.view(recording, tmp_path / "page.html").path)
    assert header["names"] == ["", ""] and other != block


def test_forces_of_a_resting_block(tmp_path):
    world, block = falling(2)
    world.set_pose(block, (0, 0.4999))
    world.add_block(hs.Shape.rectangle(4, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    world.step(1)
    recording = hs.Recording(world)
    recording.add()
    contacts = columns_of(header_of(hs.view(recording, tmp_path / "page.html").path), "contacts")
    force = world.contacts()[0].force
    size = np.linalg.norm(force)
    assert size > 0 and contacts["force"]["high"] == pytest.approx(size, rel=1e-12)
    assert contacts["direction_y"]["high"] == pytest.approx(force[1] / size, rel=1e-12)


def test_a_run_of_the_command_and_its_faults(tmp_path):
    with pytest.raises(hs.ArgumentError, match="there is no directory"):
        hs.view(tmp_path / "missing")
    with pytest.raises(hs.ArgumentError, match="has no run.pvd"):
        hs.view(tmp_path)
    world, _ = falling(2)
    with pytest.raises(hs.ArgumentError, match="has no frames"):
        hs.view(hs.Recording(world), tmp_path / "page.html")
    assert list(tmp_path.iterdir()) == []


def test_a_notebook_shows_the_page(tmp_path):
    world, _ = falling(2)
    recording = hs.Recording(world)
    recording.add()
    page = hs.view(recording)
    try:
        shown = page._repr_html_()
        assert shown.startswith("<iframe srcdoc=") and shown.count('"') == 4
    finally:
        page.path.unlink()


def test_what_cannot_be_viewed_is_refused():
    world, _ = falling(2)
    with pytest.raises(TypeError, match=r"run is <halfspace.World, 2D: 1 block.*; it must be a Recording, the output directory"):
        hs.view(world)


def test_a_recording_shows_its_length():
    recording = hs.Recording(falling(2)[0])
    recording.add()
    assert repr(recording) == "<halfspace.Recording, frames: 1>"


def test_the_folder_of_a_page_is_made(tmp_path):
    recording = hs.Recording(falling(2)[0])
    recording.add()
    assert hs.view(recording, tmp_path / "pages" / "größe.html").path.is_file()
    with pytest.raises(hs.ArgumentError, match="cannot write .*: Is a directory"):
        hs.view(recording, tmp_path)
    (tmp_path / "file").touch()
    with pytest.raises(hs.ArgumentError, match="cannot write .*: Not a directory"):
        hs.view(recording, tmp_path / "file" / "page.html")


@pytest.mark.parametrize("make", [copy.copy, copy.deepcopy, pickle.dumps])
def test_a_recording_is_not_copied(make):
    """A copy would destroy what both hold."""
    with pytest.raises(TypeError, match="a Recording cannot be copied or pickled"):
        make(hs.Recording(hs.World()))
