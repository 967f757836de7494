"""`halfspace check` tells all faults of a scene at once, each at its line and column."""
import re
import tempfile
import unittest
from pathlib import Path

from command import EXAMPLES, SCENES, halfspace, main

# line, column, key, what is said of it; one for each fault that was put into faulty.toml
EXPECTED = [
    (1, 9, "title", "not a string: 5"),
    (2, 13, "dimension", "out of range: 4; allowed: a whole number, at least 2, at most 3"),
    (5, 12, "world.duration", "out of range: -1; allowed: a number above 0"),
    (6, 1, "world.safty", "unknown key (did you mean 'safety'?)"),
    (7, 15, "world.gravity", "not finite: inf"),
    (11, 11, "material[0].density", 'not a number: "heavy"'),
    (14, 8, "material[1].name", 'used twice: "rock"'),
    (18, 13, "default_law.stiffness", "unknown word: \"per aria\" (did you mean 'per area'?)"),
    (20, 18, "default_law.friction_angle", "out of range: 95; allowed: a number, at least 0, below 90"),
    (23, 11, "law[0].between", "no such material: \"rok\" (did you mean 'rock'?)"),
    (26, 8, "block[0].name", 'not a name: "two words"'),
    (28, 12, "block[0].vertices", "vertex 2 [1, 0]: coincides with its neighbour"),
    (34, 12, "block[1].velocity", "a fixed block does not move"),
    (35, 12, "block[1].vertices", "too few points"),
    (37, 1, "jointed_rock[0].joint_set", "missing; required"),
    (38, 8, "jointed_rock[0].name", 'used twice: "plate"'),
    (40, 39, "jointed_rock[0].region[3]", 'not a number: "a"'),
    (47, 9, "triangulated[0].count", "odd: 7"),
    (50, 12, "output.tracked", 'no such block: "nobody"'),
    (53, 1, "output.picture.color", "unknown key (did you mean 'colour'?)"),
    (54, 15, "output.picture.times", "out of range: 1"),
]

EXPECTED_IN_SPACE = [
    (6, 11, "world.gravity", "not a point: [ 0, -9.8"),
    (20, 12, "block[0].vertices", "has no volume: it is flat to rounding; allowed: points"),
    (26, 12, "block[1].vertices", "has fewer than 4 vertices or fewer than 4 faces; allowed: the corners"),
    (32, 9, "block[2].faces", "not a list: 7"),
    (33, 20, "block[2].angular_velocity", "not a point: 30; allowed: [x, y, z]"),
    (38, 8, "block[3].file", "dented.obj:8: not convex: a dent 0.1 m deep at [1, 1, 0.1]; allowed: dents up to the tolerance, 0.0234 m; tolerance ="),
    (43, 8, "block[4].file", "no such file: "),
    (48, 8, "block[5].file", "faulty.toml: unknown file extension; allowed: .obj, .off, .stl, .msh"),
    (50, 1, "jointed_rock[0].region", "missing; required: [[x, y, z], [x, y, z], ...] with 4 points or more"),
    (54, 1, "jointed_rock[0].joint_set[0].dip_direction", "missing; required"),
    (56, 7, "jointed_rock[0].joint_set[0].dip", "out of range: -30; allowed: a number, at least 0, at most 90"),
    (62, 7, "voronoi[0].box", "not a box; allowed: two points, [lowest corner, highest corner]"),
    (63, 9, "voronoi[0].count", "out of range: 1; allowed: a whole number, at least 2"),
    (65, 3, "triangulated", "unknown key"),
    (68, 10, "output.picture.window", "not a window"),
    (69, 1, "output.picture.azimut", "unknown key (did you mean 'azimuth'?)"),
]


def check_text(text):
    """What check says of a scene given as text."""
    with tempfile.TemporaryDirectory() as directory:
        scene = Path(directory, "scene.toml")
        scene.write_text(text)
        return halfspace("check", scene)


class SceneFaults(unittest.TestCase):
    def test_all_faults_at_once_in_the_order_of_the_file(self):
        self.check_faults(SCENES / "faulty.toml", EXPECTED)

    def test_all_faults_of_a_scene_in_space(self):
        self.check_faults(SCENES / "faulty_in_space.toml", EXPECTED_IN_SPACE)

    def check_faults(self, scene, expected):
        answer = halfspace("check", scene)
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(answer.stdout, "")
        *lines, last = answer.stderr.splitlines()
        self.assertEqual(last, f"{len(expected)} faults in {scene}")
        self.assertEqual(len(lines), len(expected))
        for line, (row, column, key, text) in zip(lines, expected):
            self.assertTrue(line.startswith(f"{scene}:{row}:{column}: {key}: "), line)
            self.assertIn(text, line)
            self.assertRegex(line, r"(allowed|required): ")

    def test_run_says_the_same_and_writes_nothing(self):
        scene = SCENES / "faulty.toml"
        with tempfile.TemporaryDirectory() as directory:
            answer = halfspace("run", scene, "-o", Path(directory, "out"))
            self.assertEqual(answer.returncode, 1)
            self.assertEqual(answer.stderr, halfspace("check", scene).stderr)
            self.assertEqual(list(Path(directory).iterdir()), [])

    def test_an_affine_block_of_no_material_is_told_as_any_other(self):
        text = (SCENES / "elastic_column.toml").read_text().replace('material = "rock"', 'material = "stone"', 1)
        for scene in (text, re.sub(r"(?s)\[\[material\]\].*?\n\n", "", text)):
            answer = check_text(scene)
            self.assertEqual(answer.returncode, 1)
            self.assertIn(': no such material: "stone"', answer.stderr)
            self.assertNotIn("not elastic", answer.stderr)

    def test_a_key_that_was_renamed_still_counts_and_is_told_its_name(self):
        text = (SCENES / "falling_block.toml").read_text()
        text = re.sub(r"duration = .*\n", "", text, count=1) + '[[stage]]\ndo = "settle"\nmost_steps = {}\n'
        answer = check_text(text.format(10))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("note: stage[0].most_steps: renamed; use max_steps", answer.stdout)
        self.assertIn("stage[0].max_steps: out of range: -1", check_text(text.format(-1)).stderr)

    def test_laws_between_materials_that_do_not_exist_are_not_one_law(self):
        laws = "".join(f'[[law]]\nbetween = ["{name}", "{name}"]\n' for name in ("ice", "snow"))
        answer = check_text((SCENES / "falling_block.toml").read_text() + laws)
        self.assertIn('no such material: "snow"', answer.stderr)
        self.assertNotIn("given before", answer.stderr)

    def test_a_law_between_no_materials_is_a_fault(self):
        answer = check_text((SCENES / "falling_block.toml").read_text() + "[[law]]\nbetween = []\n")
        self.assertIn("law[0].between: an empty list; allowed", answer.stderr)

    def test_keys_of_any_depth_are_faults(self):
        deep = 100_000
        nine = ".".join("abcdefghi")
        quoted = '"""."b" # """".' + ".".join(["'x.'"] * 9)
        for text, place in (("[" + "a." * deep + "a]\n", "1:17"),
                            ("[[" + "a." * deep + "a]]\n", "1:18"),
                            ("a." * deep + "a = 1\n", "1:16"),
                            ("x = [0.1, 0.2]\n[a.b]\n" + nine + " = 1\n", "3:16"),
                            ("x = {" + nine + " = " + ("{" + nine + " = ") * 200 + "1" + "}" * 201 + "\n", "1:21"),
                            ('x = ["""....""."""", {' + quoted + " = 1}]\n", "1:")):
            answer = check_text(text)
            self.assertEqual(answer.returncode, 1, answer.returncode)
            self.assertIn(f"scene.toml:{place}", answer.stderr)
            self.assertIn(": more than 8 names in a key; allowed: ", answer.stderr)
        for text in ("x = " + "[" * deep + "]" * deep, "x = " + "{a = " * deep + "1" + "}" * deep):
            answer = check_text(text)
            self.assertEqual(answer.returncode, 1, answer.returncode)
            self.assertIn("not TOML: ", answer.stderr)

    def test_dots_in_texts_and_comments_are_no_keys(self):
        dots = "." * 100
        scene = (SCENES / "falling_block.toml").read_text()
        for title in (f'"{dots}"', f"'{dots}'", f'"""\n{dots}"\\""""', f"'''{dots}\n{dots}''''"):
            answer = check_text(re.sub("(?m)^title = .*$", lambda _: f"title = {title} # {dots}", scene))
            self.assertEqual((answer.returncode, answer.stderr), (0, ""))

    def test_a_name_used_twice_is_told_once(self):
        text = (SCENES / "falling_block.toml").read_text()
        answer = check_text(text.replace('name = "plate"', 'name = "falling"'))
        self.assertEqual(answer.stderr.count("used twice"), 1, answer.stderr)
        ground = '[[block]]\nname = "{}"\nmaterial = "stone"\nkind = "fixed"\ndepth = 1\n'
        ground += "boundary = [[9, -9], [0, -9], [-9, -9]]\n"
        answer = check_text(text + ground.format("ground") * 3)
        self.assertEqual(answer.stderr.count("used twice"), 2, answer.stderr)
        taken = text.replace('name = "plate"', 'name = "ground.1"').replace('name = "falling"', 'name = "ground.0"')
        self.assertEqual(check_text(taken + ground.format("ground")).stderr.count("used twice"), 1)

    def test_syntax(self):
        answer = check_text("title = 1\nb = [1,\nc = 2\n")
        self.assertEqual(answer.returncode, 1)
        self.assertTrue(re.search(r"scene\.toml:3:\d+: not TOML: ", answer.stderr), answer.stderr)

    def test_empty_scene_lists_what_is_required(self):
        answer = check_text("")
        self.assertEqual(answer.returncode, 1)
        for key in ("dimension", "world", "material", "default_law"):
            self.assertIn(f": {key}: missing; required: ", answer.stderr)

    def test_law_in_other_units_takes_no_stiffness_from_the_default(self):
        text = (SCENES / "falling_block.toml").read_text()
        law = '[[law]]\nbetween = ["stone", "stone"]\n'
        self.assertEqual(check_text(text + law + "friction_angle = 20\n").returncode, 0)
        answer = check_text(text + law + 'stiffness = "per area"\n')
        self.assertIn("law[0].normal_stiffness: missing", answer.stderr)

    def test_potentials_hold_nothing_together(self):
        text = (SCENES / "falling_block.toml").read_text()
        law = '[[law]]\nbetween = ["stone", "stone"]\nstiffness = "potential"\nnormal_stiffness = 1e7\nshear_stiffness = 1e7\n'
        self.assertEqual(check_text(text + law + "friction_angle = 20\n").returncode, 0)
        for key in ("cohesion", "tensile_strength"):
            self.assertIn(f"law[0].{key}: unknown key", check_text(text + law + f"{key} = 1\n").stderr)
        answer = check_text(text.replace("[world]\n", "[world]\npotential_length = 0\n"))
        self.assertIn("world.potential_length: out of range: 0; allowed: a number above 0", answer.stderr)

    def test_a_misspelt_key_of_a_group_is_recognized_when_it_is_the_only_one(self):
        text = (SCENES / "falling_block.toml").read_text()
        answer = check_text(text.replace("density =", "young_moduls = 1e9\ndensity =", 1))
        self.assertIn("young_moduls: unknown key (did you mean 'young_modulus'?); allowed: name, density, ", answer.stderr)
        answer = check_text(text.replace("vertices =", "normal_stres = [1, 2]\nvertices =", 1))
        self.assertIn("normal_stres: unknown key (did you mean 'normal_stress'?)", answer.stderr)

    def test_what_follows_from_a_misspelt_key_is_no_fault_of_its_own(self):
        falling = (SCENES / "falling_block.toml").read_text()
        staged = falling.replace("duration = 0.5\n", "") + '\n[[stage]]\ndo = "run"\nduration = 0.5\nramp = 0.1\n'
        rock = (EXAMPLES / "rock_collapse" / "friction_15.toml").read_text()
        in_space = (SCENES / "falling_block_in_space.toml").read_text()
        self.assertEqual(check_text(staged).returncode, 0)
        for text, right, wrong in ((falling, "dimension = ", "dimensoin = "), (in_space, "dimension = ", "dimnsion = "),
                                   (falling, "[world]", "[wrld]"), (falling, "duration = ", "duraton = "),
                                   (falling, "[[material]]", "[[materal]]"), (falling, "density = ", "densty = "),
                                   (falling, 'name = "stone"', 'nam = "stone"'),
                                   (falling, 'name = "stone"', "name = 5"),
                                   (falling, "[default_law]", "[defaultlaw]"),
                                   (falling, "normal_stiffness = ", "normal_stifness = "),
                                   (falling, "stiffness = \"", "stifness = \""),
                                   (falling, 'stiffness = "per contact"', 'stiffness = "nune"'),
                                   (falling, "[[block]]", "[[blok]]"), (falling, "vertices = ", "vertexes = "),
                                   (falling, 'name = "falling"', 'nmae = "falling"'),
                                   (falling, 'kind = "prescribed"', 'kind = "prescibed"'),
                                   (falling, 'kind = "prescribed"', 'knd = "prescribed"'),
                                   (staged, "[[stage]]", "[[stge]]"), (staged, 'do = "run"', 'du = "run"'),
                                   (staged, 'do = "run"', 'do = "runn"'),
                                   (rock, "[[jointed_rock", "[[jointed_rocks"),
                                   (rock, "spacing = ", "spaccing = "), (rock, "[[jointed_rock.joint_set]]", "[[jointed_rock.jointset]]")):
            with self.subTest(wrong=wrong):
                self.assertIn(right, text)
                changed = text.replace(right, wrong) if wrong.startswith("[") else text.replace(right, wrong, 1)
                answer = check_text(changed)
                self.assertEqual(answer.returncode, 1)
                *lines, last = answer.stderr.splitlines()
                self.assertEqual(len(lines), 1, answer.stderr)
                self.assertTrue(last.startswith("1 fault in "), last)
                self.assertRegex(lines[0], "unknown|not a string")

    def test_tracking_members_of_a_generator(self):
        text = (EXAMPLES / "rock_collapse" / "friction_15.toml").read_text()
        tracking = text.replace("[output]\n", '[output]\ntracked = ["rock.0", "ground", "rock.9999"]\n')
        answer = check_text(tracking)
        self.assertEqual(answer.stderr.count('no such block: "rock.9999"'), 1)
        self.assertIn("1 fault in", answer.stderr)

    def test_examples_have_no_faults(self):
        scenes = sorted(EXAMPLES.glob("*/*.toml"))
        self.assertGreaterEqual(len(scenes), 4)
        for scene in scenes:
            with self.subTest(scene=scene.name):
                answer = halfspace("check", scene)
                self.assertEqual((answer.returncode, answer.stderr), (0, ""))

    def test_the_scene_of_the_documentation_has_no_faults(self):
        page = (EXAMPLES.parent / "scenes" / "index.md").read_text()
        scene = re.search(r"```toml\n(.*?)```", page, re.DOTALL).group(1)
        answer = check_text(scene)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))


class Generators(unittest.TestCase):
    def test_steps_that_never_reach_the_end_of_the_run_are_a_fault(self):
        base = """dimension = 2
world = {{ duration = 1, {} }}
material = [{{ name = "m", density = 2000 }}]
default_law = {{ stiffness = "per area", normal_stiffness = {}, friction_angle = 30 }}
block = [
  {{ name = "floor", kind = "fixed", material = "m", vertices = [[-1, -1], [1, -1], [1, 0], [-1, 0]] }},
  {{ name = "stone", material = "m", vertices = [[0, 0], [1, 0], [1, 1], [0, 1]] }},
]
"""
        for world, stiffness, fault in (
                ("time_step = 1e-320", 1e8, "world.time_step: 1 s in steps of 1e-320 s: the run never ends; allowed: "
                                            "steps of at least 1.1e-16 s, by a larger time_step"),
                ("safety = 1e-300", 1e8, "by a larger safety"), ("gravity = [0, -1]", "1e75", "by a smaller normal_stiffness")):
            with self.subTest(world), tempfile.TemporaryDirectory() as directory:
                scene = Path(directory, "scene.toml")
                scene.write_text(base.format(world, stiffness))
                for command in ("check",), ("run", "-o", Path(directory, "out")):
                    answer = halfspace(command[0], scene, *command[1:], timeout=60)
                    self.assertEqual(answer.returncode, 1)
                    self.assertIn(fault, answer.stderr)
        with tempfile.TemporaryDirectory() as directory:
            scene = Path(directory, "scene.toml")
            scene.write_text(base.format("time_step = 1e-9", 1e8))
            self.assertEqual(halfspace("check", scene).returncode, 0)

    def test_what_is_too_small_to_compute_with_is_a_fault_with_its_place(self):
        world = ('dimension = 2\n[world]\nduration = 1\n[[material]]\nname = "stone"\ndensity = 2500\n'
                 '[default_law]\nstiffness = "per contact"\nnormal_stiffness = 1e8\n')
        triangles = '[[triangulated]]\nname = "t"\nmaterial = "stone"\ncount = 100\nlower_left = [0, 0]\nupper_right = [1, {}]\n'
        for height in ("1e-300", "1e300"):
            with tempfile.TemporaryDirectory() as directory:
                scene = Path(directory, "scene.toml")
                scene.write_text(world + triangles.format(height))
                answer = halfspace("check", scene)
                self.assertEqual(answer.returncode, 1)
                self.assertRegex(answer.stderr, r"scene\.toml:\d+:\d+: triangulated\[0\]: hs_polygon_create: ")


if __name__ == "__main__":
    main()
