"""`World.check` returns notes on unusual settings only."""
import copy

import pytest

import halfspace as hs


def pile(**changes):
    """Two squares on a floor; in 3D cubes."""
    dimension = changes.pop("dimension", 2)
    density, kind = changes.pop("density", 2700), changes.pop("kind", hs.BlockKind.FIXED)
    values = {"normal_stiffness": 1e8, "friction_angle": 0.5, **changes.pop("values", {})}
    world = hs.World(dimension, law=hs.Law(**values), **changes)
    world.add_material(density)
    wide = hs.Shape.rectangle(5, 1) if dimension == 2 else hs.Shape.box(5, 5, 1)
    stone = hs.Shape.rectangle(1, 1) if dimension == 2 else hs.Shape.box(1, 1, 1)
    up = (0, 1) if dimension == 2 else (0, 0, 1)
    world.add_block(wide, [-0.5 * x for x in up], kind=kind)
    for height in (0.5, 1.5):
        world.add_block(stone, [height * x for x in up])
    return world


def only_note(world):
    notes = world.check()
    assert len(notes) == 1, notes
    return notes[0]


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_world_as_usual_gets_no_note(dimension):
    world = pile(dimension=dimension)
    assert world.check() == []
    world.step(10)
    assert world.check() == []


@pytest.mark.parametrize(
    "changes, text",
    [
        ({"density": 2.7}, "material[0].density: 2.7 is unusual; usual: 50 to 19500 kg/m3"),
        ({"density": 2.7e-6}, "material[0].density: 2.7e-06 is unusual"),
        ({"gravity": (0, -9810)}, "world.gravity: [0, -9810] is unusual; usual: 9.81 m/s2"),
        ({"gravity": (0, 9.81)}, "world.gravity: [0, 9.81] points upwards; usual: along -y"),
        ({"gravity": (0, -9.81, 0), "dimension": 3}, "world.gravity: [0, -9.81, 0] has no component along z"),
        ({"values": {"friction_angle": 0.01}}, "default_law.friction_angle: 0.57"),
        ({"values": {"normal_damping": 30}}, "default_law.normal_damping: 30 is unusual; usual: 0 to 1"),
        ({"values": {"cohesion": 5}}, "default_law.cohesion: 5 is unusual; usual: 0, or 100 to 1e9 Pa"),
        ({"values": {"normal_stiffness": 50}}, "default_law.normal_stiffness: 50 is unusual"),
        ({"mass_damping": 1e4}, "world.mass_damping: 10000 is unusual"),
        ({"sleep_tolerance": 1}, "world.sleep_tolerance: 1 m is 1 times the thinnest block's thickness"),
        ({"time_step": 1}, "world.time_step: 1 s is above the stable time step"),
        ({"time_step": 1e-12}, "world.time_step: 1e-12 s is far below the stable time step"),
        ({"kind": hs.BlockKind.RIGID}, "fall: no block is fixed or prescribed"),
    ],
)
def test_an_unusual_setting_gets_a_note(changes, text):
    assert any(text in note for note in pile(**changes).check())


def test_notes_of_the_command_on_the_start():
    world = pile()
    above = world.add_block(hs.Shape.rectangle(1, 1), (0, 2.4))
    assert f'"{above}" overlaps' in only_note(world) and "by 0.1 m, 10 % of" in only_note(world)
    soft = pile(values={"normal_stiffness": 1e5})
    assert "sinks into its support" in only_note(soft)  # by 2 x 2700 kg x 9.81 m/s2 / 1e5 N/m = 0.53 m
    assert "0.53 m" in only_note(soft)


def test_settings_that_are_set_again_count_as_they_are_now():
    world = pile()
    world.set_gravity((0, -98.1))
    world.set_law(0, 0, hs.Law(normal_stiffness=1e9, normal_damping=30))
    assert [note.split(":")[0] for note in world.check()] == ["world.gravity", "law[0].normal_damping"]
    assert copy.copy(world).check() == world.check()
    world.set_gravity((0, -9.81))
    world.set_law(0, 0, hs.Law())
    assert world.check() == []


def test_blocks_beside_the_floor_and_of_other_sizes():
    world = pile()
    beside = world.add_block(hs.Shape.rectangle(1, 1), (20, 0.5))
    assert f'"{beside}" falls out of the scene' in only_note(world)
    world.remove_block(beside)
    world.add_block(hs.Shape.rectangle(1e-6, 1e-6), (2, 1))
    assert any("usual: a ratio up to 1e5" in note for note in world.check())


def test_a_mesh_without_supports_falls_and_a_held_one_does_not():
    world = hs.World()
    world.set_elasticity(world.add_material(2500), hs.Elasticity(young_modulus=1e10))
    body = world.add_mesh(hs.Mesh.rectangle(4, 1, 4, 1))
    assert "no mesh is held along gravity" in only_note(world)
    world.hold_nodes(body, [0], axes="x")
    assert "no mesh is held along gravity" in only_note(world)
    world.hold_nodes(body, [0, 1], axes="y")
    assert world.check() == []
    world.set_elasticity(0, hs.Elasticity(young_modulus=10))
    assert "material[0].young_modulus: 10 is unusual" in only_note(world)


def test_bonds_that_are_not_made():
    world = pile()
    assert world.bond_materials(0, 0, hs.Bond(normal_stiffness=1e10, cohesion=1e6)) > 0
    assert world.check() == []
    apart = hs.World()
    apart.add_material(2700)
    for x in (0, 1.0001):
        apart.add_block(hs.Shape.rectangle(1, 1), (x, 0), kind=hs.BlockKind.FIXED if x else hs.BlockKind.RIGID)
    apart.set_gravity((0, 0))
    apart.bond_materials(0, 0, hs.Bond(normal_stiffness=1e10, cohesion=1e6))
    assert only_note(apart) == "bond_materials(0, 0) made no bond; usual: blocks with a common face"


def meshed(**changes):
    """A world that no scene describes: it has fewer notes."""
    world = pile(**changes)
    world.set_elasticity(0, hs.Elasticity(young_modulus=1e10))
    world.hold_nodes(world.add_mesh(hs.Mesh.rectangle(4, 1, 4, 1), position=(0, 20)), [0, 4], axes="y")
    return world


@pytest.mark.parametrize(
    "changes, text",
    [
        ({"gravity": (0, 9.81)}, "gravity: [0, 9.81] points upwards; usual: along -y"),
        ({"sleep_tolerance": 1}, "sleep_tolerance: 1 m beside a block 1 m thick; usual: below 1%"),
        ({"time_step": 1}, "time_step: 1 s is above the stable one"),
        ({"locate_impacts": True}, "locate_impacts: no effect: all laws have springs"),
    ],
)
def test_notes_on_a_world_with_meshes(changes, text):
    assert any(text in note for note in meshed(**changes).check())


def test_a_restored_world_knows_its_settings():
    world = hs.World.restore(pile(density=2.7).save())
    assert "material[0].density: 2.7 is unusual" in only_note(world)
    assert hs.World.restore(pile().save()).check() == []


def bricks(**changes):
    """Two rigid squares on a floor, by a law without springs that rebounds."""
    world = pile(values={"stiffness_kind": "none", "restitution": 0.5, **changes.pop("values", {})}, **changes)
    world.set_elasticity(0, hs.Elasticity(young_modulus=1e8))
    return world


def test_settings_of_impulses_between_rigid_blocks_without_effect():
    settings = {"locate_impacts": True, "impulse_tolerance": 1e-8, "max_impulse_iterations": 1000}
    keys = {f"world.{name}" for name in settings}
    assert bricks(time_step=1 / 60, **settings).check() == []
    world = pile(**settings)
    assert {note.split(":")[0] for note in world.check()} == keys
    assert all("no effect: the laws of all blocks have springs" in note for note in world.check())
    assert copy.copy(world).check() == world.check()
    world.set_law(0, 0, hs.Law(stiffness_kind="none"))
    assert not any("no effect" in note for note in world.check())

    world = bricks(time_step=1e-4, **settings)
    rigid = [block for block in world.blocks if world.state(block).kind == hs.BlockKind.RIGID]
    world.add_block(hs.Shape.rectangle(1, 1), (2, 0.5), kind=hs.BlockKind.AFFINE)
    assert not [note for note in world.check() if "no effect" in note]
    for block in rigid:
        world.remove_block(block)
    notes = [note for note in world.check() if "no effect" in note]
    assert {note.split(":")[0] for note in notes} == keys | {"default_law.restitution"}
    assert all("contacts without springs of blocks that deform or are held are points" in note for note in notes)

    world = bricks(time_step=1 / 60, **settings)
    world.set_law(0, 0, hs.Law(stiffness_kind="none", cohesion=1e5))
    notes = [note for note in world.check() if "no effect" in note]
    assert {note.split(":")[0] for note in notes} >= keys
    assert all("a law without springs that has cohesion" in note for note in notes)


def test_locate_impacts_that_is_off_gets_no_note():
    assert pile(locate_impacts=False).check() == []
