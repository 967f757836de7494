"""Threads that share a context wait for each other, and destroy no object in use by another one."""
import threading

import numpy as np
import pytest

import halfspace as hs
from halfspace._library import library
from halfspace.context import Handle, _Keeper, held


def elsewhere(function):
    thread = threading.Thread(target=function)
    thread.start()
    thread.join(10)
    assert not thread.is_alive()


class WatchedLock:
    """Counts how often it is taken by a thread that does not have it yet."""

    def __init__(self):
        self.lock, self.depth, self.taken = threading.RLock(), 0, 0

    def acquire(self, blocking=True):
        got = self.lock.acquire(blocking)
        if got:
            self.taken += self.depth == 0
            self.depth += 1
        return got

    def release(self):
        self.depth -= 1
        self.lock.release()

    def __enter__(self):
        self.acquire()

    def __exit__(self, *_):
        self.release()


USES = {
    "pair_detect, a": lambda used, other: hs.pair_detect(used, (0, 0), other, (0.5, 0.5)),
    "pair_detect, b": lambda used, other: hs.pair_detect(other, (0, 0), used, (0.5, 0.5)),
    "pairs_detect": lambda used, other: hs.pairs_detect([other, used], [hs.pose((0, 0))] * 2, [(0, 1)]),
    "vertices": lambda used, other: used.vertices,
    "cut": lambda used, other: used.cut((0, 0), (1, 0)),
}


@pytest.mark.parametrize("together", [True, False], ids=["one context", "two contexts"])
@pytest.mark.parametrize("use", USES.values(), ids=USES)
def test_what_another_thread_closes_lasts_for_the_call(monkeypatch, together, use):
    ended, destroy, call = [], library.hs_shape_destroy, _Keeper.call
    monkeypatch.setattr(library, "hs_shape_destroy", lambda p: (ended.append(p), destroy(p)))
    context = hs.Context()
    other = hs.Shape.rectangle(1, 1, context=context)
    used = hs.Shape.rectangle(1, 1, context=context if together else hs.Context())
    assert used.properties.vertex_count == 4 and not ended
    pointer = used._pointer

    def call_after_the_end(keeper, function, *arguments):
        elsewhere(used.close)

        def checked(*given):
            assert not ended
            return function(*given)

        return call(keeper, checked, *arguments)

    monkeypatch.setattr(_Keeper, "call", call_after_the_end)
    use(used, other)
    monkeypatch.undo()
    with pytest.raises(hs.ClosedError):
        used.vertices
    hs.Shape.rectangle(1, 1, context=used.context)  # one call more
    assert pointer in ended


@pytest.mark.parametrize("together", [True, False], ids=["one context", "two contexts"])
@pytest.mark.parametrize("name", ["hs_block_def_init", "hs_world_add_block"])
def test_a_block_is_made_of_a_shape_that_lasts(monkeypatch, together, name):
    ended, destroy, function = [], library.hs_shape_destroy, getattr(library, name)
    monkeypatch.setattr(library, "hs_shape_destroy", lambda p: (ended.append(p), destroy(p)))
    context = hs.Context()
    world = hs.World(context=context)
    world.add_material(1)
    shape = hs.Shape.rectangle(1, 1, context=context if together else hs.Context())

    def after_the_end(*arguments):
        elsewhere(shape.close)
        assert not ended
        return function(*arguments)

    after_the_end.argtypes = function.argtypes
    monkeypatch.setattr(library, name, after_the_end)
    if name == "hs_block_def_init":
        with pytest.raises(hs.ClosedError, match="the shape is closed"):
            world.add_block(shape)
    else:
        world.block_vertices(world.add_block(shape))


def test_a_pose_is_read_before_the_pointers_are(square):
    used = hs.Shape.rectangle(1, 1)

    class Closing:
        def __array__(self, dtype=None, copy=None):
            used.close()
            return np.zeros(2)

    with pytest.raises(hs.ClosedError):
        hs.pair_detect(square, (0, 0), used, Closing())


TOGETHER = {
    "save": lambda world: world.save(),
    "blocks": lambda world: world.blocks,
    "poses": lambda world: world.poses,
    "contacts": lambda world: world.contacts(),
    "velocities": lambda world: world.velocities,
    "forces": lambda world: world.forces(0.0),
    "velocities of": lambda world: setattr(world, "velocities", np.zeros((2, 2))),
    "angular velocities of": lambda world: setattr(world, "angular_velocities", [0, 0]),
}


@pytest.mark.parametrize("act", TOGETHER.values(), ids=TOGETHER)
def test_no_other_thread_gets_in_between_calls_that_belong_together(monkeypatch, square, act):
    context = hs.Context()
    world = hs.World(context=context)
    world.add_material(1)
    for i in range(2):
        world.add_block(square, (i, 0))
    world.detect()
    lock = WatchedLock()
    monkeypatch.setattr(context._keeper, "lock", lock)
    act(world)
    assert (lock.taken, lock.depth) == (1, 0)


def test_a_handle_is_made_before_another_thread_can_close_the_context(monkeypatch):
    context, made, init = hs.Context(), [], Handle.__init__
    lock = WatchedLock()
    monkeypatch.setattr(context._keeper, "lock", lock)

    def watched_init(handle, *arguments):
        assert lock.depth > 0 and lock.taken == 1
        made.append(handle)
        init(handle, *arguments)

    monkeypatch.setattr(Handle, "__init__", watched_init)
    shape = hs.Shape.rectangle(1, 1, context=context)
    lock.taken = 0
    shape.cut((0, 0), (1, 0))
    lock.taken = 0
    world = hs.World(context=context)
    snapshot = world.save()
    lock.taken = 0
    hs.World.restore(snapshot, context=context)
    assert len(made) == 5


def test_a_context_is_not_closed_while_another_thread_makes_a_handle():
    context = hs.Context()
    closing = threading.Thread(target=context.close)
    with context._keeper.lock:
        closing.start()
        closing.join(0.1)
        shape = hs.Shape.rectangle(1, 1, context=context)
        assert not shape.closed
    closing.join(10)
    assert context.closed and shape.closed
    with pytest.raises(hs.ClosedError, match="the context is closed"):
        hs.Shape.rectangle(1, 1, context=context)


def test_two_contexts_are_held_in_one_order(monkeypatch):
    """Otherwise two threads with the same shapes in different orders would deadlock."""
    a, b = (hs.Shape.rectangle(1, 1, context=hs.Context()) for _ in range(2))
    locks = []

    class NotedLock(WatchedLock):
        def __enter__(self):
            locks.append(self)
            super().__enter__()

    for shape in (a, b):
        monkeypatch.setattr(shape._keeper, "lock", NotedLock())
    with held(a, b):
        pass
    with held(b, a):
        pass
    assert len(locks) == 4 and locks[:2] == locks[2:]


def poses_after_steps(threads):
    with hs.Context(threads=threads) as context:
        world = hs.World(context=context)
        material = world.add_material(2000)
        shape = hs.Shape.rectangle(1, 1, context=context)
        for i in range(400):
            kind = hs.BlockKind.FIXED if i < 20 else hs.BlockKind.RIGID
            place = (0.99 * (i % 20), 0.99 * (i // 20))
            world.add_block(shape, place, 0.01 * i, kind=kind, material=material)
        world.step(20)
        return np.array(world.poses)


def test_any_number_of_threads_finds_the_same_bits():
    alone = poses_after_steps(1)
    assert not np.array_equal(alone[:, :2], np.round(alone[:, :2], 2))  # something has moved
    for threads in (2, 3):
        assert np.array_equal(poses_after_steps(threads), alone)


def test_no_threads_are_refused():
    with pytest.raises(hs.HalfspaceError, match="threads is 0"):
        hs.Context(threads=0)
