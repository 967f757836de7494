"""Checkpoints whose checksums are right and whose content is not: each is refused, or the run goes on from it. What
must not happen is seen best under the address sanitizer."""
import random
import struct
import subprocess

from command import SceneTest, halfspace, main

# All that a checkpoint can hold: a pusher, a mesh with a load, bonds that fail, an affine block, sleep, stages that
# settle, dig, weaken and last, displacements from later on, frames with contacts, and a picture that has been seen.
SCENE = """title = "All parts"
dimension = 2

[world]
time_step = 1e-4
sleep_tolerance = 1e-7

[[material]]
name = "rock"
density = 2500
young_modulus = 1e7
poisson_ratio = 0.25
damping_time = 1e-4

[[material]]
name = "brick"
density = 2000
young_modulus = 1e7
poisson_ratio = 0.2

[default_law]
stiffness = "per area"
normal_stiffness = 1e7
friction_angle = 30

[[block]]
name = "floor"
kind = "fixed"
material = "rock"
vertices = [[-9, -1], [9, -1], [9, 0], [-9, 0]]

[[block]]
name = "pusher"
kind = "prescribed"
material = "rock"
velocity = [0.5, 0]
start = 0.002
stop = 0.004
vertices = [[-6, 0], [-5, 0], [-5, 2], [-6, 2]]

[[block]]
name = "drop"
material = "rock"
kind = "affine"
vertices = [[3, 2.01], [4, 2.01], [4, 3], [3, 3]]
velocity = [0.3, -1]

[[mesh]]
name = "ground"
material = "rock"
box = [[2, 0], [6, 2]]
cells = [2, 2]
cell = "quad"

[[mesh.support]]
group = "bottom"

[[mesh.load]]
group = "right"
pressure = 2e4

[[jointed_rock]]
name = "wall"
material = "brick"
box = [[-4, 0], [-1, 2]]
[[jointed_rock.joint_set]]
dip = 0
spacing = 1
[[jointed_rock.joint_set]]
dip = 90
spacing = 1

[[bond]]
between = ["brick", "brick"]
normal_stiffness = 2e7
tensile_strength = 1e2
cohesion = 1e2
tensile_fracture_energy = 5

[[stage]]
name = "settle"
do = "settle"
ratio = 1e-3
max_steps = 20
portions = 2
bonds = "may fail"

[[stage]]
name = "run"
do = "run"
duration = 0.004
ramp = 0.002
gravity = [4, -12]
strength_factor = 1.5
excavate = ["ground.3"]

[[stage]]
name = "go"
do = "run"
duration = DURATION
reset_displacement = true
excavate = ["wall.1"]

[output]
frame_interval = 0.002
history_interval = 0.001
contacts = true
tracked = ["drop", "wall.0", "ground.1"]

[output.picture]
times = [0.001]
forces = true
"""
FIRST, LONGER = SCENE.replace("DURATION", "0.002"), SCENE.replace("DURATION", "0.004")
WORLD_MAGIC = b"halfspw1"
WORLD_HEADER = 32
NUMBERS = [0.0, -1.0, 1.0, 1e-310, 1e-60, 1e60, 1e300, -1e300, float("inf"), float("nan")]
WHOLE_NUMBERS = [0, 1, 2, 3, 7, 64, 255, 4096, -1, -2, 1 << 20, (1 << 31) - 1, -(1 << 31)]


def checksum(content):
    """FNV-1a."""
    value = 0xcbf29ce484222325
    for byte in content:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value


def change(state, place, chance):
    """One number of a state becomes another."""
    kind = chance.randrange(4)
    if kind == 0:
        state[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        state[place:place + 8] = struct.pack("<d", chance.choice(NUMBERS))
    elif kind == 2:
        state[place:place + 4] = struct.pack("<i", chance.choice(WHOLE_NUMBERS))
    else:
        state[place:place + 8] = struct.pack("<q", chance.choice(WHOLE_NUMBERS))


class Checkpoint:
    """A checkpoint in parts: its first line, the snapshot of its world, and what stands around that."""

    def __init__(self, file):
        content = file.read_bytes()
        self.line = content[:content.index(b"\n") + 1]
        self.state = content[len(self.line) + 16:]
        self.world = self.state.index(WORLD_MAGIC)
        size = struct.unpack_from("<Q", self.state, self.world + 16)[0]
        self.world_end = self.world + WORLD_HEADER + size

    def damaged(self, chance):
        """Changed in one to three numbers, as often outside of the world as within, with right checksums."""
        state = bytearray(self.state)
        around = self.world + len(state) - self.world_end
        for _ in range(chance.randint(1, 3)):
            if chance.random() < 0.5:
                place = self.world + WORLD_HEADER + 4 * chance.randrange((self.world_end - self.world - 48) // 4)
            else:
                place = chance.randrange(around - 8)
                place += 0 if place < self.world - 8 else self.world_end - self.world + 8
            change(state, min(place, len(state) - 8), chance)
        world = checksum(state[self.world + WORLD_HEADER:self.world_end])
        state[self.world + 24:self.world + 32] = struct.pack("<Q", world)
        return self.line + struct.pack("<QQ", checksum(state), len(state)) + bytes(state)


class DamagedCheckpoints(SceneTest):
    def go_on_from(self, content, output):
        """The exit code of a run from this checkpoint; none where it lasts, as one with a tiny step may."""
        damaged = self.directory / "damaged"
        damaged.write_bytes(content)
        try:
            answer = halfspace("run", self.scene, "-o", output, "--force", "--from", damaged, timeout=20,
                               errors="replace")
        except subprocess.TimeoutExpired:
            return None
        self.assertIn(answer.returncode, range(5), answer.stderr)  # else a signal has ended it
        self.assertNotIn("Sanitizer", answer.stderr)
        self.assertNotIn("runtime error", answer.stderr)
        if answer.returncode == 1:
            self.assertRegex(answer.stderr, "^halfspace: |\nhalfspace: ")
        return answer.returncode

    def test_whatever_a_checkpoint_holds_it_is_refused_or_gone_on_from(self):
        self.run_scene(FIRST)
        checkpoint = Checkpoint(self.output / "checkpoint")
        self.scene.write_text(LONGER)
        output = self.directory / "again"
        self.assertEqual(self.go_on_from((self.output / "checkpoint").read_bytes(), output), 0)
        chance = random.Random(3)
        codes = [self.go_on_from(checkpoint.damaged(chance), output) for _ in range(150)]
        self.assertGreater(codes.count(1), 15)
        self.assertGreater(codes.count(0), 15)


if __name__ == "__main__":
    main()
