#!/usr/bin/python3
"""The angle of repose of a heap: fits a line to its surface on the left and on the right of the summit.

Usage: slope.py DIR, DIR being the output of `halfspace run full.toml -o DIR` or small.toml.

The surface is the highest point of any grain in each of a row of upright strips, two grains wide. Of each flank the
middle part counts, between 15 % and 85 % of the summit's height: the rounded summit and the thin toe are no slope.
"""
import pathlib
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

MOVING = (2, 3)  # the kinds of rigid and affine blocks, as in halfspace/world.h


def read_grains(path):
    """The vertices of each block that moves freely."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())[:, :2]
    offsets = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    nodes = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    kind = vtk_to_numpy(data.GetCellData().GetArray("kind"))
    return [points[nodes[offsets[i]:offsets[i + 1]]] for i in range(len(kind)) if kind[i] in MOVING]


def surface(grains):
    """Middle and height of each strip that holds part of a grain's outline."""
    size = np.median([np.ptp(grain[:, 0]) for grain in grains])
    left = min(grain[:, 0].min() for grain in grains)
    right = max(grain[:, 0].max() for grain in grains)
    edges = np.linspace(left, right, max(8, int((right - left) / (2 * size))) + 1)
    heights = np.zeros(len(edges) - 1)
    for grain in grains:
        for x, y in grain:
            strip = min(np.searchsorted(edges, x, side="right") - 1, len(heights) - 1)
            heights[strip] = max(heights[strip], y)
    return (edges[:-1] + edges[1:]) / 2, heights


def flank_angle(x, height, summit):
    """Angle in degrees of the least-squares line through the middle part of a flank, and how many strips it has."""
    chosen = (height > 0.15 * summit) & (height < 0.85 * summit)
    if chosen.sum() < 3:
        return float("nan"), int(chosen.sum())
    return abs(np.degrees(np.arctan(np.polyfit(x[chosen], height[chosen], 1)[0]))), int(chosen.sum())


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    frames = sorted(pathlib.Path(sys.argv[1], "frames").glob(
        "frame_*.vtp"), key=lambda path: int(path.stem.split("_")[1]))
    if not frames:
        sys.exit(f"no frames in {sys.argv[1]}/frames")
    x, height = surface(read_grains(frames[-1]))
    top = int(height.argmax())
    print(f"{frames[-1].name}: summit {height[top]:.3f} m at x = {x[top]:.3f} m, heap from {x[0]:.2f} to {x[-1]:.2f} m")
    for side, part in (("left", slice(None, top + 1)), ("right", slice(top, None))):
        angle, strips = flank_angle(x[part], height[part], height[top])
        print(f"{side} slope {angle:.1f} degrees ({strips} strips)")


if __name__ == "__main__":
    main()
