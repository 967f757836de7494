"""Raw Python: ctypes structures, constants, and the types of all functions."""
import re

import versions
from header import DECLARATIONS
from prose import wrapped

TYPES = {"int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64", "uint64_t": "c_uint64",
         "size_t": "c_size_t", "double": "c_double"}
IMPORTED = sorted({"CFUNCTYPE", "POINTER", "c_char_p", "c_void_p", *TYPES.values()})
LONGEST_LINE = 110

HEAD = '''\
# Generated {generated}.
"""The C interface of libhalfspace {version} as it is, for ctypes. Names and conventions are those of C.

Arrays are passed as addresses or ctypes arrays, single structs and numbers by byref(); None is NULL."""
from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_char_p,
    c_double,
    c_int32,
    c_int64,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
)
from typing import Any


class _Struct(Structure):
    """A struct that names the field which got a value of a wrong type."""

    def __setattr__(self, name: str, value: Any) -> None:
        try:
            super().__setattr__(name, value)
        except TypeError as error:
            raise TypeError(f"{{name}} is {{value!r}}: {{error}}") from None

'''


BESIDE_HEAD = '''\
# Generated {generated}.
"""The C interface {interface} as it is, for ctypes: see _raw.py."""
from ctypes import {types}
from typing import Any

from ._raw import {known}
'''


def write(api):
    lines = HEAD.format_map(api).splitlines()
    lines += ["", "# Names the interface that is described here.", f'SONAME = "{versions.soname(api["version"])}"']
    for parts in (aliases, status_codes, constants, handles, callbacks, structs, declare):
        lines += ["", *parts(api)]
    return "\n".join(lines) + "\n"


def write_beside(api, known):
    """The raw Python of another header, with types of the interface `known`."""
    written = [part(api) for part in (constants, handles, callbacks, structs, declare)]
    text = "\n".join(line for lines in written if lines for line in ["", *lines])
    names = ["_Struct", *(each["name"] for kind in DECLARATIONS for each in known[kind])]
    used = [[name for name in one if re.search(rf"\b{name}\b", text)] for one in (IMPORTED, names)]
    interface = re.search(r"halfspace/\w+\.h", api["generated"])[0]
    types, known_types = map(", ".join, used)
    return BESIDE_HEAD.format_map({**api, "interface": interface, "types": types, "known": known_types}) + text + "\n"


def aliases(api):
    lines = []
    for alias in api["aliases"]:
        lines += [*wrapped(alias["comment"], "# "), f"{alias['name']} = {TYPES[alias['type']]}"]
    return lines


def status_codes(api):
    lines = ["# Status codes."]
    for code in api["status_codes"]:
        lines += with_comment(f"{code['name']} = {code['value']}", code["text"])
    return lines


def constants(api):
    lines = []
    for group in api["constants"]:
        lines += ["", *wrapped(group["comment"], "# ")]
        for each in group["constants"]:
            lines += with_comment(f"{each['name']} = {each['value']}", each["comment"])
    return lines[1:]


def callbacks(api):
    lines = []
    for callback in api["callbacks"]:
        types = ", ".join(map(type_of, [callback["result"], *callback["parameters"]]))
        lines += [*wrapped(callback["comment"], "# "), f"{callback['name']} = CFUNCTYPE({types})"]
    return lines


def handles(api):
    lines = []
    for handle in api["handles"]:
        lines += ["", *begun_class(handle), ""]
    return lines[:-1]


def structs(api):
    lines = []
    for struct in api["structs"]:
        lines += ["", *begun_class(struct), "", "    _fields_ = ["]
        for field in struct["fields"]:
            lines += with_comment(f"        (\"{field['name']}\", {field_type(field)}),", field["comment"])
        lines += ["    ]", ""]
    return lines[:-1]


def begun_class(described):
    lines = wrapped(described["comment"] + '"""', '    """', "    ")
    return [f"class {described['name']}(_Struct):", *lines]


def field_type(field):
    declared = type_of(field)
    for count in reversed(field["dimensions"]):
        declared = f"{declared} * {count}"
    return declared


def declare(api):
    lines = ["", "def declare(library: Any) -> None:",
             '    """Says which types the functions of a loaded library take and return."""']
    for function in api["functions"]:
        called = f"library.{function['name']}"
        lines += [*wrapped(function["comment"], "    # "), f"    {called}.argtypes = ["]
        lines += [f"        {type_of(parameter)},  # {parameter['name']}" for parameter in function["parameters"]]
        lines += ["    ]", f"    {called}.restype = {type_of(function['result'])}", ""]
        if not function["parameters"]:
            lines[-4:-2] = [lines[-4] + "]"]
    return lines[:-1]


def type_of(described):
    """The ctypes type of a field, parameter or result, but for the dimensions of a field."""
    kind, declared = described["kind"], TYPES.get(described["of"], described["of"])
    if kind in ("value", "callback"):
        return declared
    if kind in ("pointer", "handle"):
        return f"POINTER({declared})"
    if kind == "new_handle":
        return f"POINTER(POINTER({declared}))"
    return {"string": "c_char_p", "nothing": "None"}.get(kind, "c_void_p")


def with_comment(code, comment):
    """Behind the code if there is room, else above it."""
    behind = f"{code}  # {comment}"
    if len(behind) <= LONGEST_LINE:
        return [behind]
    indent = code[:len(code) - len(code.lstrip())]
    return [*wrapped(comment, indent + "# "), code]


def public_names(names):
    """The names that `import *` takes from a module."""
    listed = ", ".join(f'"{name}"' for name in names)
    return wrapped(f"__all__ = [{listed}]", "", " " * 11)
