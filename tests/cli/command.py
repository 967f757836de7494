"""What the tests of the command share: the command under test, and scenes to feed it."""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMMAND = sys.argv[1] if len(sys.argv) > 1 else "halfspace"
EXAMPLES = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "docs/examples")
SCENES = pathlib.Path(__file__).parent / "scenes"


def halfspace(*arguments, **options):
    """Runs the command with its output captured, so that it has no terminal."""
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, **{"timeout": 1800} | options)


class SceneTest(unittest.TestCase):
    """A scene is written into a directory of its own, and run."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)
        self.scene = self.directory / "scene.toml"
        self.output = self.directory / "out"

    def run_scene(self, text, *arguments, code=0, command="run"):
        """What the command says of it; its exit code has to be this."""
        self.scene.write_text(text)
        answer = halfspace(command, self.scene, "-o", self.output, "--force", *arguments)
        self.assertEqual(answer.returncode, code, answer.stderr + answer.stdout)
        return answer

    def check_fault(self, text, fault):
        """The check of the scene has to tell a fault that matches."""
        self.scene.write_text(text)
        answer = halfspace("check", self.scene)
        self.assertEqual(answer.returncode, 1, text)
        self.assertRegex(answer.stderr, fault)

    def rows(self, name="history.csv"):
        with open(self.output / name, newline="") as file:
            return list(csv.DictReader(file))


def main():
    unittest.main(argv=sys.argv[:1], verbosity=2)
