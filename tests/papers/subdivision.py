"""Li et al. 2015, section 5, along one dimension: what becomes of the momentum of two bars that collide.

Each bar is one element, whose two nodes have half its mass each. From the touch on both bars are divided: at the
distance that a wave runs in the rest dt2 of the step. The two parts move in short steps between the initial nodes,
whose velocities are fixed (step 3); their forces on the initial nodes are given back to them (step 5). The text does
not say whose mass the node between has. Here the initial nodes keep theirs, as their own step needs: what the node
between takes up or gives off is no momentum of the bars.
"""
import numpy as np

MODULUS, DENSITY, STEP, SPEED = 4e10, 2700, 5e-4, 3  # those of section 6
WAVE = (MODULUS / DENSITY) ** 0.5
COURANT = 0.5


class Bar:
    """A bar of one element, divided; its nodes from the contact outwards."""

    def __init__(self, length, divided, velocity):
        self.mass_of_node = DENSITY * length / 2
        sizes = np.array([divided, length - divided])
        self.stiffness = MODULUS / sizes
        self.mass_between = DENSITY * sizes.sum() / 2
        self.shortest = sizes.min()
        self.displacement = np.zeros(3)
        self.outer = self.between = velocity

    def advance(self, contact, step):
        """Moves the parts; returns their forces on the node at the contact and on the outer one."""
        self.displacement += np.array([contact, self.between, self.outer]) * step
        near, far = self.stiffness * np.diff(self.displacement)
        self.between += (far - near) / self.mass_between * step
        return np.array([near, -far])


def momentum_of_bars(lengths, share, steps=40):
    """Momentum after each step until the bars separate, over that of the striker. `share` is dt2 over the step."""
    divided = WAVE * share * STEP
    striker, struck = (Bar(length, divided, velocity) for length, velocity in zip(lengths, (SPEED, 0)))
    both = striker.mass_of_node + struck.mass_of_node
    contact = SPEED * striker.mass_of_node / both  # equation 4
    momenta = []
    for step in range(steps):
        duration = STEP if step else share * STEP
        count = int(np.ceil(duration * WAVE / (COURANT * min(striker.shortest, struck.shortest))))
        forces = sum(np.array([bar.advance(contact, duration / count) for bar in (striker, struck)])
                     for _ in range(count)) / count
        for bar, (_, on_outer) in zip((striker, struck), forces):
            bar.outer += on_outer / bar.mass_of_node * duration
        acceleration = forces[:, 0].sum() / both  # equation 11
        contact += acceleration * duration
        momenta.append((striker.mass_of_node * striker.outer + struck.mass_of_node * struck.outer + both * contact)
                       / (2 * striker.mass_of_node * SPEED))
        if struck.mass_of_node * acceleration < forces[1, 0]:  # tension, equation 6
            break
    return np.array(momenta)
