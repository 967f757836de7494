"""Energy that a run makes or loses, as the summary tells it."""
from command import SceneTest, main

SQUARE = """dimension = 2
world = {{ duration = 1, time_step = 0.005, gravity = [0, -10] }}
material = [{{ name = "stone", density = 2000 }}]
default_law = {{ {law}, friction_angle = 35 }}
output.history_interval = 0.005
[[block]]
name = "floor"
material = "stone"
kind = "fixed"
vertices = [[-9, -1], [9, -1], [9, 0], [-9, 0]]
[[block]]
name = "square"
material = "stone"
vertices = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
rotation = {rotation}
shift = [0, 0.9]
velocity = [{speed}, -1]
angular_velocity = {spin}
"""


class Energy(SceneTest):
    def test_impacts_that_lose_energy_make_none(self):
        """Friction turns a square as it strikes by a corner. It does work then, and the impact loses as much more."""
        for rotation, speed, spin in (40, 0.5, -80), (-20, 0.8, 60), (15, -0.3, 90), (-40, -0.9, -30):
            with self.subTest(rotation=rotation):
                text = SQUARE.format(law='stiffness = "none"', rotation=rotation, speed=speed, spin=spin)
                told = self.run_scene(text).stdout
                self.assertNotIn("ENERGY CREATED", told)
                self.assertNotIn("note: energy residual", told)
                losses = [float(row["friction_loss"]) for row in self.rows()]
                self.assertEqual(losses, sorted(losses))

    def test_rebounds_with_friction_make_none(self):
        """By Newton's rule of restitution alone, half of these squares would rise higher than they fell."""
        for restitution in 0.5, 0.9, 1:
            for k in range(8):
                rotation, speed, spin = 11 * k - 41, 0.3 * k - 1, 40 * (-1) ** k * (k % 3)
                with self.subTest(restitution=restitution, rotation=rotation):
                    law = f'stiffness = "none", restitution = {restitution}'
                    told = self.run_scene(SQUARE.format(law=law, rotation=rotation, speed=speed, spin=spin)).stdout
                    self.assertNotIn("ENERGY CREATED", told)
                    self.assertNotIn("note: energy residual", told)
                    energies = [float(row["kinetic"]) + float(row["gravity"]) for row in self.rows()]
                    self.assertLess(max(energies), energies[0] + 1e-3 * (energies[0] - min(energies) + 1))

    def test_a_residual_above_1_percent_is_noted(self):
        """Springs this soft let the square through the floor, where the contact plane jumps."""
        law = 'stiffness = "per contact", normal_stiffness = 1e4'
        told = self.run_scene(SQUARE.format(law=law, rotation=0, speed=0, spin=0)).stdout
        self.assertRegex(told, r"note: energy residual: the numerical method has (created|lost) \S+ of the energy released; "
                               r"usual: below 0\.01")
        stiff = 'stiffness = "per contact", normal_stiffness = 1e7, normal_damping = 0.3'
        told = self.run_scene(SQUARE.format(law=stiff, rotation=0, speed=0, spin=0)).stdout
        self.assertNotIn("note: energy residual", told)


if __name__ == "__main__":
    main()
