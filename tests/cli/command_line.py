"""Help, version, exit codes, and a progress bar on terminals only."""
import os
import pty
import re
import shutil
import signal
import subprocess
import tempfile
import time
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

    def test_a_directory_is_no_scene(self):
        answer = halfspace("check", ".")
        self.assertEqual((answer.returncode, answer.stderr), (1, "halfspace: cannot read .: it is a directory\n"))

    def endless_scene(self, **changes):
        """It steps for hours, without falling; what is given replaces keys."""
        text = FALLING.read_text() + "\n"
        for key, value in {"gravity": [0, 0], "duration": 1e9, **changes}.items():
            line = f"{key} = {value}\n"
            if re.search(rf"(?m)^{key} = ", text):
                text = re.sub(rf"(?m)^{key} = .*\n", line, text)
            else:
                text = re.sub(r"(?m)^(\[output\]\n|\Z)", line, text, count=1)
        scene = Path(self.temporary.name, "endless.toml")
        scene.write_text(text)
        return scene

    def ended_by(self, sent, scene, **options):
        """The exit code of a run that got a signal once it had written its first file."""
        with subprocess.Popen([COMMAND, "run", str(scene), "-o", str(self.output)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, **options) as process:
            while process.poll() is None and not (self.output / "history.csv").exists():
                time.sleep(0.01)
            process.send_signal(sent)
            try:
                return process.wait(timeout=30)
            finally:
                process.kill()

    def test_signals_end_a_run_with_its_summary(self):
        for sent in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU, signal.SIGUSR1):
            with self.subTest(signal=sent.name):
                shutil.rmtree(self.output, ignore_errors=True)
                self.assertEqual(self.ended_by(sent, self.endless_scene()), 1)
                self.assertIn("interrupted", (self.output / "summary.txt").read_text())

    def test_a_signal_that_the_caller_ignores_ends_nothing(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        scene = self.endless_scene(duration=1000, frame_interval=1000, history_interval=1000)
        self.assertEqual(self.ended_by(signal.SIGHUP, scene, preexec_fn=ignore), 0)
        self.assertIn("complete", (self.output / "summary.txt").read_text())

    def test_signals_end_runs_of_times_as_extreme_as_can_be(self):
        for changes in ({"history_interval": 1e-300}, {"history_interval": 5e-324}, {"history_interval": 1e300},
                        {"duration": 1e300, "frame_interval": 1e299}):
            with self.subTest(**changes):
                shutil.rmtree(self.output, ignore_errors=True)
                self.assertEqual(self.ended_by(signal.SIGTERM, self.endless_scene(**changes)), 1)
                self.assertIn("interrupted", (self.output / "summary.txt").read_text())

    def test_tiny_intervals_give_a_row_and_a_frame_at_every_step(self):
        for interval in (5e-324, 1e-300, 1e-18):
            shutil.rmtree(self.output, ignore_errors=True)
            scene = self.endless_scene(duration=0.02, history_interval=interval, frame_interval=interval)
            self.assertEqual(halfspace("run", scene, "-o", self.output).returncode, 0)
            rows = (self.output / "history.csv").read_text().splitlines()[1:]
            self.assertEqual([row.split(",")[1] for row in rows], [str(k) for k in range(21)])
            self.assertEqual(len(list((self.output / "frames").iterdir())), 21)

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

    def test_an_unknown_word_is_told_with_the_nearest(self):
        for arguments, text in ((["rum", FALLING, "-o", self.output], "unknown command: \"rum\" (did you mean 'run'?); allowed: "),
                                (["safty"], "(did you mean 'safety'?)"), (["frobnicate"], 'unknown command: "frobnicate"; allowed: '),
                                (["run", FALLING, "--ouput", self.output], "unknown option: --ouput (did you mean '--output'?)"),
                                (["run", FALLING, "-o", self.output, "--thread=2"], "--thread=2 (did you mean '--threads'?)"),
                                (["safety", FALLING, "--resolutoin", "1"], "(did you mean '--resolution'?)")):
            with self.subTest(arguments=arguments):
                answer = halfspace(*arguments)
                self.assertEqual((answer.returncode, answer.stdout), (2, ""))
                self.assertIn(text, answer.stderr)
                self.assertFalse(self.output.exists())

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
