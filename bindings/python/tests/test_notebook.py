"""The example notebook runs in a kernel, with a progress bar in its output."""
import math
import pathlib

import pytest

NOTEBOOK = pathlib.Path(__file__).parents[1] / "examples" / "arch.ipynb"


def outputs_of(cell, kind):
    return [each for each in cell.outputs if each.output_type in ("display_data", "execute_result") and kind in each.data]


@pytest.mark.skipif(not NOTEBOOK.exists(), reason="the wheel is tested without the source tree")
def test_the_notebook_runs():
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    first, second, third, scene, safety, sweep = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert first.outputs[-1].data["text/plain"] == "[]"  # no notes
    bar, picture = outputs_of(second, "text/html")[0], outputs_of(second, "image/png")[0]
    assert '<progress value="1.0000" max="1"></progress> 100 %  t = 0.5 of 0.5 s' == bar.data["text/html"]
    assert len(picture.data["image/png"]) > 1000
    assert "27" in second.outputs[-1].data["text/plain"] or "28 blocks" in second.outputs[-1].data["text/plain"]
    for cell in (scene, safety, sweep):
        assert len(outputs_of(cell, "text/html")) == 1  # one bar, which is drawn anew
    factor = float(safety.outputs[-1].data["text/plain"])
    assert abs(factor - math.tan(math.radians(40)) / math.tan(math.radians(20))) <= 0.01
