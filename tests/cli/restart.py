"""Runs that are killed or interrupted go on from their checkpoint, and end with the same files to the bit."""
import random
import signal
import subprocess
import time

from command import COMMAND, SceneTest, halfspace, main

WORLD = """title = "Rubble on a tray that starts and stops"
dimension = 2

[world]
local_damping = 0.1
{world}

[[material]]
name = "stone"
density = 2400

[default_law]
stiffness = "per area"
normal_stiffness = 1e9
friction_angle = 30

[[bond]]
between = ["stone", "stone"]
normal_stiffness = 2e9
tensile_strength = 2e3
cohesion = 4e3
friction_angle = 30

[[block]]
name = "tray"
material = "stone"
kind = "prescribed"
vertices = [[-4, -1], [6, -1], [6, 0], [-4, 0]]
velocity = [1, 0]
start = 0.05
stop = 0.15

[[triangulated]]
name = "rubble"
material = "stone"
lower_left = [0, 0.001]
upper_right = [2, 2]
count = 60

[output]
frame_interval = 0.05
history_interval = 0.01
tracked = ["rubble.7"]

[output.picture]
times = [{picture}]
"""

PLAIN = WORLD.format(world="duration = 0.6", picture=0.2)

STAGES = """
[[stage]]
name = "settling"
do = "settle"
max_steps = 30000
ratio = 1e-7

[[stage]]
name = "shaking"
do = "run"
duration = 0.4
gravity = [4.0, -9.81]

[[stage]]
name = "weakening"
do = "run"
duration = 0.2
strength_factor = 2
local_damping = 0.3
"""

GROUND = """title = "A pit is dug in portions, and more by a ramp"
dimension = 2

[world]

[[material]]
name = "soil"
density = 2000
young_modulus = 1e8
poisson_ratio = 0.3
damping_time = 1e-4

[default_law]
stiffness = "per area"
normal_stiffness = 1e9

[[mesh]]
name = "ground"
material = "soil"
box = [[0, -4], [8, 0]]
cells = [16, 8]

[[mesh.support]]
group = "bottom"

[[mesh.load]]
group = "top"
pressure = 1e4

[output]
tracked = ["ground.100"]

[output.picture]
times = [0.3]

[[stage]]
do = "settle"
ratio = 1e-6
portions = 4

[[stage]]
do = "settle"
ratio = 1e-6
portions = 3
excavate = ["ground.252", "ground.253", "ground.254", "ground.255"]
loads = 2
reset_displacement = true

[[stage]]
do = "run"
duration = 0.8
ramp = 0.2
loads = 0
gravity = [1, -9.81]
excavate = ["ground.250", "ground.251"]
"""

STAGED = WORLD.format(world="", picture=0.3) + STAGES


def files_of(directory):
    """Files of a run, all but its checkpoint, by their names."""
    return {str(path.relative_to(directory)): path.read_bytes()
            for path in sorted(directory.rglob("*")) if path.is_file() and path.name != "checkpoint"}


class Restart(SceneTest):
    def scene_file(self, text, name="scene.toml"):
        path = self.directory / name
        path.write_text(text)
        return path

    def run_whole(self, text, *arguments, name="whole"):
        output = self.directory / name
        answer = halfspace("run", self.scene_file(text, name + ".toml"), "-o", output, *arguments)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return output

    def run_in_pieces(self, text, end_it):
        """Starts a run again and again from its last checkpoint, until it ends by itself."""
        scene, output = self.scene_file(text), self.directory / "pieces"
        chance = random.Random(1)
        pieces = 0
        while True:
            pieces += 1
            checkpoint = output / "checkpoint"
            again = ["--from", checkpoint] if checkpoint.exists() else ["--force"]
            run = subprocess.Popen(
                [COMMAND, "run", str(scene), "-o", str(output), "--checkpoint-every", "0.02s", *map(str, again)],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            # At first less than a run takes; the later, the longer, so that it ends however slow the machine is.
            time.sleep(chance.uniform(0.02, 0.06) * (1 + pieces / 8))
            is_running = run.poll() is None
            if is_running:
                end_it(run)
            _, errors = run.communicate(timeout=600)
            if not is_running or run.returncode == 0:
                self.assertEqual(run.returncode, 0, errors)
                return output, pieces

    def assert_same_files(self, one, other):
        first, second = files_of(one), files_of(other)
        self.assertEqual(list(first), list(second))
        for name, content in first.items():
            self.assertEqual(content, second[name], name)

    def test_killed_at_any_moment(self):
        for text in PLAIN, STAGED, GROUND:
            with self.subTest(scene=text[9:30]):
                whole = self.run_whole(text, "--force")
                output, pieces = self.run_in_pieces(text, lambda run: run.kill())
                self.assertGreater(pieces, 1)
                self.assert_same_files(whole, output)
                self.assertEqual((whole / "checkpoint").read_bytes()[:20], (output / "checkpoint").read_bytes()[:20])
                (output / "checkpoint").unlink()

    def test_interrupted(self):
        whole = self.run_whole(STAGED)
        output, pieces = self.run_in_pieces(STAGED, lambda run: run.send_signal(signal.SIGINT))
        self.assertGreater(pieces, 1)
        self.assert_same_files(whole, output)

    def test_a_finished_run_goes_on_with_more_stages_or_for_longer(self):
        whole = self.run_whole(STAGED)
        settled = STAGED[:STAGED.index('[[stage]]\nname = "shaking"')]
        first = self.run_whole(settled, name="settled")
        answer = halfspace("run", self.scene_file(STAGED), "-o", first, "--from", first / "checkpoint")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual((whole / "history.csv").read_bytes(), (first / "history.csv").read_bytes())
        shorter = self.run_whole(PLAIN.replace("duration = 0.6", "duration = 0.4"), name="shorter")
        longer = self.run_whole(PLAIN, name="longer")
        elsewhere = self.run_whole(PLAIN, "--from", shorter / "checkpoint", name="elsewhere")
        self.assertEqual((longer / "history.csv").read_bytes(), (elsewhere / "history.csv").read_bytes())
        self.assertEqual((longer / "last.svg").read_bytes(), (elsewhere / "last.svg").read_bytes())
        for frame in (elsewhere / "run.pvd").read_text().split('file="')[1:]:
            self.assertTrue((elsewhere / frame.split('"')[0]).exists())

    def test_a_longer_duration_is_recorded_as_evenly_as_it_says(self):
        text = PLAIN.replace("frame_interval = 0.05\nhistory_interval = 0.01\n", "")
        shorter = self.run_whole(text.replace("duration = 0.6", "duration = 0.25"), name="shorter")
        longer = self.run_whole(text, "--from", shorter / "checkpoint", name="longer")
        times = [float(line.split(",")[0]) for line in (longer / "history.csv").read_text().splitlines()[1:]]
        steps = [b - a for a, b in zip(times, times[1:]) if b > 0.27]
        self.assertLess(max(steps), 1.2 * 0.6 / 50)

    def test_a_stage_goes_on_with_more_steps(self):
        few = STAGED.replace("max_steps = 30000", "max_steps = 20")
        few = few[:few.index('[[stage]]\nname = "shaking"')]
        first = self.run_whole(few, name="few")
        self.assertIn("NOT AT REST after 20 steps", (first / "summary.txt").read_text())
        more = few.replace("max_steps = 20", "max_steps = 30000").replace("ratio = 1e-7", "ratio = 1e-3")
        answer = halfspace("run", self.scene_file(more), "-o", first, "--from", first / "checkpoint")
        self.assertIn("at rest after", answer.stdout)
        self.assertNotIn("NOT AT REST", answer.stdout)

    def refused(self, text, checkpoint):
        output = self.directory / "refused"
        answer = halfspace("run", self.scene_file(text, "refused.toml"), "-o", output, "--from", checkpoint)
        self.assertEqual(answer.returncode, 1)
        self.assertFalse(any(output.iterdir()) if output.exists() else False)
        return answer.stderr

    def test_what_is_no_checkpoint_of_the_scene_is_refused(self):
        checkpoint = self.run_whole(STAGED) / "checkpoint"
        for old, new, why in [
            ("density = 2400", "density = 2500", "its materials, laws, bonds or keys of [world] differ"),
            ("count = 60", "count = 62", "its blocks differ"),
            ("[0, 0.001]", "[0, 0.002]", "its blocks differ"),
            ('"rubble.7"', '"rubble.8"', "its tracked blocks, points or joints differ"),
            ("stop = 0.15", "stop = 0.16", "its prescribed motions or bolts differ"),
            ("gravity = [4.0", "gravity = [5.0", "stage 1, which it had begun, differs"),
            ("duration = 0.4", "duration = 0.5", "stage 1, which it had begun, differs"),
            ("ratio = 1e-7", "ratio = 1e-2", "stage 0, which it had begun, differs"),
            ("times = [0.3]", "times = [0.2]", "output.picture.times before the checkpoint differ"),
            (STAGES, '[[stage]]\ndo = "settle"\n', "it had more stages"),
        ]:
            self.assertIn(why, self.refused(STAGED.replace(old, new, 1), checkpoint), new)

    def test_damaged_files_are_refused(self):
        whole = (self.run_whole(PLAIN) / "checkpoint").read_bytes()
        damaged = self.directory / "damaged"
        chance = random.Random(2)
        for _ in range(40):
            content = bytearray(whole)
            content[chance.randrange(len(content))] ^= 1 << chance.randrange(8)
            damaged.write_bytes(content)
            self.assertRegex(self.refused(PLAIN, damaged), "damaged|is not a checkpoint|was written by version")
        for length in 0, 1, 20, 30, 40, len(whole) // 2, len(whole) - 1:
            damaged.write_bytes(whole[:length])
            self.assertRegex(self.refused(PLAIN, damaged), "damaged|is not a checkpoint|was written by version")
        self.assertIn("cannot read", self.refused(PLAIN, self.directory / "none"))


if __name__ == "__main__":
    main()
