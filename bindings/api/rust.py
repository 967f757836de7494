"""Raw Rust: constants, structs and extern "C" functions of the crate halfspace-sys."""
import re

from prose import grouped, wrapped

TYPES = {"int32_t": "i32", "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64", "size_t": "usize",
         "double": "f64", "void": "c_void", "char": "c_char"}
KEYWORDS = {"as", "box", "const", "crate", "dyn", "else", "enum", "extern", "fn", "for", "impl", "in", "let", "loop",
            "match", "mod", "move", "mut", "priv", "pub", "ref", "return", "static", "struct", "trait", "type",
            "unsafe", "use", "where", "yield"}

LONGEST_LINE = 100
LINK = re.compile(r"(\[`[^`]*`\]\([\w:]+\))")

HEAD = '''\
// Generated {generated}.

//! The C interface of libhalfspace {version} as it is. Names, conventions and what is to be observed are those of
//! the C headers; the crate `halfspace` is the safe one.
#![allow(non_camel_case_types)]

use std::marker::{{PhantomData, PhantomPinned}};
use std::os::raw::{{c_char, c_void}};
'''


def write(api):
    lines = HEAD.format_map(api).splitlines()
    for parts in (aliases, constants, handles, callbacks, structs, functions):
        lines += ["", *parts(api)]
    return "\n".join(lines) + "\n"


def aliases(api):
    lines = []
    for alias in api["aliases"]:
        lines += [*documented(alias["comment"]), f"pub type {alias['name']} = {TYPES[alias['type']]};"]
    return lines


def constants(api):
    lines = []
    for code in api["status_codes"]:
        lines += [*documented(code["text"]), f"pub const {code['name']}: hs_status = {code['value']};"]
    for group in api["constants"]:
        lines += ["", *wrapped(group["comment"], "// ")]
        for each in group["constants"]:
            lines += [*documented(each["comment"]), f"pub const {each['name']}: i32 = {each['value']};"]
    return lines


def handles(api):
    lines = []
    for handle in api["handles"]:
        lines += [*documented(handle["comment"]), "#[repr(C)]", f"pub struct {handle['name']} {{",
                  "    _opaque: [u8; 0],",
                  "    // Belongs to one thread at a time, and stays where the library made it.",
                  "    _marker: PhantomData<(*mut u8, PhantomPinned)>,", "}", ""]
    return lines[:-1]


def callbacks(api):
    lines = []
    for callback in api["callbacks"]:
        arguments = ", ".join(argument(parameter) for parameter in callback["parameters"])
        lines += [*documented(callback["comment"]), f"pub type {callback['name']} =",
                  f"    unsafe extern \"C\" fn({arguments}){returned(callback['result'])};"]
    return lines


def structs(api):
    lines = []
    for struct in api["structs"]:
        traits = ["Clone", "Copy", "Debug"] + ["Default"] * has_default(struct)
        lines += [*documented(struct["comment"]), "#[repr(C)]", f"#[derive({', '.join(traits)})]",
                  f"pub struct {struct['name']} {{"]
        for field in struct["fields"]:
            lines += [*documented(field["comment"], "    "), f"    pub {name(field)}: {field_type(field)},"]
        lines += ["}", f"const _: () = assert!(std::mem::size_of::<{struct['name']}>() == {struct['size']});", ""]
    return lines[:-1]


def has_default(struct):
    """Raw pointers have none."""
    return all(field["kind"] in ("value", "callback") for field in struct["fields"])


def field_type(field):
    declared = f"Option<{field['of']}>" if field["kind"] == "callback" else type_of(field)
    for count in reversed(field["dimensions"]):
        declared = f"[{declared}; {count}]"
    return declared


def functions(api):
    lines = ['extern "C" {']
    for function in api["functions"]:
        lines += [*function_comment(function, "    "), *declaration(function, "    "), ""]
    return [*lines[:-1], "}"]


def declaration(function, indent):
    """In one line if there is room, else an argument per line."""
    begin, end = f"{indent}pub fn {function['name']}(", f"){returned(function['result'])};"
    arguments = [argument(parameter) for parameter in function["parameters"]]
    line = begin + ", ".join(arguments) + end
    if len(line) <= LONGEST_LINE:
        return [line]
    return [begin, *(f"{indent}    {each}," for each in arguments), indent + end]


def function_comment(function, indent):
    paragraph = [indent + "///"]
    lines = documented(function["comment"], indent)
    if function["parameters"]:
        lines += paragraph
    for comment, names in grouped(function["parameters"]):
        item = f"- {', '.join(f'`{each}`' for each in names)}: {comment}"
        lines += map(unquoted, wrapped(escaped(item), indent + "/// ", indent + "///   "))
    if function["result"]["comment"]:
        lines += paragraph + documented("Returns " + function["result"]["comment"], indent)
    return lines


def argument(parameter):
    return f"{name(parameter)}: {type_of(parameter)}"


def returned(result):
    return "" if result["kind"] == "nothing" else f" -> {type_of(result)}"


def type_of(described):
    """The Rust type of a field, parameter or result, but for the dimensions of a field."""
    declared = TYPES.get(described["of"], described["of"])
    if described["kind"] == "value":
        return declared
    if described["kind"] == "new_handle":
        return f"*mut *mut {declared}"
    pointer = "*const" if described["const"] else "*mut"
    if described["kind"] == "handles":
        return f"*const {pointer} {declared}"
    if "length" in described:
        return f"{pointer} [{declared}; {described['length']}]"
    return f"{pointer} {declared}"


def name(described):
    return "r#" * (described["name"] in KEYWORDS) + described["name"]


def documented(comment, indent=""):
    return [unquoted(line) for line in wrapped(escaped(comment), indent + "/// ")]


def escaped(comment):
    """Brackets are intervals and indices, but for links to code."""
    parts = LINK.split(comment)
    parts[::2] = [part.replace("[", r"\[").replace("]", r"\]") for part in parts[::2]]
    return "".join(parts)


def unquoted(line):
    """A > that begins a line is a comparison, not a quotation."""
    return re.sub(r"(/// +)>", r"\1\\>", line, count=1)
