"""Python: a class of records for each struct that a host reads, with all of its fields in the docstring."""
import meanings
from prose import wrapped

HEAD = '''\
# Generated {generated}.
"""The library's reports and states, field by field as in the headers of C: for each a class of records, which print
their names and values, and its NumPy data type. Nine numbers in a row are a tensor of shape (3, 3). An
array of records has its fields as attributes, and `columns()`: all numbers by name, as pandas takes them."""
from . import _raw, constants
from ._record import Floats, Record, record_type
'''
METHODS_OF_NUMPY = ("mean",)  # that a field replaces
NOT_READ = ("_def", "_options", "_packed", "_view")  # a host fills these


def write(api):
    lines = HEAD.format_map(api).splitlines()
    for struct in api["structs"]:
        if not struct["name"].endswith(NOT_READ):
            lines += ["", "", *record(struct)]
    return "\n".join(lines) + "\n"


def record(struct):
    name = struct["name"].removeprefix("hs_")
    class_name = meanings.camel(name)
    lines = [f"class {class_name}(Record):", *wrapped(struct["comment"], '    """', "    "), "",
             "    Attributes", "    ----------"]
    for field in meanings.read_fields(struct):
        lines += [f"    {field['name']} : {type_of(struct, field)}", *wrapped(field["comment"], "        ")]
    lines += ['    """', "", *(annotated(struct, field) for field in meanings.read_fields(struct)), ""]
    kinds = [f'"{field["name"]}": constants.{kind_of(struct, field)}'
             for field in struct["fields"] if kind_of(struct, field)]
    if kinds:
        lines += [f"    _kinds = {{{', '.join(kinds)}}}", ""]
    return [*lines, "", f"{name.upper()} = record_type({class_name}, _raw.{struct['name']})"]


def kind_of(struct, field):
    """The enumeration that a field's values are of, or None."""
    return meanings.ENUMERATIONS.get(meanings.of(struct, field), (None, None))[1]


def annotated(struct, field):
    """The field with its type, for editors and type checkers."""
    ignored = "  # type: ignore[assignment]" if field["name"] in METHODS_OF_NUMPY else ""
    return f"    {field['name']}: {annotation_of(struct, field)}{ignored}"


def annotation_of(struct, field):
    if field["dimensions"]:
        return "Floats"  # no array of integers is in a record
    if kind_of(struct, field):
        return f"constants.{kind_of(struct, field)}"
    return "float" if field["of"] == "double" else class_of(field) or "int"


def class_of(field):
    """The class of a field that is a struct, or None."""
    is_struct = field["of"].startswith("hs_") and not field["of"] in ("hs_block", "hs_body")
    return meanings.camel(field["of"].removeprefix("hs_")) if is_struct else None


def type_of(struct, field):
    """In words."""
    if field["dimensions"]:
        shape = (3, 3) if field["dimensions"] == [9] else tuple(field["dimensions"])
        return f"array, shape {shape}"
    if field["of"] == "double":
        return "float"
    return kind_of(struct, field) or class_of(field) or "int"
