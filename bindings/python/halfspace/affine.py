"""Affine blocks: blocks with uniform strain and stress."""
from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import block_id, index, struct_of, tensor, vector
from ._library import library
from ._record import Records
from .block_arrays import BlockArrays
from .properties import Elasticity
from .records import Deformation


class AffineBlocks(BlockArrays):
    """Deformation and stress of blocks.

    Tensors have the shape (3, 3), as rows. In 2D only xx, xy, yx and yy are read, and arguments may have the shape
    (2, 2); in results the other components are 0, except zz of a gradient, which is 1.
    """

    def set_elasticity(self, material: int, elasticity: Elasticity) -> None:
        """Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep their strain."""
        self._call(library.hs_world_set_elasticity, index(material, "material"), struct_of(elasticity, Elasticity, "elasticity"))
        self._load_length = 0  # virials are loads, too

    def deformation(self, block: int) -> Deformation:
        """Returns deformation and stress of a block of any kind: a record of `DEFORMATION`.

        `gradient` is the deformation gradient, from the shape's frame to space; `rate` its time derivative, 1/s;
        `strain` the Green strain, in the shape's frame; `stress` the elastic Cauchy stress, in space, Pa, tension >
        0; `strain_energy` in J, in 2D per unit thickness.
        """
        return self._record(Deformation, library.hs_world_get_deformation, block_id(block, "block"))

    def deformations(self) -> Records:
        """Returns deformation and stress of all blocks: an array of `DEFORMATION`, whose ``["gradient"]`` has the
        shape (n, 3, 3)."""
        return self._records(Deformation, library.hs_world_get_deformations)

    def set_deformation(self, block: int, gradient: ArrayLike, rate: Optional[ArrayLike] = None) -> None:
        """Sets the deformation gradient of an affine block, with a determinant > 0, and its rate, 1/s; by default 0.
        Centroid and velocity do not change."""
        speed = np.zeros((3, 3)) if rate is None else rate
        tensors = tensor(gradient, "gradient"), tensor(speed, "rate")
        self._call(library.hs_world_set_deformation, block_id(block, "block"), *tensors)

    def set_stress(self, block: int, stress: ArrayLike) -> None:
        """Sets the current Cauchy stress of an affine block, e.g. the in situ stress; symmetric, Pa, tension > 0.
        Later strain adds to it."""
        self._given.beyond_scenes.add("stresses")
        self._call(library.hs_world_set_stress, block_id(block, "block"), tensor(stress, "stress"))

    def add_surface_load(self, block: int, face: int, traction: ArrayLike) -> None:
        """Adds a permanent load on one face of an affine block. Its direction does not change as the block moves, nor
        its magnitude as the face is strained.

        Parameters
        ----------
        block : int
            From `add_block`.
        face : int
            Index; in 2D of the edge that starts at the vertex of that index.
        traction : array_like
            Force per area of the face as it was given, Pa.
        """
        self._given.beyond_scenes.add("surface loads")
        load = index(face, "face"), vector(traction, "traction")
        self._call(library.hs_world_add_surface_load, block_id(block, "block"), *load)

    def clear_surface_loads(self, block: int) -> None:
        """Removes all surface loads of an affine block."""
        self._call(library.hs_world_clear_surface_loads, block_id(block, "block"))
