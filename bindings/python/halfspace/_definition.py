"""Definitions: settings that a function of the library takes together."""
from __future__ import annotations

import ctypes
import dataclasses
from enum import IntEnum
from typing import Any, Callable, TypeVar

from ._choice import choice

_Struct = TypeVar("_Struct")


def filled(struct: _Struct, initialise: Callable[..., Any], *arguments: Any, **values: Any) -> _Struct:
    """A struct with the library's defaults, but for these values of its fields."""
    initialise(ctypes.byref(struct), ctypes.sizeof(struct), *arguments)  # type: ignore[arg-type]
    for name, value in values.items():
        setattr(struct, name, value)
    return struct


@dataclasses.dataclass(frozen=True)
class Definition:
    """Settings with the names of the struct that they fill."""

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            if isinstance(field.default, IntEnum):
                value = choice(getattr(self, field.name), type(field.default), field.name)
                object.__setattr__(self, field.name, value)

    def _filled(self, struct: _Struct, initialise: Callable[..., Any]) -> _Struct:
        return filled(struct, initialise, **vars(self))
