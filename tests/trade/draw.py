"""Pictures and tables of trade.csv: error against cost of each engine, task by task."""
import collections
import csv
import dataclasses
import math
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

LOOKS = {  # colour and marker
    "halfspace, no springs": ("#f08000", "h"),
    "halfspace, per contact": ("#d1495b", "o"),
    "halfspace, per area": ("#e58c8a", "s"),
    "halfspace, potential": ("#7c2e41", "^"),
    "halfspace, per contact, affine": ("#b08968", "D"),
    "Box2D": ("#2e6f9e", "v"),
    "Box2D 3": ("#56b4e9", "<"),
    "Box3D 0": ("#00897b", "<"),
    "Bullet, double": ("#3a7d44", "v"),
    "Bullet, single": ("#8fbc94", "P"),
    "ODE": ("#8a6fb3", "X"),
    "YADE": ("#666666", "*"),
}
LONGEST = 100  # s of one case
SMALLEST = 1e-9  # the lower limit of drawn errors
TARGETS = (1e-1, 1e-2, 1e-3, 1e-4)


def look(curve):
    return LOOKS.get(curve) or LOOKS.get(curve.split(".")[0], ("black", "."))  # of all versions 3.1.1, 3.2.0


@dataclasses.dataclass(frozen=True)
class Row:
    task: str
    dimension: int
    engine: str
    way: str
    indentation: float
    step: float
    value: float
    exact: float
    error: float
    cost: float  # processor seconds per simulated second

    @property
    def curve(self):
        """A law or kind of this library has its own curve; a peer has one curve for all its solvers."""
        law = re.sub(r", (\d+ iterations|tolerance .*)", "", self.way)
        return f"{self.engine}, {law}" if self.engine == "halfspace" else self.engine


def rows_of(path):
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            found = Row(row["task"], int(row["dimension"]), row["engine"], row["way"],
                        float(row["indentation"]), float(row["step"]), float(row["value"]),
                        float(row["exact"]), float(row["error"]), float(row["cpu_seconds_per_second"]))
            yield found


def grouped(rows, key):
    groups = collections.defaultdict(list)
    for row in rows:
        groups[key(row)].append(row)
    return groups


def front(rows):
    """The Pareto front of error and cost, cheapest first."""
    best = []
    for row in sorted(rows, key=lambda row: (row.cost, row.error)):
        if not best or row.error < best[-1].error:
            best.append(row)
    return best


def draw_dimension(rows, path):
    tasks = grouped(rows, lambda row: row.task)
    across = 3
    down = math.ceil((len(tasks) + 1) / across)
    figure, axes = plt.subplots(down, across, figsize=(3.4 * across, 2.8 * down), layout="constrained")
    for axis, (task, of_task) in zip(axes.flat, tasks.items()):
        for curve, points in grouped(of_task, lambda row: row.curve).items():
            colour, marker = look(curve)
            best = front(points)
            axis.plot([row.cost for row in points], [max(row.error, SMALLEST) for row in points], marker, color=colour,
                      markersize=3, alpha=0.35)
            axis.plot([row.cost for row in best], [max(row.error, SMALLEST) for row in best], marker + "-",
                      color=colour, markersize=5, linewidth=1.2)
        axis.set(xscale="log", yscale="log", title=task)
        axis.grid(color="#dddddd", linewidth=0.5)
    for axis in axes.flat[len(tasks):]:
        axis.set_axis_off()
    shown = list(dict.fromkeys(row.curve for row in rows))
    handles = [plt.Line2D([], [], color=look(curve)[0], marker=look(curve)[1], label=curve) for curve in shown]
    axes.flat[-1].legend(handles=handles, loc="center", frameon=False)
    figure.supxlabel("processor seconds per simulated second")
    figure.supylabel("relative error")
    figure.savefig(path, dpi=100)
    plt.close(figure)


def cost_to_reach(rows, target):
    """The cost of the cheapest setting within the error; rows without a value have exceeded the time limit."""
    within = [row.cost for row in rows if row.error <= target]
    if within:
        return f"{min(within):.1e}"
    return f"> {LONGEST} s" if any(math.isnan(row.error) for row in rows) else "—"


def finest_first(rows):
    """Points by indentation at the default step, or else by step: those of the variant with the costliest run."""
    whole = [row for row in rows if math.isfinite(row.error)]
    way = max(whole, key=lambda row: row.cost).way
    with_springs = [row for row in whole if row.way == way and row.indentation > 0 and row.step == 0.5]
    ladder = with_springs or [row for row in whole if row.way == way]
    return sorted(ladder, key=lambda row: (row.indentation, row.step))


def own_error(finest, next_finest):
    return abs(finest.value - next_finest.value) / (abs(finest.exact) or 1)


def table(rows, dimension):
    lines = []
    for task, of_task in grouped((row for row in rows if row.dimension == dimension), lambda row: row.task).items():
        lines += ["", f"### {task.capitalize()}", "",
                  "| engine | 10 % | 1 % | 0.1 % | 0.01 % | min | finest | from the next |",
                  "|---|---:|---:|---:|---:|---:|---:|---:|"]
        for curve, points in grouped(of_task, lambda row: row.curve).items():
            ladder = finest_first(points)
            cells = [curve] + [cost_to_reach(points, target) for target in TARGETS]
            cells += [f"{min(row.error for row in points if math.isfinite(row.error)):.1e}", f"{ladder[0].error:.1e}"]
            cells += [f"{own_error(*ladder[:2]):.1e}" if len(ladder) > 1 else "—"]
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines[1:])


PAGE = """# Cost to reach an error, task by task

Processor seconds per second of the scene, at the cheapest setting within the error. A dash: no setting reaches the
error; "> 100 s": none reached it within that time. "Min" is the smallest error. "Finest" is the error with the stiffest
springs at half of the stable step, or with the shortest step. Both are against the exact answer. The last column is the
difference between this run and the next finest. If this difference is small and both are far from the exact answer, the
engine converges to another value; smaller errors are then coincidence.

Bisection has the exact answer in the middle of its interval: no error is below 3.1e-5, and 0.5 means that the outcome
is the same from half the exact answer to one and a half. Costs of equal runs differed by up to 1.5 times.
`tests/trade/run` writes this page.

## In the plane

{plane}

## In space

{space}
"""


def draw_all(csv_path, output):
    rows = list(rows_of(csv_path))
    for dimension, name in ((2, "plane"), (3, "space")):
        draw_dimension([row for row in rows if row.dimension == dimension and math.isfinite(row.error)], output / f"trade_{name}.png")
    (output / "trade_costs.md").write_text(PAGE.format(plane=table(rows, 2), space=table(rows, 3)), encoding="utf-8")
