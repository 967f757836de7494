"""A world of blocks, stepped by the library or by an integrator of the host."""
from __future__ import annotations

import functools
import operator
import time
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import as_pose, block_id, gravity_vector, index, mutable_view_of, pose, struct_of, turn_vector, vector
from ._choice import choice
from ._definition import filled
from ._library import library
from ._record import Records
from .action import ActedOn
from .block_arrays import Floats
from .compound import CompoundBlocks, set_start
from .constants import BlockKind, FastBlocks
from .context import Context, held, made
from .notes import notes_on
from .plot import picture_by, plot_blocks
from .plot_space import plot_solids
from .properties import Law
from .records import BlockState, Contact, WorldPlan
from .run import Runs
from .shape import Shape
from .share import Shares

_FIRST_PORTION = 16  # steps
_PICTURE_LIMIT = 20000  # blocks: larger worlds have no automatic picture in notebooks
_PICTURE_LIMIT_IN_SPACE = 2000


class World(ActedOn, CompoundBlocks, Shares, Runs):
    """Blocks, materials, laws and time.

    Arrays of blocks have the order of `blocks`. In 2D vectors have 2 components, angular velocities and torques 1; in
    3D both have 3.

    Parameters
    ----------
    dimension : int
        2 or 3.
    gravity : array_like
        m/s2; by default 9.81 along -y in 2D, along -z in 3D.
    time_step : float
        s, > 0; 0 (default): `safety` times the stable time step.
    safety : float
        Factor of the stable time step, (0, 1]; by default 0.5.
    local_damping : float
        Ratio of the damping force to the unbalanced force, per component, [0, 1); by default 0.
    mass_damping : float
        1/s, >= 0: force -mass_damping * mass * velocity; by default 0.
    skin : float
        Skin of the neighbour list, as a fraction of a block's size, (0, 1]; by default 0.1.
    parallel_angle, vertex_zone : float
        As for `pair_detect`.
    potential_length : float
        Length H of potentials, m, > 0; 0 (default): mean length of all edges at the first evaluation of forces.
    fast_blocks : FastBlocks or its name
        Continuous collision: DIVIDE (default) divides a step in which blocks approach too fast; REFUSE raises
        TooFastError.
    sleep_tolerance : float
        Max displacement error of a block by sleep over a run, m, >= 0; 0 (default): no block sleeps.
    impulse_tolerance : float
        Velocity that the impulses of rigid blocks without springs may leave unbalanced, over gravity times time
        step, > 0; default 1e-6.
    max_impulse_iterations : int
        Max sweeps of their solver per half step where blocks move past each other, >= 1; default 200.
    locate_impacts : bool
        Divide steps at their impacts, which makes rebounds accurate; default False.
    law : Law, optional
        Law of all pairs of materials without a law of their own.
    context : Context, optional
        The owner; the default context if there is none given.

    Examples
    --------
    >>> world = World(law=Law(normal_stiffness=1e7))
    >>> stone = world.add_material(density=2000)
    >>> floor = world.add_block(Shape.rectangle(4, 1), (0, -0.5), kind=BlockKind.FIXED)
    >>> block = world.add_block(Shape.rectangle(1, 1), (0, 1))
    >>> world.step(1000)
    >>> world.state(block).velocity[1] < 0
    True
    """

    def __init__(
        self,
        dimension: int = 2,
        *,
        gravity: Optional[ArrayLike] = None,
        time_step: Optional[float] = None,
        safety: Optional[float] = None,
        local_damping: Optional[float] = None,
        mass_damping: Optional[float] = None,
        skin: Optional[float] = None,
        parallel_angle: Optional[float] = None,
        vertex_zone: Optional[float] = None,
        potential_length: Optional[float] = None,
        fast_blocks: Union[FastBlocks, str, None] = None,
        sleep_tolerance: Optional[float] = None,
        impulse_tolerance: Optional[float] = None,
        max_impulse_iterations: Optional[int] = None,
        locate_impacts: Optional[bool] = None,
        law: Optional[Law] = None,
        context: Optional[Context] = None,
    ) -> None:
        given = {name: value for name, value in locals().items() if value is not None}
        given["dimension"] = dimension = index(dimension, "dimension")
        if gravity is not None:
            given["gravity"] = gravity_vector(gravity, dimension)
        if fast_blocks is not None:
            given["fast_blocks"] = choice(fast_blocks, FastBlocks, "fast_blocks")
        settings = {name: given[name] for name, _ in _raw.hs_world_def._fields_ if name in given}
        plane_or_space = 3 if dimension == 3 else 2  # the library refuses the dimension below, with an error text
        definition = filled(_raw.hs_world_def(), library.hs_world_def_init, plane_or_space, **settings)
        self._make(context, dimension, library.hs_world_create, definition)
        self._given.is_of_snapshot = False
        if law is not None:
            self.set_default_law(law)

    def _make(self, context: Optional[Context], dimension: int, make: Any, *arguments: Any) -> None:
        own = functools.partial(super().__init__, destroy=library.hs_world_destroy, dimension=dimension)
        made(own, context, make, *arguments)

    @classmethod
    def _of(cls, owner: Context, pointer: Any, dimension: int, *, is_owned: bool = True) -> "World":
        """A world that another part of the library made in a context, whose lock the caller holds, and that the other
        part destroys if it is not owned."""
        world = cls.__new__(cls)
        destroy = library.hs_world_destroy if is_owned else lambda _: None
        super(World, world).__init__(owner, pointer, destroy, dimension)
        return world

    @classmethod
    def restore(
        cls, snapshot: Union[bytes, bytearray, memoryview], *, context: Optional[Context] = None
    ) -> "World":
        """Creates a world from a snapshot of `save`, with the same ids, materials and laws. It continues bit for
        bit."""
        stored = np.frombuffer(snapshot, np.uint8)
        world = cls.__new__(cls)
        world._make(context, 0, library.hs_world_restore, stored.ctypes.data, stored.nbytes)
        world._dimension = int(world.report.dimension)  # the snapshot's
        return world

    def save(self) -> bytes:
        """Returns a snapshot of the complete state."""
        return bytes(self._array(np.uint8, library.hs_world_save))

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle: the context is not stored
        return World.restore, (self.save(),)

    def __copy__(self) -> "World":
        other = World.restore(self.save(), context=self.context)
        other._given = self._given.copy()
        other._names, other._notes_of_scene = dict(self._names), self._notes_of_scene
        return other

    def __deepcopy__(self, _: Dict[int, Any]) -> "World":
        return self.__copy__()

    def __bool__(self) -> bool:
        return True

    def __repr__(self) -> str:
        return (
            "<halfspace.World, closed>"
            if self.closed
            else f"<halfspace.World, {self.dimension}D: {len(self)} blocks>"
        )

    # ---- materials and laws ----

    def add_material(self, density: float) -> int:
        """Adds a material (density > 0, kg/m3) and returns its index."""
        return self._value(library.hs_world_add_material, density)

    def set_default_law(self, law: Law) -> None:
        """Sets the law of all pairs of materials without a law of their own."""
        self._call(library.hs_world_set_default_law, struct_of(law, Law, "law"))

    def set_law(self, material_a: int, material_b: int, law: Law) -> None:
        """Sets the law of two materials, in either order; they may be the same."""
        materials = index(material_a, "material_a"), index(material_b, "material_b")
        self._call(library.hs_world_set_law, *materials, struct_of(law, Law, "law"))

    # ---- blocks ----

    def add_block(
        self,
        shape: Shape,
        position: Optional[ArrayLike] = None,
        angle: Optional[float] = None,
        *,
        rotation: Optional[ArrayLike] = None,
        kind: Union[BlockKind, str] = BlockKind.RIGID,
        material: int = 0,
        velocity: Optional[ArrayLike] = None,
        angular_velocity: Optional[ArrayLike] = None,
    ) -> int:
        """Adds a block. The world copies the shape.

        Parameters
        ----------
        shape : Shape
            Of the world's dimension.
        position : array_like, optional
            Position of the centroid, m; by default in the coordinates of the shape's vertices.
        angle : float, optional
            Rotation about z, rad.
        rotation : array_like, optional
            Unit quaternion x, y, z, w, instead of an angle.
        kind : BlockKind or its name
            Rigid, affine, fixed or prescribed. The material of an affine block must have an elasticity.
        material : int
            From `add_material`.
        velocity : array_like, optional
            Velocity of the centroid, m/s.
        angular_velocity : float or array_like, optional
            rad/s; a number is about z.

        Returns
        -------
        int
            Id of the block (unsigned, 64 bits). Ids of removed blocks are not reused.
        """
        with held(shape):
            definition = filled(_raw.hs_block_def(), library.hs_block_def_init, shape._alive)
        set_start(definition, position, angle, rotation, kind, material, velocity, angular_velocity)
        with held(self, shape):
            return self._value(library.hs_world_add_block, shape._alive, definition)

    def add_blocks(
        self,
        shapes: Sequence[Shape],
        *,
        kind: Union[BlockKind, str] = BlockKind.RIGID,
        material: int = 0,
        velocity: Optional[ArrayLike] = None,
        angular_velocity: Optional[ArrayLike] = None,
    ) -> NDArray[np.uint64]:
        """Adds blocks in the coordinates of their vertices, as `jointed_rock`, `wall` and others make them. The other
        arguments are those of `add_block`. Returns their ids.

        Examples
        --------
        >>> from halfspace import stack
        >>> world = World()
        >>> stone = world.add_material(density=2000)
        >>> len(world.add_blocks(stack((1, 1), count=3)))
        3
        """
        ids = [
            self.add_block(
                shape, kind=kind, material=material, velocity=velocity, angular_velocity=angular_velocity
            )
            for shape in shapes
        ]
        return np.array(ids, np.uint64)

    def remove_block(self, block: int) -> None:
        """Removes a block; its id becomes stale."""
        self._call(library.hs_world_remove_block, block_id(block, "block"))

    def state(self, block: int) -> BlockState:
        """Returns the motion of a block: a record of `BLOCK_STATE`."""
        return self._record(BlockState, library.hs_world_get_block_state, block_id(block, "block"))

    def block_vertices(self, block: int) -> Floats:
        """Returns the current positions of a block's vertices, m, shape (n, dimension)."""
        named, count, room = block_id(block, "block"), 16, np.empty((0, self.dimension))
        while len(room) < count:
            room = np.empty((count, self.dimension))
            view = mutable_view_of(room, self.dimension, "vertices")
            count = self._value(library.hs_world_get_block_vertices, named, view)
        return room[:count]

    def set_pose(
        self,
        block: int,
        position: ArrayLike,
        angle: Optional[float] = None,
        *,
        rotation: Optional[ArrayLike] = None,
    ) -> None:
        """Sets the pose of a block: a position with a rotation about z or a quaternion, or 7 numbers as from `pose`."""
        whole = np.size(position) == 7
        if whole and (angle is not None or rotation is not None):
            raise ValueError("position has 7 numbers, including a rotation; give neither angle nor rotation")
        place = position if whole else pose(position, angle, rotation=rotation)
        self._call(library.hs_world_set_pose, block_id(block, "block"), as_pose(place, "pose"))

    def set_velocity(self, block: int, velocity: ArrayLike, angular_velocity: ArrayLike = 0.0) -> None:
        """Sets the velocity, m/s, and angular velocity, rad/s, of a block (one number is about z)."""
        turn = turn_vector(angular_velocity, "angular_velocity")
        motion = vector(velocity, "velocity"), turn
        self._call(library.hs_world_set_velocity, block_id(block, "block"), *motion)

    def set_applied_force(self, block: int, force: ArrayLike, torque: ArrayLike = 0.0) -> None:
        """Sets the external force at the centroid, N, and torque, N m, of a rigid or affine block, until set again."""
        self._given.beyond_scenes.add("applied forces")
        load = vector(force, "force"), turn_vector(torque, "torque")
        self._call(library.hs_world_set_applied_force, block_id(block, "block"), *load)

    # ---- stages and steps ----

    def detect(self) -> int:
        """Stage: neighbour search and detection at the current poses. Returns the number of pairs in contact."""
        return self._value(library.hs_world_detect)

    def forces(
        self, elapsed: float, out: Optional[Floats] = None, torques_out: Optional[Floats] = None
    ) -> Tuple[Floats, Floats]:
        """Stage: contact forces at the current poses and velocities, after `detect`.

        Parameters
        ----------
        elapsed : float
            Time since the last call, s, >= 0: shear springs extend by velocity times this.
        out : numpy.ndarray, optional
            Array for the forces, shape (n, dimension), float64; may be strided.
        torques_out : numpy.ndarray, optional
            Array for the torques, shape (n,) in 2D, else (n, 3).

        Returns
        -------
        forces, torques : numpy.ndarray
            On each block, N, and about its centroid, N m.
        """
        return self._vectors_and_turns(library.hs_world_forces, (elapsed,), out, torques_out)

    def step(self, steps: int = 1) -> None:
        """Steps the world by velocity Verlet. Ctrl-C interrupts a long run after a complete step.

        Raises
        ------
        UnstableError
            The time step is too large. The world keeps the last valid state.
        """
        # In portions of about 0.1 s, as Python handles signals between them. Results do not depend on the portions.
        left, portion = operator.index(steps), _FIRST_PORTION
        while left > portion:
            start = time.perf_counter()
            self._call(library.hs_world_step, portion)
            left -= portion
            portion = max(1, int(portion * min(2.0, 0.1 / (time.perf_counter() - start))))
        self._call(library.hs_world_step, left)

    def contacts(self) -> Records:
        """Returns the contacts of the last detection: an array of `CONTACT`, a before b. Those of laws with springs are
        first, sorted by block index. `contacts().gap` is the array of their gaps."""
        return self._records(Contact, library.hs_world_get_contacts)

    def set_shear_force(self, block_a: int, block_b: int, shear_force: ArrayLike) -> None:
        """Preloads the shear spring of a contact with a force on `block_b`, e.g. to start from
        equilibrium."""
        blocks = block_id(block_a, "block_a"), block_id(block_b, "block_b")
        self._call(library.hs_world_set_shear_force, *blocks, vector(shear_force, "shear_force"))

    def plan(self, steps: int = 0) -> WorldPlan:
        """Returns active parts, bytes, and the limit of the time step: a record of the fields of ``hs_world_plan``.

        Its times are measured over `steps` steps of a copy. ``plan.parts`` are the active parts, a `WorldPart`."""
        return self._record(WorldPlan, library.hs_world_get_plan, steps)

    def check(self) -> List[str]:
        """Returns notes on unusual input: those of ``halfspace check`` (docs/scenes/notes.md), in the words of scenes,
        whose angles are in degrees, on bonds that were not made, and on an energy residual above 1 % of the released
        energy. Empty if there is nothing unusual; nothing is changed.

        Worlds that `Scene.from_world` refuses, as those with meshes, have fewer notes: on values in a wrong unit,
        gravity, sizes, the time step, settings of impulses, and, unless they are from `restore`, support.

        Examples
        --------
        >>> world = World(gravity=(0, -9.81))
        >>> stone = world.add_material(density=2.7)
        >>> world.check()
        ['material[0].density: 2.7 is unusual; usual: 50 to 19500 kg/m3, 2700 of rock']
        """
        return notes_on(self)

    def _outlined(self) -> Tuple[NDArray[np.uint64], List[Floats]]:
        """All blocks but compounds, which have no vertices of their own, and their vertices."""
        with_vertices = [(block, vertices) for block in self.blocks if len(vertices := self.block_vertices(block)) > 0]
        ids = np.array([block for block, _ in with_vertices], np.uint64)
        return ids, [vertices for _, vertices in with_vertices]

    # ---- pictures ----

    def plot(self, ax: Any = None, *, contacts: bool = True) -> Any:
        """Draws the world by matplotlib: blocks, with fixed and prescribed ones in grey, and a line along each
        contact force of the last step, with a width proportional to it. Returns the axes.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes to draw into, in 3D of ``projection="3d"``; by default the current ones, in 3D those of a new figure.
        contacts : bool
            Draw the forces.
        """
        with held(self):
            blocks, outlines = self._outlined()
            free = (BlockKind.RIGID, BlockKind.AFFINE)
            are_free = [self.state(block).kind in free for block in blocks]
            touching = self.contacts()
        shown = touching if contacts else touching[:0]
        if self.dimension == 3:
            return plot_solids(blocks, outlines, are_free, shown, ax, context=self.context)
        return plot_blocks(blocks, outlines, are_free, shown, ax)

    def _repr_png_(self) -> Optional[bytes]:
        """None for a closed, empty or large world."""
        if self.closed or not 0 < len(self) <= (_PICTURE_LIMIT if self.dimension == 2 else _PICTURE_LIMIT_IN_SPACE):
            return None
        return picture_by(self.plot, self.dimension)
