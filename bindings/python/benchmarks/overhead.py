"""Overhead of the binding relative to C: the same calls on the same world of 1e5 blocks, alternately by a C loop and
by Python.

    overhead.py BASELINE [--quick]    BASELINE: the library made of bindings/calls_in_c.c

Two figures for each call. Side by side: the median of the ratios of consecutive measurements, with a scatter of about
1 %. By itself: Python's time minus C's for the call on a world of two blocks, which is the overhead of the binding
independent of the number of blocks, divided by the time of the call on the large world.
"""
import argparse
import ctypes
import statistics
import time

import numpy as np

import halfspace as hs
from halfspace import _raw
from halfspace._arrays import mutable_view_of


def brick_wall(count):
    """Squares in rows on a floor with small overlaps: all are in contact."""
    rows = max(1, round((count / 10) ** 0.5))
    columns = -(-count // rows)
    world = hs.World(time_step=1e-5, law=hs.Law(normal_stiffness=1e7, friction_angle=0.5))
    world.add_material(2000)
    world.add_block(hs.Shape.rectangle(columns + 2, 1), (0.5 * columns, -0.5), kind=hs.BlockKind.FIXED)
    square = hs.Shape.rectangle(1, 1)
    for i in range(count):
        row, column = divmod(i, columns)
        world.add_block(square, (column * 1.001 + 0.25 * (row % 2), 0.5 + row * 0.9999))
    world.step(1)
    return world


def seconds(call, calls):
    start = time.thread_time()
    for _ in range(calls):
        call()
    return time.thread_time() - start


class Calls:
    """The three calls on a world, by Python and by C."""

    def __init__(self, world, baseline):
        self.forces, self.torques = np.empty((len(world), 2)), np.empty((len(world), 3))
        self.poses = world.poses
        arrays = mutable_view_of(self.forces, 2, "forces"), mutable_view_of(self.torques, 3, "torques")
        self.python = {
            "step": world.step,
            "detect": lambda: self.set_and_detect(world),
            "forces": lambda: world.forces(0.0, self.forces, self.torques),
        }
        self.c = {
            "step": lambda calls: baseline.seconds_of_step(world._alive, calls),
            "detect": lambda calls: baseline.seconds_of_detect(
                world._alive, calls, self.poses.ctypes.data, len(self.poses)
            ),
            "forces": lambda calls: baseline.seconds_of_forces(world._alive, calls, *arrays),
        }

    def set_and_detect(self, world):
        world.poses = self.poses  # without a change there is nothing to detect
        world.detect()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("baseline")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    baseline = ctypes.CDLL(arguments.baseline)
    for name in ("seconds_of_step", "seconds_of_detect", "seconds_of_forces"):
        function = getattr(baseline, name)
        function.restype = ctypes.c_double
        function.argtypes = [ctypes.POINTER(_raw.hs_world), ctypes.c_int64]
    baseline.seconds_of_detect.argtypes += [ctypes.c_void_p, ctypes.c_int64]
    baseline.seconds_of_forces.argtypes += [_raw.hs_mutable_view] * 2

    blocks, rounds, small_calls = (2000, 5, 200) if arguments.quick else (100_000, 25, 5000)
    large_world, small_world = brick_wall(blocks), brick_wall(1)
    large, small = Calls(large_world, baseline), Calls(small_world, baseline)
    print(f"{len(large_world)} blocks, {len(large_world.contacts())} contacts")
    print(f"{'call':8}{'C, ms':>10}{'side by side':>15}{'by itself, us':>16}{'share':>10}")
    for name in large.python:
        pairs = [(large.c[name](1), seconds(large.python[name], 1)) for _ in range(rounds)]
        c_time = statistics.median(c for c, _ in pairs)
        ratio = statistics.median(python / c for c, python in pairs) - 1
        small_pairs = [
            (small.c[name](small_calls), seconds(small.python[name], small_calls)) for _ in range(5)
        ]
        own = (min(python for _, python in small_pairs) - min(c for c, _ in small_pairs)) / small_calls
        print(f"{name:8}{1e3 * c_time:10.3f}{100 * ratio:14.2f}%{1e6 * own:16.2f}{100 * own / c_time:9.4f}%")


if __name__ == "__main__":
    main()
