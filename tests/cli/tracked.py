"""Points that blocks carry along, and joints between blocks, in the history of a run."""
import math

from command import SceneTest, main

HEAD = """dimension = {dimension}
[world]
duration = 0.5
{world}
[[material]]
name = "rock"
density = 2000
young_modulus = 1e8
poisson_ratio = 0.25
damping_time = 1e-3
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
friction_angle = {friction}
"""

SPINNING = """
[[block]]
name = "box"
material = "rock"
vertices = [[1, 1], [3, 1], [3, 2], [1, 2]]
velocity = [3, 1]
angular_velocity = 90
[output]
frame_interval = 0.05
tracked = [{name = "corner", at = [3, 2]}, "box", {name = "side", at = [2.25, 1]}]
"""


class Points(SceneTest):
    def number(self, row, name):
        return float(row[name])

    def test_a_rigid_block_carries_a_point_around(self):
        self.run_scene(HEAD.format(dimension=2, world="gravity = [0, 0]", friction=0) + SPINNING)
        rows = self.rows()
        self.assertEqual(list(rows[0])[-18:-12], ["box." + name for name in ("x", "y", "angle", "vx", "vy", "angular_velocity")])
        self.assertEqual(list(rows[0])[-12:-6], ["corner." + name for name in ("x", "y", "ux", "uy", "vx", "vy")])
        rate = math.pi / 2
        for row in rows:
            time = float(row["time"])
            for name, (dx, dy) in (("corner", (1, 0.5)), ("side", (0.25, -0.5))):
                c, s = math.cos(rate * time), math.sin(rate * time)
                offset = (c * dx - s * dy, s * dx + c * dy)
                at = (2 + 3 * time + offset[0], 1.5 + time + offset[1])
                for key, value in (("x", at[0]), ("y", at[1]), ("ux", at[0] - 2 - dx), ("uy", at[1] - 1.5 - dy),
                                   ("vx", 3 - rate * offset[1]), ("vy", 1 + rate * offset[0])):
                    self.assertAlmostEqual(float(row[f"{name}.{key}"]), value, delta=1e-9)

    def test_points_of_blocks_that_strain_move_with_their_strain(self):
        # A column under a pressure, free at its sides: strain of plane stress.
        column = """
[[mesh]]
name = "column"
material = "rock"
box = [[0, 0], [1, 4]]
cells = [{cells}]
{kind}
[[mesh.support]]
group = "bottom"
axes = "y"
[[mesh.load]]
group = "top"
pressure = 1e3
[[stage]]
do = "settle"
ratio = 1e-9
[output]
tracked = [{{name = "low", at = [0.3, 1.1]}}, {{name = "high", at = [0.3, 3.3]}}]
"""
        text = HEAD.format(dimension=2, world="gravity = [0, 0]", friction=0).replace("duration = 0.5\n", "")
        text = text.replace("poisson_ratio = 0.25", 'poisson_ratio = 0.25\nplane = "stress"')
        for cells, kind in (("1, 4", ""), ("2, 3", 'cell = "triangle"')):
            self.run_scene(text + column.format(cells=cells, kind=kind))
            last = self.rows()[-1]
            for name, height in (("low", 1.1), ("high", 3.3)):
                self.assertAlmostEqual(float(last[name + ".uy"]) / (-height * 1e3 / 1e8), 1, delta=1e-4)
                self.assertAlmostEqual(float(last[name + ".y"]) - float(last[name + ".uy"]), height, delta=1e-12)

    def test_points_of_an_affine_block_follow_its_gradient(self):
        floor = '[[block]]\nname = "floor"\nmaterial = "rock"\nkind = "fixed"\nvertices = [[-2, -1], [3, -1], [3, 0], [-2, 0]]\n'
        block = '[[block]]\nname = "box"\nkind = "affine"\nmaterial = "rock"\nvertices = [[0, 0], [1, 0], [1, 2], [0, 2]]\n'
        output = '[output]\ntracked = ["box", {name = "foot", at = [0, 0]}, {name = "head", at = [0, 2]}]\n'
        text = HEAD.format(dimension=2, world="", friction=0).replace("duration = 0.5\n", "")
        self.run_scene(text + block + floor + output + '[[stage]]\ndo = "settle"\nratio = 1e-9\n')
        last = self.rows()[-1]
        strain = (float(last["head.uy"]) - float(last["foot.uy"])) / 2
        # Plane strain, free at the sides: syy = E / (1 - nu^2) eyy, and half the weight of the block on average.
        self.assertAlmostEqual(strain / (-2000 * 9.81 * 1 / (1e8 / (1 - 0.25 ** 2))), 1, delta=1e-3)
        middle = (float(last["head.y"]) + float(last["foot.y"])) / 2
        self.assertAlmostEqual(middle, float(last["box.y"]), delta=1e-12)

    def test_in_space(self):
        box = """
[[block]]
name = "box"
material = "rock"
vertices = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]]
angular_velocity = [0, 0, 90]
rotation = [0, 0, 90]
shift = [2, 0, 0]
[output]
tracked = [{name = "corner", at = [2, 2, 2]}]
"""
        self.run_scene(HEAD.format(dimension=3, world="gravity = [0, 0, 0]", friction=0) + box)
        rate = math.pi / 2
        for row in self.rows():
            time = float(row["time"])
            angle = math.pi / 4 + rate * time
            for key, value in (("x", 1 + math.sqrt(2) * math.cos(angle)), ("y", 1 + math.sqrt(2) * math.sin(angle)),
                               ("z", 2), ("uz", 0), ("vx", -rate * math.sqrt(2) * math.sin(angle)), ("vz", 0)):
                self.assertAlmostEqual(float(row["corner." + key]), value, delta=1e-9)

    def test_displacements_are_reset_as_those_of_frames(self):
        text = HEAD.format(dimension=2, world="gravity = [0, 0]", friction=0).replace("duration = 0.5\n", "") + SPINNING
        stage = '[[stage]]\ndo = "run"\nduration = 0.25\n'
        self.run_scene(text.replace("angular_velocity = 90\n", "") + stage + stage + "reset_displacement = true\n")
        self.assertAlmostEqual(float(self.rows()[-1]["corner.ux"]), 0.75, delta=1e-9)
        self.assertAlmostEqual(float(self.rows()[-1]["corner.x"]), 4.5, delta=1e-9)

    def test_faults_name_the_nearest_block_or_what_is_wrong(self):
        text = HEAD.format(dimension=2, world="", friction=0) + SPINNING
        for old, new, fault in [
            ("at = [2.25, 1]", "at = [4.5, 4]", r'output\.tracked\[2\]\.at: \[4\.5, 4\] is outside of all blocks; '
                                                r'the nearest is "box", 2\.5 m away'),
            ('name = "side"', 'name = "corner"', r'output\.tracked\[2\]\.name: used twice: "corner"'),
            ('name = "side"', 'name = "box"', r'output\.tracked\[2\]\.name: used twice: "box"'),
            (', at = [3, 2]', '', r"output\.tracked\[0\]\.at: missing; required: \[x, y\]"),
            ('"box", {', '5, {', r'output\.tracked: not a string or a table: 5; allowed: \["string", \{\.\.\.\}, \.\.\.\]'),
            ('name = "corner"', 'nme = "corner"', r"output\.tracked\[0\]\.nme: unknown key \(did you mean 'name'\?\)"),
        ]:
            self.check_fault(text.replace(old, new, 1), fault)


PLANE = """
[[block]]
name = "slope"
material = "rock"
kind = "fixed"
vertices = [[-1, -1], [9, -1], [9, 0], [-1, 0]]
[[block]]
name = "box"
material = "rock"
vertices = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
"""


class Joints(SceneTest):
    def check_sliding(self, text, weight, area, friction, sign):
        """A box on a slope of 30 degrees, which gravity is turned for, under a friction angle."""
        self.run_scene(text)
        along, normal = 9.81 * math.sin(math.pi / 6), 9.81 * math.cos(math.pi / 6)
        last = self.rows()[-1]
        time = float(last["time"])
        resistance = math.tan(math.radians(friction)) * normal
        for name in "pair", "place":
            # The start within the damped springs costs some displacement; a part in a thousand of the way.
            slip = sign * (along - resistance) * time ** 2 / 2
            self.assertAlmostEqual(float(last[name + ".slip"]) / slip, 1, delta=2e-3)
            self.assertAlmostEqual(float(last[name + ".normal_force"]) / (weight * normal), 1, delta=1e-3)
            self.assertAlmostEqual(float(last[name + ".opening"]) / (-weight * normal / (1e9 * area)), 1, delta=1e-2)
            self.assertAlmostEqual(float(last[name + ".shear_force"]) / (sign * weight * resistance), 1, delta=1e-3)

    def test_slip_opening_and_forces_in_the_plane(self):
        head = HEAD.format(dimension=2, world=f"gravity = [{9.81 * 0.5}, {-9.81 * math.sqrt(3) / 2}]", friction=15)
        joints = '[output]\njoints = [{name = "pair", blocks = ["box", "slope"]}, {name = "place", at = [0.5, 0.1]}]\n'
        # From the slope, the box moves to its right: to +x, with the normal +y.
        self.check_sliding(head + PLANE + joints, 2000 * 0.5, 1, 15, -1)

    def test_slip_opening_and_forces_in_space(self):
        def box(low, high):
            corners = [[x, y, z] for z in (low[2], high[2]) for x, y in
                       ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))]
            return f"vertices = {corners}\n"
        head = HEAD.format(dimension=3, world=f"gravity = [{9.81 * 0.5}, 0, {-9.81 * math.sqrt(3) / 2}]", friction=15)
        blocks = '[[block]]\nname = "slope"\nmaterial = "rock"\nkind = "fixed"\n' + box((-1, -1, -1), (9, 3, 0))
        blocks += '[[block]]\nname = "box"\nmaterial = "rock"\n' + box((0, 0, 0), (1, 2, 0.5))
        joints = '[output]\njoints = [{name = "pair", blocks = ["box", "slope"]}, {name = "place", at = [0.5, 1, 0]}]\n'
        self.check_sliding(head + blocks + joints, 2000, 2, 15, 1)

    def test_forces_of_a_bond(self):
        # The box hangs from the slope, which gravity is turned for.
        head = HEAD.format(dimension=2, world="gravity = [0.5, 2]\nmass_damping = 50", friction=0)
        bond = '[[bond]]\nbetween = ["rock", "rock"]\nnormal_stiffness = 1e9\ntensile_strength = 1e9\ncohesion = 1e9\n'
        self.run_scene(head + bond + PLANE + '[output]\njoints = [{name = "j", blocks = ["box", "slope"]}]\n')
        last = self.rows()[-1]
        for name, value in (("normal_force", -2000), ("shear_force", -500), ("opening", 2e-6), ("slip", -0.5e-6)):
            self.assertAlmostEqual(float(last["j." + name]) / value, 1, delta=1e-3)

    def test_a_joint_that_opens(self):
        head = HEAD.format(dimension=2, world="gravity = [0, 0]", friction=0)
        joints = '[output]\njoints = [{name = "j", blocks = ["slope", "box"]}]\n'
        moving = PLANE + "velocity = [0.5, 2]\n" + joints
        self.run_scene(head + moving.replace("[0, 0], [1, 0], [1, 0.5], [0, 0.5]", "[0, 0.25], [1, 0.25], [1, 1], [0, 1]"))
        for row in self.rows():
            time = float(row["time"])
            self.assertAlmostEqual(float(row["j.opening"]), 0.25 + 2 * time, delta=1e-9)
            self.assertAlmostEqual(float(row["j.slip"]), -0.5 * time, delta=1e-9)
            self.assertEqual((float(row["j.normal_force"]), float(row["j.shear_force"])), (0, 0))

    def test_faults(self):
        text = HEAD.format(dimension=2, world="", friction=0) + PLANE
        wall = PLANE.replace('"slope"', '"wall"').split('[[block]]\nname = "box"')[0].replace("-1", "-2")
        for joint, fault in [
            ('blocks = ["box", "slop"]', r"output\.joints\[0\]\.blocks: no such block: \"slop\" \(did you mean 'slope'"),
            ('blocks = ["box"]', r"output\.joints\[0\]\.blocks: not a pair of blocks; allowed: two names"),
            ('blocks = ["box", "box"]', r"output\.joints\[0\]\.blocks: not a pair of blocks"),
            ('blocks = ["box", "slope"], at = [0, 0]', r"output\.joints\[0\]\.at: the blocks are given as well"),
            ("", r"output\.joints\[0\]\.at: missing"),
            ('blocks = ["slope", "wall"]', r'output\.joints\[0\]\.blocks: "slope" and "wall" never touch'),
        ]:
            self.check_fault(text + wall + f'[output]\njoints = [{{name = "j", {joint}}}]\n'.replace(", }", "}"), fault)


if __name__ == "__main__":
    main()
