"""Type checkers know the package: mypy accepts it, and finds faults of its users."""
import os
import pathlib
import subprocess
import sys

import pytest

import halfspace

PACKAGE = pathlib.Path(halfspace.__file__).parent
SETTINGS = pathlib.Path(__file__).parents[1] / "pyproject.toml"
USER = """
import halfspace as hs
from halfspace.records import BlockState

scene = hs.Scene.load("arch.toml", {"default_law.friction_angle": 30})
world = scene.world()
world.add_block(hs.Shape.rectangle(1, 1), kind="fixed")
world.run(until=2.0, every=0.1, callback=lambda world: world.time < 1, progress=True)
state: BlockState = world.state(world.block("arch.3"))
height: float = state.pose.position[1] + scene.run("out").history.time[-1]
factor: float = scene.safety(low=1).factor
angles = scene.sweep({"default_law.friction_angle": range(15, 45, 5)}, safety=True)["factor_of_safety"]
bricks: list[hs.Shape] = hs.wall(4, 3, (1, 0.5))
balance = world.relax()[1].mean
"""
FAULTS = """
import halfspace as hs

hs.World().state(0).poses
hs.Scene.load(3)
hs.World().run(until="2 s")
"""


def checked(folder, program):
    pytest.importorskip("mypy")
    (folder / "user.py").write_text(program, encoding="utf-8")
    environment = dict(os.environ)
    if "-packages" not in str(PACKAGE):  # mypy finds what is installed by itself
        environment["MYPYPATH"] = str(PACKAGE.parent)
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir", str(folder)]
    return subprocess.run([*command, "user.py"], cwd=folder, env=environment, capture_output=True, text=True).stdout


def test_programs_of_users_are_accepted(tmp_path):
    assert "Success: no issues found" in checked(tmp_path, USER)


def test_faults_of_users_are_found(tmp_path):
    lines = [line.split(": error: ") for line in checked(tmp_path, FAULTS).splitlines()[:-1]]
    assert [place for place, _ in lines] == ["user.py:4", "user.py:5", "user.py:6"]
    assert 'has no attribute "poses"' in lines[0][1] and '"load" of "Scene"' in lines[1][1]


@pytest.mark.skipif(not SETTINGS.exists(), reason="the wheel is tested without the source tree")
def test_the_package_is_accepted(tmp_path):
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--config-file", SETTINGS, "--cache-dir", tmp_path, PACKAGE]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert "Success: no issues found" in done.stdout, done.stdout
