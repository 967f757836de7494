"""Python values as TOML, for scenes."""
from __future__ import annotations

import math
from typing import Any, Iterator, List, Mapping, Sequence, Union

import numpy as np

Settings = Union[Mapping[str, Any], Sequence[str], None]


def toml_value(value: Any) -> str:
    """A value on one line: numbers, words, truth values, lists, arrays and tables."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        plain = value.replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in plain) + '"'
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value)) if math.isfinite(value) else str(float(value))
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(key)} = {toml_value(each)}" for key, each in value.items()) + "}"
    if isinstance(value, np.ndarray):
        return toml_value(value.tolist())
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    raise TypeError(f"{value!r} has no form in TOML; allowed: numbers, texts, lists, arrays and dicts")


def _key(key: str) -> str:
    return key if key.replace("_", "").replace("-", "").isalnum() and key.isascii() else toml_value(key)


def _is_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(each, Mapping) for each in value)


def _section(heading: str, table: Mapping[str, Any]) -> Iterator[str]:
    yield f"\n{heading}"
    yield from (f"{_key(key)} = {toml_value(value)}" for key, value in table.items())


def toml_text(tables: Mapping[str, Any]) -> str:
    """A file of the given tables; a list of tables is one with double brackets."""
    lines: List[str] = []
    for key, value in tables.items():
        if not isinstance(value, Mapping) and not _is_tables(value):
            lines.append(f"{_key(key)} = {toml_value(value)}")
    for key, value in tables.items():
        if isinstance(value, Mapping):
            lines.extend(_section(f"[{_key(key)}]", value))
        elif _is_tables(value):
            for each in value:
                lines.extend(_section(f"[[{_key(key)}]]", each))
    return "\n".join(lines) + "\n"


def settings_of(settings: Settings) -> List[str]:
    """Settings `key=value`, as after --set, from a mapping or from such texts."""
    if settings is None:
        return []
    if isinstance(settings, str):
        raise TypeError("settings is a text; give a dict {key: value} or a list of texts \"key=value\"")
    if isinstance(settings, Mapping):
        return [f"{key}={toml_value(value)}" for key, value in settings.items()]
    return list(settings)
