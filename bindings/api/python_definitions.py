"""Python: a dataclass for each definition of the properties of materials and joints."""
import re

import definitions
import meanings
from prose import wrapped
from python import public_names
from python_records import kind_of

HEAD = '''\
# Generated {generated}.
"""Properties of materials and joints."""
from __future__ import annotations

import dataclasses
from typing import Dict, Union

from . import _raw
from ._definition import Definition
from ._library import library
from .constants import {kinds}
'''
EXAMPLES = {
    "hs_law_def": ("Law(normal_stiffness=1e7, shear_stiffness=5e6, friction_angle=0.5).cohesion", "0.0"),
    "hs_elasticity_def": ("Elasticity(young_modulus=5e10, damping_time=1e-5).poisson_ratio", "0.25"),
    "hs_bond_def": ("Bond(normal_stiffness=1e11, tensile_strength=2e5, cohesion=4e5).residual_cohesion", "0.0"),
    "hs_bolt_def": ("Bolt(stiffness=2e7, pretension=1e5).is_tension_only", "True"),
}


def write(api):
    structs = [meanings.find(api, name) for name in definitions.PROPERTIES]
    kinds = {kind_of(struct, field) for struct in structs for field in struct["fields"]} - {None}
    lines = HEAD.format(generated=api["generated"], kinds=", ".join(sorted(kinds))).splitlines()
    lines += ["", *public_names(map(class_of, structs))]
    for struct in structs:
        lines += ["", "", *dataclass(struct)]
    return "\n".join(lines) + "\n"


def dataclass(struct):
    fields = definitions.settings(struct)
    call, result = EXAMPLES[struct["name"]]
    lines = ["@dataclasses.dataclass(frozen=True)", f"class {class_of(struct)}(Definition):",
             *wrapped(definitions.comment_of(struct), '    """', "    "), "", "    Attributes", "    ----------"]
    for field in fields:
        lines += [f"    {field['name']} : {type_in_words(struct, field)}",
                  *wrapped(in_words(struct, field), "        ")]
    lines += ["", "    Examples", "    --------", f"    >>> {call}", f"    {result}", '    """', ""]
    lines += [f"    {field['name']}: {annotation_of(struct, field)} = {default_of(struct, field)}" for field in fields]
    return [*lines, *belonging(fields), "", f"    def _as_struct(self) -> _raw.{struct['name']}:",
            f"        return self._filled(_raw.{struct['name']}(), library.{struct['name']}_init)"]


def in_words(struct, field):
    """The comment of a field, with constants by their names in Python."""
    words = definitions.of_flag(struct, field, "True", "False")
    for prefix, (_, kind) in meanings.ENUMERATIONS.items():
        words = re.sub(rf"\b(an? )?{prefix}(?: value)?", lambda found: f"a {kind}" if found[1] else f"{kind}.", words)
    return words


def belonging(fields):
    """A function that says which numbers belong to some laws only."""
    conditions = [(field["name"], definitions.belongs(field)) for field in fields if definitions.belongs(field)]
    if not conditions:
        return []
    lines = []
    for name, belongs in conditions:
        condition = belongs.condition("self", "and", "or").replace("HS_STIFFNESS_", "StiffnessKind.")
        lines.append(f'            "{name}": {condition.replace("self.stiffness_kind", "kind")},')
    return ["", "    def _belongs(self) -> Dict[str, bool]:",
            '        """Whether the numbers that some kinds of stiffness do not have belong to this law."""',
            "        kind = self.stiffness_kind", "        return {", *lines, "        }"]


def class_of(struct):
    return meanings.camel(struct["name"].removeprefix("hs_").removesuffix("_def"))


def is_flag(struct, field):
    return meanings.of(struct, field) == meanings.FLAG


def type_in_words(struct, field):
    kind = kind_of(struct, field)
    return f"{kind} or its name" if kind else "bool" if is_flag(struct, field) else "float"


def annotation_of(struct, field):
    kind = kind_of(struct, field)
    return f"Union[{kind}, str]" if kind else "bool" if is_flag(struct, field) else "float"


def default_of(struct, field):
    default, kind = definitions.default_of(field), kind_of(struct, field)
    if kind:
        return f"{kind}.{default.removeprefix(meanings.of(struct, field))}"
    if is_flag(struct, field):
        return str(default == "1")
    return default if "e" in default or "." in default else default + ".0"
