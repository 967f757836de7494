"""Builds and steps scenes in YADE for engine_yade.cpp. Run by YADE itself, with two pipes."""
import itertools
import os
import time

from yade import polyhedra_utils
from yade.minieigenHP import Quaternion, Vector3

requests = os.fdopen(int(os.environ["TRADE_REQUESTS"]))
answers = os.fdopen(int(os.environ["TRADE_ANSWERS"]), "w")
rotations = []  # of each body: from YADE's own orientation to that of the scene


def world(stiffness, friction, density, damping, time_step, *gravity):
    """Stiffness in N/m^3 of overlap: two PolyhedraMat in series have half the young of each."""
    O.reset()
    rotations.clear()
    O.materials.append(PolyhedraMat(density=density, young=2 * stiffness, poisson=1, frictionAngle=friction))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Polyhedra_Aabb()], verletDist=0.02),
        InteractionLoop(
            [Ig2_Polyhedra_Polyhedra_PolyhedraGeom()],
            [Ip2_PolyhedraMat_PolyhedraMat_PolyhedraPhys()],
            [Law2_PolyhedraGeom_PolyhedraPhys_Volumetric()],
        ),
        NewtonIntegrator(damping=damping, gravity=gravity),
    ]
    O.dt = time_step
    return []


def body(is_fixed, *numbers):
    size, place, velocity, spin = (Vector3(*numbers[i:i + 3]) for i in (0, 3, 6, 9))
    x, y, z, w = numbers[12:]
    rotation = Quaternion(w, x, y, z)
    corners = [place + rotation * Vector3(*(0.5 * s * a for s, a in zip(signs, size)))
               for signs in itertools.product((-1, 1), repeat=3)]
    made = polyhedra_utils.polyhedra(O.materials[-1], v=corners)
    made.state.blockedDOFs = "xyzXYZ" if is_fixed else ""
    rotations.append(made.state.ori.conjugate() * rotation)
    made.state.vel, made.state.angVel = velocity, spin
    made.state.angMom = made.state.ori * Vector3(*(
        i * s for i, s in zip(made.state.inertia, made.state.ori.conjugate() * spin)))
    O.bodies.append(made)
    return []


def step(steps):
    start = time.process_time()
    O.run(int(steps), True)
    return [time.process_time() - start]


def state(number):
    now = O.bodies[int(number)].state
    rotation = now.ori * rotations[int(number)]
    return [*now.pos, rotation[0], rotation[1], rotation[2], rotation[3], *now.vel, *now.angVel]


for line in requests:
    verb, *numbers = line.split()
    answer = {"world": world, "body": body, "step": step, "state": state}[verb](*map(float, numbers))
    print(*answer, file=answers, flush=True)
