#!/usr/bin/python3
"""check.py BOX2D_COMPARISON: runs the comparison shortened, makes its page, and looks whether every scene is in all of
it. No figure decides, but that half-spaces are to have no verdict wrong."""
import csv
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SCENES = {
    "pyramid", "stack_10", "stack_50", "mass_ratio_100", "mass_ratio_1000", "dominoes", "card_house", "bullet",
    "slope_below_friction", "slope_at_friction", "slopes_settled", "slopes_of_two", "tiny_edges", "balanced", "slivers",
    "heap", "heap_10km", "stack_10km", "stack_1000km",
}  # fmt: skip
WORLDS = {world + run for world in ("box2d", "halfspace", "impulses") for run in ("", "_nudged", "_nudged_back")}
FORCES = "forces"  # in the scenes that it is meant for
WITHOUT_FORCES = {"bullet", "tiny_edges", "slivers", "heap", "heap_10km", "stack_1000km"}
FORCES_ONCE = {"pyramid", "stack_50", "slopes_of_two"}
STEPS = 30


def require(condition: bool, fault: str) -> None:
    if not condition:
        sys.exit(f"FAILED: {fault}")


def rows_of(path: Path) -> list:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def numbers_are_finite(rows: list) -> bool:
    texts = [text for row in rows for name, text in row.items() if name not in ("scene", "world")]
    return all(math.isfinite(float(text)) for text in texts if text)


def main() -> None:
    here = Path(__file__).parent
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        subprocess.run([sys.argv[1], "--quick", "-o", folder], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([sys.executable, "-B", here / "page.py", folder], check=True)

        scenes, summary, steps = (rows_of(folder / f"{name}.csv") for name in ("scenes", "summary", "steps"))
        require({row["scene"] for row in scenes} == SCENES, "scenes.csv has other scenes than those known")
        expected = {(scene, world) for scene in SCENES for world in WORLDS}
        expected |= {(scene, FORCES) for scene in SCENES - WITHOUT_FORCES}
        nudged = SCENES - WITHOUT_FORCES - FORCES_ONCE
        expected |= {(scene, FORCES + run) for scene in nudged for run in ("_nudged", "_nudged_back")}
        found = {(row["scene"], row["world"]) for row in summary}
        require(found == expected, f"summary.csv has other rows than are expected: {sorted(found ^ expected)}")
        for row in scenes:
            is_run = row["scene"] not in WITHOUT_FORCES
            require(bool(row["stiffness"]) == is_run, f"stiffness of {row['scene']}")
            require(bool(row["why_no_forces"]) != is_run, f"why {row['scene']} is not run in force mode")
        for row in summary:
            scene, world = row["scene"], row["world"]
            require((int(row["sub_steps"]) > 1) == world.startswith(FORCES), f"sub-steps of {scene}, {world}")
        for pair in expected:
            found = sum((row["scene"], row["world"]) == pair for row in steps)
            require(found == STEPS, f"steps.csv has {found} rows of {pair}, not {STEPS}")
        require(numbers_are_finite(summary) and numbers_are_finite(steps), "a figure is not finite")
        wrong = sum(int(row["wrong_verdicts"]) for row in summary if row["world"] == "halfspace")
        require(wrong == 0, f"half-spaces have {wrong} verdicts wrong")

        page = (folder / "index.html").read_text(encoding="utf-8")
        for row in scenes:
            require(f'<section id="{row["scene"]}">' in page, f"{row['scene']} is not on the page")
        pictures = len(re.findall(r'src="data:image/png;base64,', page))
        require(pictures == len(SCENES) + 3, f"the page has {pictures} pictures")
        not_run = page.count("<b>Force mode.</b> Not run. ")
        require(not_run == len(WITHOUT_FORCES), f"the page says of {not_run} scenes why they are not run in force mode")
        for mode in ("impulse", "force"):
            require(f'<section id="{mode}_mode">' in page, f"{mode} mode has no section")
        require(not re.search(r'(src|href)="(?!data:|#)', page), "the page leans on another file")


if __name__ == "__main__":
    main()
