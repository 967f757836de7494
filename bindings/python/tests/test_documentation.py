"""Programs in the README and examples in docstrings work."""
import doctest
import inspect
import pathlib
import pydoc
import re

import pytest

import halfspace
from halfspace import context, generators, impact, pair, properties, query, run, scene, shape, world

README = pathlib.Path(__file__).parents[1] / "README.md"
REFERENCE = pathlib.Path(__file__).resolve().parents[3] / "docs/doxygen/reference"
SYMBOLS = pathlib.Path(__file__).parents[1] / "../../capi/symbols.txt"


MODULES = [context, generators, impact, pair, properties, query, run, scene, shape, world]


@pytest.mark.parametrize("module", [halfspace, halfspace._arrays, *MODULES])
def test_examples_in_docstrings(module):
    names = {name: getattr(halfspace, name) for name in halfspace.__all__}
    result = doctest.testmod(module, extraglobs=names)
    assert result.attempted > 0 and result.failed == 0


@pytest.mark.skipif(not README.exists(), reason="the wheel is tested without the source tree")
def test_programs_in_the_readme(capsys, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("Agg")
    (tmp_path / "docs").symlink_to(README.parents[2] / "docs")
    monkeypatch.chdir(tmp_path)
    names = {}
    for program in re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL):
        exec(program, names)
    assert names["contact"].gap == -0.125
    assert "EDGE_EDGE -0.125" in capsys.readouterr().out
    assert (tmp_path / "out" / "frame_0000_contacts.vtp").exists()


@pytest.mark.skipif(not SYMBOLS.exists(), reason="the wheel is tested without the source tree")
def test_every_function_of_the_library_is_reached():
    sources = pathlib.Path(halfspace.__file__).parent.glob("*.py")
    text = "".join(each.read_text(encoding="utf-8") for each in sources if each.name != "_raw.py")
    called = set(re.findall(r"\blibrary\.(hs_\w+)", text))
    # Functions without a Python interface.
    needless = {"hs_task_run"}  # for schedulers of C
    assert set(SYMBOLS.read_text(encoding="ascii").split()) - called == needless


def public_members(kind):
    """Methods and properties of a class, also of classes of the package that it is derived from."""
    for base in kind.__mro__:
        for name, member in vars(base).items() if base.__module__.startswith("halfspace") else ():
            if not name.startswith("_") and (callable(getattr(base, name)) or isinstance(member, property)):
                yield name


@pytest.mark.skipif(not REFERENCE.exists(), reason="the wheel is tested without the source tree")
def test_the_reference_has_all_members_under_their_public_classes(monkeypatch):
    monkeypatch.syspath_prepend(str(REFERENCE))
    import python_pages

    pages = list(python_pages.modules(REFERENCE.parents[2]))
    shown = {(owner, member.name) for page in pages for item in page.items for owner in item.name.split(", ")
             for member in item.members}
    items = {item.name for page in pages for item in page.items}
    for name in halfspace.__all__:
        member = getattr(halfspace, name)
        if inspect.isclass(member) and not issubclass(member, int):
            assert name in items
            assert not [each for each in public_members(member) if (name, each) not in shown]
    owners = {owner for item in items for owner in item.split(", ")}
    assert not {"Runs", "ActedOn", "Statics", "Handle"} & owners


@pytest.mark.skipif(not REFERENCE.exists(), reason="the wheel is tested without the source tree")
def test_the_reference_escapes_no_underscores(monkeypatch):
    monkeypatch.syspath_prepend(str(REFERENCE))
    import page_of_module
    import python_pages

    for module in python_pages.modules(REFERENCE.parents[2]):
        assert "\\_" not in page_of_module.markdown("Python", module, "py")[1]


def test_everything_public_is_documented():
    for name in halfspace.__all__:
        member = getattr(halfspace, name)
        if isinstance(member, type):
            assert member.__doc__, name
            for attribute, value in vars(member).items():
                if not attribute.startswith("_") and (
                    callable(value) or isinstance(value, (property, classmethod))
                ):
                    assert getattr(member, attribute).__doc__, f"{name}.{attribute}"


def test_lines_of_help_fit_a_screen():
    for name in halfspace.__all__:
        for line in pydoc.plain(pydoc.render_doc(getattr(halfspace, name))).splitlines():
            assert len(line) <= 120, f"{name}: {line}"
    signature = str(inspect.signature(halfspace.World.add_block))
    assert "    kind: Union[BlockKind, str] = BlockKind.RIGID,\n" in signature and signature.endswith("\n) -> int")
    assert str(inspect.signature(halfspace.World.step)) == "(self, steps: int = 1) -> None"
