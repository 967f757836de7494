"""Programs in the README and examples in docstrings work."""
import doctest
import pathlib
import re

import pytest

import halfspace
from halfspace import affine, context, impact, law, pair, query, shape, world

README = pathlib.Path(__file__).parents[1] / "README.md"
SYMBOLS = pathlib.Path(__file__).parents[1] / "../../capi/symbols.txt"


@pytest.mark.parametrize(
    "module", [halfspace, halfspace._arrays, affine, context, impact, law, pair, query, shape, world]
)
def test_examples_in_docstrings(module):
    names = {name: getattr(halfspace, name) for name in halfspace.__all__}
    result = doctest.testmod(module, extraglobs=names)
    assert result.attempted > 0 and result.failed == 0


@pytest.mark.skipif(not README.exists(), reason="the wheel is tested without the source tree")
def test_programs_in_the_readme(capsys):
    pytest.importorskip("matplotlib").use("Agg")
    names = {}
    for program in re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL):
        exec(program, names)
    assert names["contact"].gap == -0.125
    assert "EDGE_EDGE -0.125" in capsys.readouterr().out


@pytest.mark.skipif(not SYMBOLS.exists(), reason="the wheel is tested without the source tree")
def test_every_function_of_the_library_is_reached():
    sources = pathlib.Path(halfspace.__file__).parent.glob("*.py")
    text = "".join(each.read_text(encoding="utf-8") for each in sources if each.name != "_raw.py")
    called = set(re.findall(r"\blibrary\.(hs_\w+)", text))
    # Functions without a Python interface.
    needless = {"hs_task_run"}  # for schedulers of C
    assert set(SYMBOLS.read_text(encoding="ascii").split()) - called == needless


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
