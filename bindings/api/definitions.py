"""What the comment of a setting says of its values, in the words of all headers: its range (`> 0`, `>= 0`, `[0, 1]`),
its default (`default 0`), and the kinds of stiffness that it belongs to (`only with`, `not with`, `ignored with`)."""
import math
import re
from collections import namedtuple

import meanings
from header import Fault

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
RANGE = re.compile(rf"(>=?) ({NUMBER})|([\[(])({NUMBER}), (\S+?)([\])])")
DEFAULT = re.compile(rf"\bdefault ({NUMBER}|HS_\w+)")
WITH = re.compile(r"\b(only|not|ignored) with (HS_STIFFNESS_\w+(?:(?:, | and | or )HS_STIFFNESS_\w+)*)")
ENDS = {"pi/2": math.pi / 2}

# Without a limit, `high` is None.
Range = namedtuple("Range", "low with_low high with_high")

# Structs of numbers, constants and flags alone, but for what functions fill in: the properties of materials and joints.
PROPERTIES = ["hs_law_def", "hs_elasticity_def", "hs_bond_def", "hs_bolt_def"]


def settings(struct):
    """The numbers of a definition, then its constants and flags: the order of positional arguments."""
    fields = [field for field in meanings.read_fields(struct)
              if not field["dimensions"] and field["of"] in ("double", "int32_t")]
    return sorted(fields, key=lambda field: field["of"] != "double")


def numbers(struct):
    return [field for field in settings(struct) if field["of"] == "double"]


def comment_of(struct):
    """Without the call that constructors make."""
    return re.sub(r" Fill it with hs_\w+_init\(\)\.", "", struct["comment"])


def default_of(field):
    found = DEFAULT.search(field["comment"])
    if not found:
        raise Fault(f"the comment of {field['name']} has no default")
    return found[1]


def range_of(field):
    found = RANGE.search(field["comment"])
    if not found:
        raise Fault(f"the comment of {field['name']} has no range")
    if found[1]:
        return Range(found[2], found[1] == ">=", None, True)
    return Range(found[4], found[3] == "[", found[5], found[6] == "]")


def kinds_without(api, field):
    """Word and kinds of stiffness that a number does not belong to, by its comment: they refuse or ignore it."""
    found = WITH.search(field["comment"])
    if not found:
        return "", []
    named = re.findall(r"HS_STIFFNESS_\w+", found[2])
    kinds = next(group["constants"] for group in api["constants"] if group["group"] == "HS_STIFFNESS_")
    names = [kind["name"] for kind in kinds]
    return found[1], [name for name in names if (name in named) != (found[1] == "only")]


def of_flag(struct, field, yes, no):
    """The comment of a field, with the values that a flag has in a language."""
    if meanings.of(struct, field) != meanings.FLAG:
        return field["comment"]
    words = re.sub(r"\b(1|0): ", lambda value: (yes if value[1] == "1" else no) + ": ", field["comment"])
    return re.sub(r"\bdefault ([01])", lambda value: "default " + (yes if value[1] == "1" else no), words)
