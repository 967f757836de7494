"""Readers of text cases (tests/cases): fields and constants of the library by their names, for C, Rust and Fortran.
Python has them by their names as it is."""
import math

import fortran_records
import meanings
import rust_definitions
import rust_records

# Subjects of `expect` statements, and structs whose fields statements set.
SUBJECTS = {"shape": "hs_shape_properties", "contact": "hs_contact", "impact": "hs_impact", "block": "hs_block_state",
            "deformation": "hs_deformation", "report": "hs_world_report", "energy": "hs_energy"}
SETTINGS = ["hs_world_def", "hs_law_def", "hs_elasticity_def", "hs_pair_options", "hs_motion_def"]
RUST_SETTINGS = ["law", "elasticity", "motion", "world"]
FORTRAN_SETTINGS = ["law", "elasticity"]
# In Rust these are not functions of the same name.
RUST_VALUES = {
    "hs_contact.type": "vec![f64::from(of.kind().value())]",
    "hs_contact.feature_a": "vec![of.features().0.map_or(-1.0, |index| index as f64)]",
    "hs_contact.feature_b": "vec![of.features().1.map_or(-1.0, |index| index as f64)]",
    "hs_contact.point_count": "vec![of.points().len() as f64]",
    "hs_contact.points": "of.points().concat()",
    "hs_contact.gaps": "of.gaps().to_vec()",
    "hs_impact.feature_a": "vec![of.features().0 as f64]",
    "hs_impact.feature_b": "vec![of.features().1 as f64]",
    "hs_block_state.material": "vec![f64::from(of.material.index())]",
}

C_HEAD = """\
/* Generated {generated}.
   Fields and constants of the library by their names. C99 that is C++ as well. */
#include "fields.h"
"""
RUST_HEAD = """\
// Generated {generated}.

//! Fields and constants of the library by their names in C.

use halfspace::{{BlockState, Contact, Deformation, Energy, Impact, Report, ShapeProperties}};
use halfspace::{{Elasticity, Law, Motion, StiffnessKind, WorldDef}};
use halfspace_sys as sys;
"""
FORTRAN_HEAD = """\
! Generated {generated}.

!> Fields and constants of the library by their names in C. The files count from 0, the modules from 1.
module case_fields
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none
  private
  public :: constant, {subjects}
  public :: {setters}

contains

  integer function constant(name)
    character(*), intent(in) :: name
    select case (name)
"""


def constants(api):
    """The names of all of them."""
    groups = [api["status_codes"], *(group["constants"] for group in api["constants"])]
    return [each["name"] for group in groups for each in group]


def fields(api, struct, path="", joint="."):
    """Path and description of each field that is a number or several; a pose is both of its fields."""
    for field in meanings.read_fields(struct):
        if field["of"] == "hs_pose":
            yield from fields(api, meanings.find(api, "hs_pose"), path + field["name"] + joint, joint)
        elif field["of"] in ("int32_t", "int64_t", "double"):
            yield path + field["name"], field


def write_c(api):
    lines = [*C_HEAD.format_map(api).splitlines(), "", "const Constant case_constants[] = {"]
    lines += [*(f'    {{"{name}", {name}}},' for name in constants(api)), "    {NULL, 0},", "};"]
    for table, name in (SUBJECTS | {name.removeprefix("hs_"): name for name in SETTINGS}).items():
        lines += ["", f"const Field {table}_fields[] = {{"]
        for path, field in fields(api, meanings.find(api, name)):
            kind, count = "FIELD_" + field["of"].removesuffix("_t").upper(), math.prod(field["dimensions"])
            lines.append(f'    {{"{field["name"]}", {kind}, {count}, offsetof({name}, {path})}},')
        lines += ["    {NULL, FIELD_INT32, 0, 0},", "};"]
    return "\n".join(lines) + "\n"


def write_rust(api):
    lines = [*RUST_HEAD.format_map(api).splitlines(), "", "pub fn constant(name: &str) -> Option<i32> {",
             "    Some(match name {", *(f'        "{name}" => sys::{name},' for name in constants(api))]
    lines += ["        _ => return None,", "    })", "}"]
    for subject, name in SUBJECTS.items():
        struct = meanings.find(api, name)
        record = rust_records.name_of(name)
        lines += ["", f"pub fn of_{subject}(of: &{record}, field: &str) -> Option<Vec<f64>> {{",
                  "    Some(match field {"]
        for path, field in fields(api, struct):
            value = RUST_VALUES.get(f"{name}.{field['name']}") or rust_value(struct, path, field)
            lines.append(f'        "{field["name"]}" => {value},')
        lines += ["        _ => return None,", "    })", "}"]
    for setting in RUST_SETTINGS:
        lines += ["", *rust_setting(meanings.find(api, f"hs_{setting}_def"), setting)]
    return "\n".join(lines) + "\n"


def rust_setting(struct, setting):
    """Sets a field of a definition by its builder."""
    builder = rust_definitions.BUILDERS[struct["name"]]
    lines = [f"pub fn set_{setting}(of: {builder}, field: &str, values: &[f64]) -> Option<{builder}> {{",
             "    Some(match field {"]
    for field in meanings.read_fields(struct):
        rust_type = rust_definitions.type_of(struct, field)
        if rust_type:
            value = {"f64": "values[0]", "[f64; 3]": "values.try_into().ok()?", "bool": "values[0] != 0.0",
                     "i32": "values[0] as i32"}.get(rust_type)
            lines.append(f'        "{field["name"]}" => '
                         f'of.{field["name"]}({value or f"{rust_type}::from_value(values[0] as i32)"}),')
    return [*lines, "        _ => return None,", "    })", "}"]


def rust_value(struct, path, field):
    rust_type, _ = rust_records.converted(struct, field, "")
    value = f"of.{path}()" if struct["name"] in rust_records.GETTERS else f"of.{path}"
    if rust_type == "f64":
        return f"vec![{value}]"
    if rust_type.startswith("["):
        is_tensor = struct["name"] in rust_records.SAME_LAYOUT
        return f"{value}.concat()" if is_tensor else f"{value}.to_vec()"
    if rust_type in ("usize", "u64"):
        return f"vec![{value} as f64]"
    return f"vec![f64::from({value}.value())]"


def write_fortran(api):
    head = FORTRAN_HEAD.format(generated=api["generated"], subjects=", ".join(f"of_{each}" for each in SUBJECTS),
                               setters=", ".join(f"set_{each}" for each in FORTRAN_SETTINGS))
    lines = [*head.splitlines(), *(f"    case ('{name}'); constant = {name}" for name in constants(api))]
    lines += ["    case default; error stop 'a case names a constant that is none'", "    end select",
              "  end function constant"]
    for subject, name in SUBJECTS.items():
        struct = meanings.find(api, name)
        lines += ["", f"  function of_{subject}(record, field) result(values)",
                  f"    type({fortran_records.name_of(name)}), intent(in) :: record",
                  "    character(*), intent(in) :: field", "    real(real64), allocatable :: values(:)",
                  "    select case (field)"]
        lines += [f"    case ('{field['name']}'); values = {fortran_value(struct, 'record%' + path, field)}"
                  for path, field in fields(api, struct, joint="%")]
        lines += [f"    case default; error stop 'a case names a field of {subject} that is none'",
                  "    end select", f"  end function of_{subject}"]
    for setting in FORTRAN_SETTINGS:
        lines += ["", *fortran_setting(meanings.find(api, f"hs_{setting}_def"), setting)]
    return "\n".join([*lines, "", "end module case_fields", ""])


def fortran_setting(struct, setting):
    lines = [f"  subroutine set_{setting}(of, field, value)", f"    type(halfspace_{setting}), intent(inout) :: of",
             "    character(*), intent(in) :: field", "    real(real64), intent(in) :: value",
             "    select case (field)"]
    lines += [f"    case ('{path}'); of%{path} = {'value' if field['of'] == 'double' else 'int(value, int32)'}"
              for path, field in fields({}, struct)]
    return [*lines, f"    case default; error stop 'a case names a field of {setting} that is none'", "    end select",
            f"  end subroutine set_{setting}"]


def fortran_value(struct, value, field):
    if field["dimensions"] == [9]:
        return f"reshape(transpose({value}), [9])"
    if field["dimensions"]:
        return value if len(field["dimensions"]) == 1 else f"[{value}]"
    if field["of"] == "double":
        return f"[{value}]"
    from_1 = meanings.of(struct, field) in (meanings.INDEX, meanings.INDEX_OR_NONE)
    return f"[real({value}{' - 1' * from_1}, real64)]"
