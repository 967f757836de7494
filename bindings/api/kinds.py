"""Constants of the C API as enumerations: of Rust, those that a host reads or chooses from, and of Python."""
import meanings
from prose import wrapped
from python import public_names, with_comment
from rust import documented

RUST_HEAD = '''\
// Generated {generated}.

//! The library's constants as enums. A later version of the library may have more of them.

use crate::constants::constants;
'''
PYTHON_HEAD = '''\
# Generated {generated}.
"""The library's constants as enumerations."""
from enum import IntEnum, IntFlag

from . import _raw
'''
RUST_NAMES = {"HS_BOND_HOLDS": "None"}
NOT_IN_RUST = {"HS_FAULT_NONE"}  # no fault is no value


def write_rust(api):
    lines = RUST_HEAD.format_map(api).splitlines()
    errors = [{"name": code["name"], "comment": code["text"]} for code in api["status_codes"] if code["value"] < 0]
    lines += rust_enum("ErrorKind", "What kind of thing went wrong.", "HS_ERROR_", errors)
    for name, group in meanings.groups(api, 0):
        lines += rust_enum(name, group["comment"], group["group"], group["constants"])
    return "\n".join(lines) + "\n"


def rust_enum(name, comment, prefix, constants):
    lines = ["", "constants! {", *documented(comment, "    "), f"    {name} {{"]
    for each in constants:
        if each["name"] not in NOT_IN_RUST:
            variant = RUST_NAMES.get(each["name"]) or meanings.camel(each["name"].removeprefix(prefix))
            lines += [*documented(each["comment"], "        "), f"        {variant} = {each['name']},"]
    return [*lines, "    }", "}"]


def write_python(api):
    names = [name for name, _ in meanings.groups(api, 1)]
    lines = [*PYTHON_HEAD.format_map(api).splitlines(), "", *public_names(names)]
    for name, group in meanings.groups(api, 1):
        base = "IntFlag" if group["group"] in meanings.SUMS else "IntEnum"
        lines += ["", "", f"class {name}({base}):", *wrapped(group["comment"] + '"""', '    """', "    "), ""]
        for each in group["constants"]:
            member = each["name"].removeprefix(group["group"])
            lines += with_comment(f"    {member} = _raw.{each['name']}", each["comment"])
    return "\n".join(lines) + "\n"
