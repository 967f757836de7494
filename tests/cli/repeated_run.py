"""The same scene gives the same bytes, in every file, on any number of threads."""
import tempfile
import unittest
from pathlib import Path

from command import EXAMPLES, SCENES, halfspace, main


def files_of(directory):
    return {str(path.relative_to(directory)): path.read_bytes() for path in directory.rglob("*") if path.is_file()}


class RepeatedRun(unittest.TestCase):
    def test_identical_bytes_in_space(self):
        with tempfile.TemporaryDirectory() as directory:
            runs = []
            for name, threads in (("once", "1"), ("again", "3")):
                answer = halfspace("run", SCENES / "cells_fall.toml", "-o", Path(directory, name), "--threads", threads)
                self.assertEqual(answer.returncode, 0, answer.stderr)
                runs.append(files_of(Path(directory, name)))
            self.assertEqual(*runs)
            contacts = int(runs[0]["history.csv"].decode().splitlines()[-1].split(",")[2])
            print(f"{len(runs[0])} files, {contacts} contacts at the end: identical")
            self.assertGreater(contacts, 30)

    def test_identical_bytes(self):
        with tempfile.TemporaryDirectory() as directory:
            # The collapse with irregular joints, for as long as it takes to get many contacts.
            text = (EXAMPLES / "rock_collapse" / "friction_15.toml").read_text()
            text = text.replace("duration = 7.5", "duration = 0.3").replace("[2.5, 5.0]", "[0.1]")
            text = text.replace("spacing = 1.5", "spacing = 1.5\njitter = 0.4\nseed = 7")
            runs = []
            for name, threads in (("once", 1), ("again", 2)):
                scene = Path(directory, f"{name}.toml")
                scene.write_text(text.replace("[world]", f"[world]\nthreads = {threads}"))
                answer = halfspace("run", scene, "-o", Path(directory, name))
                self.assertEqual(answer.returncode, 0, answer.stderr)
                runs.append(files_of(Path(directory, name)))
            once, again = runs
            self.assertEqual(sorted(once), sorted(again))
            for name, content in once.items():
                self.assertEqual(content, again[name], name)
            contacts = int(once["history.csv"].decode().splitlines()[-1].split(",")[2])
            print(f"{len(once)} files, {sum(map(len, once.values()))} bytes, {contacts} contacts at the end: identical")
            self.assertGreater(contacts, 100)


if __name__ == "__main__":
    main()
