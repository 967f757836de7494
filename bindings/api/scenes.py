"""Scenes: the words of kinds in their files, and the tables of their pages that tell kinds and the keys of laws."""
import pathlib
import re

import definitions
import law_numbers
import meanings
from header import Fault

HEAD = """\
// Generated {generated}.
// clang-format off
#pragma once

#include <array>
#include <string_view>

#include "halfspace/halfspace.h"

namespace halfspace::cli {{
"""
# Names of an array: the constants in whose order it has their words, what joins the parts of a word, and its comment.
WORDS = {
    "law_names": ("HS_STIFFNESS_", " ", "The names of laws in scene files, in the order of the HS_STIFFNESS_ values."),
    "action_names": ("HS_ACTION_", "_", "The names of actions in scene files, in the order of the HS_ACTION_ values."),
}
LOADED = "on a rigid or affine block"
TABLE = re.compile(r"(<!-- (.+) by bindings/api/generate -->\n\n)(?:\|.*\n)*")
CONSTANT = re.compile(r"(HS_STIFFNESS_|HS_ACTION_)(\w+)")
UNIT = re.compile(r"(?:N|Pa|rad|m)\b")


def word(name):
    joint = next(joint for group, joint, _ in WORDS.values() if name.startswith(group))
    return CONSTANT.match(name)[2].lower().replace("_", joint)


def write_kinds(api):
    lines = HEAD.format_map(api).splitlines()
    for name, (group, _, comment) in WORDS.items():
        constants = meanings.constants(api, group)
        if [each["value"] for each in constants] != list(range(len(constants))):
            raise Fault(f"the values of {group} are not 0, 1, 2 and so on, which {name} needs")
        words = [f'"{word(each["name"])}"' for each in constants]
        lines += ["", f"/// {comment}",
                  f"inline constexpr std::array<std::string_view, {len(words)}> {name} = {{", f"    {', '.join(words)}}};"]
    loads = [f"action_kind == {each['name']}" for each in meanings.constants(api, "HS_ACTION_")
             if LOADED in each["comment"]]
    lines += ["", "inline bool is_load(int action_kind) {", f"  return {' || '.join(loads)};", "}"]
    return "\n".join([*lines, "", "}  // namespace halfspace::cli", ""])


def page(path, *names):
    """A writer of the tables of a page, each below its mark; all else in it is by hand."""
    def write(api):
        text = (pathlib.Path(__file__).parents[2] / path).read_text(encoding="utf-8")
        if [found[2] for found in TABLE.finditer(text)] != list(names):
            raise Fault(f"{path} has not the marks of its tables: {', '.join(names)}")
        return TABLE.sub(lambda table: table[1] + "".join(f"{row}\n" for row in TABLES[table[2]](api)), text)

    return write


def row(*cells):
    return "|" + "|".join(f" {cell} " if cell else " " for cell in cells) + "|"


def table(*columns):
    return [row(*columns), "|" + "---|" * len(columns)]


def of_scenes(comment):
    """A comment of C in the words of scenes: actions are on blocks, and a key that does not belong to a law is a fault."""
    text = re.sub(r"; 2D uses z| or (?:of|on) nodes", "", comment).replace("are ignored", "do not belong to it")
    text = CONSTANT.sub(lambda name: f'`"{word(name[0])}"`', text)
    text = re.sub(r"(?<![`\"\w])[a-z]+(?:_[a-z]+)+\b", lambda name: f"`{name[0]}`", text)
    return re.sub(r"\bs2\b", "s²", text)


def kinds_of_action(api):
    return kinds(api, "HS_ACTION_", "kind", "unit and block")


def kinds_of_stiffness(api):
    return kinds(api, "HS_STIFFNESS_", "stiffness", "unit and meaning")


def kinds(api, group, *columns):
    """The word of each constant, and what it is."""
    return table(*columns) + [row(of_scenes(each["name"]), of_scenes(each["comment"]))
                              for each in meanings.constants(api, group)]


def keys_of_laws(api):
    return table("key", "meaning", "unit", "range", "default") + [
        row("`stiffness`", "the kind, see below", "", "words", "required"),
        *(key_of_law(field) for field in definitions.numbers(meanings.find(api, "hs_law_def")))]


def key_of_law(field):
    """The row of a number. Its comment has the unit or what it is, the range, and then clauses: its default, the laws
    that it belongs to, and what else there is to say. A number above 0 has no default in scenes."""
    comment = field["comment"]
    limits = definitions.RANGE.search(comment)
    first, clauses = comment[:limits.start()].rstrip(", "), comment[limits.end():].strip("; ").split("; ")
    unit = first if UNIT.match(first) else ""
    meaning = field["name"].replace("_", " ") if unit else first
    belonging, default = "", "required"
    for clause in map(of_scenes, clauses):
        if clause.startswith("default "):
            default = clause.removeprefix("default ") if definitions.range_of(field).with_low else default
        elif definitions.belongs(field) and re.match("(?:only|not|ignored) with ", clause):
            belonging = "; " + re.sub("^ignored", "not", re.sub(r"\bcohesion\b", "`cohesion`", clause))
        else:
            meaning += f" {clause}" if clause.startswith("of ") else f": {clause}"
    unit = of_scenes(unit).replace("`stiffness_kind`", "`stiffness`").replace("rad", "degrees")
    return row(f"`{field['name']}`", meaning + belonging, unit, range_of(field), default)


def range_of(field):
    low, with_low, high, with_high = definitions.range_of(field)
    if high is None:
        return f"{'at least' if with_low else 'above'} {low}"
    high = law_numbers.IN_DEGREES.get(high, high)
    return ("" if with_low else "above ") + f"{low} to " + ("" if with_high else "below ") + high


TABLES = {"Keys": keys_of_laws, "Kinds of stiffness": kinds_of_stiffness, "Kinds of action": kinds_of_action}
