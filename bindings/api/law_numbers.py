"""C++: the numbers of a contact law, as the C interface checks them."""
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
TERMS = {"pi/2": "std::numbers::pi / 2"}


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
