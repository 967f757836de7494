"""Safe Rust: builders of the definitions that hosts fill, with the library's defaults and a function for each measure,
and the constructors of actions, one for each kind."""
import re

import definitions
import meanings
from rust import documented
from rust_records import comment_of, plain_type

HEAD = '''\
// Generated {generated}.

//! Defaults of definitions, and the functions that change a field of them.

use halfspace_sys as sys;

use crate::action::{{Action, Table}};
use crate::affine::Elasticity;
use crate::bolt::Bolt;
use crate::bond::Bond;
use crate::call::defaults;
use crate::impact::Motion;
use crate::kinds::StiffnessKind;
use crate::law::Law;
use crate::relax::Relaxation;
use crate::strength::StrengthSearch;
use crate::water::Water;
use crate::world::WorldDef;
'''
DEFAULT = '''
impl Default for {name} {{
    fn default() -> Self {{
        Self {{
            raw: defaults(sys::{struct}_init),
        }}
    }}
}}
'''
READER = '''
    /// All settings, as fields with the names and values of the C interface.
    pub fn values(&self) -> &sys::{struct} {{
        &self.raw
    }}
'''
BUILDERS = {
    "hs_action_def": "Action",
    "hs_law_def": "Law",
    "hs_world_def": "WorldDef",
    "hs_elasticity_def": "Elasticity",
    "hs_bond_def": "Bond",
    "hs_bolt_def": "Bolt",
    "hs_water_def": "Water",
    "hs_motion_def": "Motion",
    "hs_relaxation_def": "Relaxation",
    "hs_strength_def": "StrengthSearch",
}
NO_DEFAULT = {"hs_world_def", "hs_action_def"}  # without a dimension, without a table
READ = {"hs_action_def", "hs_law_def", "hs_world_def", "hs_elasticity_def"}  # that a world returns
BY_HAND = {"hs_action_def.point", "hs_world_def.dimension"}  # together with the place, as constructors
COUNTS = {"int32_t": "i32", "int64_t": "u64"}
ACTIONS = "HS_ACTION_"
TAKES_MORE = {"HS_ACTION_SERVO"}  # than a table


def write(api):
    lines = HEAD.format_map(api).splitlines()
    for struct_name, name in BUILDERS.items():
        constructors = kinds_of_action(api) if name == "Action" else []
        lines += ["", f"impl {name} {{", *[*constructors, *functions(meanings.find(api, struct_name))][1:]]
        if struct_name in READ:
            lines += READER.format(struct=struct_name).rstrip().splitlines()
        lines.append("}")
        if struct_name not in NO_DEFAULT:
            lines += DEFAULT.format(name=name, struct=struct_name).rstrip().splitlines()
    return "\n".join(lines) + "\n"


def kinds_of_action(api):
    """The comments of these constants begin with the unit."""
    lines = []
    for each in meanings.constants(api, ACTIONS):
        name = function_of_kind(each["name"])
        if each["name"] not in TAKES_MORE:
            words = f"{name.capitalize().replace('_', ' ')}, in {each['comment']}."
            linked = re.sub(rf"\b{ACTIONS}\w+", lambda kind: "[`{0}`](Self::{0})".format(function_of_kind(kind[0])),
                            words)
            lines += ["", *documented(linked, "    "), f"    pub fn {name}(table: Table) -> Self {{",
                      f"        Self::of_kind(sys::{each['name']}, table)", "    }"]
    return lines


def function_of_kind(constant):
    return constant.removeprefix(ACTIONS).lower()


def functions(struct):
    lines = []
    for field in meanings.read_fields(struct):
        name, rust_type = field["name"].removeprefix("is_"), type_of(struct, field)
        if rust_type:
            words = definitions.of_flag(struct, field, "`true`", "`false`")
            if rust_type == "bool":
                words = words.replace("1 (default)", "`true` (default)")
            lines += ["", *documented(comment_of(words, rust_type), "    "),
                      f"    pub fn {name}(mut self, {name}: {rust_type}) -> Self {{",
                      f"        self.raw.{field['name']} = {raw_value(name, rust_type)};", "        self", "    }"]
    return lines


def raw_value(name, rust_type):
    if rust_type == "bool":
        return f"{name}.into()"
    if rust_type == "u64":
        return f"i64::try_from({name}).unwrap_or(i64::MAX)"
    return name if rust_type == "i32" or "f64" in rust_type else f"{name}.value()"


def type_of(struct, field):
    """The type of a measure, a vector, a flag, a count or one of several constants; None for what is set by hand."""
    if f"{struct['name']}.{field['name']}" in BY_HAND:
        return None
    if field["dimensions"] in ([], [3]) and plain_type(field):
        return plain_type(field)
    meaning = meanings.of(struct, field)
    if meaning == meanings.FLAG:
        return "bool"
    if meaning:
        return meanings.ENUMERATIONS.get(meaning, (None, None))[0]
    return None if field["dimensions"] else COUNTS.get(field["of"])
