"""What the tests of the command share: the command under test, and scenes to feed it."""
import pathlib
import subprocess
import sys
import unittest

COMMAND = sys.argv[1] if len(sys.argv) > 1 else "halfspace"
EXAMPLES = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "docs/examples")
SCENES = pathlib.Path(__file__).parent / "scenes"


def halfspace(*arguments, **options):
    """Runs the command with its output captured, so that it has no terminal."""
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, **{"timeout": 1800} | options)


def main():
    unittest.main(argv=sys.argv[:1], verbosity=2)
