"""Safe Rust: the structs that hosts read, with the conversion from the raw ones."""
import re
from collections import namedtuple

import meanings
from rust import documented
from rust import name as raw_name

HEAD = '''\
// Generated {generated}.

//! The library's reports and states, field by field as in the headers of C.

use std::mem::{{align_of, size_of}};

use halfspace_sys as sys;

use crate::affine::Tensor;
use crate::block::{{Block, Material}};
use crate::body::Body;
use crate::contact::Contact;
use crate::impact::Impact;
use crate::kinds::{{BlockKind, BondFailure, ErrorKind, FaultKind, ImpactState, PairKind, Setting}};
use crate::pose::Pose;
use crate::world::World;
'''

# A field of Rust alone: its name, type, value and comment, and the fields of C that it replaces.
ByHand = namedtuple("ByHand", "name type value comment replaced")
BLOCKS = ByHand("blocks", "Option<(Block, Block)>", "Block::from_id(raw.block_a).zip(Block::from_id(raw.block_b))",
                "Both blocks; `None` if either has been removed.", ("block_a", "block_b"))
CELL = ByHand("limiting_cell", "Option<(Body, usize)>",
              "Body::from_id(raw.limiting_body)\n                .map(|body| (body, raw.limiting_cell as usize))",
              "Body of the limiting block and its cell that is the stiffest for its mass, if its elements limit the "
              "step more than contacts and bonds.", ("limiting_body", "limiting_cell"))
VERTICES = ByHand("vertices", "Vec<[f64; 2]>", None, "Remaining vertices, counter-clockwise.", ())
FALLEN = ByHand("fallen", "Option<World>", None, "Final state of the last copy that failed; `None` if none did. Its "
                "velocities and [`bond events`](World::bond_events) show the mechanism.", ())
REFUSAL = ByHand("refusal", "Option<ErrorKind>",
                 "(raw.refusal != sys::HS_OK).then(|| ErrorKind::from_value(raw.refusal))",
                 "The error with which [`move_blocks`](World::move_blocks) would end: `TooFast`, a block moves by more than "
                 "its radius, turns by more than 1 rad, or approaches another so fast that the step would be divided; "
                 "`Unstable`, the motion is not finite.", ("refusal",))
HIT = ByHand(None, None, None, None, ("is_hit",))  # a ray without a hit is `None`
ON_SUCCESS = ByHand(None, None, None, None, ("fault", "sufficient_tolerance"))  # the report of a fault is an error

# Struct: its name, its traits if not those that its fields allow, and fields by hand.
Record = namedtuple("Record", "name traits by_hand", defaults=(None, ()))
RECORDS = {
    "hs_energy": Record("Energy"),
    "hs_world_report": Record("Report"),
    "hs_world_plan": Record("Plan", None, (CELL,)),
    "hs_block_state": Record("BlockState"),
    "hs_bond": Record("BondState", None, (BLOCKS,)),
    "hs_bond_event": Record("BondEvent"),
    "hs_bond_report": Record("BondReport"),
    "hs_bolt": Record("BoltState"),
    "hs_note": Record("Note"),
    "hs_body_state": Record("BodyState"),
    "hs_mesh_properties": Record("MeshProperties"),
    "hs_shape_properties": Record("ShapeProperties"),
    "hs_fault": Record("Fault"),
    "hs_clean_report": Record("Cleaned", "Clone, Debug, PartialEq", (VERTICES,)),
    "hs_fit_report": Record("FitReport", None, (ON_SUCCESS,)),
    "hs_ray_hit": Record("RayHit", None, (HIT,)),
    "hs_closest_points": Record("ClosestPoints"),
    "hs_balance": Record("Balance"),
    "hs_share_info": Record("ShareInfo"),
    "hs_share_plan": Record("SharePlan", None, (REFUSAL,)),
    "hs_strength_report": Record("StrengthFound", "Debug", (FALLEN,)),
}
SAME_LAYOUT = {"hs_deformation": "Deformation", "hs_cell_state": "CellState"}  # arrays of them are written in place
# Read by functions; these are written by hand, or ask whether there is a region.
GETTERS = {"hs_contact": "Contact", "hs_impact": "Impact"}
OTHER_GETTERS = {"block_a", "block_b", "type", "feature_a", "feature_b", "point_count", "points", "gaps"}
OF_REGION = {"area", "length", "center", "center_gap"}
RENAMED = {"hs_bond_event.step": "steps"}


def name_of(struct_name):
    return SAME_LAYOUT.get(struct_name) or GETTERS.get(struct_name) or RECORDS[struct_name].name


def write(api):
    lines = HEAD.format_map(api).splitlines()
    for struct in api["structs"]:
        name = struct["name"]
        if name in RECORDS:
            lines += ["", *record(api, struct, RECORDS[name])]
        elif name in SAME_LAYOUT:
            lines += ["", *same_layout(struct, SAME_LAYOUT[name])]
        elif name in GETTERS:
            lines += ["", *getters(struct, GETTERS[name])]
    return "\n".join(lines) + "\n"


def record(api, struct, names):
    fields = shown_fields(api, struct, names.by_hand)
    given = [field for field in fields if field.value is None]
    arguments = "".join(f", {field.name}: {field.type}" for field in given)
    begin, end = f"impl From<sys::{struct['name']}> for {names.name} {{", "    fn from(raw: "
    if given:
        begin, end = f"impl {names.name} {{", "    pub(crate) fn new(raw: "
    values = [f"            {field.name}: {field.value}," if field.value else f"            {field.name},"
              for field in fields]
    return [*documented(struct["comment"]), f"#[derive({names.traits or traits(fields)})]", "#[non_exhaustive]",
            f"pub struct {names.name} {{", *declared(fields), "}", "", begin,
            f"{end}sys::{struct['name']}{arguments}) -> Self {{", "        Self {", *values, "        }", "    }", "}"]


def shown_fields(api, struct, by_hand):
    hidden = {name for each in by_hand for name in each.replaced}
    fields = []
    for field in meanings.read_fields(struct):
        if meanings.of(struct, field) in meanings.SUMS:
            fields += parts(api, field, meanings.of(struct, field))
        elif field["name"] not in hidden:
            rust_type, value = converted(struct, field, "raw.")
            name = RENAMED.get(f"{struct['name']}.{field['name']}", raw_name(field))
            fields.append(ByHand(name, rust_type, value, comment_of(field["comment"], rust_type), ()))
    return fields + [field for field in by_hand if field.name]


def parts(api, field, prefix):
    """Each constant of a sum is a field of its own."""
    return [ByHand(each["name"].removeprefix(prefix).lower(), "bool", f"raw.{field['name']} & sys::{each['name']} != 0",
                   each["comment"], ()) for each in meanings.constants(api, prefix)]


def converted(struct, field, raw):
    """Type and value of a field of `raw`."""
    name, meaning = raw + raw_name(field), meanings.of(struct, field)
    plain = plain_type(field)
    if plain:
        return plain, name
    if meaning in meanings.ENUMERATIONS:
        kind = meanings.ENUMERATIONS[meaning][0]
        return kind, f"{kind}::from_value({name})"
    if field["name"] == "material":
        return "Material", f"Material({name})"
    if meaning == meanings.BLOCK:
        return "Option<Block>", f"Block::from_id({name})"
    if meaning == meanings.FLAG:
        return "bool", f"{name} != 0"
    if meaning == meanings.INDEX_OR_NONE:
        return "Option<usize>", f"usize::try_from({name}).ok()"
    if field["of"].startswith("hs_"):
        return "Pose" if field["of"] == "hs_pose" else name_of(field["of"]), f"{name}.into()"
    is_size = field["of"] == "int32_t" or meaning or field["name"].endswith(("_count", "_bytes"))
    number = "usize" if is_size else "u64"
    return number, f"{name} as {number}"


def comment_of(comment, rust_type):
    """The comment of a field, with the values that Rust has in place of numbers."""
    words = re.sub(r"\ban? HS_[A-Z]+_ value", f"a `{rust_type}`", comment)
    return re.sub(r"-1\b", "`None`", words) if rust_type.startswith("Option") else words


def plain_type(field):
    """The type of measures, which are shown as they are; None of others."""
    if field["of"] != "double":
        return None
    declared = "f64"
    for count in reversed(field["dimensions"]):
        declared = f"[{declared}; {count}]"
    return declared


def declared(fields):
    lines = []
    for field in fields:
        lines += [*documented(field.comment, "    "), f"    pub {field.name}: {field.type},"]
    return lines


def traits(fields):
    types = {field.type for field in fields}
    found = ["Clone", "Copy", "Debug"]
    if not types & {"Material", *(rust for rust, _ in meanings.ENUMERATIONS.values())}:
        found.append("Default")
    found.append("PartialEq")
    if not any("f64" in each for each in types):
        found.append("Eq")
    return ", ".join(found)


def same_layout(struct, name):
    fields = [ByHand(field["name"], "Tensor" if field["dimensions"] == [9] else plain_type(field), None,
                     field["comment"], ()) for field in struct["fields"]]
    checks = [f"const _: () = assert!({check}::<{name}>() == {check}::<sys::{struct['name']}>());"
              for check in ("size_of", "align_of")]
    return [*documented(struct["comment"]), "///",
            "/// The memory is that of the C interface, so slices of it are written without a copy.",
            "#[derive(Clone, Copy, Debug, Default, PartialEq)]", "#[repr(C)]", f"pub struct {name} {{",
            *declared(fields), "}", "", *checks]


def getters(struct, name):
    lines = []
    for field in meanings.read_fields(struct):
        if field["name"] in OTHER_GETTERS:
            continue
        rust_type, value = converted(struct, field, "self.raw.")
        if struct["name"] == "hs_contact" and field["name"] in OF_REGION:
            value = f"self.of_region({value})"
        lines += ["", *documented(comment_of(field["comment"], rust_type), "    "), f"    pub fn {field['name']}(&self) -> {rust_type} {{",
                  f"        {value}", "    }"]
    return [f"impl {name} {{", *lines[1:], "}"]
