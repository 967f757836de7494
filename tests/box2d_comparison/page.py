#!/usr/bin/python3
"""Makes one HTML page, with its pictures in it, of the CSVs that box2d_comparison has left in a folder."""
import argparse
import base64
from html import escape
from pathlib import Path
from statistics import median

import plots
from figures import COST, FORCES, HALFSPACE, IMPULSES, MOTION, NAMES, PAIRS, STOCK, has_range, judge, read
from force_section import force_section
from impulse_section import impulse_section
from words import count, figure_of, get, pay, range_of, ratio

INTRODUCTION = """
<p>The same scenes stepped with Box2D's own narrow phase and with the half-space narrow phase of the adapter. Solver,
broad phase and continuous collision are Box2D's in both: the adapter changes which contacts the solver is given, not
what it makes of them. 60 steps per second, 8 velocity and 3 position iterations, nothing sleeps. A third world is in
<a href="#impulse_mode">impulse mode</a>: impulses of the library in place of Box2D's solver, at the same step. Where it
is meant for the scene, a fourth is in <a href="#force_mode">force mode</a>: forces in sub-steps.</p>
"""

HOW_TO_READ = """
<p><b>Cost and pairs.</b> Frames per second are those that one core could do, over the whole run. For the figures of
pairs both narrow phases are asked about each pair at the same poses, in the world that half-spaces drive, these first,
so that they fetch what both read; the time is the median over steps. The truth is computed in long double, of the true
polygons. A verdict is wrong when manifold points are there and the skins do not reach each other, or the reverse. The
depth's error is that of the largest gap, the normal's that of the nearest face as good as the best to Box2D's own
tolerance, 0.5 mm. Points flicker when they come or go while the two bodies have moved less than 0.1 mm and 0.1
mrad.</p>
<p><b>Motion and luck.</b> A stack that falls, falls elsewhere when it is nudged. So each world is run twice more with
all that moves 0.1 mm to the left and to the right by turns. A figure of motion, or of frames, is called <span
class="better-words">better</span> or <span class="worse-words">worse</span> only where all three runs with half-spaces
are so against all three of Box2D's; else the difference says nothing. Where what is to stay falls in all runs, the
motion is not judged. Energy gained is summed over all steps that end with more energy than they began with; jitter is
the root mean square change of velocity from step to step. Where three runs in force mode would take minutes there is
one, which is called so against all three of Box2D's. Thin lines in the pictures are the nudged runs.</p>
"""


def image(png: bytes, text: str) -> str:
    return f'<img alt="{escape(text)}" src="data:image/png;base64,{base64.b64encode(png).decode()}">'


def row_of(scene, figure) -> str:
    text = f"<tr><td>{escape(figure.words)}</td>"
    for world in scene.worlds():
        verdict, shown = judge(scene, figure, world), ratio(scene, figure, world)
        kind = "unseen" if verdict == "same" and shown == "both unseen" else verdict
        colour = f' class="{kind}"' if world != STOCK else ""
        text += f"<td{colour}>{figure_of(scene, world, figure)}</td>"
        if len(scene.runs(world)) > 1:
            text += f"<td{colour}>{range_of(scene, world, figure) if has_range(figure) else ''}</td>"
        if world != STOCK:
            text += f"<td{colour}>{shown}</td>"
    return text + "</tr>"


def table_of(scene) -> str:
    titles = [""]
    for world in scene.worlds():
        titles += [NAMES.get(world, world)] + ["three runs"] * (len(scene.runs(world)) > 1)
        titles += ["ratio"] * (world != STOCK)
    kind = ' class="wide"' if scene.stiffness else ""
    text = f"<table{kind}><tr>" + "".join(f"<th>{escape(title)}</th>" for title in titles) + "</tr>"
    asked = scene.summary[STOCK]["judged"]
    groups = (("What you pay", COST), (f"The pairs: {count(asked)} verdicts", PAIRS), ("The motion", MOTION))
    for name, figures in groups:
        text += f'<tr class="group"><td colspan="{len(titles)}">{name}</td></tr>'
        text += "".join(row_of(scene, figure) for figure in figures)
    return text + "</table>"


def gains_of(scene, world: str) -> str:
    """What a world costs and what is better and worse in it, in words."""
    better, worse = get(scene, "better", world), get(scene, "worse", world)
    text = pay(scene, world)
    if better:
        text += f' <span class="better-words">Better:</span> {"; ".join(better)}.'
    if worse:
        text += f' <span class="worse-words">Worse:</span> {"; ".join(worse)}.'
    if not better and not worse:
        text += " Nothing else that luck would not explain."
    return text


def section_of(scene) -> str:
    text = f'<section id="{scene.name}"><h2>{escape(scene.title)}</h2><p>{escape(scene.stands_for)}</p>'
    if scene.falls_in_all():
        text += (
            "<p>It is to stay and does not, in any run with Box2D's solver: better contacts do not mend what the solver "
            "leaves undone.</p>"
        )
    text += f"<p><b>Half-space narrow phase.</b> {gains_of(scene, HALFSPACE)}</p>"
    text += f"<p><b>Impulse mode.</b> {gains_of(scene, IMPULSES)}</p>"
    forces = gains_of(scene, FORCES) if scene.stiffness else f"Not run. {escape(scene.why_no_forces)}"
    text += f"<p><b>Force mode.</b> {forces}</p>"
    return text + table_of(scene) + image(plots.scene_plots(scene), f"{scene.title} over time") + "</section>"


def wrong_verdicts(scene, world: str) -> str:
    wrong, farthest = (figure_of(scene, world, figure) for figure in PAIRS[:2])
    return wrong if wrong == "0" else f"{wrong} ({farthest})"


def overall(scenes) -> str:
    """All scenes in one table: cost and how many figures are better or worse."""
    text = (
        "<table><tr><th>scene</th><th>frames, ratio</th><th>time per pair, ratio</th><th>wrong verdicts (farthest off)<br>Box2D | half-space</th>"
        "<th>depth, mean error<br>Box2D | half-space</th><th>flicker<br>Box2D | half-space</th>"
        "<th>figures<br>better | worse</th></tr>"
    )
    _, _, depth, _, _, flicker = PAIRS
    for scene in scenes:
        both = [" | ".join(wrong_verdicts(scene, world) for world in (STOCK, HALFSPACE))]
        both += [" | ".join(figure_of(scene, w, f) for w in (STOCK, HALFSPACE)) for f in (depth, flicker)]
        link = f'<a href="#{scene.name}">{escape(scene.title)}</a>'
        cells = [link, ratio(scene, COST[0]), ratio(scene, COST[1]), *both]
        cells.append(" | ".join(str(len(get(scene, which))) for which in ("better", "worse")))
        text += "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"
    return text + "</table>"


def in_short(scenes) -> str:
    """What is paid, got and not got, in three paragraphs."""

    def total(column: str, world: str) -> str:
        return count(sum(scene.summary[world][column] for scene in scenes))

    def titles(some) -> str:
        return "; ".join(escape(scene.title) for scene in some) or "none"

    frames = sorted(scene.of(HALFSPACE, COST[0]) / scene.of(STOCK, COST[0]) for scene in scenes)
    return (
        f"<p><b>What do I pay?</b> Frames per second are {frames[0]:.2f} to {frames[-1]:.2f} of Box2D's, "
        f"{median(frames):.2f} in the median scene.</p>"
        f"<p><b>What do I get?</b> Of {total('judged', STOCK)} verdicts Box2D has {total('wrong_verdicts', STOCK)} wrong, "
        f"half-spaces {total('wrong_verdicts', HALFSPACE)}; most are of pairs whose skins just touch, and off by micrometres or "
        f"less, the table says by how much at most. Points that came or went while nothing moved: {total('flicker', STOCK)} "
        f"of Box2D's, {total('flicker', HALFSPACE)} of half-spaces.</p>"
        f"<p><b>What do I not get?</b> What falls in all runs, as it is the solver that does not carry it: "
        f"{titles(scene for scene in scenes if scene.falls_in_all())}. Some figure is worse with half-spaces in: "
        f"{titles(scene for scene in scenes if get(scene, 'worse'))}.</p>"
    )


def page_of(scenes) -> str:
    forced = [scene for scene in scenes if scene.stiffness]
    style = (Path(__file__).parent / "style.css").read_text()
    return (
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Half-spaces inside Box2D</title>'
        f"<style>{style}</style></head><body><main><h1>Half-spaces inside Box2D: what do I pay, what do I get?</h1>"
        f"{INTRODUCTION}"
        f"{in_short(scenes)}"
        f'<section><h2>All scenes</h2>{overall(scenes)}{image(plots.overview(scenes), "All scenes")}</section>'
        f'<section id="impulse_mode"><h2>Impulse mode</h2>{impulse_section(scenes)}'
        f'{image(plots.mode_overview(scenes, IMPULSES), "Impulse mode")}</section>'
        f'<section id="force_mode"><h2>Force mode</h2>{force_section(scenes)}'
        f'{image(plots.mode_overview(forced, FORCES), "Force mode") if forced else ""}</section>'
        f"<section><h2>How to read this</h2>{HOW_TO_READ}</section>"
        + "".join(section_of(scene) for scene in scenes)
        + "</main></body></html>\n"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where box2d_comparison has left its CSVs")
    parser.add_argument("-o", "--output", type=Path, help="the page to write (default: index.html in the folder)")
    arguments = parser.parse_args()
    output = arguments.output or arguments.folder / "index.html"
    output.write_text(page_of(read(arguments.folder)), encoding="utf-8")


if __name__ == "__main__":
    main()
