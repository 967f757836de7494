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
  use halfspace_c, only: {counted}
  implicit none
  private
  public :: count_from_1, &
    {names}
"""
CONSTANTS_HEAD = """\
! Generated {generated}.

!> The constants of the C interface.
module halfspace_constants
"""
RECORDS = ["hs_contact", "hs_deformation", "hs_bond", "hs_bolt", "hs_cell_state", "hs_balance", "hs_ray_hit",
           "hs_closest_points", "hs_note", "hs_world_plan"]
# halfspace_bond and halfspace_bolt say how one is made.
NAMES = {"hs_bond": "halfspace_bond_state", "hs_bolt": "halfspace_bolt_state", "hs_world_def": "halfspace_world_def"}
# Structs with indices or tensors that no function of Fortran returns as they are: an impact has indices where there is
# one only, a motion is given, and a cache is C's.
AS_IN_C = {"hs_impact", "hs_motion_def", "hs_pair_cache"}


def name_of(struct_name):
    return NAMES.get(struct_name) or struct_name.replace("hs_", "halfspace_", 1).removesuffix("_def")


def counted(api):
    """Structs that count indices from 1, and rows of tensors first."""
    return [struct["name"] for struct in api["structs"] if struct["name"] not in AS_IN_C
            and any(is_index(struct, field) or shape_of(field) == [3, 3] for field in struct["fields"])]


def write(api):
    names = " &\n    ".join(textwrap.wrap(", ".join(map(name_of, RECORDS)), 104))
    of_c = ", ".join(name for name in counted(api) if name not in RECORDS)
    lines = [*HEAD.format(generated=api["generated"], names=names, counted=of_c).splitlines()]
    for name in RECORDS:
        struct = meanings.find(api, name)
        lines += ["", *above("  ", struct["comment"]), f"  type, bind(c) :: {name_of(name)}"]
        for field in struct["fields"]:
            lines += with_comment("    " + declared(api, struct, field), comment_of(struct, field), 120)
        lines.append(f"  end type {name_of(name)}")
    lines += ["", "  !> Counts indices from 1, and rows of tensors first, in what the library has written.",
              "  interface count_from_1", "    module procedure &",
              ", &\n".join(f"      {name.replace('hs_', 'count_')}" for name in counted(api)), "  end interface", "", "contains"]
    for name in counted(api):
        lines += ["", *counting(name, meanings.find(api, name))]
    return "\n".join([*lines, "", "end module halfspace_records", ""])


def counting(name, struct):
    lines = []
    for field in struct["fields"]:
        value = f"values%{field['name']}"
        if is_index(struct, field):
            lines.append(f"    {value} = {value} + 1")
        elif shape_of(field) == [3, 3]:
            lines.append(f"    {value} = transpose({value})")
    count, type_name = name.replace("hs_", "count_"), name_of(name) if name in RECORDS else name
    return [f"  elemental subroutine {count}(values)", f"    type({type_name}), intent(inout) :: values", *lines,
            f"  end subroutine {count}"]


def is_index(struct, field):
    return meanings.of(struct, field) in (meanings.INDEX, meanings.INDEX_OR_NONE)


def shape_of(field):
    return [3, 3] if field["dimensions"] == [9] else field["dimensions"]


def comment_of(struct, field):
    return re.sub(r"-1\b", "0", field["comment"]) if is_index(struct, field) else field["comment"]


def declared(api, struct, field):
    if meanings.of(struct, field) == meanings.BLOCK:
        return f"type(halfspace_block) :: {field['name']}"
    if field["name"] == "reserved":
        return "integer(c_int32_t), private :: reserved = 0"
    return Writer(api).field(field | {"dimensions": shape_of(field)})


def write_constants(api):
    groups = [api["status_codes"], *(group["constants"] for group in api["constants"])]
    names = ", ".join(each["name"] for group in groups for each in group)
    lines = textwrap.wrap(names, 110, initial_indent="    ", subsequent_indent="    ")
    lines = [*(line + " &" for line in lines[:-1]), lines[-1]]
    return "\n".join([*CONSTANTS_HEAD.format_map(api).splitlines(), "  use halfspace_c, only: &", *lines,
                      "  implicit none", "  public", "end module halfspace_constants", ""])
