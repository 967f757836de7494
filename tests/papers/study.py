"""Runs of the papers' scenes, what they are compared with, and their curves."""
import csv
import dataclasses
import os
import re
import subprocess
import time
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "docs/examples"
GRAVITY = 9.81
LINE = 0.01  # width of a printed curve, as a fraction of its axis: no figure can be read more accurately
OURS = {"rigid": {"color": "#d1495b", "marker": "o", "markersize": 7, "markerfacecolor": "none"},
        "affine": {"color": "#2e6f9e", "marker": "s", "markersize": 3},
        "mesh": {"color": "#3a7d44", "marker": "^", "markersize": 5}}


@dataclasses.dataclass(frozen=True)
class Value:
    """A number of ours beside the one that is expected."""
    name: str
    ours: float
    expected: float
    tolerance: float

    @property
    def difference(self):
        return abs(self.ours - self.expected)

    @property
    def holds(self):
        return bool(self.difference <= self.tolerance)

    def __str__(self):
        verdict = "" if self.holds else "   NOT WITHIN IT"
        return (f"{self.name}: {self.ours:.6g}, expected {self.expected:.6g}, difference {self.difference:.1e}, "
                f"tolerance {self.tolerance:.1e}{verdict}")


@dataclasses.dataclass(frozen=True)
class Order:
    """Two numbers of ours, of which a paper says that the first one is larger."""
    name: str
    larger: float
    smaller: float

    @property
    def holds(self):
        return self.larger > self.smaller

    def __str__(self):
        return f"{self.name}: {self.larger:.4g} and {self.smaller:.4g}" + ("" if self.holds else "   NOT MORE")


@dataclasses.dataclass(frozen=True)
class Words:
    """Words of ours beside those that are expected."""
    name: str
    ours: str
    expected: str

    @property
    def holds(self):
        return self.ours == self.expected

    def __str__(self):
        return f"{self.name}: {self.ours}" + ("" if self.holds else f"   NOT {self.expected}")


@dataclasses.dataclass(frozen=True)
class Told:
    """What is only printed."""
    words: str
    holds = True

    def __str__(self):
        return self.words


class Run:
    """The history of a run, of its last stage, as columns; and its contacts."""

    def __init__(self, folder):
        self.folder = folder
        with open(folder / "history.csv", newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))
        if "stage" in self.rows[0]:
            last = self.rows[-1]["stage"]
            self.rows = [row | {"time": row["stage_time"]} for row in self.rows if row["stage"] == last]

    def __getitem__(self, name):
        return np.array([float(row[name]) for row in self.rows])

    def at(self, when, name):
        """A column at the row that is nearest to a time."""
        return self[name][np.argmin(abs(self["time"] - when))]

    def frames(self, kind="frame"):
        """Paths of the frames, or of those of contacts."""
        return sorted(self.folder.glob(f"frames/{kind}_*.vtp"), key=lambda path: int(path.stem.split("_")[1]))

    def contact_types(self):
        """The type of the first contact in each frame, as a number; None without a contact."""
        types = (values_of(path, "type") for path in self.frames("contacts"))
        return [int(found[0]) if len(found) else None for found in types]


def time_of(frame):
    return float(re.search(rb'Name="TimeValue"[^>]*>([^<]+)<', frame.read_bytes()).group(1))


def values_of(frame, name):
    """An array of a VTK file whose data are appended as they are: a number of bytes, and the values."""
    head, data = frame.read_bytes().split(b'<AppendedData encoding="raw">', 1)
    found = re.search(rf'type="(\w+)" Name="{name}" NumberOfComponents="(\d+)"[^>]*offset="(\d+)"'.encode(), head)
    kind, components, offset = found.group(1).decode().lower(), int(found.group(2)), int(found.group(3))
    start = data.index(b"_") + 1 + offset
    size = int(np.frombuffer(data, np.uint64, 1, start)[0])
    values = np.frombuffer(data, kind, size // 8, start + 8)
    return values.reshape(-1, components) if components > 1 else values


class Study:
    """A case of a paper: its runs, the numbers that it compares, and its picture."""

    def __init__(self, name, output, quick, panels=1):
        self.name, self.output, self.quick = name, output, quick
        self.values, self.seconds = [], 0.0
        self.figure, axes = plt.subplots(1, panels, figsize=(4.6 * panels if panels > 1 else 6, 3.6), squeeze=False)
        self.axes = axes[0]

    @property
    def kinds(self):
        """Kinds of blocks that cases compare: affine ones have the paper's elasticity."""
        return ("rigid",) if self.quick else ("rigid", "affine")

    def run(self, scene, **settings):
        """Runs docs/examples/SCENE.toml; a setting block__a__kind="affine" is --set block.a.kind=affine."""
        words = [f"{key.replace('__', '.')}={value}" for key, value in settings.items()]
        folder = self.output / "runs" / re.sub(r"[^\w.=,-]+", "_", "_".join([scene.replace("/", "_"), *words]))[:180]
        folder.parent.mkdir(parents=True, exist_ok=True)
        command = os.environ.get("HALFSPACE_COMMAND", str(ROOT / "build/release/bin/halfspace"))
        start = time.monotonic()
        done = subprocess.run([command, "run", str(EXAMPLES / f"{scene}.toml"), "-o", str(folder), "--force",
                               *(f"--set={word}" for word in words)], capture_output=True, text=True, check=False)
        self.seconds += time.monotonic() - start
        if done.returncode:
            raise SystemExit(f"{scene} {' '.join(words)}: {done.stderr}")
        return Run(folder)

    def agree(self, name, ours, expected):
        self.values.append(Words(name, ", ".join(ours), ", ".join(expected)))

    def tell(self, words):
        self.values.append(Told(words))

    def exceeds(self, name, larger, smaller):
        self.values.append(Order(name, float(larger), float(smaller)))

    def compare(self, name, ours, expected, tolerance):
        self.values.append(Value(name, float(ours), float(expected), float(tolerance)))

    def draw(self, kind, x, y, panel=0, label=None, style="-"):
        """A curve of ours with about 25 markers; without a label in the legend where it is None."""
        self.axes[panel].plot(x, y, linestyle=style, linewidth=0.7, markevery=max(1, len(x) // 25), label=label,
                              **OURS[kind])

    def expect(self, x, y, panel=0, label=None, style="-"):
        self.axes[panel].plot(x, y, style, color="black", linewidth=1, label=label)

    def finish(self, titles, across, up):
        """Titles of the panels and of their axes: one for all, or one of each."""
        for panel, axes in enumerate(self.axes):
            title, below, beside = (words if isinstance(words, str) else words[panel] for words in (titles, across, up))
            axes.set_title(title, fontsize=9)
            axes.set_xlabel(below, fontsize=8)
            axes.set_ylabel(beside, fontsize=8)
            axes.tick_params(labelsize=8)
            axes.grid(alpha=0.3)
            if axes.get_legend_handles_labels()[0]:
                axes.legend(fontsize=7)
        self.figure.tight_layout()
        self.figure.savefig(self.output / f"{self.name}.png", dpi=130, metadata={"Software": None})
        plt.close(self.figure)
