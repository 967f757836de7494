"""Signatures that help() shows in lines that fit a screen."""
from __future__ import annotations

import inspect
import re
import types
from enum import Enum
from typing import Any, Iterable

_WIDTH = 80
_INDENT = " " * 4


def _parameter_text(parameter: inspect.Parameter) -> str:
    default = parameter.default
    if isinstance(default, Enum):
        parameter = parameter.replace(default=inspect.Parameter.empty)
        return f"{_unquoted(str(parameter))} = {type(default).__name__}.{default.name}"
    return _unquoted(str(parameter))


def _unquoted(text: str) -> str:
    return re.sub(r"(?<=: )'([^']*)'", r"\1", text)


class WrappedSignature(inspect.Signature):
    """The signature of a function, made at first use; it prints a parameter per line where one line is too long."""

    __slots__ = ("_function",)
    _function: Any  # a function, which mypy would take for a method

    @classmethod
    def of(cls, function: types.FunctionType) -> WrappedSignature:
        """The signature of a function."""
        signature = cls.__new__(cls)
        signature._function = function
        return signature

    def __getattr__(self, name: str) -> Any:  # of a part that is not made yet
        if name not in ("_parameters", "_return_annotation"):
            raise AttributeError(name)
        given = self._function  # a copy, as the function itself has this signature
        parts = given.__code__, given.__globals__, given.__name__, given.__defaults__, given.__closure__
        copy = types.FunctionType(*parts)
        copy.__kwdefaults__, copy.__annotations__ = given.__kwdefaults__, given.__annotations__
        made = inspect.Signature.from_callable(copy)
        self.__init__(list(made.parameters.values()), return_annotation=made.return_annotation)  # type: ignore[misc]
        return getattr(self, name)

    def __str__(self) -> str:
        line = _unquoted(super().__str__()).replace("-> '", "-> ").rstrip("'")
        line = re.sub(r"<(\w+\.\w+): \d+>", r"\1", line)
        if len(line) <= _WIDTH:
            return line
        kinds = inspect.Parameter
        lines, is_after_star = [], False
        for parameter in self.parameters.values():
            if parameter.kind is kinds.VAR_POSITIONAL:
                is_after_star = True
            elif parameter.kind is kinds.KEYWORD_ONLY and not is_after_star:
                lines.append("*")
                is_after_star = True
            lines.append(_parameter_text(parameter))
        end = line[line.rindex(")"):] if "->" in line else ")"
        return "(\n" + "".join(f"{_INDENT}{each},\n" for each in lines) + end


def wrap_signatures(members: Iterable[Any]) -> None:
    """Gives functions, and those of classes, signatures that fit a screen."""
    for member in members:
        if inspect.isclass(member):
            for base in member.__mro__:
                if base.__module__.startswith(__package__):
                    wrap_signatures(
                        getattr(each, "__func__", each) for each in vars(base).values() if not inspect.isclass(each)
                    )
        elif inspect.isfunction(member) and not hasattr(member, "__signature__"):
            member.__signature__ = WrappedSignature.of(member)  # type: ignore[attr-defined]
