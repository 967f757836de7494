"""What is legal but seldom meant is told before the run: by `check` apart from the faults, by `run`, and in the summary."""
import re
import tempfile
import unittest
from pathlib import Path

from command import EXAMPLES, halfspace, main

HEAD = """dimension = {}
[world]
duration = 0.01
[[material]]
name = "stone"
density = 2500
[[material]]
name = "rubber"
density = 1000
young_modulus = 1e6
poisson_ratio = 0.3
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
shear_stiffness = 1e8
"""


def block(name, low, high, more="", material="stone"):
    """An upright box."""
    if len(low) == 2:
        corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
    else:
        corners = [[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]]
                   for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    return f'[[block]]\nname = "{name}"\nmaterial = "{material}"\nvertices = {corners}\n{more}\n'


def boundary(points, more=""):
    return ('[[block]]\nname = "ground"\nmaterial = "stone"\nkind = "fixed"\ndepth = 0.5\n'
            f"boundary = {points}\n{more}\n")


class Notes(unittest.TestCase):
    def check(self, blocks, dimension=2, **changes):
        """The notes of a scene that has no faults, each without the name of the file; but for those of the head's
        materials, of which not all scenes have blocks."""
        head = HEAD.format(dimension)
        for key, value in changes.items():
            head = re.sub(rf"(?m)^{key} = .*$", f"{key} = {value}", head) if re.search(rf"(?m)^{key} = ", head) \
                else head.replace("[world]\n", f"[world]\n{key} = {value}\n")
        return self.check_text(head + blocks)

    def check_text(self, text):
        with tempfile.TemporaryDirectory() as directory:
            scene = Path(directory, "scene.toml")
            scene.write_text(text)
            answer = halfspace("check", scene)
            self.assertEqual((answer.returncode, answer.stderr), (0, ""))
            first, *notes = answer.stdout.splitlines()
            self.assertIn("no faults, ", first)
            return [note.removeprefix(f"{scene}:") for note in notes if "no block is of" not in note]

    def assert_one(self, notes, pattern):
        self.assertEqual(len(notes), 1, notes)
        self.assertRegex(notes[0], pattern)

    def test_blocks_that_overlap(self):
        pair = block("lower", [0, 0], [1, 1]) + block("upper", [0.2, 0.6], [1.2, 1.6])
        self.assert_one(self.check(pair), r'^22:8: note: block\[1\]: "upper" overlaps "lower" at the start by 0\.4 m, 40 % of '
                                          "the thinner one's thickness")
        for kind in ("fixed", "prescribed", "affine"):
            other = pair.replace("upper", f'upper"\nkind = "{kind}', 1).replace(
                'material = "stone"', 'material = "rubber"')
            self.assert_one(self.check(other), "by 0.4 m, 40 %")
        solid = block("lower", [0, 0, 0], [1, 1, 1]) + block("upper", [0, 0, 0.999], [1, 1, 1.499])
        self.assert_one(self.check(solid, 3), r"by 0\.001 m, 0\.2 % of")
        for stiffness in ('"per area"', '"potential"'):
            self.assert_one(self.check(pair, stiffness=stiffness), "by 0.4 m, 40 %")
            self.assert_one(self.check(solid, 3, stiffness=stiffness), "by 0.001 m, 0.2 %")
        ground = boundary([[9, 0], [-9, 0]])
        self.assert_one(self.check(block("sunk", [0, -0.1], [1, 1]) + ground),
                        '"ground" overlaps "sunk" .* by 0.1 m, 20 % of')

    def test_of_many_overlaps_the_deepest_are_told(self):
        row = "".join(block(f"b{i}", [0.9 * i, 0], [0.9 * i + 1 + 0.001 * i, 1]) for i in range(12))
        notes = self.check(row)
        self.assertEqual(len(notes), 5)
        self.assertEqual(sum('"b11" overlaps "b10"' in note for note in notes), 1)
        self.assertEqual(sum("; 6 more pairs overlap less" in note for note in notes), 1)

    def test_blocks_that_touch_to_rounding_do_not_overlap(self):
        turned = "rotation = 36.8698341166685\nshift = [1e6, -3e5]\n"
        wall = "".join(block(f"b{i}.{j}", [i, 0.5 * j], [i + 1, 0.5 * j + 0.5], turned)
                       for i in range(4) for j in range(4))
        self.assertEqual(self.check(wall), [])
        rock = '[[jointed_rock]]\nname = "rock"\nmaterial = "stone"\n'
        joints = "".join(f"[[jointed_rock.joint_set]]\ndip = {dip}\nspacing = {spacing}\n"
                         for dip, spacing in ((31.7, 0.3), (-67.3, 0.4)))
        self.assertEqual(self.check(rock + "box = [[3000.1, 0.3], [3004.3, 5.7]]\n" + joints), [])
        joints = joints.replace("spacing", "dip_direction = 17.3\nspacing").replace("-67.3", "67.3")
        self.assertEqual(self.check(rock + "box = [[0.1, 0.3, 0.7], [4.3, 5.7, 2.9]]\n" + joints, 3), [])
        cells = '[[voronoi]]\nname = "cell"\nmaterial = "stone"\ncount = 200\nbox = [[0, 0, 0], [1, 2, 3]]\n'
        self.assertEqual(self.check(cells, 3), [])
        triangles = '[[triangulated]]\nname = "t"\nmaterial = "stone"\ncount = 200\nlower_left = [0, 0]\nupper_right = [7, 3]\n'
        self.assertEqual(self.check(triangles), [])

    def test_boundaries_the_wrong_way_round(self):
        inside = block("inside", [1, 1], [2, 2])
        walls = [[-3, -2], [5, -2], [5, 7], [-3, 7]]  # counter-clockwise: wrong around a block
        valley = [[9, 5], [2, -1], [0, -1], [-9, 5]]
        for points in ([[9, 0], [-9, 0]], walls[::-1], walls[::-1] + walls[-1:], valley, [[0, -9], [0, 9]]):
            self.assertEqual(self.check(inside + boundary(points)), [], points)
            self.assert_one(self.check(inside + boundary(points[::-1])),
                            r'note: block\[1\]\.boundary: "ground" seems to be reversed: 1 of 1 free block behind it; usual: ')
        turned = "rotation = 180\nshift = [0, -0.5]\n"
        self.assertEqual(self.check(inside + boundary([[-9, 0], [9, 0]], turned)), [])
        self.assertEqual(len(self.check(inside + boundary([[9, 0], [-9, 0]], turned))), 1)
        below = block("below", [1, -3], [2, -2])
        self.assert_one(self.check(inside + block("too", [3, 1], [4, 2]) + below + boundary([[-9, 0], [9, 0]])),
                        "seems to be reversed: 2 of 3 free blocks behind it")
        shelf = boundary([[3, 3], [-3, 3]])  # with a block on it and one below
        self.assertEqual(self.check(inside + block("on_it", [0, 3], [1, 4]) + shelf), [])

    def test_a_time_step_above_the_stable_one(self):
        free = block("free", [0, 0], [1, 1])
        self.assert_one(self.check(free, time_step=0.01),
                        r"^3:13: note: world\.time_step: 0\.01 s is above the stable time step, 0\.00\d+ s")
        self.assertEqual(self.check(free, time_step=1e-5), [])

    def test_springs_too_soft_for_the_weight(self):
        pair = block("on_top", [0, 1], [1, 2]) + block("below", [0, 0], [1, 1], 'kind = "fixed"')
        solid = block("on_top", [0, 0, 1], [1, 1, 2]) + block("below", [0, 0, 0], [1, 1, 1], 'kind = "fixed"')
        for scene, dimension in ((pair, 2), (solid, 3)):
            weight, size = 2500 * 9.81, 1
            for stiffness, force_per_depth in (('"per contact"', 1), ('"per area"', 1), ('"potential"', 2)):
                changes = {"stiffness": stiffness, "potential_length": 1}
                soft = 49 * weight / size / force_per_depth
                self.assert_one(self.check(scene, dimension, normal_stiffness=soft, **changes),
                                r'block\[0\]: "on_top" sinks into its support by 0\.0204 m, 2\.04 % of its thickness, under its own weight')
                self.assertEqual(self.check(scene, dimension, normal_stiffness=101 * soft, **changes), [])
        law = '[[law]]\nbetween = ["rubber", "stone"]\nnormal_stiffness = 1e4\n'
        self.assertEqual(self.check(pair + law), [])
        self.assertEqual(len(self.check(pair.replace("stone", "rubber", 1) + law)), 1)

    def test_springs_too_soft_for_the_weight_of_a_pile(self):
        soft = 2500 * 9.81 / 0.009  # each block alone sinks in by 0.9 %
        stack = block("base", [-1, -1], [3, 0], 'kind = "fixed"')
        stack += "".join(block(f"b{i}", [0, i], [1, i + 1]) for i in range(20))
        beside = "".join(block(f"c{i}", [i - 3, 0], [i - 2, 1]) for i in range(3))
        solid = block("base", [-1, -1, -1], [2, 2, 0], 'kind = "fixed"') + \
            "".join(block(f"b{i}", [0, 0, i], [1, 1, i + 1]) for i in range(20))
        pattern = r'"b0" sinks into its support by 0\.18 m, 18 % of its thickness, under its weight and the weight above it'
        for stiffness, share in (('"per contact"', 1), ('"per area"', 1), ('"potential"', 0.5)):
            changes = {"stiffness": stiffness, "normal_stiffness": soft * share, "potential_length": 1}
            self.assert_one(self.check(stack + beside, **changes), pattern)
            self.assert_one(self.check(solid, 3, **changes), pattern)
            changes["normal_stiffness"] *= 5
            self.assertEqual(self.check(stack + beside, **changes), [])
        # What lies on a slab presses on all of it, 59.4 % as it is cut into columns to some per cent.
        table = block("left", [0, 0], [1, 1]) + block("right", [5, 0], [6, 1]) + block("slab", [0, 1], [6, 2]) + \
            block("load", [0, 2], [6, 12])
        self.assert_one(self.check(block("base", [-1, -1], [9, 0], 'kind = "fixed"') + table, normal_stiffness=soft),
                        r'"slab" sinks into its support by 0\.5[6-9]\d* m')
        self.assertEqual(self.check(stack, normal_stiffness=soft, gravity=[0, 0]), [])
        sideways = self.check(stack, normal_stiffness=soft, gravity=[9.81, 0])
        self.assert_one(sideways, r"gravity: \[9\.81, 0\] has no component along y")

    def test_springs_too_soft_for_the_speed(self):
        wall = block("wall", [0, 0], [0.02, 1], 'kind = "fixed"')
        bar = block("bar", [-2, 0], [-1.5, 1], "velocity = [100, 0]")
        self.assert_one(self.check(wall + bar, gravity=[0, 0]),
                        r'note: block\[1\]: "bar" at 100 m/s would penetrate "wall" by 0\.354 m, .* 17\.7 times')
        self.assertEqual(self.check(wall + bar.replace("100", "0.5"), gravity=[0, 0]), [])
        # Between free blocks it is the reduced mass that has to be stopped: half of that of one.
        twins = block("one", [0, 0], [0.5, 1]) + bar
        self.assert_one(self.check(twins, gravity=[0, 0]), r"by 0\.25 m, .* 50 % of")
        side_by_side = block("one", [0, 0], [0.5, 1], "velocity = [100, 0]") + bar
        self.assertEqual(self.check(side_by_side, gravity=[0, 0]), [])

    def test_joints_that_run_through_no_region(self):
        rock = '[[jointed_rock]]\nname = "rock"\nmaterial = "stone"\nbox = [[0.5, 0.5], [1.5, 1.5]]\n'
        sets = "".join(
            f"[[jointed_rock.joint_set]]\ndip = {dip}\nspacing = {spacing}\n" for dip, spacing in ((0, 7), (90, 1)))
        self.assert_one(self.check(rock + sets),
                        r"^22:11: note: jointed_rock\[0\]\.joint_set\[0\]\.spacing: none of these joints, 7 m apart")

    def test_joint_sets_that_make_too_many_blocks_together_are_refused_at_once(self):
        for dimension, box, dips in ((2, [[0, 0], [4, 4]], (30, -30)), (3, [[0, 0, 0], [4, 4, 4]], (0, 45, 89))):
            sets = "".join(f"[[jointed_rock.joint_set]]\ndip = {dip}\nspacing = {1e-3 if dimension == 2 else 1e-2}\n" +
                           ("dip_direction = 0\n" if dip < 89 else "dip_direction = 90\n") * (dimension - 2) for dip in dips)
            with tempfile.TemporaryDirectory() as directory:
                scene = Path(directory, "scene.toml")
                scene.write_text(HEAD.format(dimension) +
                                 f'[[jointed_rock]]\nname = "rock"\nmaterial = "stone"\nbox = {box}\n' + sets)
                answer = halfspace("check", scene, timeout=30)
                self.assertEqual(answer.returncode, 1)
                self.assertRegex(
                    answer.stderr, r"joint_set\[\d\]\.spacing: about \S+ blocks between the joints of all sets")

    def test_pictures_after_the_end(self):
        scene = block("free", [0, 0], [1, 1]) + "[output.picture]\ntimes = [0.005, 5]\n"
        self.assert_one(self.check(scene), r"^22:9: note: output\.picture\.times: 5 s is after the end of the run, 0\.01 s")

    def test_a_run_tells_them_first_and_in_its_summary_with_the_largest_of_the_whole_run(self):
        scene = block("lower", [0, 0], [1, 1]) + block("upper", [0.2, 0.6], [1.2, 1.6])
        with tempfile.TemporaryDirectory() as directory:
            file = Path(directory, "scene.toml")
            file.write_text(HEAD.format(2).replace("duration = 0.01", "duration = 0.1") + scene)
            answer = halfspace("run", file, "-o", Path(directory, "out"))
            self.assertEqual(answer.returncode, 0)
            self.assertIn(f'{file}:22:8: note: block[1]: "upper" overlaps "lower"', answer.stderr)
            summary = Path(directory, "out", "summary.txt").read_text()
            self.assertIn('scene:22:8: note: block[1]: "upper" overlaps "lower" at the start by 0.4 m', summary)
            self.assertNotIn(directory, summary)
            self.assertRegex(summary, r"contacts +0 at the end, largest overlap 0 m")
            self.assertRegex(summary, r"in the whole run +largest overlap 0\.4 m, fastest block \d\d")
            self.assertNotIn("above the stable one", summary)

    def test_keys_of_impulses_between_rigid_blocks_where_there_are_none(self):
        of_world = {"locate_impacts": "true", "impulse_tolerance": "1e-8", "max_impulse_iterations": "9"}
        world = "".join(f"{key} = {value}\n" for key, value in of_world.items())
        none = (HEAD.format(2).replace('"per contact"\nnormal_stiffness = 1e8\nshear_stiffness = 1e8', '"none"\nrestitution = 0.5')
                .replace("[world]\n", "[world]\n" + world + "time_step = 1e-3\n"))
        springs = HEAD.format(2).replace("[world]\n", "[world]\n" + world)
        stone = block("ground", [-1, -1], [2, 0], 'kind = "fixed"') + block("box", [0, 0], [1, 1])
        ground = block("ground", [-1, -1], [2, 0], 'kind = "fixed"')
        soft = block("soft", [2, 0], [3, 1], 'kind = "affine"', "rubber")
        held = block("held", [0, 0], [1, 1], 'hold = "x"')
        glued = '[[law]]\nbetween = ["stone", "stone"]\nstiffness = "none"\ncohesion = 1e5\n'
        own = '[[law]]\nbetween = ["stone", "stone"]\nstiffness = "none"\nrestitution = 0.5\n'
        every = sorted(f"world.{key}" for key in of_world)
        points = "contacts without springs of blocks that deform or are held are points"
        for head, blocks, keys, reason in (
                (none, stone, [], ""),
                (springs.replace("locate_impacts = true", "locate_impacts = false"), stone, every[:1] + every[2:], "have springs"),
                (springs, stone, every, "the laws of all blocks have springs; usual: a law with stiffness = \"none\""),
                (springs, own + stone, [], ""),
                (springs, own + stone + soft, [], ""),
                (none, stone + held, [], ""),
                (none, ground + held, ["default_law.restitution"] + every, points),
                (none, ground + soft, ["default_law.restitution"] + every, points),
                (none, glued + stone, ["default_law.restitution"] + every, "that has cohesion or"),
                (none, glued + stone + soft.replace("affine", "rigid"), [], "")):
            with self.subTest(blocks=blocks, keys=keys):
                notes = [note for note in self.check_text(head + blocks) if "no effect" in note]
                self.assertEqual(sorted(note.split("note: ")[1].split(":")[0] for note in notes), keys)
                self.assertTrue(all(reason in note for note in notes), notes)
        self.assertTrue(self.check_text(springs + stone)[0].startswith("3:18: note: world.locate_impacts: no effect: "))

    def run_scene(self, text):
        """The answer of a run and its summary."""
        with tempfile.TemporaryDirectory() as directory:
            file = Path(directory, "scene.toml")
            file.write_text(text)
            answer = halfspace("run", file, "-o", Path(directory, "out"))
            return answer, Path(directory, "out", "summary.txt").read_text()

    def test_a_bar_that_would_fly_through_a_plate_in_a_step_is_stopped_and_told(self):
        plate = block("plate", [0, 0], [1, 0.005], 'kind = "fixed"')
        bar = block("bar", [0, 0.5], [1, 0.505], "velocity = [0, -300]")
        world = HEAD.format(2).replace("[world]", "[world]\ngravity = [0, 0]\ntime_step = 1e-4").replace("1e8", "1e12")
        answer, summary = self.run_scene(world + plate + bar)
        self.assertEqual(answer.returncode, 0)
        self.assertRegex(summary, r"outcome +complete")
        self.assertRegex(summary, r"divided steps +1, at impacts or fast rotations")
        self.assertRegex(summary, r"in the whole run +largest overlap 0\.0009\d+ m, fastest block 300 m/s")
        self.assertRegex(summary, r"time step +above the stable one, min 7\.29e-07 s")
        self.assertRegex(summary, r"softest springs +allow a penetration of 21\.2 % of the thinner one's thickness")
        self.assertRegex(summary, r"run-out .* 0\.00 m to the left")
        answer, summary = self.run_scene(world.replace("[world]", '[world]\nfast_blocks = "refuse"') + plate + bar)
        self.assertEqual(answer.returncode, 3)
        self.assertRegex(answer.stderr, r'blocks "\w+" and "\w+" approach at time 0\.0016 \(step 16\) with up to 300 m/s')
        self.assertIn("a time step of 4.16667e-06 is sufficient; give that time_step in [world]", answer.stderr)
        self.assertRegex(summary, r"outcome +REFUSED")

    def test_sleep_is_told(self):
        scene = (re.sub("duration = .*", "duration = 3\nsleep_tolerance = 1e-6", HEAD.format(2))
                 + block("floor", [0, -1], [2, 0], 'kind = "fixed"', "rubber") + block("box", [0, 0], [1, 1]))
        answer, summary = self.run_scene(scene)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        told = re.search(r"asleep +1 of 2 blocks at the end; max displacement error by sleep (\S+) m", summary)
        self.assertLessEqual(float(told[1]), 1e-6)

    def test_examples_overlap_nowhere_and_run_the_right_way_round(self):
        for scene in sorted(EXAMPLES.glob("*/*.toml")):
            for note in halfspace("check", scene).stdout.splitlines()[1:]:
                self.assertIn("note: world.time_step: ", note)


if __name__ == "__main__":
    main()
