"""Runs the case files that all languages share (tests/cases/README.md) by the package."""
import numpy as np

import halfspace as hs
from halfspace import _raw


def statements(path):
    """Line number and words of each line with a statement, and the text after the second word."""
    for number, line in enumerate(path.read_text(encoding="ascii").splitlines(), 1):
        text = line.split("#")[0].strip()
        if text:
            yield number, text.split(), text.split(None, 2)[2:]


def cases(path):
    """Name and statements of each case."""
    name, body = None, []
    for number, words, rest in statements(path):
        if words[0] == "case":
            if name:
                yield name, body
            name, body = " ".join(words[1:]), []
        else:
            body.append((number, words, rest))
    yield name, body


def value(word):
    return getattr(_raw, word) if word.startswith("HS_") else float(word)


def numbers(words):
    return np.array([value(word) for word in words])


def fields(words, lengths=()):
    """FIELD VALUE ... as keyword arguments; a field in `lengths` has that many values."""
    found, i = {}, 0
    while i < len(words):
        count = dict(lengths).get(words[i], 1)
        values = numbers(words[i + 1 : i + 1 + count])
        found[words[i]] = values if count > 1 else values[0]
        i += 1 + count
    return found


class Player:
    def __init__(self):
        self.shapes, self.poses, self.motions, self.blocks, self.options = {}, {}, {}, {}, {}
        self.face_lists = []
        self.world = self.contact_found = self.impact_found = None

    def play(self, body):
        for i, (number, words, rest) in enumerate(body):
            if words[0] in ("refused", "expect"):
                if words[0] == "expect":
                    getattr(self, "expect_" + words[1])(number, words[2:])
                continue
            following = body[i + 1] if i + 1 < len(body) else (0, [""], [])
            if following[1][0] == "refused":
                self.refused(words, following)
            else:
                getattr(self, "call_" + words[0])(*words[1:])

    def refused(self, words, following):
        number, (_, status, *_), (text,) = following
        try:
            getattr(self, "call_" + words[0])(*words[1:])
        except hs.HalfspaceError as error:
            assert error.status == value(status) and text in str(
                error
            ), f"line {number}: {error.status}, {error}"
        else:
            raise AssertionError(f"line {number}: the call was not refused")

    # ---- calls ----

    def call_faces(self, *words):
        counts, self.face_lists = list(map(int, words)), []
        while counts:
            self.face_lists.append(counts[1 : 1 + counts[0]])
            counts = counts[1 + counts[0] :]

    def call_shape(self, name, kind, *words):
        if kind == "boundary":
            values = numbers(words)
            before, after = values[5:].reshape(-1, 2) if len(values) > 5 else (None, None)
            self.shapes[name] = hs.Shape.boundary(values[:2], values[2:4], values[4], before=before, after=after)
            return
        columns = 4 if kind == "halfspaces" else 2 if kind.startswith("polygon") else 3
        points = numbers(words).reshape(-1, columns)
        if kind == "polygon":
            self.shapes[name] = hs.Shape.polygon(points)
        elif kind == "polyhedron":
            self.shapes[name] = hs.Shape.polyhedron(points, self.face_lists)
        elif kind == "halfspaces":
            self.shapes[name] = hs.Shape.from_halfspaces(points[:, :3], points[:, 3])
        else:
            self.shapes[name] = hs.Shape.hull(points)

    def call_cut(self, name, *words):
        behind, ahead = self.shapes[name].cut(numbers(words[:3]), numbers(words[3:6]))
        self.shapes.update({words[6]: behind, words[7]: ahead})

    def call_options(self, *words):
        self.options.update(fields(words))

    def call_pose(self, name, *words):
        self.poses[name] = numbers(words)

    def call_pair(self, a, b):
        places = [self.poses.get(name, hs.pose((0, 0))) for name in (a, b)]
        self.contact_found = hs.pair_detect(
            self.shapes[a], places[0], self.shapes[b], places[1], **self.options
        )

    def call_motion(self, name, *words):
        lengths = {"velocity": 3, "angular_velocity": 3, "gradient": 9, "gradient_rate": 9}
        settings = fields(words, lengths)
        self.motions[name] = {
            field: values.reshape(3, 3) if len(values) == 9 else values for field, values in settings.items()
        }

    def call_impact(self, a, b, duration):
        motions = [
            hs.Motion(self.poses.get(name, hs.pose((0, 0))), **self.motions.get(name, {})) for name in (a, b)
        ]
        self.impact_found = hs.pair_time_of_impact(
            self.shapes[a], motions[0], self.shapes[b], motions[1], value(duration)
        )

    def call_world(self, *words):
        settings = fields(words, {"gravity": 3})
        self.world = hs.World(int(settings.pop("dimension", 2)), **settings)

    def call_material(self, density):
        self.world.add_material(value(density))

    def law_of(self, words):
        settings = fields(words)
        if "stiffness_kind" in settings:
            settings["stiffness_kind"] = hs.StiffnessKind(int(settings["stiffness_kind"]))
        return hs.Law(**settings)

    def call_default_law(self, *words):
        self.world.set_default_law(self.law_of(words))

    def call_law(self, a, b, *words):
        self.world.set_law(int(a), int(b), self.law_of(words))

    def call_elasticity(self, material, *words):
        settings = fields(words)
        if "plane" in settings:
            settings["plane"] = hs.Plane(int(settings["plane"]))
        self.world.set_elasticity(int(material), hs.Elasticity(**settings))

    def call_block(self, name, shape, kind, material, *words):
        place = numbers(words)
        self.blocks[name] = self.world.add_block(
            self.shapes[shape],
            place[:3],
            rotation=place[3:],
            kind=hs.BlockKind(value(kind)),
            material=int(material),
        )

    def call_set_pose(self, name, *words):
        self.world.set_pose(self.blocks[name], numbers(words))

    def call_velocity(self, name, *words):
        self.world.set_velocity(self.blocks[name], numbers(words[:3]), numbers(words[3:]))

    def call_applied_force(self, name, *words):
        self.world.set_applied_force(self.blocks[name], numbers(words[:3]), numbers(words[3:]))

    def call_set_deformation(self, name, *words):
        gradient, rate = numbers(words).reshape(2, 3, 3)
        self.world.set_deformation(self.blocks[name], gradient, rate)

    def call_set_stress(self, name, *words):
        self.world.set_stress(self.blocks[name], numbers(words).reshape(3, 3))

    def call_surface_load(self, name, face, *words):
        self.world.add_surface_load(self.blocks[name], int(face), numbers(words))

    def call_clear_surface_loads(self, name):
        self.world.clear_surface_loads(self.blocks[name])

    def call_remove(self, name):
        self.world.remove_block(self.blocks[name])

    def first_contact(self):
        contacts = self.world.contacts()
        if len(contacts) > 0:
            self.contact_found = contacts[0]

    def call_detect(self):
        self.world.detect()
        self.first_contact()

    def call_forces(self, elapsed):
        self.world.forces(value(elapsed))
        self.first_contact()

    def call_step(self, count):
        self.world.step(int(count))
        self.first_contact()

    def call_reopen(self):
        snapshot = self.world.save()
        self.world.close()
        self.world = hs.World.restore(snapshot)

    def call_restore(self, *words):
        hs.World.restore(bytes(map(int, words)))

    # ---- expectations ----

    def compare(self, number, record, words):
        field, *values = words
        within = values.index("within") if "within" in values else len(values)
        expected, tolerance = numbers(values[:within]), numbers(values[within + 1 :])
        got = np.ravel(record[field])
        assert got.shape == expected.shape, f"line {number}: {field} has {got.shape} values"
        allowed = tolerance if tolerance.size else 0.0
        assert np.all(
            np.abs(got - expected) <= allowed
        ), f"line {number}: {field} is {got}, expected {expected}"

    def expect_shape(self, number, words):
        self.compare(number, self.shapes[words[0]].properties, words[1:])

    def expect_contact(self, number, words):
        self.compare(number, self.contact_found, words)

    def expect_impact(self, number, words):
        self.compare(number, self.impact_found, words)

    def expect_block(self, number, words):
        state = self.world.state(self.blocks[words[0]])
        self.compare(number, state.pose if words[1] in ("position", "rotation") else state, words[1:])

    def expect_deformation(self, number, words):
        self.compare(number, self.world.deformation(self.blocks[words[0]]), words[1:])

    def expect_report(self, number, words):
        self.compare(number, self.world.report, words)

    def expect_energy(self, number, words):
        self.compare(number, self.world.energy, words)

    def expect_hash(self, number, words):
        result = 0xCBF29CE484222325
        for byte in self.world.poses.tobytes():
            result = ((result ^ byte) * 0x100000001B3) % 2**64
        assert f"{result:016x}" == words[0], f"line {number}: the hash is {result:016x}"
