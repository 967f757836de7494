"""A host with its own arrays and its own integrator; the library computes contacts and forces only.

A block of 5 x 4 m slides down a slope of 30 degrees (Wang et al. 2021, section 4.1): s = 1/2 (g sin - g cos
tan(friction)) t^2. The relative error must be below 1e-3.

    own_integrator.py [--output DIR]    the folder is not used, as this program writes no files
"""
import argparse
import sys

import numpy as np

import halfspace as hs

SLOPE, FRICTION, GRAVITY = np.radians(30), np.radians(20), 9.81
DENSITY, STIFFNESS = 2500.0, 1e10
TIME_STEP, DURATION = 1e-4, 5.0


def quaternions(angles):
    """Quaternions of rotations about z."""
    turned = np.zeros((len(angles), 4))
    turned[:, 2], turned[:, 3] = np.sin(0.5 * angles), np.cos(0.5 * angles)
    return turned


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output")
    parser.parse_args()

    downhill = np.array([np.cos(SLOPE), -np.sin(SLOPE)])
    upward = np.array([np.sin(SLOPE), np.cos(SLOPE)])
    plane, block = hs.Shape.rectangle(300, 1), hs.Shape.rectangle(5, 4)
    mass = DENSITY * block.volume
    inertia = DENSITY * block.properties.second_moment[:2].sum()

    # The host's state: the plane, then the block in equilibrium on its springs, with overlap and a forward tilt, as
    # friction acts at its base, 2 m below the centroid. Springs of half the stiffness at both corners resist the
    # tilt.
    normal_force = mass * GRAVITY * np.cos(SLOPE)
    friction_force = normal_force * np.tan(FRICTION)
    depth = normal_force / STIFFNESS
    tilt = (2 - depth) * friction_force / (STIFFNESS * 5**2 / 4 - normal_force * 2)
    position = np.array([-0.5 * upward, (2 - depth) * upward])
    angle = np.array([-SLOPE, -SLOPE - tilt])
    velocity, spin = np.zeros((2, 2)), np.zeros(2)
    acceleration, turning = np.zeros((2, 2)), np.zeros(2)
    moves = np.array([0.0, 1.0])  # the plane is fixed

    # The library's world has shapes, materials and laws; the host has gravity and time.
    law = hs.Law(normal_stiffness=STIFFNESS, shear_stiffness=STIFFNESS, friction_angle=FRICTION)
    world = hs.World(gravity=(0, 0), time_step=TIME_STEP, law=law)
    world.add_material(DENSITY)
    floor_id = world.add_block(plane, position[0], angle[0], kind=hs.BlockKind.FIXED)
    block_id = world.add_block(block, position[1], angle[1])
    world.detect()
    world.set_shear_force(floor_id, block_id, -friction_force * downhill)

    poses = np.zeros((2, 7))
    forces, torques = np.zeros((2, 2)), np.zeros(2)

    def evaluate_forces():
        poses[:, :2], poses[:, 3:] = position, quaternions(angle)
        world.poses = poses
        world.set_velocities(velocity, spin)
        world.detect()
        world.forces(TIME_STEP, forces, torques)
        acceleration[:] = moves[:, None] * (forces / mass + (0, -GRAVITY))
        turning[:] = moves * torques / inertia

    start = position[1].copy()
    evaluate_forces()
    for _ in range(round(DURATION / TIME_STEP)):  # velocity Verlet
        velocity += 0.5 * TIME_STEP * acceleration
        spin += 0.5 * TIME_STEP * turning
        position += TIME_STEP * velocity
        angle += TIME_STEP * spin
        evaluate_forces()
        velocity += 0.5 * TIME_STEP * acceleration
        spin += 0.5 * TIME_STEP * turning

    slide = (position[1] - start) @ downhill
    exact = 0.5 * GRAVITY * (np.sin(SLOPE) - np.cos(SLOPE) * np.tan(FRICTION)) * DURATION**2
    error = slide / exact - 1
    print(f"slide {slide:.6f} m, by the formula {exact:.6f} m: relative error {error:.2e}")
    return int(abs(error) > 1e-3)


if __name__ == "__main__":
    sys.exit(main())
