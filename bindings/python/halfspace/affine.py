"""Blocks that strain as a whole."""
import ctypes
import dataclasses
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _raw
from ._arrays import DEFORMATION, block_id, empty_record, empty_records, index, tensor, vector
from ._library import library
from .block_arrays import BlockArrays
from .constants import Plane, choice
from .context import held


@dataclasses.dataclass(frozen=True)
class Elasticity:
    """How the affine blocks of a material strain: the second Piola stress is linear in Green's strain and
    isotropic, so that a rotation, however large, costs no energy.

    Attributes
    ----------
    young_modulus : float
        Pa, > 0.
    poisson_ratio : float
        Above -1, below 0.5.
    damping_time : float
        s, >= 0: viscous stress is the elastic one of the strain rate times this (Rayleigh's beta).
    plane : Plane or its name
        In 2D: of a body that cannot strain across the plane, or of a sheet without stress across it.

    Examples
    --------
    >>> granite = Elasticity(young_modulus=5e10, damping_time=1e-5)
    >>> granite.poisson_ratio
    0.25
    """

    young_modulus: float = 1e9
    poisson_ratio: float = 0.25
    damping_time: float = 0.0
    plane: Union[Plane, str] = Plane.STRAIN

    def __post_init__(self) -> None:
        object.__setattr__(self, "plane", choice(self.plane, Plane, "plane"))

    def _as_struct(self) -> _raw.hs_elasticity_def:
        struct = _raw.hs_elasticity_def()
        library.hs_elasticity_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        for field in dataclasses.fields(self):
            setattr(struct, field.name, getattr(self, field.name))
        return struct


class AffineBlocks(BlockArrays):
    """Strain and stress of a world's blocks.

    Tensors have the shape (3, 3), rows first. In 2D xx, xy, yx and yy count; of those that come out, the
    others are 0, but zz of a gradient 1; those that go in may have the shape (2, 2).
    """

    def set_elasticity(self, material: int, elasticity: Elasticity) -> None:
        """Makes a material elastic, for affine blocks. Blocks that have the material keep their strain."""
        self._call(library.hs_world_set_elasticity, index(material, "material"), elasticity._as_struct())
        self._given.see(f"material[{material}]", elasticity)

    def deformation(self, block: int) -> Any:
        """How a block of any kind is turned and strained: a record of `DEFORMATION`.

        Its `gradient` leads from places in the shape's frame, relative to its centroid, to places about the
        block's; `rate` is that of the gradient, 1/s; `strain` Green's, in the shape's frame; `stress`
        Cauchy's, elastic, in space, tension > 0; `strain_energy` in 2D that of unit thickness.
        """
        array, address = empty_record(DEFORMATION)
        deformation = _raw.hs_deformation.from_address(address)
        self._call(library.hs_world_get_deformation, block_id(block, "block"), deformation)
        return array[0]

    def deformations(self) -> "np.recarray[Any, Any]":
        """How all blocks are turned and strained, a structured array of `DEFORMATION`: its
        ``["gradient"]`` has the shape (n, 3, 3)."""
        with held(self):
            deformations = empty_records(len(self), DEFORMATION)
            self._call(library.hs_world_get_deformations, deformations.ctypes.data, len(deformations), None)
        return deformations

    def set_deformation(self, block: int, gradient: ArrayLike, rate: Optional[ArrayLike] = None) -> None:
        """Turns and strains an affine block by a gradient with a determinant > 0, and sets how fast it goes
        on, 1/s; by default it does not. Its centroid and velocity stay."""
        speed = np.zeros((3, 3)) if rate is None else rate
        self._call(
            library.hs_world_set_deformation,
            block_id(block, "block"),
            tensor(gradient, "gradient"),
            tensor(speed, "rate"),
        )

    def set_stress(self, block: int, stress: ArrayLike) -> None:
        """Says how an affine block is stressed as it is now, e.g. in situ: Cauchy's, symmetric, Pa, tension
        > 0. What the block is strained by from now on adds to that."""
        self._call(library.hs_world_set_stress, block_id(block, "block"), tensor(stress, "stress"))

    def add_surface_load(self, block: int, face: int, traction: ArrayLike) -> None:
        """Adds a load on one face of an affine block, which keeps its direction as the block moves and its
        size as the face is strained.

        Parameters
        ----------
        block : int
            From `add_block`.
        face : int
            Index; in 2D of the edge that starts at the vertex of that index.
        traction : array_like
            Force per area of the face as it was given, Pa.
        """
        self._call(
            library.hs_world_add_surface_load,
            block_id(block, "block"),
            index(face, "face"),
            vector(traction, "traction"),
        )

    def clear_surface_loads(self, block: int) -> None:
        """Takes all surface loads off an affine block."""
        self._call(library.hs_world_clear_surface_loads, block_id(block, "block"))
