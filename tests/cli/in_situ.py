"""Rigid blocks that start under in-situ stress are in equilibrium from the first step on."""
import re

from command import SceneTest, main

HEAD = """title = "in situ"
dimension = {dimension}
[world]
[[material]]
name = "rock"
density = 2500
[default_law]
stiffness = "{stiffness}"
normal_stiffness = 1e10
friction_angle = 40
[in_situ]
surface = 12
K0 = 0.6
material = "rock"
[[stage]]
do = "settle"
max_steps = 1
ratio = 1e-12
"""
PLANE = """
block = [
  { name = "floor", kind = "fixed", material = "rock", vertices = [[-2, -2], [22, -2], [22, 0], [-2, 0]] },
  { name = "left", kind = "fixed", material = "rock", vertices = [[-2, 0], [0, 0], [0, 12], [-2, 12]] },
  { name = "right", kind = "fixed", material = "rock", vertices = [[20, 0], [22, 0], [22, 12], [20, 12]] },
]
[[jointed_rock]]
name = "rock"
material = "rock"
region = [[0, 0], [20, 0], [20, 12], [0, 12]]
joint_set = [{ dip = 20, spacing = 1.3 }, { dip = -65, spacing = 1.7, jitter = 0.3 }]
"""
SETS = """joint_set = [
  { dip = 20, dip_direction = 30, spacing = 2.3 },
  { dip = 75, dip_direction = 200, spacing = 2.7 },
  { dip = 80, dip_direction = 110, spacing = 2.5 },
]
"""


def wall(name, low, high):
    corners = [[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    return f'[[block]]\nname = "{name}"\nkind = "fixed"\nmaterial = "rock"\nvertices = {corners}\n'


SPACE = (
    f'\n[[jointed_rock]]\nname = "rock"\nmaterial = "rock"\nbox = [[0, 0, 0], [8, 8, 8]]\n{SETS}'
    + wall("base", [-1, -1, -1], [9, 9, 0])
    + wall("roof", [-1, -1, 8], [9, 9, 9])
    + wall("west", [-1, -1, 0], [0, 9, 8])
    + wall("east", [8, -1, 0], [9, 9, 8])
    + wall("south", [0, -1, 0], [8, 0, 8])
    + wall("north", [0, 8, 0], [8, 9, 8])
)


def scene(dimension, blocks, stiffness="per area"):
    """Inline tables of the top level stand before the first table."""
    top, tables = HEAD.format(dimension=dimension, stiffness=stiffness).split("[world]", 1)
    inline, rest = blocks.split("[[jointed_rock]]", 1)
    return top + inline + "[world]" + tables + "[[jointed_rock]]" + rest


class InSitu(SceneTest):
    def test_nothing_is_unbalanced_at_the_start(self):
        for dimension, blocks in ((2, PLANE), (3, SPACE)):
            with self.subTest(dimension):
                told = self.run_scene(scene(dimension, blocks)).stdout
                mean, largest = re.search(r"unbalanced ratio (\S+), of a single block (\S+?)[;\s]", told).groups()
                # The overlap is 2.5e-5 m: at ends of joints a pressure on this height acts across, too.
                self.assertLess(float(mean), 2e-4)
                self.assertLess(float(largest), 1e-3)

    def test_faults_are_named(self):
        self.check_fault(scene(2, PLANE, "per contact"), r"in_situ: the joints of .* have no stiffness per area")
        unknown = scene(2, PLANE).replace('material = "rock"\n[[stage]]', 'material = "sand"\n[[stage]]')
        self.check_fault(unknown, "in_situ.material: no such material")


if __name__ == "__main__":
    main()
