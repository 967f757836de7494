"""Fortran: constructors of the properties of materials and joints."""
import definitions
import meanings
from fortran import above, broken, with_comment

LONGEST_LINE = 120
HEAD = """\
! Generated {generated}.

!> Properties of materials and joints, with constructors such as halfspace_law(friction_angle=0.5_c_double): missing
!! arguments have the defaults of the library.
module halfspace_properties
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_sizeof
  use halfspace_c, only: HS_OK, &
    {used}
  implicit none
  private
  public :: {names}
"""


def name_of(struct_name):
    """Of hs_law_def: law."""
    return struct_name.removeprefix("hs_").removesuffix("_def")


def write(api):
    structs = [meanings.find(api, name) for name in definitions.PROPERTIES]
    names = [name_of(struct["name"]) for struct in structs]
    used = ", &\n    ".join(f"hs_{name}_def_init, halfspace_{name} => hs_{name}_def" for name in names)
    lines = HEAD.format(generated=api["generated"], used=used,
                        names=", ".join(f"halfspace_{name}" for name in names)).splitlines()
    for name, struct in zip(names, structs):
        lines += ["", *above("  ", definitions.comment_of(struct)), f"  interface halfspace_{name}",
                  f"    module procedure {name}", "  end interface"]
    lines += ["", "contains"]
    for name, struct in zip(names, structs):
        lines += ["", *constructor(name, struct)]
    return "\n".join([*lines, "", "end module halfspace_properties", ""])


def constructor(name, struct):
    fields = definitions.settings(struct)
    lines = broken(f"  function {name}({', '.join(field['name'] for field in fields)})", LONGEST_LINE)
    given = []
    for field in fields:
        words = definitions.of_flag(struct, field, ".true.", ".false.")
        dummy = f"    {type_of(struct, field)}, intent(in), optional :: {field['name']}"
        lines += with_comment(dummy, words, LONGEST_LINE)
        given.append(f"    if (present({field['name']})) {name}%{field['name']} = {value_of(struct, field)}")
    return [*lines, f"    type(halfspace_{name}) :: {name}",
            "    ! If its initialisation fails it keeps size 0, and is refused on use.",
            f"    if (hs_{name}_def_init({name}, c_sizeof({name})) /= HS_OK) return", *given, f"  end function {name}"]


def type_of(struct, field):
    if meanings.of(struct, field) == meanings.FLAG:
        return "logical"
    return "real(c_double)" if field["of"] == "double" else "integer(c_int32_t)"


def value_of(struct, field):
    is_flag = meanings.of(struct, field) == meanings.FLAG
    return f"merge(1_c_int32_t, 0_c_int32_t, {field['name']})" if is_flag else field["name"]
