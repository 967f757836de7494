"""What the comment of a setting says of its values, in the words of all headers: its range (`> 0`, `>= 0`, `[0, 1]`),
its default (`default 0`), and the kinds of stiffness that it belongs to (`only with`, `not with`, `ignored with`)."""
import re
from collections import namedtuple

import meanings
from header import Fault

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
RANGE = re.compile(rf"(>=?) ({NUMBER})|([\[(])({NUMBER}), (\S+?)([\])])")
DEFAULT = re.compile(rf"\bdefault ({NUMBER}|HS_\w+)")
WITH = re.compile(r"\b(only|not|ignored) with (HS_\w+(?:(?:, | and | or )HS_\w+)*)(?:, without (\w+(?: and \w+)*))?")

# Without a limit, `high` is None.
Range = namedtuple("Range", "low with_low high with_high")


class Belongs:
    """The laws that a number belongs to: those of some kinds of stiffness, or of all others, in which other numbers are
    0. A law of another kind refuses or ignores it."""

    def __init__(self, word, kinds, zeros):
        self.is_refused, self.is_only, self.kinds, self.zeros = word != "ignored", word == "only", kinds, zeros

    def condition(self, law, both="&&", either="||"):
        same, joint = ("==", either) if self.is_only else ("!=", both)
        kinds = f" {joint} ".join(f"{law}.stiffness_kind {same} {name}" for name in self.kinds)
        if self.zeros and self.is_only and len(self.kinds) > 1:
            kinds = f"({kinds})"
        return f" {both} ".join([kinds, *(f"{law}.{name} == 0" for name in self.zeros)])

    @property
    def words(self):
        """The value of the number in other laws."""
        if not self.is_only:
            return f"0 with {' and '.join(self.kinds)}"
        zeros = f" and {' and '.join(self.zeros)} are 0" if self.zeros else ""
        return f"0 unless stiffness_kind is {' or '.join(self.kinds)}{zeros}"


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


def belongs(field):
    """The laws that a number belongs to; None if it belongs to all."""
    found = WITH.search(field["comment"])
    if not found:
        return None
    return Belongs(found[1], re.findall(r"HS_STIFFNESS_\w+", found[2]), re.findall(r"(?!and\b)\b\w+", found[3] or ""))


def of_flag(struct, field, yes, no):
    """The comment of a field, with the values that a flag has in a language."""
    if meanings.of(struct, field) != meanings.FLAG:
        return field["comment"]
    words = re.sub(r"\b(1|0): ", lambda value: (yes if value[1] == "1" else no) + ": ", field["comment"])
    return re.sub(r"\bdefault ([01])", lambda value: "default " + (yes if value[1] == "1" else no), words)
