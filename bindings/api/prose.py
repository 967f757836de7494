"""Text as the generated files have it: wrapped comments, grouped parameters, JSON that is read line by line."""
import json
import textwrap

WIDTH = 110


def wrapped(text, prefix, continued=None):
    """A comment in lines that begin with `prefix`, those after the first with `continued` if given; an empty line
    between paragraphs."""
    continued = continued or prefix
    lines = []
    for paragraph in text.splitlines():
        if lines:
            lines.append(continued.rstrip())
        lines += textwrap.wrap(paragraph, WIDTH, initial_indent=continued if lines else prefix,
                               subsequent_indent=continued, break_long_words=False, break_on_hyphens=False)
    return lines


def grouped(parameters):
    """Pairs of a comment and the names of the parameters that share it."""
    names = {}
    for parameter in parameters:
        names.setdefault(parameter["comment"], []).append(parameter["name"])
    return names.items()


def json_text(value):
    return _json_lines(value, "") + "\n"


def _json_lines(value, indent):
    """Innermost objects stand in one line each, so that a difference shows what it is in."""
    inner = indent + "  "
    if isinstance(value, dict) and any(map(_holds_objects, value.values())):
        members = [f"{inner}{json.dumps(key)}: {_json_lines(member, inner)}" for key, member in value.items()]
        return "{\n" + ",\n".join(members) + f"\n{indent}}}"
    if isinstance(value, list) and _holds_objects(value):
        return "[\n" + ",\n".join(inner + _json_lines(member, inner) for member in value) + f"\n{indent}]"
    return json.dumps(value, ensure_ascii=False)


def _holds_objects(value):
    return isinstance(value, dict) or isinstance(value, list) and any(isinstance(member, dict) for member in value)
