"""Bonds: breakable connections of blocks along their common faces."""
from __future__ import annotations

from ._arrays import block_id, index, struct_of
from ._library import library
from ._record import Records
from .mesh import Bodies
from .properties import Bond
from .records import Bond as BondRecord
from .records import BondEvent, BondReport


class BondedBlocks(Bodies):
    """Bonds of a world."""

    def bond_blocks(self, block_a: int, block_b: int, bond: Bond) -> None:
        """Bonds two blocks along their common faces in their current positions: every pair of faces that is coplanar
        to rounding."""
        blocks = block_id(block_a, "block_a"), block_id(block_b, "block_b")
        self._call(library.hs_world_bond_blocks, *blocks, struct_of(bond, Bond, "bond"))
        self._given.bonds[f"bond_blocks({block_a}, {block_b})"] = bond

    def bond_materials(self, material_a: int, material_b: int, bond: Bond) -> int:
        """Bonds all pairs of blocks of two materials, which may be the same, along their common faces. Returns the
        number of bonds made."""
        materials = index(material_a, "material_a"), index(material_b, "material_b")
        count = self._value(library.hs_world_bond_materials, *materials, struct_of(bond, Bond, "bond"))
        name = f"bond_materials({material_a}, {material_b})"
        self._given.bonds[name] = bond
        if count == 0:
            self._given.empty_bonds.append(name)
        return count

    def hold_bonds(self, are_held: bool = True) -> None:
        """Suspends (True) or resumes (False) the failure of all bonds."""
        self._call(library.hs_world_hold_bonds, int(are_held))

    def bonds(self) -> Records:
        """Returns all bonds made so far, in their order of creation: an array of `BOND`."""
        return self._records(BondRecord, library.hs_world_get_bonds)

    def bond_events(self, first: int = 0) -> Records:
        """Returns the failures of bond points, in order of time, from index `first` on: an array of `BOND_EVENT`."""
        return self._records(BondEvent, library.hs_world_get_bond_events, first)

    @property
    def bond_report(self) -> BondReport:
        """Summary of all bonds: a record of `BOND_REPORT`."""
        return self._record(BondReport, library.hs_world_get_bond_report)
