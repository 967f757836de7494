"""Runs of worlds in time, their progress, and files of their blocks."""
import io
import sys
import types

import numpy as np
import pytest

import halfspace as hs


def test_a_run_ends_at_the_nearest_step(resting_world):
    resting_world.run(0.05)
    assert resting_world.time == pytest.approx(0.05)
    resting_world.run(until=0.0804)
    assert resting_world.time == pytest.approx(0.08)


def test_the_steps_of_a_run_are_those_of_step(resting_world):
    other = hs.World.restore(resting_world.save())
    resting_world.run(until=0.2, every=0.013, callback=lambda world: None)
    other.step(200)
    assert resting_world.save() == other.save()


def test_callbacks_are_called_at_multiples_of_their_interval(resting_world):
    times = []
    resting_world.run(until=0.25, every=0.1, callback=lambda world: times.append(world.time))
    assert times == pytest.approx([0.1, 0.2, 0.25])


def test_a_callback_ends_the_run(resting_world):
    resting_world.run(until=1, every=0.1, callback=lambda world: world.time < 0.25)
    assert resting_world.time == pytest.approx(0.3)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def run_with_progress(world):
    world.run(0.1, progress=True)
    scene = hs.Scene.from_world(world, 0.01)
    scene.run(progress=True)
    scene.sweep({"world.safety": [0.4, 0.5]}, progress=True)


def test_progress_is_shown_in_a_terminal(resting_world, monkeypatch):
    monkeypatch.setattr(sys, "stderr", Terminal())
    run_with_progress(resting_world)
    shown = sys.stderr.getvalue()
    assert "100 %" in shown and "t = 0.1 of 0.1 s" in shown and "2 of 2 runs" in shown and shown.endswith("\n")


def test_progress_is_not_written_to_files(resting_world, monkeypatch, tmp_path):
    with (tmp_path / "log.txt").open("w", encoding="utf-8") as log:
        monkeypatch.setattr(sys, "stderr", log)
        run_with_progress(resting_world)
    assert (tmp_path / "log.txt").read_text(encoding="utf-8") == ""
    run_with_progress(resting_world)  # to a file that is closed
    for stream in (None, types.SimpleNamespace(write=pytest.fail)):  # without a console; a logger's
        monkeypatch.setattr(sys, "stderr", stream)
        run_with_progress(resting_world)


@pytest.mark.parametrize("end", [{"duration": -1}, {"duration": float("nan")}, {"until": float("inf")}])
def test_an_end_is_finite(resting_world, end):
    (name, value), = end.items()
    with pytest.raises(ValueError, match=f"{name} is {value}; it must be"):
        resting_world.run(**end)


def test_a_run_without_an_end_is_refused(resting_world):
    with pytest.raises(ValueError, match="either duration or until"):
        resting_world.run()
    with pytest.raises(ValueError, match="every is 0; it must be above 0"):
        resting_world.run(1, every=0)


def vtk_arrays(path):
    """The cell arrays of a file of VTK."""
    if "/usr/lib/python3/dist-packages" not in sys.path:
        pytest.importorskip("vtkmodules")
    reader = pytest.importorskip("vtkmodules.vtkIOXML").vtkXMLPolyDataReader()
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader.SetFileName(str(path))
    reader.Update()
    found = reader.GetOutput()
    data = found.GetCellData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    arrays = {name: vtk_to_numpy(data.GetArray(name)) for name in names}
    return found, arrays


def test_vtk_files_of_a_world(resting_world, tmp_path):
    start = resting_world.poses
    resting_world.run(0.5)
    resting_world.write_vtk(tmp_path / "frame_0000.vtp", contacts=True, start=start)
    found, arrays = vtk_arrays(tmp_path / "frame_0000.vtp")
    assert found.GetNumberOfCells() == 2 and found.GetNumberOfPoints() == 8
    assert arrays["displacement"][:, :2] == pytest.approx(resting_world.positions - start[:, :2])
    _, contacts = vtk_arrays(tmp_path / "frame_0000_contacts.vtp")
    assert contacts["normal_force"].sum() == pytest.approx(2000 * 9.81, rel=1e-3)


def test_vtk_files_in_space_have_all_faces(tmp_path):
    world = hs.World(3)
    world.add_material(2000)
    world.add_blocks(hs.stack((1, 1, 2), 2))
    world.write_vtk(tmp_path / "boxes.vtp")
    found, arrays = vtk_arrays(tmp_path / "boxes.vtp")
    assert found.GetNumberOfCells() == 12 and found.GetNumberOfPoints() == 16
    assert np.bincount(arrays["block"]).tolist() == [6, 6]
    assert found.GetBounds() == pytest.approx((-0.5, 0.5, -0.5, 0.5, 0, 4))
    with pytest.raises(hs.StateError, match="cannot"):
        world.write_vtk(tmp_path / "boxes.vtp" / "nowhere.vtp")
