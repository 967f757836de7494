#!/usr/bin/python3 -B
"""abi_layout.py: prints assertions on the binary layout of the C API as it is now: the baseline of a version, which
tests/abi/freeze writes once. The assertions that no baseline has yet are generated."""
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
BASELINES = HERE.parents[1] / "tests" / "abi"

BASELINE = """\
/* Sizes, offsets and values that programs compiled with version {version} of the headers rely on, on machines
 * with 64-bit pointers. Written once, when that version was frozen. Do not regenerate it, and do not mend it: where it
 * does not compile, a program that is already linked breaks. Definitions and reports may have grown since; nothing else
 * may. */
"""
ADDITIONS = """\
/* Generated {generated}.
 * As in the baselines layout_X_Y.c, of structs, fields and constants that none of them has. */
"""
GROWTH = """\
# Generated {generated}.
# Definitions and reports go with their size as the caller was compiled: fields may be appended to them, not inserted.
# This also hides fields inserted in the middle from abidiff; the layout_X_Y.c see those.
[suppress_type]
  name_regexp = ^({names})$
  has_data_member_inserted_at = end
"""
INCLUDES = """\
#include <halfspace/halfspace.h>
#include <stddef.h>

#define FIELD(type, field, offset, size) \\
  _Static_assert(offsetof(type, field) == offset && sizeof(((type *)0)->field) == size, #type "." #field)
"""


def baseline(api):
    version = ".".join(api["version"].split(".")[:2])
    return text(BASELINE.format(version=version), assertions(api))


def additions(api):
    frozen = "".join(path.read_text(encoding="utf-8") for path in BASELINES.glob("layout_[0-9]*.c"))
    known = set(map(subject, frozen.splitlines()))
    groups = [[line for line in group if subject(line) not in known] for group in assertions(api)]
    return text(ADDITIONS.format_map(api), groups)


def text(head, groups):
    return "\n".join([head + INCLUDES, *("\n".join([*group, ""]) for group in groups if group)])


def growth(api):
    """The differences that abidiff is not to see."""
    return GROWTH.format(generated=api["generated"], names="|".join(sorted(growing(api))))


def growing(api):
    """Structs that go with their size as the caller was compiled."""
    comments = " ".join(each["comment"] for function in api["functions"] for each in function["parameters"])
    return set(re.findall(r"sizeof\((\w+)\) as the caller was compiled", comments))


def assertions(api):
    """Lines in groups, by struct and by group of constants."""
    may_grow = growing(api)
    yield from (struct(each, ">=" if each["name"] in may_grow else "==") for each in api["structs"])
    yield from map(values, [api["status_codes"], *(group["constants"] for group in api["constants"])])


def struct(described, comparison):
    name = described["name"]
    return [f'_Static_assert(sizeof({name}) {comparison} {described["size"]}, "{name}");',
            *(f'FIELD({name}, {field["name"]}, {field["offset"]}, {field["size"]});' for field in described["fields"])]


def values(constants):
    return [f'_Static_assert({each["name"]} == {each["value"]}, "{each["name"]}");' for each in constants]


def subject(line):
    """The struct, field or constant that an assertion is about; None of other lines."""
    found = re.match(r"FIELD\(\w+, \w+|_Static_assert\((sizeof\(\w+\)|HS_\w+)", line)
    return found and found.group()


if __name__ == "__main__":
    print(baseline(json.loads((HERE / "halfspace_api.json").read_text(encoding="utf-8"))), end="")
