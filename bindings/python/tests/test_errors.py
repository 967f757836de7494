"""Failed calls raise exceptions with the text of the library, and the use of closed objects is safe."""
import copy
import gc
import os
import pickle
import subprocess
import sys
import threading

import numpy as np
import pytest

import halfspace as hs
from halfspace import _raw


def test_an_error_carries_status_and_text():
    with pytest.raises(hs.GeometryError, match=r"hs_polygon_create: vertices\[2\] = \(1, 0.5\)") as caught:
        hs.Shape.polygon([(0, 0), (2, 0), (1, 0.5), (2, 2), (0, 2)])
    assert caught.value.status == _raw.HS_ERROR_GEOMETRY
    assert caught.value.message == str(caught.value)
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, hs.HalfspaceError)


@pytest.mark.parametrize(
    "error, natural",
    [
        (hs.ArgumentError, ValueError),
        (hs.GeometryError, ValueError),
        (hs.StaleIdError, LookupError),
        (hs.OutOfMemoryError, MemoryError),
        (hs.StateError, RuntimeError),
        (hs.UnstableError, ArithmeticError),
        (hs.FormatError, ValueError),
        (hs.InternalError, RuntimeError),
    ],
)
def test_errors_are_natural_ones_too(error, natural):
    assert issubclass(error, natural)
    again = pickle.loads(pickle.dumps(error(-1, "text")))
    assert type(again) is error and (again.status, again.message) == (-1, "text")


def test_every_status_has_its_exception():
    from halfspace.errors import _ERROR_OF_STATUS

    statuses = {value for name, value in vars(_raw).items() if name.startswith("HS_ERROR_")}
    assert statuses == set(_ERROR_OF_STATUS)
    assert hs.status_text(_raw.HS_ERROR_UNSTABLE).startswith("the run became unstable")


def test_an_unstable_run_stays_at_the_last_good_step(square):
    world = hs.World(gravity=(0, 0), time_step=0.002, law=hs.Law(normal_stiffness=1e9))
    world.add_material(1)
    world.add_block(hs.Shape.rectangle(8, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    world.add_block(square, (0, 0.499999))
    with pytest.raises(hs.UnstableError, match="time step 0.002, stable time step"):
        world.step(100)
    assert np.isfinite(world.poses).all()


def test_a_stale_id_is_refused(resting_world):
    block = int(resting_world.blocks[1])
    resting_world.remove_block(block)
    with pytest.raises(LookupError, match="no living block"):
        resting_world.state(block)


def test_what_is_closed_says_so(square):
    with hs.Context() as context:
        mine = hs.Shape.rectangle(1, 2, context=context)
        world = hs.World(context=context)
        assert mine.volume == 2
    assert context.closed and mine.closed and world.closed
    with pytest.raises(hs.ClosedError, match="the world is closed"):
        world.step()
    with pytest.raises(hs.ClosedError, match="the shape is closed"):
        hs.pair_detect(square, (0, 0), mine, (0, 0))
    with pytest.raises(hs.ClosedError, match="the context is closed"):
        hs.World(context=context)
    world.close()
    context.close()
    assert "closed" in repr(world) + repr(mine) + repr(context)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, pickle.dumps])
def test_what_has_no_copy_says_so(square, copied):
    for one, name in ((square, "Shape"), (square.context, "Context")):
        with pytest.raises(TypeError, match=f"a {name} cannot be copied or pickled; make another one"):
            copied(one)


def test_a_context_lives_as_long_as_what_it_owns():
    context = hs.Context()
    shape = hs.Shape.rectangle(1, 1, context=context)
    del context
    gc.collect()
    assert shape.cut((0, 0), (1, 0))[0].volume == 0.5


def test_a_world_keeps_its_own_copy_of_a_shape(resting_world):
    with hs.Shape.rectangle(0.5, 0.5) as small:
        block = resting_world.add_block(small, (0, 3))
    assert len(resting_world.block_vertices(block)) == 4
    resting_world.step(10)


def test_threads_with_contexts_of_their_own_and_with_one_together():
    def run(context, results, i):
        world = hs.World(time_step=1e-3, law=hs.Law(normal_stiffness=1e6), context=context)
        world.add_material(1000)
        for k in range(20):
            world.add_block(hs.Shape.rectangle(1, 1, context=context), (0.1 * k, 1.01 * k))
            gc.collect(0)
        for _ in range(50):
            world.step(4)
        results[i] = world.poses

    for contexts in ([hs.Context() for _ in range(4)], [hs.Context()] * 4):
        results = [None] * 4
        threads = [threading.Thread(target=run, args=(c, results, i)) for i, c in enumerate(contexts)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert all(np.array_equal(result, results[0]) for result in results)


def test_dropped_while_another_thread_is_in_a_call(square):
    context = hs.Context()
    shape = hs.Shape.rectangle(1, 1, context=context)
    keeper = context._keeper
    holding, done = threading.Event(), threading.Event()

    def hold():
        with keeper.lock:
            holding.set()
            done.wait(10)

    thread = threading.Thread(target=hold)
    thread.start()
    holding.wait(10)
    del shape  # does not wait for the other thread
    gc.collect()
    assert len(keeper._abandoned) == 1
    done.set()
    thread.join()
    hs.Shape.rectangle(2, 2, context=context)
    assert len(keeper._abandoned) == 0


@pytest.mark.parametrize(
    "path, text", [("/nowhere/libhalfspace.so", "HALFSPACE_LIBRARY"), ("libm.so.6", "another version")]
)
def test_a_library_that_cannot_be_used_is_an_import_error(path, text):
    environment = {**os.environ, "HALFSPACE_LIBRARY": path}
    run = subprocess.run(
        [sys.executable, "-c", "import halfspace"], capture_output=True, text=True, env=environment
    )
    assert run.returncode == 1
    assert "ImportError" in run.stderr and text in run.stderr and path in run.stderr


def test_a_library_of_another_minor_version_is_an_import_error():
    program = """
import importlib.util, pathlib, sys
folder = pathlib.Path(importlib.util.find_spec("halfspace").origin).parent
raw = (folder / "_raw.py").read_text(encoding="utf-8").replace('SONAME = "libhalfspace.so.', 'SONAME = "libhalfspace.so.7.')
class OtherInterface:
    def find_spec(self, name, path=None, target=None):
        return importlib.util.spec_from_loader(name, self) if name == "halfspace._raw" else None
    def create_module(self, spec):
        return None
    def exec_module(self, module):
        exec(raw, module.__dict__)
sys.meta_path.insert(0, OtherInterface())
import halfspace
"""
    environment = {**os.environ, "HALFSPACE_LIBRARY": str(hs._library.library._name)}
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=environment)
    assert run.returncode == 1
    assert f"has version {hs.version()}; required: 7." in run.stderr


def test_what_ended_with_the_interpreter_says_so():
    program = """
import atexit

def late():  # registered first, called last
    for use in (lambda: shape.vertices, lambda: world.step(), lambda: hs.Shape.rectangle(1, 1)):
        try:
            use()
        except hs.ClosedError as error:
            print(error)

atexit.register(late)
import halfspace as hs
shape, world = hs.Shape.rectangle(1, 1), hs.World()
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.split("\n")[:3] == [f"the {name} is closed" for name in ("shape", "world", "context")]


def test_the_interpreter_may_end_during_a_call():
    program = """
import threading, halfspace as hs
world, stepping = hs.World(time_step=1e-3), threading.Event()
world.add_material(1)
for i in range(400):
    world.add_block(hs.Shape.rectangle(1, 1), (i, 0))

def run():
    stepping.set()
    world.step(10**9)

threading.Thread(target=run, daemon=True).start()
stepping.wait()
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr


def test_the_end_of_the_interpreter_is_quiet():
    program = "import halfspace as hs; s = hs.Shape.box(1, 1, 1); w = hs.World(3); w.add_material(1); w.add_block(s)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (0, "")


WORLD_2D = hs.World(law=hs.Law(normal_stiffness=1e7))


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda: hs.World(law=hs.Law(normal_stiffness="stiff")), TypeError, "normal_stiffness is 'stiff': must be real"),
        (lambda: hs.World(time_step="1"), TypeError, "time_step is '1': must be real number"),
        (lambda: hs.World(law={"friction_angle": 0.5}), TypeError, "law is {'friction_angle': 0.5}; it must be a Law"),
        (lambda: hs.World(gravity=(0, 0, -9.81)), ValueError, r"gravity is \(0.0, 0.0, -9.81\); its z must be 0 in 2D"),
        (lambda: WORLD_2D.set_gravity((0, -9, 1)), ValueError, r"gravity is \(0.0, -9.0, 1.0\); its z must be 0 in 2D"),
        (lambda: WORLD_2D.add_material("heavy"), TypeError, "hs_world_add_material: 'heavy' is of a wrong type"),
        (lambda: WORLD_2D.set_damping(None), TypeError, "hs_world_set_damping: None is of a wrong type"),
        (lambda: WORLD_2D.relax("fine"), TypeError, "ratio is 'fine': must be real number"),
        (lambda: WORLD_2D.add_block([[0, 0], [1, 0], [0, 1]], (0, 0)), TypeError, "is no object of the library, such as"),
        (lambda: WORLD_2D.add_blocks([None]), TypeError, "None is no object of the library, such as a Shape"),
        (lambda: WORLD_2D.cast_ray("here", (0, -1)), ValueError, "origin: could not convert string to float: 'here'"),
        (lambda: hs.Shape.polygon(([0, 0], [1], [0, 1])), ValueError, "vertices: setting an array element with a seq"),
        (lambda: hs.Shape.polygon((i, i) for i in range(3)), TypeError, "vertices: float"),
        (lambda: hs.Shape.hull("abc"), ValueError, "points: could not convert string to float: 'abc'"),
        (lambda: hs.Shape.rectangle(None, 1), ValueError, "width is None; it must be above 0 and finite"),
        (lambda: hs.stack((1, 1), -3), ValueError, "count is -3; it must be at least 0"),
    ],
)
def test_arguments_of_a_wrong_type_are_named(call, kind, text):
    with pytest.raises(kind, match=text):
        call()
