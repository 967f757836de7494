"""C++: the numbers of a contact law, as the C interface checks them and as scenes have them."""
import definitions
import meanings

CAPI_HEAD = """\
// Generated {generated}.
// clang-format off
#pragma once

#include <numbers>

#include "force/law.h"
#include "halfspace/law.h"
#include "require.h"

namespace halfspace::capi {{
"""
SCENE_HEAD = """\
// Generated {generated}.
// clang-format off
#pragma once

#include "scene/read_values.h"

namespace halfspace::cli {{
"""
TERMS = {"pi/2": "std::numbers::pi / 2"}
IN_DEGREES = {"pi/2": "90"}


def numbers(api):
    return definitions.numbers(meanings.find(api, "hs_law_def"))


def write_capi(api):
    fields = numbers(api)
    lines = [*CAPI_HEAD.format_map(api).splitlines(), "",
             "/// Refuses numbers beyond their range, and those other than 0 that the kind of stiffness does not have.",
             "inline LawNumbers read_numbers(const hs_law_def& def) {"]
    for field in fields:
        lines += checks(field)
    lines += ["  return {", *(f"      .{field['name']} = def.{field['name']}," for field in fields), "  };", "}", "",
              "inline void write_numbers(const LawNumbers& numbers, hs_law_def& def) {",
              *(f"  def.{field['name']} = numbers.{field['name']};" for field in fields), "}"]
    return "\n".join([*lines, "", "}  // namespace halfspace::capi", ""])


def checks(field):
    """The statements that refuse a value."""
    value, name = f"def.{field['name']}", f'"law.{field["name"]}"'
    low, with_low, high, with_high = definitions.range_of(field)
    if high is None:
        lines = [f"  require_{'from' if with_low else 'above'}_zero({value}, {name});"]
    else:
        above, below = ">=" if with_low else ">", "<=" if with_high else "<"
        holds = f"{value} {above} {low} && {value} {below} {TERMS.get(high, high)}"
        words = f"{'at least' if with_low else 'above'} {low} and {'at most' if with_high else 'below'} {high}"
        lines = [f"  require({holds},", f'          {value}, {name}, "{words}");']
    belongs = definitions.belongs(field)
    if belongs and belongs.is_refused:
        lines += [f"  require({value} == 0 ||", f"              ({belongs.condition('def')}),",
                  f"          {value}, {name},", f'          "{belongs.words}");']
    return lines


def write_scene(api):
    fields = numbers(api)
    lines = [*SCENE_HEAD.format_map(api).splitlines(), "",
             "/// Reads the numbers that the law's kind of stiffness has. Missing keys keep their value, but a law that",
             "/// does not inherit states those above 0.",
             "inline void read_law_numbers(Keys& keys, hs_law_def& law, bool inherits) {",
             "  const auto inherited = [&](double value) { return inherits ? std::optional(value) : required; };"]
    for field in fields:
        belongs = definitions.belongs(field)
        lines += [f"  if ({belongs.condition('law')})"] if belongs else []
        lines.append(("    " if belongs else "  ") + reading(field))
    lines += ["}", "", "/// Sets the numbers to 0 that the kind of stiffness refuses.",
              "inline void clear_refused_numbers(hs_law_def& law) {"]
    for field in fields:
        belongs = definitions.belongs(field)
        if belongs and belongs.is_refused:
            lines.append(f"  if (!({belongs.condition('law')})) law.{field['name']} = 0;")
    return "\n".join([*lines, "}", "", "}  // namespace halfspace::cli", ""])


def reading(field):
    """The statement that reads a key; angles are in degrees."""
    name, value = field["name"], f"law.{field['name']}"
    is_angle = field["comment"].startswith("rad")
    low, with_low, high, with_high = definitions.range_of(field)
    if high is None:
        limits = f"{'at_least' if with_low else 'above'}({low})"
    else:
        ends = [f".low = {low}", f".high = {IN_DEGREES[high] if is_angle else high}"]
        ends += [".with_low = false"] * (not with_low) + [".with_high = false"] * (not with_high)
        limits = f"{{{', '.join(ends)}}}"
    if is_angle:
        return f'{value} =\n      degrees(keys, "{name}", {limits}, {value} / degree);'
    fallback = value if with_low else f"inherited({value})"
    return f'{value} = keys.number("{name}", {limits}, {fallback});'
