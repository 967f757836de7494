"""Constants as arguments: enum members, numbers or names."""
from __future__ import annotations

from enum import IntEnum
from typing import Type, Union

from ._arrays import index


def choice(value: Union[int, str], choices: Type[IntEnum], name: str) -> int:
    """Converts a constant: an enum member, its number, or its name in any case, with spaces, e.g. "per area". The
    library refuses other numbers."""
    words = {member.name.lower().replace("_", " "): member for member in choices}
    if isinstance(value, str):
        found = words.get(value.lower().replace("_", " ").replace("-", " "))
    else:
        try:
            number = index(value, name)
        except TypeError:
            found = None
        else:
            found = next((member for member in choices if member == number), None)
            if found is None:
                return number
    if found is None:
        allowed = ", ".join(f'"{word}"' for word in words)
        raise ValueError(f"{name} is {value!r}; it must be one of {allowed}, or a {choices.__name__}")
    return found
