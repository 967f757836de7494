"""Joints between rigid blocks: resultants, eccentricities and openings against statics, and their pictures."""
import re

from command import SceneTest, main

SCENE = """title = "Two blocks on a plate"
dimension = {dimension}

[world]
gravity = {gravity}

[[material]]
name = "stone"
density = 2500

[default_law]
stiffness = "per area"
normal_stiffness = 1e10
friction_angle = 30

[[stage]]
do = "{do}"

[output]
joint_forces = true
{picture}
"""

BLOCK = """
[[block]]
name = "{name}"
kind = "{kind}"
material = "stone"
vertices = {vertices}
velocity = {velocity}
"""


def box(low, high):
    if len(low) == 2:
        return [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
    return [[x, y, z] for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]


def scene_of(dimension, gravity, do="settle", picture="", velocity=0):
    flat = [0] * (dimension - 1)
    text = SCENE.format(dimension=dimension, gravity=gravity, do=do, picture=picture)
    for name, kind, low, high in ("plate", "fixed", -1, 0), ("lower", "rigid", 0, 1), ("upper", "rigid", 1, 3):
        wide = 5 if name == "plate" else 0
        corners = [-wide] * (dimension - 1) + [low], [2 + wide] * (dimension - 1) + [high]
        text += BLOCK.format(name=name, kind=kind, vertices=box(*corners),
                             velocity=[*flat, velocity if name == "upper" else 0])
    return text.replace(f"velocity = {[*flat, 0]}\n", "")


class Masonry(SceneTest):
    def joints(self):
        return {(row["block_a"], row["block_b"]): {key: float(value) for key, value in row.items() if key[:5] != "block" and value}
                for row in self.rows("joints.csv")}

    def test_resultants_of_a_leaning_column(self):
        for dimension in 2, 3:
            with self.subTest(dimension=dimension):
                # Gravity leans by tan = 0.1: shear 0.1 N; the resultant passes below the centroid of all above.
                self.run_scene(scene_of(dimension, [1] + [0] * (dimension - 2) + [-10]))
                joints = self.joints()
                self.assertEqual(set(joints), {("plate", "lower"), ("lower", "upper")})
                area = 2**(dimension - 1)
                for pair, height, lever in (("plate", "lower"), 3, 1.5), (("lower", "upper"), 2, 1):
                    joint = joints[pair]
                    weight = 2500 * area * height * 10
                    self.assertAlmostEqual(joint["length" if dimension == 2 else "area"], area)
                    self.assertAlmostEqual(joint["normal_force"] / weight, 1, delta=1e-3)
                    self.assertAlmostEqual(joint["shear_force"] / weight, 0.1, delta=1e-3)
                    self.assertAlmostEqual(joint["eccentricity"], 0.1 * lever, delta=1e-3)
                    self.assertLess(joint["opening"], 0)
                    self.assertAlmostEqual(joint["normal_y" if dimension == 2 else "normal_z"], 1, delta=1e-6)

    def test_a_joint_opens_as_its_blocks_part(self):
        for dimension in 2, 3:
            with self.subTest(dimension=dimension):
                text = scene_of(dimension, [0] * dimension, "run\"\nduration = 0.1\nname = \"parts", velocity=0.2)
                self.run_scene(text)
                joint = self.joints()["lower", "upper"]
                self.assertAlmostEqual(joint["opening"], 0.02, delta=1e-9)
                self.assertEqual(joint["normal_force"], 0)
                self.assertNotIn("eccentricity", joint)

    def test_pictures(self):
        picture = "[output.picture]\nthrust = true\nopen_joints = true\n"
        self.run_scene(scene_of(2, [1, -10], picture=picture))
        last = (self.output / "last.svg").read_text()
        self.assertEqual(len(re.findall('stroke="#d35400"', last)), 1)  # the lower block; the upper one has one joint
        self.assertNotIn('fill="#c0392b"', last)
        self.run_scene(scene_of(2, [0, 0], "run\"\nduration = 0.1\nname = \"parts", picture, 0.2))
        self.assertIn('fill="#c0392b"', (self.output / "last.svg").read_text())
        self.run_scene(scene_of(2, [1, -10]))
        self.assertNotIn('stroke="#d35400"', (self.output / "last.svg").read_text())


if __name__ == "__main__":
    main()
