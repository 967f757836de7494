"""Pictures of a scene in the plane: one window and one scale of colours, which hold the whole run."""
import re
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from command import EXAMPLES, SCENES, SceneTest, halfspace, main

SPACE = "{http://www.w3.org/2000/svg}"
FREE = "#1b1b1b"  # outline of what moves freely


class PicturesInPlane(unittest.TestCase):
    def pictures_of(self, scene):
        """By name, the drawings of a run."""
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        path = Path(temporary.name, "scene.toml")
        path.write_text(scene)
        answer = halfspace("run", path, "-o", path.with_name("out"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return {file.name: ElementTree.parse(file).getroot() for file in path.with_name("out").glob("*.svg")}

    def check_windows(self, pictures):
        """All the same, with every free block inside."""
        windows = set()
        for name, root in pictures.items():
            x, y, width, height = (float(root.find(f".//{SPACE}clipPath/{SPACE}rect").get(key))
                                   for key in ("x", "y", "width", "height"))
            windows.add((x, y, width, height))
            free = [path for path in root.iter(SPACE + "path") if path.get("stroke") == FREE]
            self.assertGreater(len(free), 0)
            for path in free:
                for corner in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", path.get("d")):
                    self.assertTrue(x <= float(corner[0]) <= x + width and y <= float(corner[1]) <= y + height, name)
        self.assertEqual(len(windows), 1)

    @staticmethod
    def fill_of_free(root):
        return next(path.get("fill") for path in root.iter(SPACE + "path") if path.get("stroke") == FREE)

    def test_a_block_thrown_up_is_seen_on_its_way_and_in_the_colour_of_it(self):
        scene = (SCENES / "thrown_up.toml").read_text()
        fills = {}
        for colour in ("displacement", "speed"):
            pictures = self.pictures_of(scene + f'colour = "{colour}"\n')
            self.check_windows(pictures)
            fills[colour] = [self.fill_of_free(pictures[name]) for name in ("first.svg", "at_0.45s.svg", "last.svg")]
        least, most = fills["displacement"][:2]
        self.assertLess(sum(bytes.fromhex(least[1:])) + 200, sum(bytes.fromhex(most[1:])), "dark and bright end")
        self.assertEqual(fills, {"displacement": [least, most, least], "speed": [most, least, most]})

    def test_a_window_that_is_given_stays(self):
        scene = (SCENES / "thrown_up.toml").read_text() + "window = [[-1, -1], [3, 3]]\n"
        for name, root in self.pictures_of(scene).items():
            rectangle = root.find(f".//{SPACE}clipPath/{SPACE}rect")
            self.assertEqual((rectangle.get("width"), rectangle.get("height")), ("640.00", "640.00"), name)

    def test_two_pictures_at_one_step_are_both_drawn(self):
        scene = (SCENES / "thrown_up.toml").read_text().replace("times = [0.45]", "times = [0.45, 0.4500000001, 0.9]")
        self.assertEqual(set(self.pictures_of(scene)),
                         {"first.svg", "at_0.45s.svg", "at_0.4500000001s.svg", "at_0.9s.svg", "last.svg"})

    def test_the_first_scene_of_the_documentation_is_seen_whole(self):
        page = (EXAMPLES.parent / "scenes" / "index.md").read_text()
        self.check_windows(self.pictures_of(re.search(r"```toml\n(.*?)```", page, re.DOTALL).group(1)))


class Numbers(SceneTest):
    def test_blocks_have_their_numbers_on_request(self):
        text = (SCENES / "falling_block.toml").read_text()
        for picture, numbers in (("", set()), ("numbers = true\n", {"0", "1", "2"})):
            self.run_scene(text + "[output.picture]\n" + picture)
            clipped = ElementTree.parse(self.output / "last.svg").getroot().iter(SPACE + "g")
            self.assertEqual({label.text for group in clipped for label in group.iter(SPACE + "text")}, numbers)


if __name__ == "__main__":
    main()
