"""Scenes with meshes: boxes and Gmsh files, groups, supports, loads, bodies that break, and what is written of them."""
import re

import vtk

from command import SceneTest, main

HEAD = """title = "{title}"
dimension = {dimension}

[world]
gravity = {gravity}

[[material]]
name = "rock"
density = 2500
young_modulus = 10e9
poisson_ratio = {poisson}
{plane}

[[material]]
name = "soft_rock"
density = 2000
young_modulus = 5e9
poisson_ratio = {poisson}
{plane}

[[material]]
name = "ground"
density = 2500

[default_law]
stiffness = "per area"
normal_stiffness = 1e11
friction_angle = 30
"""

SETTLE = """
[[stage]]
do = "settle"
ratio = 1e-9
"""


def head(title, dimension=2, gravity="[0, 0]", poisson=0, plane='plane = "stress"'):
    return HEAD.format(title=title, dimension=dimension, gravity=gravity, poisson=poisson, plane=plane)


def gmsh(version, nodes, elements, names):
    """A file of nodes {tag: place} and elements (dimension, group, type, nodes), with names {(dimension, group): name}."""
    lines = ["$MeshFormat", f"{version} 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names))]
    lines += [f'{dimension} {group} "{name}"' for (dimension, group), name in names.items()]
    lines += ["$EndPhysicalNames"]
    groups = sorted({(dimension, group) for dimension, group, _, _ in elements})
    if version == "4.1":
        counts = [sum(d == dimension for d, _ in groups) for dimension in range(4)]
        lines += ["$Entities", " ".join(map(str, counts))]
        for dimension, group in groups:  # one entity a group, with another tag than the group's
            box = "0 0 0" if dimension == 0 else "0 0 0 9 9 9"
            physical = f"1 {group}" if group else "0"
            lines += [f"{group + 70} {box} {physical}" + (" 0" if dimension else "")]
        lines += ["$EndEntities", "$Nodes", f"1 {len(nodes)} 1 {max(nodes)}", f"2 1 0 {len(nodes)}"]
        lines += [str(tag) for tag in nodes] + [" ".join(map(str, place)) for place in nodes.values()]
        lines += ["$EndNodes", "$Elements", f"{len(elements)} {len(elements)} 1 {len(elements)}"]
        for tag, (dimension, group, kind, corners) in enumerate(elements, 1):
            lines += [f"{dimension} {group + 70} {kind} 1", " ".join(map(str, [tag, *corners]))]
    else:
        lines += ["$Nodes", str(len(nodes))]
        lines += [" ".join(map(str, [tag, *place])) for tag, place in nodes.items()]
        lines += ["$EndNodes", "$Elements", str(len(elements))]
        for tag, (_, group, kind, corners) in enumerate(elements, 1):
            lines += [" ".join(map(str, [tag, kind, 2, group, 7, *corners]))]
    return "\n".join(lines + ["$EndElements", ""])


# A bar of a square and two triangles, of two materials, held at the left and pulled at the right. Node 50 is the
# centre of an arc, in no cell; the square and one triangle run clockwise.
BAR_NODES = {1: (0, 0, 0), 2: (1, 0, 0), 3: (2, 0, 0), 11: (0, 1, 0), 12: (1, 1, 0), 13: (2, 1, 0), 50: (9, 9, 0)}
BAR_ELEMENTS = [(1, 1, 1, (1, 11)), (1, 2, 1, (3, 13)), (2, 3, 3, (1, 11, 12, 2)),
                (2, 4, 2, (2, 13, 3)), (2, 4, 2, (2, 13, 12)), (0, 5, 15, (1,)), (1, 0, 1, (1, 2))]
BAR_NAMES = {(1, 1): "held", (1, 2): "pulled", (2, 3): "stiff part", (2, 4): "soft part", (0, 5): "corner"}

BAR = """
[[mesh]]
name = "bar"
material = "rock"
file = "bar.msh"
scale = 0.5

[[mesh.group]]
name = "soft part"
material = "soft_rock"

[[mesh.support]]
group = "held"
axes = "x"

[[mesh.support]]
group = "corner"
axes = "y"

[[mesh.load]]
group = "pulled"
traction = [1e6, 0]
pressure = -1e6

[output]
tracked = ["bar.0", "bar.1", "bar.2"]
"""


def box(name, low, high, cells, cell, more=""):
    return f"""
[[mesh]]
name = "{name}"
material = "rock"
box = [{low}, {high}]
cells = {cells}
cell = "{cell}"
{more}
"""


class Meshes(SceneTest):
    def last_row(self):
        return {key: float(value) for key, value in self.rows()[-1].items()}

    def test_a_cantilever_of_a_box_bends_as_timoshenko_says(self):
        self.run_scene(head("A cantilever", poisson=0.25)
                       + box("beam", [0, 0], [10, 1], [40, 4], "quad",
                             '[[mesh.support]]\ngroup = "left"\n[[mesh.load]]\ngroup = "right"\ntraction = [0, -1e5]')
                       + SETTLE)
        # The work of the load, half of force times displacement, is in the cells: F2 L3 / 6 E I + F2 L / 2 k G A.
        # A clamped end that cannot contract is stiffer by some 1 %.
        work = 1e5**2 * 1000 / (6 * 10e9 / 12) + 1e5**2 * 10 / (2 * 5 / 6 * 4e9)
        self.assertAlmostEqual(self.last_row()["block_strain"] / work, 1, delta=0.012)

    def test_a_gmsh_file_of_either_version_with_its_groups(self):
        histories = []
        for version in "2.2", "4.1":
            (self.directory / "bar.msh").write_text(gmsh(version, BAR_NODES, BAR_ELEMENTS, BAR_NAMES))
            told = self.run_scene(head("A bar") + BAR + SETTLE).stdout
            self.assertIn("3 cells of 1 mesh\n", told.replace(")", ""))
            row = self.last_row()
            for cell in range(3):  # 2 MPa; Cauchy's stress of a bar that is stretched by 2e-4 to 4e-4
                self.assertAlmostEqual(row[f"bar.{cell}.sxx"] / 2e6, 1, delta=1e-3)
                self.assertAlmostEqual(row[f"bar.{cell}.syy"] / 2e6, 0, delta=1e-6)
            # The soft part is stretched by 4e-4, so that the middle of its last cell has moved by that of the stiff one
            # and two thirds of its own; Green's strain is larger than that of engineers by half its square.
            self.assertAlmostEqual(row["bar.1.x"] - 0.5 * (1 + 2 / 3), 0.5 * (2e-4 + 2 / 3 * 4e-4), delta=2e-7)
            histories.append((self.output / "history.csv").read_text())
        self.assertEqual(*histories)

    def test_a_cell_that_is_listed_for_each_of_its_groups_is_one(self):
        twice = BAR_ELEMENTS + [(2, 6, 3, (1, 11, 12, 2))]
        (self.directory / "bar.msh").write_text(gmsh("2.2", BAR_NODES, twice, BAR_NAMES | {(2, 6): "again"}))
        self.assertIn("3 cells of 1 mesh", self.run_scene(head("A bar") + BAR + SETTLE).stdout)

    def test_boxes_in_space_under_pressure(self):
        for cell in "tetrahedron", "prism", "hexahedron":
            with self.subTest(cell=cell):
                self.run_scene(head("A pillar", 3, "[0, 0, 0]", plane="")
                               + box("pillar", [0, 0, 0], [1, 1, 2], [2, 2, 3], cell,
                                     '[[mesh.support]]\nbox = [[-1, -1, 0], [2, 2, 0]]\naxes = "z"\n'
                                     '[[mesh.support]]\ngroup = "left"\naxes = "x"\n'
                                     '[[mesh.support]]\ngroup = "front"\naxes = "y"\n'
                                     '[[mesh.load]]\ngroup = "top"\npressure = 3e6')
                               + SETTLE + '[output]\ntracked = ["pillar.0", "pillar.7"]')
                row = self.last_row()
                for name in "pillar.0", "pillar.7":
                    self.assertAlmostEqual(row[name + ".szz"] / -3e6, 1, delta=1e-3)
                    self.assertAlmostEqual(row[name + ".sxx"] / 3e6, 0, delta=1e-6)

    def test_a_body_of_cells_breaks_and_its_cracks_are_told(self):
        told = self.run_scene(head("A slab on a wedge", gravity="[0, -9.81]", plane="").replace("[world]", "[world]\nduration = 0.1") + """
[[bond]]
between = ["rock", "rock"]
normal_stiffness = 1e12
tensile_strength = 2e5
cohesion = 4e5
friction_angle = 30

[[block]]
name = "wedge"
kind = "fixed"
material = "ground"
vertices = [[0, -1], [2, -1], [1, 0]]
""" + box("slab", [-1, 0.001], [3, 1], [8, 2], "triangle", 'bodies = "cells"\nvelocity = [0, -2]') + """
[output]
contacts = true
[output.picture]
forces = true
""").stdout
        self.assertIn("32 cells of 32 meshes", told)
        events = self.rows("cracks.csv")
        self.assertGreater(len(events), 0)
        self.assertEqual({event["failure"] for event in events} - {"tension", "shear"}, set())
        self.assertTrue(all(event["block_a"].startswith("slab.") for event in events))
        area, energy = map(float, re.search(r"cracks of (\S+) m, fracture energy (\S+) J", told).groups())
        self.assertAlmostEqual(sum(float(event["area"]) for event in events) / area, 1, delta=1e-3)
        self.assertAlmostEqual(sum(float(event["energy"]) for event in events) / energy, 1, delta=1e-3)
        self.assertTrue((self.output / "contacts.pvd").exists())

    def test_bodies_of_groups_rest_on_the_ground_with_their_weight(self):
        (self.directory / "bar.msh").write_text(gmsh("4.1", BAR_NODES, BAR_ELEMENTS, BAR_NAMES))
        told = self.run_scene(head("Two bodies", gravity="[0, -10]") + """
[[block]]
name = "floor"
kind = "fixed"
material = "ground"
vertices = [[-1, -1], [3, -1], [3, 0], [-1, 0]]

[[mesh]]
name = "bar"
material = "rock"
file = "bar.msh"
bodies = "groups"
[[mesh.group]]
name = "soft part"
material = "soft_rock"

[output]
contacts = true
""" + SETTLE).stdout
        self.assertIn("3 cells of 2 meshes", told)
        on_floor = [row for row in self.rows("contacts.csv") if "floor" in (row["block_a"], row["block_b"])]
        force = sum(abs(float(row["force_y"])) for row in on_floor)
        self.assertAlmostEqual(force / (10 * (2500 + 2000)), 1, delta=1e-4)

    def test_files_are_read_by_vtk(self):
        self.test_bodies_of_groups_rest_on_the_ground_with_their_weight()
        reader = vtk.vtkXMLPolyDataReader()
        frame = sorted((self.output / "frames").glob("contacts_*.vtp"))[-1]
        reader.SetFileName(str(frame))
        reader.Update()
        points = reader.GetOutput()
        self.assertEqual(points.GetNumberOfCells(), len(self.rows("contacts.csv")))
        forces = points.GetCellData().GetArray("normal_force")
        self.assertEqual([forces.GetValue(i) for i in range(points.GetNumberOfCells())],
                         [float(row["normal_force"]) for row in self.rows("contacts.csv")])
        reader.SetFileName(str(sorted((self.output / "frames").glob("frame_*.vtp"))[-1]))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), 4)  # the floor and three cells
        self.assertEqual(reader.GetOutput().GetCellData().GetArray("stress").GetNumberOfComponents(), 9)

    def weight_on_floor(self, text):
        self.run_scene(text + SETTLE.replace("1e-9", "1e-7") + "[output]\ncontacts = true\n")
        axis = "force_z" if "dimension = 3" in text else "force_y"
        return sum(abs(float(row[axis])) for row in self.rows("contacts.csv")
                   if "floor" in (row["block_a"], row["block_b"]))

    def test_blocks_are_cut_into_cells_that_fill_them(self):
        floor = ('[[block]]\nname = "floor"\nkind = "fixed"\nmaterial = "ground"\n'
                 'vertices = [[-1, -1], [5, -1], [5, 0], [-1, 0]]\n')
        trapezium = ('[[block]]\nname = "stone"\nmaterial = "rock"\nkind = "mesh"\ncell_size = {}\ncell = "{}"\n'
                     'vertices = [[0, 0], [3, 0], [2, 1], [1, 1]]\n')
        for size, cell, count in (9, "quad", 4), (0.5, "quad", 36), (0.5, "triangle", 72):
            with self.subTest(size=size, cell=cell):
                weight = self.weight_on_floor(head("A stone", gravity="[0, -10]", plane="") + floor
                                              + trapezium.format(size, cell))
                self.assertIn(f"{count} cells of 1 mesh", (self.output / "summary.txt").read_text())
                self.assertAlmostEqual(weight / (10 * 2500 * 2), 1, delta=1e-4)

    def test_joint_sets_make_blocks_of_cells(self):
        weight = self.weight_on_floor(head("A column", gravity="[0, -10]", plane="") + """
[[block]]
name = "floor"
kind = "fixed"
material = "ground"
vertices = [[-1, -1], [5, -1], [5, 0], [-1, 0]]

[[jointed_rock]]
name = "column"
material = "rock"
kind = "mesh"
cell_size = 0.5
box = [[0, 0], [1, 3]]
[[jointed_rock.joint_set]]
dip = 0
spacing = 1
offset = 0
""")
        self.assertIn("12 cells of 3 meshes", (self.output / "summary.txt").read_text())
        self.assertAlmostEqual(weight / (10 * 2500 * 3), 1, delta=1e-4)

    def test_solids_are_cut_into_hexahedra_or_tetrahedra(self):
        solids = {"box": ([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], 64, 1),
                  "wedge": ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], 6 * 27, 0.5),
                  "pyramid": ([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]], 16, 1 / 3)}
        for name, (vertices, count, volume) in solids.items():
            with self.subTest(solid=name):
                weight = self.weight_on_floor(head(name, 3, "[0, 0, -10]", plane="") + f"""
[[block]]
name = "floor"
kind = "fixed"
material = "ground"
vertices = [[-1, -1, -1], [2, -1, -1], [2, 2, -1], [-1, 2, -1], [-1, -1, 0], [2, -1, 0], [2, 2, 0], [-1, 2, 0]]

[[block]]
name = "stone"
material = "rock"
kind = "mesh"
cell_size = 0.26
vertices = {vertices}
""")
                self.assertIn(f"{count} cells of 1 mesh", (self.output / "summary.txt").read_text())
                self.assertAlmostEqual(weight / (10 * 2500 * volume), 1, delta=1e-4)

    def test_faults_name_their_key(self):
        (self.directory / "bar.msh").write_text(gmsh("2.2", BAR_NODES, BAR_ELEMENTS, BAR_NAMES))
        whole = head("A bar") + BAR + SETTLE
        for old, new, fault in [
            ('group = "held"', 'group = "heldd"', r'mesh\[0\]\.support\[0\]\.group: no such group: "heldd"; allowed: held, pulled'),
            ('group = "held"', 'group = ""', r"mesh\[0\]\.support\[0\]\.group: empty; allowed: a string of at least one letter"),
            ('axes = "x"', 'axes = "xx"', r'mesh\[0\]\.support\[0\]\.axes: "xx"; allowed'),
            ('name = "soft part"', 'name = "corner"', r"mesh\[0\]\.group\[0\]\.name: no cell is in this group"),
            ('material = "soft_rock"', 'material = "ground"', r'group\[0\]\.material: the material "ground" is not elastic'),
            ('group = "pulled"', 'group = "corner"', r"mesh\[0\]\.load\[0\]\.group: no outer face is in it"),
            ('group = "pulled"', 'box = [[5, 5], [6, 6]]', r"mesh\[0\]\.load\[0\]\.box: no outer face is in it"),
            ('"bar.msh"', '"rab.msh"', r"mesh\[0\]\.file: no such file: .*rab\.msh"),
            ('file = "bar.msh"\nscale = 0.5', 'box = [[0, 0], [1, 1]]\ncells = [2]', r"mesh\[0\]\.cells: out of range: .*2 whole numbers"),
            ('file = "bar.msh"\nscale = 0.5', 'box = [[0, 0], [0, 1]]\ncells = [2, 2]', r"mesh\[0\]\.box: not a box"),
            ('tracked = ["bar.0"', 'tracked = ["bar.3"', r'output\.tracked: no such block: "bar\.3"'),
        ]:
            self.assertIn(old, whole)
            self.check_fault(whole.replace(old, new, 1), fault)

    def test_faults_of_files(self):
        for change, fault in [
            ((BAR_NODES | {13: (2, 1, 0.1)}, BAR_ELEMENTS), "nodes at different z"),
            ((BAR_NODES, [e for e in BAR_ELEMENTS if e[0] < 2]), "no cell; allowed in 2D"),
            ((BAR_NODES | {13: (2, 0, 0)}, BAR_ELEMENTS), "bar.msh:27: a cell without an area"),
        ]:
            (self.directory / "bar.msh").write_text(gmsh("2.2", *change, BAR_NAMES))
            self.check_fault(head("A bar") + BAR + SETTLE, re.escape(fault))


if __name__ == "__main__":
    main()
