"""What a C type does not say: the names that constants have as enumerations, and the fields that are more than a
measure or a count. All other fields mean what their type says, and need no entry here."""

# Group of constants: name of the enumeration in Rust and in Python; None where a language has none.
ENUMERATIONS = {
    "HS_CONTACT_": ("ContactType", "ContactType"),
    "HS_PAIR_": ("PairKind", "PairKind"),
    "HS_STIFFNESS_": ("StiffnessKind", "StiffnessKind"),
    "HS_FAULT_": ("FaultKind", "Fault"),
    "HS_BLOCK_": ("BlockKind", "BlockKind"),
    "HS_FAST_": (None, "FastBlocks"),
    "HS_PLANE_": (None, "Plane"),
    "HS_BOND_": ("BondFailure", "BondFailure"),
    "HS_IMPACT_": ("ImpactState", "ImpactState"),
    "HS_CELL_": (None, "CellKind"),
    "HS_PART_": (None, "WorldPart"),
    "HS_UNBALANCED_": (None, "Unbalanced"),
    "HS_ACTION_": (None, "ActionKind"),
    "HS_PLACE_": (None, "ForcePlace"),
    "HS_ROLE_": ("Role", "Role"),
    "HS_SETTING_": ("Setting", "Setting"),
}
SUMS = {"HS_PART_"}  # of several constants at once

INDEX = "index"  # counted from 0, in Fortran from 1
INDEX_OR_NONE = "index or none"  # likewise; -1 is none
FLAG = "flag"  # 1 or 0
SIZE = "size"  # a count whose name does not end so
BLOCK = "block"  # the id of a block, 0 is none

MEANINGS = {
    "hs_contact.block_a": BLOCK,
    "hs_contact.block_b": BLOCK,
    "hs_contact.type": "HS_CONTACT_",
    "hs_law_def.stiffness_kind": "HS_STIFFNESS_",
    "pair_kind": "HS_PAIR_",  # of any struct
    "feature_a": INDEX,
    "feature_b": INDEX,
    "hs_block_state.kind": "HS_BLOCK_",
    "hs_block_state.material": INDEX,
    "hs_impact.state": "HS_IMPACT_",
    "hs_bond.is_joint": FLAG,
    "hs_bolt.is_ruptured": FLAG,
    "hs_ray_hit.is_hit": FLAG,
    "hs_ray_hit.face": INDEX_OR_NONE,
    "hs_bolt_def.is_tension_only": FLAG,
    "hs_bond_event.bond": INDEX,
    "hs_bond_event.point": INDEX,
    "hs_bond_event.failure": "HS_BOND_",
    "hs_fault.kind": "HS_FAULT_",
    "hs_fault.vertex": INDEX_OR_NONE,
    "hs_fault.face": INDEX_OR_NONE,
    "hs_clean_report.welded": SIZE,
    "hs_clean_report.straightened": SIZE,
    "hs_clean_report.reversed": FLAG,
    "hs_fit_report.merged": SIZE,
    "hs_world_plan.parts": "HS_PART_",
    "hs_world_plan.limiting_bond": INDEX_OR_NONE,
    "hs_world_plan.limiting_cell": INDEX_OR_NONE,
    "hs_strength_report.stands_at_low": FLAG,
    "hs_strength_report.falls_at_high": FLAG,
    "hs_world_def.locate_impacts": FLAG,
    "hs_world_def.fast_blocks": "HS_FAST_",
    "hs_relaxation_def.measure": "HS_UNBALANCED_",
    "hs_relaxation_def.is_adaptive": FLAG,
    "hs_relaxation_def.hold_bonds": FLAG,
    "hs_share_info.is_whole": FLAG,
    "hs_share_plan.needs_list": FLAG,
    "hs_share_plan.needs_assembly": FLAG,
    "hs_note.setting": "HS_SETTING_",
    "hs_note.material_a": INDEX_OR_NONE,
    "hs_note.material_b": INDEX_OR_NONE,
    "hs_elasticity_def.plane": "HS_PLANE_",
    "hs_action_def.kind": "HS_ACTION_",
    "hs_action_def.place": "HS_PLACE_",
    "hs_action_def.table": INDEX,
}
BLOCK_TYPES = {"hs_block": BLOCK}


def of(struct, field):
    """A meaning from above, a group of constants, or None: a measure, a count or another struct."""
    exact = MEANINGS.get(f"{struct['name']}.{field['name']}")
    return exact or MEANINGS.get(field["name"]) or BLOCK_TYPES.get(field["of"])


def read_fields(struct):
    """The fields that a host reads."""
    unread = ("reserved", "struct_size")
    return [field for field in struct["fields"] if not field["name"].startswith(unread)]


def find(api, name):
    """A struct by its name."""
    return next(struct for struct in api["structs"] if struct["name"] == name)


def constants(api, group):
    """Those whose names begin with `group`."""
    return next(each["constants"] for each in api["constants"] if each["group"] == group)


def camel(words):
    """vertex_face or VERTEX_FACE as VertexFace."""
    return "".join(word.capitalize() for word in words.split("_"))


def groups(api, language):
    """Name and group of each enumeration; language 0 is Rust, 1 Python."""
    named = [(ENUMERATIONS.get(group["group"], (None, None))[language], group) for group in api["constants"]]
    return [(name, group) for name, group in named if name]
