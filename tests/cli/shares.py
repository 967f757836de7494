"""Scenes and snapshots are cut into shares, and joined again."""
import shutil

from command import SceneTest, halfspace, main

SCENE = """title = "A row of boxes on a floor"
dimension = 2

[world]
{world}

[[material]]
name = "stone"
density = 2400

[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
friction_angle = 30

[[block]]
name = "floor"
material = "stone"
kind = "{kind}"
vertices = [[-1, -1], [21, -1], [21, 0], [-1, 0]]
{motion}
"""

BOX = """
[[block]]
name = "box.{a}"
material = "stone"
vertices = [[{a}, 0], [{b}, 0], [{b}, 1], [{a}, 1]]
"""


def scene(world="duration = 1\ntime_step = 1e-5", kind="fixed", motion="", boxes=20, more=""):
    return SCENE.format(world=world, kind=kind, motion=motion) + more + "".join(
        BOX.format(a=i, b=i + 1) for i in range(boxes))


class Shares(SceneTest):
    def setUp(self):
        super().setUp()
        self.shares = self.directory / "shares"

    def split(self, text, count, *arguments, code=0):
        self.scene.write_text(text)
        answer = halfspace("split", self.scene, count, self.shares, *arguments)
        self.assertEqual(answer.returncode, code, answer.stderr + answer.stdout)
        return answer

    def refused(self, reason, *arguments):
        answer = halfspace(*arguments)
        self.assertEqual(answer.returncode, 1, answer.stdout)
        self.assertRegex(answer.stderr, reason)

    def names(self):
        return sorted(path.name for path in self.shares.iterdir())

    def test_a_scene_is_cut_and_joined(self):
        answer = self.split(scene(), 3)
        self.assertRegex(answer.stdout, r"shares: 3 shares, each with 6 to 7 blocks and \d+ to \d+ copies")
        self.assertEqual(self.names(), ["share_0.hsw", "share_1.hsw", "share_2.hsw"])
        joined, again = self.directory / "joined.hsw", self.directory / "again.hsw"
        answer = halfspace("join", self.shares, joined)
        self.assertRegex(answer.stdout, "joined.hsw: 21 blocks after 0 steps")
        # Another number of shares of the snapshot joins to the same bytes.
        self.assertEqual(halfspace("split", joined, 5, self.shares, "--force").returncode, 0)
        self.assertEqual(len(self.names()), 5)
        self.assertEqual(halfspace("join", self.shares, again).returncode, 0)
        self.assertEqual(joined.read_bytes(), again.read_bytes())
        self.assertEqual(halfspace("split", joined, 1, self.shares, "--force").returncode, 0)
        self.assertEqual(self.names(), ["share_0.hsw"])
        self.assertEqual(halfspace("join", self.shares, again).returncode, 0)
        self.assertEqual(again.read_bytes(), joined.read_bytes())

    def test_settings_replace_values_of_the_scene(self):
        self.split(scene(world="duration = 1"), 2, "--set", "world.time_step=1e-5")

    def test_scenes_that_need_more_than_steps_are_refused(self):
        self.assertRegex(self.split(scene(world="duration = 1"), 2, code=1).stderr,
                         "world.time_step: shares require a time step")
        stage = '\n[[stage]]\ndo = "run"\nduration = 1\n'
        self.assertRegex(self.split(scene(world="time_step = 1e-5", more=stage), 2, code=1).stderr,
                         "shares do not run stages")
        self.assertRegex(self.split(scene(boxes=0), 2, code=1).stderr, "no free block")
        moving = scene(kind="prescribed", motion="velocity = [1, 0]\nstop = 0.5")
        self.assertRegex(self.split(moving, 2, code=1).stderr, "shares do not start or stop motions")
        self.assertRegex(self.split(scene(world="duration = 1\ntime_step = 1e-5\nsleep_tolerance = 1e-3"), 2, code=1).stderr,
                         "sleep, which shares cannot hold")
        self.assertRegex(self.split(scene(), 21, code=1).stderr, "cannot cut 20 free blocks into 21 shares")
        self.assertFalse(self.shares.exists())

    def test_earlier_shares_are_kept_without_force(self):
        self.split(scene(), 4)
        self.assertRegex(self.split(scene(), 2, code=1).stderr, "not empty; --force")
        self.split(scene(), 2, "--force")
        self.assertEqual(len(self.names()), 2)

    def test_joining_requires_all_shares_of_one_run(self):
        self.refused("cannot read .*share_0.hsw", "join", self.directory / "none", self.directory / "end.hsw")
        self.split(scene(), 4)
        share = self.shares / "share_2.hsw"
        self.refused("a share of a larger one", "split", share, 2, self.directory / "parts")
        shutil.copy(share, self.shares / "share_4.hsw")
        self.refused("block .* is in two shares", "join", self.shares, self.directory / "end.hsw")
        (self.shares / "share_4.hsw").unlink()
        (self.shares / "share_3.hsw").unlink()
        self.refused("the shares hold 16 of 21 blocks", "join", self.shares, self.directory / "end.hsw")
        share.write_bytes(b"damaged")
        self.refused("hs_world_restore", "join", self.shares, self.directory / "end.hsw")
        self.refused("--set is for scenes", "split", share, 2, self.directory / "parts", "--set", "world.duration=1")


if __name__ == "__main__":
    main()
