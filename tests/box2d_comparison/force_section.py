"""What the page says of force mode: its law, what it costs, where it is better and where worse."""
from html import escape
from statistics import median

from figures import COST, FORCES, MOTION, NAMES, STOCK, extremes, judge
from words import count, figure_of, number, range_of, ratio

LAW = """
<p>Box2D's solver passes pairs of polygons by, and forces of the library act in its place, in sub-steps. One rule makes
the law of all scenes. The stiffness is such that the usual block on the ground overlaps it by 0.1 mm under its
share of the weight of all, a fiftieth of what Box2D's solver leaves skins to overlap (its linear slop, 5 mm). Along the
face it is four times as much, and damping is critical. Sub-steps are half as long as the library's stable step, as
<code>ForceMode::sub_steps_for()</code> advises. Blocks have no skins: they begin where they just touch, or as high
above each other as in Box2D's worlds beyond the skins. The energy is that of the bodies, without what springs hold and
give back.</p>
"""

CREEP_WORDS = """
<p><b>Creep at friction = slope.</b> A block that is let go falls vertically until its spring carries it, which is along
the edge of the friction cone, and stops; so does one that begins within the slope, as one of the nudges makes it, for
what is put down overlapping carries its weight straight down. Box2D's keeps the speed that its first step leaves it. Of
two blocks the lower one leans downhill on its spring by up to 2 W / (k w), W their weight, k the stiffness and w the
width. So the upper one lies on a slope a little steeper than the friction angle and goes g t&sup2; W / (k w) at most in
the time t, on all slopes alike; that falls with the stiffness. Box2D's creep is what its iterations leave undone: far
more on half of the slopes, less on some, none on a few.</p>
"""

FRAMES = COST[0]
MOTION_OF = {figure.column: figure for figure in MOTION}


def table(titles: list, rows: list) -> str:
    """Cells are pairs of a text and a class."""
    head = "".join(f"<th>{title}</th>" for title in titles)
    body = "".join(
        "<tr>" + "".join(f'<td class="{kind}">{text}</td>' for text, kind in row) + "</tr>" for row in rows
    )
    return f'<table class="wide"><tr>{head}</tr>{body}</table>'


def name_of(scene) -> tuple:
    return f'<a href="#{scene.name}">{escape(scene.title)}</a>', ""


def against(scene, figure, mode: str = FORCES) -> tuple:
    """Box2D | mode."""
    both = (figure_of(scene, world, figure) for world in (STOCK, mode))
    return " | ".join(both), judge(scene, figure, mode)


def _all_table(scenes: list) -> str:
    titles = ["Box2D | force mode", "stiffness", "sub-steps<br>in a frame", "frames<br>per second", "ratio"]
    titles += ["at rest after", "drift of<br>the farthest", "energy<br>gained", "jitter"]
    rows = []
    for scene in scenes:
        row = [name_of(scene), (number(scene.stiffness / 1e6) + " MN/m", "")]
        row += [(count(scene.summary[FORCES]["sub_steps"]), "")]
        row += [against(scene, FRAMES), (ratio(scene, FRAMES, FORCES), "")]
        row += [against(scene, MOTION_OF[column]) for column in ("rest_time", "drift", "energy_gained", "jitter")]
        rows.append(row)
    return table(titles, rows)


def _creep_table(scenes: list) -> str:
    creep = MOTION_OF["creep"]
    titles = ["", "creep of the farthest block:<br>Box2D, all runs", "force mode,<br>all runs", "ratio of<br>the first"]
    titles += [f"drift of the {block}:<br>Box2D | force mode" for block in ("farthest", "usual block")]
    rows = []
    for scene in scenes:
        kind = judge(scene, creep, FORCES)
        row = [name_of(scene), (range_of(scene, STOCK, creep), "")]
        row += [(range_of(scene, FORCES, creep), kind), (ratio(scene, creep, FORCES), kind)]
        rows.append(row + [against(scene, MOTION_OF[column]) for column in ("drift", "median_drift")])
    return table(titles, rows)


def _cost(scenes: list) -> str:
    slower = sorted(scene.of(STOCK, FRAMES) / scene.of(FORCES, FRAMES) for scene in scenes)
    slowest = min(scenes, key=lambda scene: scene.of(FORCES, FRAMES))
    live = sum(scene.of(FORCES, FRAMES) >= 60 for scene in scenes)
    return (
        f"<p><b>What it costs.</b> A frame takes {count(slower[0])} to {count(slower[-1])} times as long as Box2D's, "
        f"{count(median(slower))} times in the median scene. {live} of {len(scenes)} scenes keep up with 60 frames per "
        f"second on one core; the slowest, {escape(slowest.title)}, has {figure_of(slowest, FORCES, FRAMES)}.</p>"
    )


def _worse(scene, figure, mode: str) -> str:
    """The figure's name if it is worse than Box2D's, in all runs or in the worst of either."""
    if judge(scene, figure, mode) == "worse":
        return figure.words
    worst_stock, worst = (extremes(scene, world, figure)[1] for world in (STOCK, mode))
    is_worse = not scene.falls_in_all(mode) and worst > worst_stock * (1 + figure.noise) + figure.floor
    return f"{figure.words}, in some run" if is_worse else ""


def gains(scenes: list, mode: str = FORCES) -> str:
    def fallen(world: str) -> str:
        titles = [escape(s.title) for s in scenes if any(s.has_fallen(run) for run in s.runs(world))]
        return "; ".join(titles) or "none"

    worse = []
    for scene in scenes:
        figures = [words for figure in MOTION if (words := _worse(scene, figure, mode))]
        if figures:
            worse.append(f"{escape(scene.title)} ({'; '.join(figures)})")
    return (
        f"<p><b>What falls that is to stay.</b> In Box2D: {fallen(STOCK)}. In {NAMES[mode]}: {fallen(mode)}.</p>"
        f'<p><span class="worse-words">Worse than Box2D</span>, but for the cost: {"; ".join(worse) or "nowhere"}.</p>'
    )


def force_section(scenes: list) -> str:
    run = [scene for scene in scenes if scene.stiffness]
    if not run:
        return "<p>Not run.</p>"
    slopes = [scene for scene in run if scene.on_slopes]
    return LAW + _cost(run) + gains(run) + _all_table(run) + CREEP_WORDS + _creep_table(slopes)
