"""Attributes: the assignment of one that does not exist is an error, which names the right one."""
from __future__ import annotations

import dataclasses
import difflib
import enum
import inspect
from typing import Any, Dict, Iterable, List, Mapping

Ways = Mapping[str, str]  # how to set what has a name


def _parameters(function: Any) -> List[inspect.Parameter]:
    return list(inspect.signature(function).parameters.values())


def _calls(kind: type) -> Dict[str, str]:
    """The methods of a class, as they are called."""
    methods = inspect.getmembers(kind, inspect.isfunction)
    return {
        name: f"{name}({', '.join(each.name for each in _parameters(method)[1:])})"
        for name, method in methods
        if not name.startswith("_")
    }


def calls_that_set(kind: type) -> Ways:
    """Methods that set something, by its name, and by those of their arguments that are neither indices nor ids."""
    nouns, arguments = {}, {}
    for name, call in _calls(kind).items():
        verb, _, noun = name.partition("_")
        if verb in ("set", "with") and noun:
            nouns[noun] = call
            values = [each.name for each in _parameters(getattr(kind, name))[1:] if each.annotation not in ("int", int)]
            arguments.update({value: call for value in values if value not in arguments})
    return {**arguments, **nouns}


def _ways_to_set(kind: type) -> Ways:
    """By assignment, by a call, or when an object is made."""
    assigned = {name: name for name, member in inspect.getmembers(kind) if getattr(member, "fset", None)}
    settings = [each.name for each in _parameters(kind) if each.default is not each.empty]
    made = {name: f"{kind.__name__}(..., {name}=...)" for name in settings}
    return {**made, **calls_that_set(kind), **assigned}


def _similar(name: str, ways: Ways) -> str:
    found = dict.fromkeys(ways[each] for each in difflib.get_close_matches(name, ways))
    return f"; similar: {', '.join(found)}" if found else ""


def unknown_attribute(owner: type, name: str, known: Iterable[str]) -> AttributeError:
    """The error of reading or assigning an attribute that does not exist."""
    return AttributeError(f"{owner.__name__} has no attribute {name}{_similar(name, {each: each for each in known})}")


def refused_assignment(owner: type, name: str, ways: Ways, exists: bool) -> AttributeError:
    """The error of an assignment to an attribute that cannot be set so, or does not exist. It names the way to set it,
    or those of similar names, or all that set anything."""
    what = f"{owner.__name__}.{name} cannot be assigned" if exists else f"{owner.__name__} has no attribute {name}"
    if name in ways:
        return AttributeError(f"{what}; use {ways[name]}")
    setters = dict.fromkeys(way.partition("(")[0] for way in ways.values() if not way.startswith(owner.__name__))
    return AttributeError(what + (_similar(name, ways) or (f"; to set: {', '.join(setters)}" if setters else "")))


def _read(self: Any, name: str) -> Any:
    kind = type(self)
    if hasattr(kind, name):  # a property, whose own error led here
        return object.__getattribute__(self, name)
    raise unknown_attribute(kind, name, [each for each in dir(self) if not each.startswith("_")])


def _assign(self: Any, name: str, value: Any) -> None:
    kind = type(self)
    if not name.startswith("_") and not getattr(getattr(kind, name, None), "fset", None):
        ways, exists = {**_calls(kind), **_ways_to_set(kind)}, hasattr(kind, name)
        if "__setattr__" in vars(kind) or exists or name in ways:  # classes of users may have more
            raise refused_assignment(kind, name, ways if name in ways else _ways_to_set(kind), exists)
    object.__setattr__(self, name, value)


def _assign_to_frozen(self: Any, name: str, _: Any) -> None:
    fields = [field.name for field in dataclasses.fields(self)]
    if name not in fields:
        raise unknown_attribute(type(self), name, fields)
    raise refused_assignment(type(self), name, {name: f"dataclasses.replace(..., {name}=...)"}, exists=True)


def guard_attributes(members: Iterable[Any]) -> None:
    """Lets the classes among these refuse assignments to attributes that they do not have."""
    for kind in members:
        if inspect.isclass(kind) and not issubclass(kind, (enum.Enum, BaseException)):
            setattr(kind, "__setattr__", _assign_to_frozen if dataclasses.is_dataclass(kind) else _assign)
            setattr(kind, "__getattr__", _read)
