"""The ctypes structures have the sizes and offsets of the description, and every function can be declared."""
import ast
import ctypes
import importlib.util
import json
import pathlib
import unittest
from unittest import mock

BINDINGS = pathlib.Path(__file__).resolve().parents[1]
RAW = BINDINGS / "python" / "halfspace" / "_raw.py"
OLDEST_PYTHON = (3, 9)


class PythonLayout(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        module = importlib.util.spec_from_file_location("_raw", RAW)
        cls.raw = importlib.util.module_from_spec(module)
        module.loader.exec_module(cls.raw)
        cls.api = json.loads((BINDINGS / "api" / "halfspace_api.json").read_text(encoding="utf-8"))

    def test_structures(self):
        for struct in self.api["structs"]:
            structure = getattr(self.raw, struct["name"])
            with self.subTest(structure=struct["name"]):
                self.assertEqual(ctypes.sizeof(structure), struct["size"])
                names = [name for name, _ in structure._fields_]
                self.assertEqual(names, [field["name"] for field in struct["fields"]])
            for field in struct["fields"]:
                with self.subTest(structure=struct["name"], field=field["name"]):
                    member = getattr(structure, field["name"])
                    self.assertEqual((member.offset, member.size), (field["offset"], field["size"]))

    def test_functions(self):
        library = mock.MagicMock()
        self.raw.declare(library)
        for function in self.api["functions"]:
            with self.subTest(function=function["name"]):
                self.assertEqual(len(getattr(library, function["name"]).argtypes), len(function["parameters"]))

    def test_oldest_python(self):
        ast.parse(RAW.read_text(encoding="utf-8"), feature_version=OLDEST_PYTHON)


if __name__ == "__main__":
    unittest.main()
