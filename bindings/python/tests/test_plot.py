"""Pictures by matplotlib, which is optional."""
import subprocess
import sys

import pytest

import halfspace as hs

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")


@pytest.fixture
def axes():
    from matplotlib.figure import Figure

    return Figure().add_subplot()


def test_a_world_with_its_contacts(resting_world, axes):
    resting_world.step(500)
    assert resting_world.plot(axes) is axes
    blocks, contacts = axes.collections
    assert len(blocks.get_paths()) == 2 and len(contacts.get_segments()) == 1
    (lower, upper) = contacts.get_segments()[0]
    assert lower[0] == pytest.approx(upper[0], abs=1e-3) and lower[1] < 0 < upper[1]
    left, right = axes.get_xlim()
    assert left <= -2 and right >= 2
    axes.figure.canvas.draw()


def test_what_moves_freely_is_not_painted_as_fixed(axes):
    world = hs.World()
    stone = world.add_material(1)
    world.set_elasticity(stone, hs.Elasticity(young_modulus=1e6))
    for i, kind in enumerate((hs.BlockKind.FIXED, hs.BlockKind.PRESCRIBED, hs.BlockKind.RIGID, hs.BlockKind.AFFINE)):
        world.add_block(hs.Shape.rectangle(1, 1), (2 * i, 0), kind=kind)
    fixed, prescribed, rigid, affine = (tuple(colour) for colour in world.plot(axes).collections[0].get_facecolors())
    assert fixed == prescribed and rigid == affine and fixed != rigid


def test_without_contacts(resting_world, axes):
    resting_world.step(500)
    resting_world.plot(axes, contacts=False)
    assert len(axes.collections) == 1


def test_a_pair(square, axes):
    from halfspace.plot import plot_pair

    place = hs.pose((0.25, 0.9), 0.005)
    contact = hs.pair_detect(square, (0, 0), square, place)
    assert contact.point_count == 2
    plot_pair(square, (0, 0), square, place, contact, axes)
    axes.figure.canvas.draw()


def test_a_notebook_shows_a_world(resting_world):
    assert resting_world._repr_png_()[:8] == b"\x89PNG\r\n\x1a\n"
    assert hs.World()._repr_png_() is None
    assert hs.World(3)._repr_png_() is None


def test_a_world_in_space_with_its_contacts():
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    world = hs.World(3, law=hs.Law(normal_stiffness=1e8), time_step=1e-3)
    world.add_material(2000)
    world.add_block(hs.Shape.box(4, 4, 1), (0, 0, -0.5), kind="fixed")
    world.add_blocks(hs.stack((1, 1, 1), 2))
    world.step(10)
    axes = Figure().add_subplot(projection="3d")
    assert world.plot(axes) is axes
    fixed, free, contacts = axes.collections
    FigureCanvasAgg(axes.figure).draw()
    assert len(fixed.get_facecolors()) == 6 and len(free.get_facecolors()) == 12
    assert len(contacts.get_segments()) == 2
    assert axes.get_xlim() == (-2, 2) and axes.get_zlim() == (-1, pytest.approx(2, abs=1e-3))
    assert world._repr_png_()[:4] == b"\x89PNG"
    assert len(hs.World(3).plot().collections) == 0


def test_matplotlib_is_optional():
    program = (
        "import sys; sys.modules['matplotlib'] = None\n"
        "import halfspace as hs; w = hs.World(); w.add_material(1); w.add_block(hs.Shape.rectangle(1, 1))\n"
        "assert w._repr_png_() is None"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def test_a_short_axis_has_few_labels():
    world = hs.World(3)
    world.add_material(density=2000)
    world.add_block(hs.Shape.box(12, 4, 1))
    ax = world.plot()
    assert len(ax.get_yticks()) <= 5 and len(ax.get_zticks()) <= 4
