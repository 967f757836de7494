"""Builds and steps scenes in YADE for engine_yade.cpp. Run by YADE itself, with two pipes."""
import itertools
import os
import time

from yade import polyhedra_utils
from yade.minieigenHP import Quaternion, Vector3

requests = os.fdopen(int(os.environ["TRADE_REQUESTS"]))
answers = os.fdopen(int(os.environ["TRADE_ANSWERS"]), "w")
turns = []  # of each body: what YADE's own turn is multiplied by


def world(stiffness, friction, density, damping, time_step, *gravity):
    """Stiffness in N/m^3 of overlap: that of two PolyhedraMat in a row is half the young of each."""
    O.reset()
    turns.clear()
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
    turn = Quaternion(w, x, y, z)
    corners = [place + turn * Vector3(*(0.5 * s * a for s, a in zip(signs, size)))
               for signs in itertools.product((-1, 1), repeat=3)]
    made = polyhedra_utils.polyhedra(O.materials[-1], v=corners)
    made.state.blockedDOFs = "xyzXYZ" if is_fixed else ""
    turns.append(made.state.ori.conjugate() * turn)
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
    turn = now.ori * turns[int(number)]
    return [*now.pos, turn[0], turn[1], turn[2], turn[3], *now.vel, *now.angVel]


for line in requests:
    verb, *numbers = line.split()
    answer = {"world": world, "body": body, "step": step, "state": state}[verb](*map(float, numbers))
    print(*answer, file=answers, flush=True)
