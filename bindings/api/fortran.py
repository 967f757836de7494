"""Raw Fortran: the module halfspace_c over iso_c_binding."""
import textwrap

from prose import wrapped

KINDS = {"int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
         "uint64_t": "integer(c_int64_t)", "size_t": "integer(c_size_t)", "double": "real(c_double)"}
LONGEST_LINE = 132

HEAD = '''\
! Generated {generated}.

!> The C interface of libhalfspace {version} as it is: names, order and units are those of the C headers, indices
!! start at 0, and nothing is checked. The module halfspace is the one to use.
!!
!! Fortran has no unsigned integers: ids and sizes of structs are signed here, with the same bits. Structs and
!! numbers that may be NULL, and arrays whose length is not fixed, are passed as c_loc() or c_null_ptr.
module halfspace_c
  use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int32_t, c_int64_t, c_null_funptr, &
    c_null_ptr, c_ptr, c_size_t
  implicit none
  public
'''


def write(api):
    writer = Writer(api)
    lines = HEAD.format_map(api).splitlines()
    for parts in (writer.constants, writer.structs, writer.callbacks, writer.functions):
        lines += ["", *parts()]
    return "\n".join([*lines, "", "end module halfspace_c", ""])


class Writer:
    def __init__(self, api):
        self.api = api
        self.basic = {alias["name"]: alias["type"] for alias in api["aliases"]}

    def declared_as(self, of):
        """A number or struct by its Fortran type."""
        return KINDS.get(self.basic.get(of, of)) or f"type({of})"

    def constants(self):
        lines = ["  !> Status codes."]
        for code in self.api["status_codes"]:
            lines += with_comment(constant(code), code["text"])
        for group in self.api["constants"]:
            lines += ["", *above("  ", group["comment"])]
            for each in group["constants"]:
                lines += with_comment(constant(each), each["comment"])
        return lines

    def structs(self):
        lines = []
        for struct in self.api["structs"]:
            lines += [*above("  ", struct["comment"]), f"  type, bind(c) :: {struct['name']}"]
            for field in struct["fields"]:
                lines += with_comment("    " + self.field(field), field["comment"])
            lines += [f"  end type {struct['name']}", ""]
        return lines[:-1]

    def field(self, field):
        # The first index of C is the last of Fortran.
        dimensions = ", ".join(map(str, reversed(field["dimensions"])))
        name = f"{field['name']}({dimensions})" if dimensions else field["name"]
        if field["kind"] == "callback":
            return f"type(c_funptr) :: {name} = c_null_funptr"
        if field["kind"] != "value":
            return f"type(c_ptr) :: {name} = c_null_ptr"
        declared = self.declared_as(field["of"])
        if declared.startswith("type"):  # has its own defaults
            return f"{declared} :: {name}"
        zero = "0.0_c_double" if declared.startswith("real") else "0"
        return f"{declared} :: {name} = {zero}"

    def callbacks(self):
        lines = ["  abstract interface"]
        for callback in self.api["callbacks"]:
            lines += ["", *self.procedure(callback)]
        return [*lines, "", "  end interface"]

    def functions(self):
        lines = ["  interface"]
        for function in self.api["functions"]:
            lines += ["", *self.procedure(function)]
        return [*lines, "", "  end interface"]

    def procedure(self, procedure):
        name, result = procedure["name"], procedure["result"]
        word = "subroutine" if result["kind"] == "nothing" else "function"
        lines = above("    ", procedure["comment"])
        if result.get("comment"):
            lines += wrapped("Returns " + result["comment"], "    !! ")
        dummies = ", ".join(parameter["name"] for parameter in procedure["parameters"])
        lines += broken(f"    {word} {name}({dummies}) bind(c)")
        lines.append("      import")
        for parameter in procedure["parameters"]:
            lines += with_comment("      " + self.dummy(parameter), parameter.get("comment", ""))
        if word == "function":
            lines.append(f"      {self.result(result)} :: {name}")
        return [*lines, f"    end {word} {name}"]

    def result(self, result):
        return self.declared_as(result["of"]) if result["kind"] == "value" else "type(c_ptr)"

    def dummy(self, parameter):
        kind, name = parameter["kind"], parameter["name"]
        if kind == "value":
            return f"{self.declared_as(parameter['of'])}, value :: {name}"
        if kind == "new_handle":
            return f"type(c_ptr), intent(out) :: {name}"
        has_fixed_size = kind == "pointer" or "length" in parameter
        if not has_fixed_size or parameter["optional"]:
            return f"type(c_ptr), value :: {name}"
        intent = parameter["direction"].replace("_", "")
        length = f"({parameter['length']})" if "length" in parameter else ""
        return f"{self.declared_as(parameter['of'])}, intent({intent}) :: {name}{length}"


def constant(each):
    return f"  integer(c_int32_t), parameter :: {each['name']} = {each['value']}"


def above(indent, comment):
    return wrapped(comment, indent + "!> ", indent + "!! ")


def with_comment(code, comment, longest_line=LONGEST_LINE):
    """Behind the code if there is room, else above it."""
    behind = f"{code}  !< {comment}"
    if not comment:
        return [code]
    if len(behind) <= longest_line:
        return [behind]
    indent = code[:len(code) - len(code.lstrip())]
    return [*above(indent, comment), code]


def broken(statement, longest_line=LONGEST_LINE):
    """A statement in as many lines as it takes."""
    lines = textwrap.wrap(statement, longest_line - 2, subsequent_indent=8 * " ")
    return [*(line + " &" for line in lines[:-1]), lines[-1]]
