"""The cases that all languages share."""
import os
import pathlib

import pytest
from case_player import Player, cases

FOLDER = pathlib.Path(
    os.environ.get("HALFSPACE_CASES", pathlib.Path(__file__).parents[3] / "tests" / "cases")
)
FILES = sorted(FOLDER.glob("*.case"))


def test_there_are_cases():
    assert len(FILES) >= 5


@pytest.mark.parametrize(
    "body", [pytest.param(body, id=f"{path.stem}: {name}") for path in FILES for name, body in cases(path)]
)
def test_case(body):
    assert body
    Player().play(body)
