"""Fortran: a method that forwards to a function of C: its arguments, how C gets each, and what it does with results."""
import itertools
import re

import fortran_records
from fortran import Writer, above, broken, with_comment
from fortran_definitions import LONGEST_LINE
from fortran_words import Words

ARGUMENT = re.compile(r"(\w+)(?:=(\w+))?(\[\]|\([^)]*\))?(\?\d*)?(?:, |$)")
IDS = {"hs_block": "id_of", "hs_body": "id_of_body"}
VIEWS = {"hs_view": ("view", "in"), "hs_mutable_view": ("mutable_view", "inout")}
STATUS = [("stat", "integer, intent(out), optional", ""), ("errmsg", "character(*), intent(inout), optional", "")]


def refuse_unless(check):
    return f"if (.not. {check}, stat, errmsg)) return"


def only_if(condition, lines):
    if len(lines) == 1:
        return [f"if ({condition}) {lines[0]}"]
    return [f"if ({condition}) then", *(f"  {line}" for line in lines), "end if"]


class Argument:
    """As the method has it, and the parameter of C that gets it."""

    def __init__(self, parameters, name, c_name, shape, mark):
        self.name, self.shape, self.c_name = name, shape, c_name or name
        self.is_optional, self.absent = bool(mark), mark[1:] or "0"
        parameter = parameters[self.c_name]
        self.of, self.kind, self.comment = (parameter[key] for key in ("of", "kind", "comment"))
        self.length, self.may_be_null = parameter.get("length"), parameter.get("optional")
        self.is_result = parameter.get("direction") == "out" or self.of == "hs_mutable_view"
        self.is_index = bool(re.match(r"(?:receives (?:its|the) )?ind(?:ex|ices)\b", self.comment))
        self.if_present = f"if (present({name})) " if mark else ""


class Method:
    """What it declares, does before the call, passes to C, and does after a success."""

    def __init__(self, api, names, name, c_name, arguments):
        self.raw, self.words, self.name, self.counted = Writer(api), Words(names), name, fortran_records.counted(api)
        in_c = [prefix + (c_name or name) for prefix in ("hs_world_get_", "hs_world_")]
        self.function = next(function for function in api["functions"] if function["name"] in in_c)
        self.dummies, self.locals, self.before, self.after, self.structs = [], [], [], [], set()
        self.values, self.list = {"world": "self%c_handle()"}, None
        parameters = {parameter["name"]: parameter for parameter in self.function["parameters"]}
        given = [Argument(parameters, *found) for found in ARGUMENT.findall(arguments)]
        views = [argument.name for argument in given if argument.of in VIEWS]
        for argument in given:
            self.add(argument)
            if argument.name in views[-1:]:
                words = f"layout of {'both' if views[1:] else argument.name}"
                self.dummies.append(("rows", "logical, intent(in), optional", words))

    def add(self, argument):
        if argument.of in VIEWS:
            self.add_points(argument)
        elif argument.kind == "value":
            (self.add_id if argument.of in IDS else self.add_number)(argument)
        elif argument.kind == "array":
            is_filled = argument.is_result and not argument.shape.startswith("(")
            (self.add_filled if is_filled else self.add_fixed if argument.length else self.add_array)(argument)
        elif argument.is_result and argument.of in (*IDS, "int32_t", "int64_t"):
            self.add_found(argument)
        else:
            self.add_struct(argument)

    def declare(self, argument, declared, extent=""):
        absent = argument.absent if argument.is_optional and not argument.is_result else None
        words = self.words.of_argument(argument.comment, absent)
        if argument.name == "count" and any("inout" in dummy[1] for dummy in self.dummies):
            words += ", also when they do not fit"
        self.dummies.append((argument.name + extent, declared + ", optional" * argument.is_optional, words))

    def give(self, argument, checks, value, declared, absent=None):
        """Passes the value of the argument to C or, where it may be absent, a variable."""
        if argument.is_optional:
            given = f"given_{argument.name}"
            self.locals.append(declared.format(given))
            self.before += [f"{given} = {absent}"] if absent is not None else []
            checks, value = only_if(f"present({argument.name})", [*checks, f"{given} = {value}"]), given
        self.before += checks
        self.values[argument.c_name] = f"c_loc({value})" if ", target" in declared else value

    def type_of(self, of):
        """The struct by its name in Fortran, or the number."""
        if of in IDS:
            return f"type({of.replace('hs_', 'halfspace_')})"
        if not of.startswith("hs_"):
            return self.raw.declared_as(of)
        self.structs.add(of)
        return f"type({fortran_records.name_of(of)})"

    def add_id(self, argument):
        self.declare(argument, f"{self.type_of(argument.of)}, intent(in)")
        self.values[argument.c_name] = f"{IDS[argument.of]}({argument.name})"
        if argument.is_optional:
            self.locals.append("integer(c_int64_t) :: id")
            self.before.append(refuse_unless(f"names_block({argument.name}, id"))
            self.values[argument.c_name] = "id"

    def add_number(self, argument):
        number = self.raw.declared_as(argument.of)
        value, declared, absent = argument.name, number, argument.absent
        if argument.is_index:
            value, absent = f"{value} - 1", int(absent) - 1
        elif argument.comment.startswith("1: "):
            value, declared = f"merge(1_c_int32_t, 0_c_int32_t, {value})", "logical"
        elif value == "steps":
            declared = "integer"  # as hosts count them
        self.declare(argument, f"{declared}, intent(in)")
        self.give(argument, [], value, f"{number} :: {{}}", absent)

    def add_points(self, argument):
        view, intent = VIEWS[argument.of]
        self.declare(argument, f"real(c_double), intent({intent}), target", "(:,:)")
        checks = [refuse_unless(f"are_points({argument.name}, '{argument.name}', rows")]
        self.give(argument, checks, f"{view}({argument.name}, rows)", f"type({argument.of}) :: {{}}")

    def add_fixed(self, argument):
        """A vector or a tensor, in the plane with fewer components, or an array as in C."""
        name, extent, length = argument.name, argument.shape, argument.shape or f"({argument.length})"
        checks, value, target = [], name, ", target" if argument.may_be_null else ""
        if not extent and argument.length == 3:
            in_plane = 1 if "2D uses z" in argument.comment else 2
            checks, extent, value = [refuse_unless(f"is_vector({name}, '{name}', {in_plane}")], "(:)", f"three_of({name})"
        elif not extent:
            checks, extent, value = [refuse_unless(f"is_tensor({name}, '{name}'")], "(:,:)", f"nine_of({name})"
        self.declare(argument, "real(c_double), intent(in)", extent)
        self.give(argument, checks, value, f"real(c_double){target} :: {{}}{length}", "0")

    def add_array(self, argument):
        name, intent = argument.name, "out" if argument.is_result else "in"
        if argument.is_index:
            self.declare(argument, "integer(c_int32_t), intent(in)", "(:)")
            self.locals.append("integer(c_int32_t), allocatable, target :: from_0(:)")
            self.before.append(refuse_unless(f"are_from_0({name}, from_0"))
            name = "from_0"
        else:
            contiguous = "" if argument.shape else ", contiguous"
            self.declare(argument, f"{self.type_of(argument.of)}, intent({intent}), target{contiguous}",
                         argument.shape or "(:)")
        self.values |= {argument.c_name: f"c_loc({name})", "count": f"size({name}, kind=c_int64_t)"}

    def add_filled(self, argument):
        declared, name = self.type_of(argument.of), argument.name
        if argument.shape:
            self.declare(argument, f"{declared}, intent(inout), allocatable, target", "(:)")
            self.list = argument
            self.values["size"] = "storage_size(all, c_size_t) / 8"
            return
        self.declare(argument, f"{declared}, intent(inout), target, contiguous", "(:)")
        size = f"size({name}, kind=c_int64_t)"
        self.values |= {argument.c_name: f"c_loc({name})", "capacity": size, "count": "c_null_ptr"}
        if argument.of in self.counted:
            self.locals.append("integer(c_int64_t), target :: found")
            self.before.append("found = 0")
            self.values["count"] = "c_loc(found)"
            self.after.append(f"call count_from_1({name}(:min(found, {size})))")

    def add_found(self, argument):
        """One id, index or count."""
        name, value, target = argument.name, argument.if_present + argument.name, ", target" * argument.may_be_null
        if argument.of in IDS:
            self.declare(argument, f"{self.type_of(argument.of)}, intent(out)")
            self.locals.append("integer(c_int64_t) :: id")
            self.after.append(f"{value} = transfer(id, {name})")
            self.values[argument.c_name] = "id"
            return
        self.before.append(f"{value} = 0")
        if argument.is_index:
            self.declare(argument, "integer(c_int32_t), intent(out)")
            self.locals.append(f"integer(c_int32_t){target} :: from_0")
            self.after.append(f"{value} = from_0 + 1")
            self.values[argument.c_name] = "c_loc(from_0)" if target else "from_0"
        elif argument.c_name in self.values:  # the array before it asks for its count
            self.declare(argument, "integer(c_int64_t), intent(out)")
            self.after.append(f"{value} = found")
        else:
            self.declare(argument, "integer(c_int64_t), intent(out), target")
            self.values[argument.c_name] = f"address_of({name})"

    def add_struct(self, argument):
        name = passed = argument.name
        self.declare(argument, f"{self.type_of(argument.of)}, intent({'out' if argument.is_result else 'in'})")
        if argument.is_result and argument.of in fortran_records.RECORDS:
            passed = "found"
            self.locals.append(f"type({argument.of}) :: found")
            self.after.append(f"{name} = transfer(found, {name})")
        if argument.is_result and argument.of in self.counted:
            self.after.append(f"call count_from_1({name})")
        self.values |= {argument.c_name: passed, "size": f"c_sizeof({passed})"}

    def call(self, **others):
        values = self.values | others
        return f"{self.function['name']}({', '.join(values[each['name']] for each in self.function['parameters'])})"

    def text(self):
        world = self.function["parameters"][0]
        dummies = [("self", f"class(forwarding_world), intent({'in' if world['const'] else 'inout'})", ""),
                   *self.dummies, *STATUS]
        names = ", ".join(name.partition("(")[0] for name, _, _ in dummies)
        lines = above("  ", self.words.of_method(self.function))
        lines += broken(f"  subroutine {self.name}({names})", LONGEST_LINE)
        for (declared, words), group in itertools.groupby(dummies, lambda dummy: dummy[1:]):
            lines += with_comment(f"    {declared} :: {', '.join(name for name, _, _ in group)}", words, LONGEST_LINE)
        for line in self.filling() if self.list else self.forwarding():
            lines += broken("    " + line, LONGEST_LINE)
        return [*lines, f"  end subroutine {self.name}"]

    def forwarding(self):
        if not self.after:
            return [*self.locals, *self.before, f"call conclude({self.call()}, self%c_context(), stat, errmsg)"]
        return [*self.locals, "integer(c_int32_t) :: status", *self.before, f"status = {self.call()}",
                *only_if("status >= HS_OK", self.after), "call conclude(status, self%c_context(), stat, errmsg)"]

    def filling(self):
        """An array that fits: C says how many entries there are, and fills it."""
        name, declared = self.list.name, self.type_of(self.list.of)
        count = self.call(**{self.list.c_name: "c_null_ptr", "capacity": "0_c_int64_t", "count": "c_loc(count)"})
        fill = self.call(**{self.list.c_name: "c_loc(all)", "capacity": "count", "count": "c_null_ptr"})
        done = ["call count_from_1(all)"] * (self.list.of in self.counted) + [f"call move_alloc(all, {name})"]
        return [f"{declared}, allocatable, target :: all(:)", *self.locals,
                "integer(c_int64_t), target :: count", "integer(c_int32_t) :: status", "integer :: failure",
                *self.before, f"status = {count}", "if (status >= HS_OK) then",
                "  allocate (all(count), stat=failure)", "  if (.not. had_memory(failure, stat, errmsg)) return",
                f"  status = {fill}", *(f"  {line}" for line in only_if("status >= HS_OK", done)), "end if",
                "call conclude(status, self%c_context(), stat, errmsg)"]
