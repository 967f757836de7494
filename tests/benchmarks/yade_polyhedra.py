"""Times YADE's polyhedra on the bin that `bench_polyhedra --write bin.txt` has left.

Run by YADE itself:  BIN=bin.txt yade-double -n -x yade_polyhedra.py
Prints microseconds per body and step on one core.
"""

import os
import time

from yade import polyhedra_utils, utils  # noqa: F401
from yade.minieigenHP import Vector3

STEPS, PASSES = 20, 5

with open(os.environ["BIN"]) as file:
    width, depth, height = map(float, file.readline().split())
    grains = [list(map(float, line.split())) for line in file]

material = PolyhedraMat(density=2500, young=1e7, poisson=0.3, frictionAngle=0.5)
O.materials.append(material)
for grain in grains:
    corners = [Vector3(*grain[i:i + 3]) for i in range(0, len(grain), 3)]
    O.bodies.append(polyhedra_utils.polyhedra(material, v=corners))
for axis, place in ((0, 0), (0, width), (1, 0), (1, depth), (2, 0)):
    O.bodies.append(utils.wall(place, axis=axis, sense=0, material=material))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Polyhedra_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Wall_Polyhedra_PolyhedraGeom(), Ig2_Polyhedra_Polyhedra_PolyhedraGeom()],
        [Ip2_PolyhedraMat_PolyhedraMat_PolyhedraPhys()],
        [Law2_PolyhedraGeom_PolyhedraPhys_Volumetric()],
    ),
    NewtonIntegrator(damping=0.2, gravity=(0, 0, -9.81)),
]
O.dt = 1e-5
O.run(5, True)

costs = []
for _ in range(PASSES):
    start = time.process_time()
    O.run(STEPS, True)
    costs.append((time.process_time() - start) / (STEPS * len(grains)) * 1e6)
contacts = sum(1 for i in O.interactions if i.isReal) / len(grains)
print("YADE: %d bodies, %.1f us per body and step (median %.1f), %.2f contacts a body"
      % (len(grains), min(costs), sorted(costs)[PASSES // 2], contacts))
