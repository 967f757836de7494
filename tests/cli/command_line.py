"""Help, version, exit codes, and a progress bar on terminals only."""
import os
import pty
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from command import COMMAND, SCENES, halfspace, main

FALLING = SCENES / "falling_block.toml"


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.output = Path(self.temporary.name, "out")

    def test_help(self):
        answer = halfspace("--help")
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        for word in ("run", "check", "--help", "--version", "Exit codes"):
            self.assertIn(word, answer.stdout)
        answer = halfspace("run", "--help")
        self.assertEqual(answer.returncode, 0)
        for word in ("--output", "--force", "scene"):
            self.assertIn(word, answer.stdout)

    def test_manual(self):
        manual = Path(__file__, "../../../bindings/cli/halfspace.1").resolve().read_text().replace("\\", "")
        for words in ((), ("run",), ("check",)):
            for option in re.findall(r"--\w+", halfspace(*words, "--help").stdout):
                self.assertIn(option, manual)
        scene = Path(self.temporary.name, "example.toml")
        scene.write_text(re.search(r"(?s)\.nf\n(.*)\.fi", manual)[1])
        self.assertEqual(halfspace("check", scene).returncode, 0)

    def test_version(self):
        answer = halfspace("--version")
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        self.assertRegex(answer.stdout, r"^halfspace \d+\.\d+\.\d+\n$")

    def test_ok_is_0(self):
        self.assertEqual(halfspace("check", FALLING).returncode, 0)
        self.assertEqual(halfspace("run", FALLING, "-o", self.output).returncode, 0)

    def test_failed_is_1(self):
        missing = halfspace("check", "no_such_scene.toml")
        self.assertEqual((missing.returncode, missing.stderr), (1, "halfspace: cannot read no_such_scene.toml\n"))
        self.output.write_text("in the way")
        blocked = halfspace("run", FALLING, "-o", self.output)
        self.assertEqual(blocked.returncode, 1)
        self.assertIn(str(self.output), blocked.stderr)
        self.assertEqual(self.output.read_text(), "in the way")

    def test_no_time_step_to_derive_is_1(self):
        nothing_moves = FALLING.read_text().replace("time_step = 1e-3\n", "")
        for kind in ("rigid", "prescribed"):
            nothing_moves = nothing_moves.replace(f'kind = "{kind}"', 'kind = "fixed"')
        nothing_moves = re.sub(r"(?m)^(velocity|angular_velocity|start|stop) = .*\n", "", nothing_moves)
        nothing_moves = nothing_moves.replace('name = "falling"', 'name = "falling"\nkind = "fixed"')
        scene = Path(self.temporary.name, "nothing_moves.toml")
        scene.write_text(nothing_moves)
        answer = halfspace("run", scene, "-o", self.output)
        self.assertEqual(answer.returncode, 1)
        self.assertIn("time step", answer.stderr)

    def test_wrong_usage_is_2(self):
        for arguments in ([], ["runn"], ["run"], ["run", FALLING], ["check"], ["check", FALLING, "more"],
                          ["run", FALLING, "-o", self.output, "--frce"]):
            with self.subTest(arguments=arguments):
                answer = halfspace(*arguments)
                self.assertEqual((answer.returncode, answer.stdout), (2, ""))
                self.assertIn("--help", answer.stderr)

    def test_unstable_run_is_3_and_keeps_its_output(self):
        answer = halfspace("run", SCENES / "unstable.toml", "-o", self.output)
        self.assertEqual(answer.returncode, 3)
        self.assertIn("unstable", answer.stderr)
        self.assertIn("UNSTABLE", (self.output / "summary.txt").read_text())
        for name in ("run.pvd", "history.csv", "first.svg", "last.svg", "frames/frame_0000.vtp"):
            self.assertTrue((self.output / name).is_file(), name)

    def test_no_progress_bar_without_a_terminal(self):
        answer = halfspace("run", FALLING, "-o", self.output)
        self.assertEqual(answer.stderr, "")
        self.assertNotIn("\r", answer.stdout)

    def test_progress_bar_with_time_left_on_a_terminal(self):
        controller, terminal = pty.openpty()
        with subprocess.Popen([COMMAND, "run", str(FALLING), "-o", str(self.output)], stdout=subprocess.DEVNULL,
                              stderr=terminal) as process:
            self.assertEqual(process.wait(timeout=60), 0)
        os.close(terminal)
        shown = os.read(controller, 1 << 16).decode()
        os.close(controller)
        self.assertRegex(shown, r"\[#* *\] \d+ %  t = \S+ of 0\.5 s  \d+:\d\d left")
        self.assertTrue(shown.endswith("\r\033[K"), "the bar leaves a clean line")


if __name__ == "__main__":
    main()
