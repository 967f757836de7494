"""Fortran: the structs of which the modules have types of their own, byte for byte, with blocks by their names and
tensors as matrices; and the list of all constants."""
import re
import textwrap

import meanings
from fortran import Writer, above, with_comment

HEAD = """\
! Generated {generated}.

!> Structs of the C interface byte for byte, with blocks by their names and tensors as matrices t(row, column). Indices
!! count from 1, and 0 is none.
module halfspace_records
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
  use halfspace_blocks, only: halfspace_block
  implicit none
  private
  public :: {names}
"""
CONSTANTS_HEAD = """\
! Generated {generated}.

!> The constants of the C interface.
module halfspace_constants
"""
RECORDS = ["hs_contact", "hs_deformation", "hs_bond", "hs_bolt", "hs_cell_state", "hs_balance", "hs_ray_hit",
           "hs_closest_points", "hs_note"]
# halfspace_bond and halfspace_bolt say how one is made.
NAMES = {"hs_bond": "halfspace_bond_state", "hs_bolt": "halfspace_bolt_state"}


def name_of(struct_name):
    return NAMES.get(struct_name) or struct_name.replace("hs_", "halfspace_", 1)


def write(api):
    names = " &\n    ".join(textwrap.wrap(", ".join(map(name_of, RECORDS)), 104))
    lines = [*HEAD.format(generated=api["generated"], names=names).splitlines()]
    for name in RECORDS:
        struct = meanings.find(api, name)
        lines += ["", *above("  ", struct["comment"]), f"  type, bind(c) :: {name_of(name)}"]
        for field in struct["fields"]:
            lines += with_comment("    " + declared(api, struct, field), comment_of(struct, field), 120)
        lines.append(f"  end type {name_of(name)}")
    return "\n".join([*lines, "", "end module halfspace_records", ""])


def comment_of(struct, field):
    is_index = meanings.of(struct, field) in (meanings.INDEX, meanings.INDEX_OR_NONE)
    return re.sub(r"-1\b", "0", field["comment"]) if is_index else field["comment"]


def declared(api, struct, field):
    if meanings.of(struct, field) == meanings.BLOCK:
        return f"type(halfspace_block) :: {field['name']}"
    if field["name"] == "reserved":
        return "integer(c_int32_t), private :: reserved = 0"
    shape = [3, 3] if field["dimensions"] == [9] else field["dimensions"]
    return Writer(api).field(field | {"dimensions": shape})


def write_constants(api):
    groups = [api["status_codes"], *(group["constants"] for group in api["constants"])]
    names = ", ".join(each["name"] for group in groups for each in group)
    lines = textwrap.wrap(names, 110, initial_indent="    ", subsequent_indent="    ")
    lines = [*(line + " &" for line in lines[:-1]), lines[-1]]
    return "\n".join([*CONSTANTS_HEAD.format_map(api).splitlines(), "  use halfspace_c, only: &", *lines,
                      "  implicit none", "  public", "end module halfspace_constants", ""])
