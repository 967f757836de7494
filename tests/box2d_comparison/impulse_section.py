"""The section of the page about impulse mode: its cost, and where it is better and worse."""
from statistics import median

from figures import COST, IMPULSES, MOTION, STOCK
from force_section import against, gains, name_of, table
from words import ratio

METHOD = """
<p>Impulses of the library replace Box2D's solver between polygons, at Box2D's own step of 1/60 s: unilateral
constraints with Coulomb friction, solved to a tolerance. Blocks have no skins: they begin where they just touch, or as
high above each other as in Box2D's worlds beyond the skins. All scenes use the default options.</p>
"""

FRAMES = COST[0]


def _cost(scenes: list) -> str:
    slower = sorted(scene.of(STOCK, FRAMES) / scene.of(IMPULSES, FRAMES) for scene in scenes)
    return (
        f"<p><b>What it costs.</b> A frame takes {slower[0]:.1f} to {slower[-1]:.0f} times as long as Box2D's, "
        f"{median(slower):.1f} times in the median scene.</p>"
    )


def impulse_section(scenes: list) -> str:
    titles = ["Box2D | impulse mode", "frames<br>per second", "ratio"]
    titles += ["at rest after", "drift of<br>the farthest", "creep of<br>the farthest", "energy<br>gained", "jitter"]
    columns = ("rest_time", "drift", "creep", "energy_gained", "jitter")
    figures = [figure for column in columns for figure in MOTION if figure.column == column]
    rows = []
    for scene in scenes:
        row = [name_of(scene), against(scene, FRAMES, IMPULSES), (ratio(scene, FRAMES, IMPULSES), "")]
        rows.append(row + [against(scene, figure, IMPULSES) for figure in figures])
    return METHOD + _cost(scenes) + gains(scenes, IMPULSES) + table(titles, rows)
