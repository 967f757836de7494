"""Scenes: the same bits as the command, and facts from analysis."""
import copy
import math
import os
import pathlib
import pickle
import re
import signal
import subprocess
import threading

import numpy as np
import pytest

import halfspace as hs

FALLING = """
title = "A block falls"
dimension = 2
[world]
duration = 0.5
time_step = 1e-3
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
friction_angle = 30
[[material]]
name = "stone"
density = 2500
[[block]]
name = "falling"
material = "stone"
vertices = [[0, 10], [1, 10], [1, 11], [0, 11]]
[[block]]
name = "plate"
material = "stone"
kind = "fixed"
vertices = [[-2, -1], [3, -1], [3, 0], [-2, 0]]
[output]
tracked = ["falling"]
"""
# A block slides on a plane of 20 degrees.
SLIDING = """
dimension = 2
world.duration = 0.1
world.gravity = [3.355217612407962, -9.218184730095113]
default_law = { stiffness = "per contact", normal_stiffness = 1e9, shear_stiffness = 1e9, friction_angle = 40 }
material = [{ name = "stone", density = 2500 }]
[[block]]
name = "slider"
material = "stone"
vertices = [[0, 0], [2, 0], [2, 0.5], [0, 0.5]]
[[block]]
name = "plane"
material = "stone"
kind = "fixed"
vertices = [[-3, -1], [5, -1], [5, 0], [-3, 0]]
"""
COMMAND = os.environ.get("HALFSPACE_COMMAND", "")
with_command = pytest.mark.skipif(not COMMAND, reason="the command is not built")


@pytest.fixture
def falling():
    return hs.Scene.loads(FALLING)


def free_fall(steps, time_step=1e-3, height=10.5):
    """Velocity Verlet is exact for a constant acceleration."""
    return height - 0.5 * 9.81 * (steps * time_step) ** 2


def test_a_world_of_a_scene(falling):
    assert (falling.dimension, falling.duration, falling.threads, falling.stage_count) == (2, 0.5, 1, 0)
    world = falling.world()
    assert world.names == ["falling", "plate"]
    world.step(100)
    block = world.block("falling")
    assert world.state(block).pose.position[1] == pytest.approx(free_fall(100), rel=1e-12)
    assert world.state(world.block("plate")).kind == hs.BlockKind.FIXED
    with pytest.raises(KeyError, match="'plank'"):
        world.block("plank")


def test_a_run_calls_back_and_returns_the_end(falling):
    heights = []
    result = falling.run(every=0.1, callback=lambda world: heights.append(float(world.positions[0, 1])))
    assert heights == pytest.approx([free_fall(steps) for steps in (0, 100, 200, 300, 400, 500)], rel=1e-12)
    assert result.end == "complete" and result.steps == 500 and result.directory is None
    assert result.world.time == result.time == pytest.approx(0.5)
    assert result.world.names == ["falling", "plate"]
    assert result.history.time == pytest.approx(np.linspace(0, 0.5, 6))
    assert result.history["falling.y"] == pytest.approx(heights)
    assert result.max_displacement == pytest.approx(0.5 * 9.81 * 0.25)
    assert "A block falls" in str(result)


def test_a_callback_ends_a_run(falling):
    result = falling.run(every=0.1, callback=lambda world: world.time < 0.15)
    assert result.end == "interrupted" and result.time == pytest.approx(0.2)
    assert falling.run().end == "complete"  # the next one is not interrupted


def test_an_error_in_a_callback_is_raised(falling):
    def fail(world):
        raise ZeroDivisionError("of the callback")

    with pytest.raises(ZeroDivisionError, match="of the callback"):
        falling.run(callback=fail)


def test_a_world_of_a_callback_ends_with_it_and_its_copy_stays(falling):
    kept = []
    falling.run(every=0.25, callback=lambda world: kept.append((world, copy.copy(world))))
    with pytest.raises(hs.ClosedError):
        kept[1][0].step()
    world = kept[1][1]
    assert world.time == pytest.approx(0.25) and world.names == ["falling", "plate"]
    world.step(10)
    assert world.positions[0, 1] == pytest.approx(free_fall(260), rel=1e-12)


def test_settings_replace_values(falling):
    scene = hs.Scene.loads(FALLING, {"world.gravity": (0, -1), "world.duration": 0.2, "title": 'quoted "words"'})
    assert scene.run().max_displacement == pytest.approx(0.02)
    assert hs.Scene.loads(FALLING, ["world.gravity=[0,-1]"]).world().check() == []
    again = falling.with_settings({"world.duration": 0.3}).with_settings({"world.gravity": np.array([0, -2])})
    assert again.run().max_displacement == pytest.approx(0.5 * 2 * 0.09)


def test_a_saved_scene_is_the_same(falling, tmp_path):
    falling.save(tmp_path / "same.toml")
    assert (tmp_path / "same.toml").read_text(encoding="utf-8") == FALLING
    slow = falling.with_settings({"world.gravity": (0, -1)})
    slow.save(tmp_path / "slow.toml")
    assert hs.Scene.load(tmp_path / "slow.toml").run().max_displacement == slow.run().max_displacement


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda scene: pickle.loads(pickle.dumps(scene))])
def test_a_copy_of_a_scene_is_the_same(falling, copied):
    scene = falling.with_settings({"default_law.friction_angle": 20})
    assert copied(scene).text == scene.text


def test_an_interrupt_ends_a_run(falling, capsys):
    settings = {"world.duration": 1e5, "output.frame_interval": 1e4, "output.history_interval": 1e4}
    timer = threading.Timer(0.5, signal.pthread_kill, (threading.main_thread().ident, signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        falling.with_settings(settings).run()
    timer.join()
    assert capsys.readouterr().err == ""
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_an_interrupt_ends_all_runs_of_a_sweep(falling):
    """Each would take hours."""
    scene = falling.with_settings({"world.duration": 1e6, "world.gravity": [0, 0], "output.frame_interval": 1e5,
                                   "output.history_interval": 1e5})
    timer = threading.Timer(0.5, signal.pthread_kill, (threading.main_thread().ident, signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        scene.sweep({"world.time_step": [1e-5, 2e-5, 3e-5]}, jobs=2)
    timer.join()


def test_an_interrupt_ends_a_callback(falling):
    """It is raised in the callback, however long that takes."""
    def wait(_):
        signal.raise_signal(signal.SIGINT)
        raise AssertionError("it goes on")

    with pytest.raises(KeyboardInterrupt):
        falling.run(callback=wait)


def test_a_scene_from_tables():
    scene = hs.Scene.from_dict(
        {
            "dimension": 2,
            "world": {"duration": 0.1, "time_step": 1e-3, "gravity": np.array([0, -2.0])},
            "default_law": {"stiffness": "per contact", "normal_stiffness": 1e8, "friction_angle": 30},
            "material": [{"name": "stone", "density": 2500}],
            "block": [{"name": "a", "material": "stone", "vertices": [(0, 0), (1, 0), (0, 1)]}],
        }
    )
    assert scene.run().max_displacement == pytest.approx(0.01)


def test_faults_name_line_and_key():
    with pytest.raises(hs.SceneError) as error:
        hs.Scene.loads(FALLING.replace("time_step = 1e-3", "time_step = -1").replace('"falling"]', '"fall"]'))
    assert len(error.value.faults) == 1  # names are compared when the blocks are made
    assert error.value.faults[0].startswith("scene:6:")
    assert "world.time_step: out of range: -1" in str(error.value)
    scene = hs.Scene.loads(FALLING.replace('"falling"]', '"fall"]'))
    with pytest.raises(hs.SceneError, match='output.tracked.*"fall"'):
        scene.world()
    with pytest.raises(hs.SceneError, match="--set world.step=1"):
        hs.Scene.loads(FALLING, {"world.step": 1})
    with pytest.raises(FileNotFoundError):
        hs.Scene.load("no_such_scene.toml")


def test_a_residual_above_1_percent_is_a_note_of_the_run_and_of_its_world():
    scene = hs.Scene.loads("""
dimension = 2
world = { duration = 1, time_step = 0.005 }
material = [{ name = "stone", density = 2000 }]
default_law = { stiffness = "per contact", normal_stiffness = 1e4, friction_angle = 35 }
[[block]]
name = "floor"
material = "stone"
kind = "fixed"
vertices = [[-9, -1], [9, -1], [9, 0], [-9, 0]]
[[block]]
name = "square"
material = "stone"
vertices = [[-0.5, 0.4], [0.5, 0.4], [0.5, 1.4], [-0.5, 1.4]]
""")
    assert not any("energy residual" in note for note in scene.check())
    result = scene.run()
    note = result.notes[-1]
    assert re.match(r"energy residual: the numerical method has (created|lost) \S+ of the energy released", note)
    assert result.world.check() == result.notes
    assert f"note: {note}\n" in result.summary


def test_notes_are_those_of_the_command():
    scene = hs.Scene.loads(FALLING.replace("density = 2500", "density = 2.5"))
    notes = scene.check()
    assert any("material[0].density: 2.5 is unusual" in note for note in notes)
    assert scene.world().check() == notes == scene.run().notes


def test_an_unstable_run_raises(tmp_path):
    scene = hs.Scene.loads(
        FALLING.replace("time_step = 1e-3", "time_step = 0.1").replace("duration = 0.5", "duration = 20")
    )
    with pytest.raises((hs.UnstableError, hs.TooFastError)):
        scene.run(tmp_path / "out")
    assert (tmp_path / "out" / "history.csv").exists()


def test_a_directory_in_use_is_refused(falling, tmp_path):
    falling.run(tmp_path / "out")
    with pytest.raises(hs.StateError, match="not empty; replace=True"):
        falling.run(tmp_path / "out")
    assert falling.run(tmp_path / "out", replace=True).directory == tmp_path / "out"


def test_a_run_resumes_from_a_checkpoint(falling, tmp_path):
    whole = falling.run()
    part = falling.run(tmp_path / "out", callback=lambda world: world.time < 0.2)
    assert part.end == "interrupted"
    rest = falling.run(tmp_path / "out", resume_from=tmp_path / "out" / "checkpoint")
    assert rest.end == "complete" and rest.world.save() == whole.world.save()


def test_the_factor_of_safety_of_a_slider_is_that_of_coulomb():
    """Tangents of friction angle and slope."""
    found = hs.Scene.loads(SLIDING).safety(low=1, high=4, resolution=0.01)
    assert found.end == "complete"
    assert found.stable <= math.tan(math.radians(40)) / math.tan(math.radians(20)) <= found.falls
    assert found.falls - found.stable <= 0.01 and found.stable < found.factor < found.falls


def test_each_trial_is_the_last_stage_if_that_runs():
    """Within 2 s the block slides by more than a tenth of its diagonal if friction is too small by the acceleration
    that this takes."""
    scene = hs.Scene.loads(SLIDING.replace("world.duration = 0.1", 'stage = [{ do = "run", duration = 2 }]'))
    found = scene.safety(low=1, high=4, resolution=0.01)
    assert "the last stage, 2 s" in str(found)
    acceleration = 2 * 0.1 * math.hypot(2, 0.5) / 2**2
    friction = math.tan(math.radians(20)) - acceleration / (9.81 * math.cos(math.radians(20)))
    assert found.factor == pytest.approx(math.tan(math.radians(40)) / friction, abs=0.01)


def test_limits_of_a_slider_are_those_of_coulomb():
    """On a slope of 20 degrees friction must be as large; turned back about -z, by 60 degrees it slides at 40."""
    scene = hs.Scene.loads(SLIDING)
    tilted = scene.limit(tilt="-z", low=0, high=70, resolution=0.5)
    assert tilted.end == "complete" and tilted.stable < tilted.value < tilted.falls
    assert tilted.stable <= 60 <= tilted.falls <= tilted.stable + 0.5
    assert "largest tilt" in str(tilted)
    friction = scene.limit(values={"default_law.friction_angle": (5, 45)}, smallest=True, resolution=0.5)
    assert friction.falls <= 20 <= friction.stable <= friction.falls + 0.5


def test_searches_refuse_what_does_not_fit():
    scene = hs.Scene.loads(SLIDING)
    for options in {}, {"tilt": True, "loads": True}, {"values": {"a": (1, 2)}, "tilt": True}:
        with pytest.raises(ValueError, match="one of tilt, loads and values"):
            scene.limit(**options)
    with pytest.raises(ValueError, match="a search varies one"):
        scene.limit(values={"a": (1, 2), "b": (1, 2)})
    with pytest.raises(hs.ArgumentError, match="not an axis: x; allowed: z, -z"):
        scene.limit(tilt="x")
    with pytest.raises(hs.ArgumentError, match="the bracket 5 to 4"):
        scene.limit(tilt=True, low=5, high=4)
    with pytest.raises(hs.SceneError, match="default_law.friction_angle: out of range: 95"):
        scene.limit(values={"default_law.friction_angle": (5, 95)})
    with pytest.raises(hs.SceneError, match="no loads"):
        scene.limit(loads=True)


@pytest.mark.parametrize("values", [20, "20:30:5"])
def test_the_values_of_a_sweep_are_a_sequence(falling, values):
    with pytest.raises(TypeError, match=f"the values of default_law.friction_angle are {values!r}; they must be a sequence"):
        falling.sweep({"default_law.friction_angle": values})


def test_a_sweep_in_threads():
    swept = hs.Scene.loads(FALLING).sweep({"world.gravity": [(0, -1), (0, -2)], "world.duration": [0.1, 0.2]}, jobs=2)
    assert swept["max_displacement"] == pytest.approx([0.005, 0.02, 0.01, 0.04])
    assert swept["world.duration"].tolist() == [0.1, 0.2, 0.1, 0.2]
    assert str(swept).splitlines()[0].split() == ["world.gravity", "world.duration", "run_out", "max_displacement",
                                                  "largest_overlap", "energy_residual"]


@with_command
def test_the_files_of_a_limit_are_those_of_the_command(tmp_path):
    (tmp_path / "slider.toml").write_text(SLIDING, encoding="utf-8")
    key = "default_law.friction_angle"
    subprocess.run(
        [COMMAND, "limit", tmp_path / "slider.toml", "-o", tmp_path / "command", "--set", f"{key}=5:45", "--smallest"],
        check=True,
        capture_output=True,
    )
    hs.Scene.load(tmp_path / "slider.toml").limit(tmp_path / "python", values={key: (5, 45)}, smallest=True)
    files = sorted(path.name for path in (tmp_path / "command").iterdir())
    assert files == ["falls.svg", "limit.txt", "stands.svg", "trials.csv"]
    for file in files:
        assert (tmp_path / "python" / file).read_bytes() == (tmp_path / "command" / file).read_bytes(), file


@with_command
@pytest.mark.parametrize("example, settings", [
    ("dropped_block/dropped_block.toml", []),
    ("masonry/arch.toml", []),
    ("rock_collapse/friction_30.toml", ["world.duration=0.02"]),
])
def test_the_files_are_those_of_the_command(example, settings, tmp_path):
    path = pathlib.Path(__file__).parents[3] / "docs" / "examples" / example
    options = [option for setting in settings for option in ("--set", setting)]
    subprocess.run([COMMAND, "run", path, "-o", tmp_path / "command", *options], check=True, capture_output=True)
    hs.Scene.load(path, settings).run(tmp_path / "python")
    files = sorted(each.relative_to(tmp_path / "command") for each in (tmp_path / "command").rglob("*.*"))
    assert pathlib.Path("history.csv") in files
    for file in files:
        assert (tmp_path / "python" / file).read_bytes() == (tmp_path / "command" / file).read_bytes(), file
