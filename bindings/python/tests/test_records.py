"""Reports and states are records: all fields of the C structs, which they print by their names."""
import copy
import inspect
import pickle

import numpy as np
import pytest

import halfspace as hs
from halfspace import _raw, records
from halfspace._record import Record

CLASSES = [each for _, each in inspect.getmembers(records, inspect.isclass) if issubclass(each, Record)]
BALANCE = "Balance(mean=0.5, largest=0.0, largest_force=0.0, steps=7, largest_force_block=0)"
POSE = "Pose(position=[0., 0., 0.], rotation=[0., 0., 0., 0.])"


def struct_of(dtype):
    """The C struct of a record's data type."""
    (name,) = (name for name, each in vars(records).items() if each is dtype)
    return getattr(_raw, "hs_" + name.lower())


@pytest.mark.parametrize("dtype", [each for each in vars(records).values() if isinstance(each, np.dtype)], ids=str)
def test_a_record_has_all_fields_of_its_struct_where_c_has_them(dtype):
    struct = struct_of(dtype)
    assert dtype.names == tuple(name for name, *_ in struct._fields_)
    assert [dtype.fields[name][1] for name in dtype.names] == [getattr(struct, name).offset for name in dtype.names]
    described = [name for name in dtype.names if not name.startswith("reserved")]
    assert all(f"    {name} : " in dtype.type.__doc__ for name in described)
    text = repr(np.zeros(1, dtype)[0])
    assert text.startswith(dtype.type.__name__ + "(") and all(f"{name}=" in text for name in described)


def test_each_class_is_of_a_data_type():
    assert len(CLASSES) - 1 == sum(isinstance(each, np.dtype) for each in vars(records).values())  # but for Record


def test_short_records_are_one_line():
    balance = np.zeros(1, hs.BALANCE)[0]
    balance.mean, balance.steps = 0.5, 7
    assert repr(balance) == str(balance) == BALANCE
    assert balance.mean == balance["mean"] == 0.5  # not the method of NumPy


def test_records_in_records_and_constants_print_their_names():
    state = np.zeros(1, hs.BLOCK_STATE)[0]
    state.pose.rotation[3] = 1
    state.kind = hs.BlockKind.RIGID
    assert state["pose"]["rotation"][3] == 1 and repr(state.pose) == POSE.replace("0.])", "1.])")
    assert "\n    kind=BlockKind.RIGID,\n" in repr(state) and "\n    mass=0.0,\n)" in repr(state)
    assert state.kind is hs.BlockKind.RIGID and state["kind"] == 2
    state.kind = 77  # of a later version
    assert "kind=77" in repr(state) and state.kind == 77


def test_sums_of_constants_print_all_names():
    plan = np.zeros(1, records.WORLD_PLAN)[0]
    plan.parts = hs.WorldPart.FRICTION | hs.WorldPart.SLEEP
    assert "parts=WorldPart.FRICTION|SLEEP" in repr(plan)
    assert hs.WorldPart.SLEEP in plan.parts and hs.WorldPart.BONDS not in plan.parts


def test_tensors_are_rows():
    deformation = np.zeros(2, hs.DEFORMATION)[1]
    assert deformation.gradient.shape == (3, 3) and deformation.strain_energy == 0


def test_arrays_of_records_have_the_fields(falling_world):
    contacts = falling_world.contacts()
    assert {type(contacts[0]), type(contacts[contacts.gap < 0][0])} == {records.Contact}
    assert type(contacts.gap) is np.ndarray and contacts.gap.shape == (1,)
    contacts.gap = 3
    assert contacts[0].gap == 3
    with pytest.raises(AttributeError, match="Records has no attribute gaps_; similar: gaps, gap"):
        contacts.gaps_


def test_arrays_of_records_are_columns_of_numbers(falling_world):
    states = falling_world.states()
    columns = states.columns()
    assert all(column.shape == (2,) and column.dtype.names is None for column in columns.values())
    for name, values in (
        ("mass", states.mass),
        ("velocity[1]", states.velocity[:, 1]),
        ("pose.position[1]", states["pose"]["position"][:, 1]),
    ):
        assert columns[name].tolist() == values.tolist()
    assert falling_world.deformations().columns()["gradient[0, 0]"].tolist() == [1, 1]
    assert falling_world.bonds().columns()["area"].shape == (0,)


def test_pandas_takes_the_columns(falling_world):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(falling_world.contacts().columns())
    assert table["gap"][0] == falling_world.contacts().gap[0] and table["normal[1]"][0] == 1


def test_copies_are_records(falling_world):
    report = falling_world.report
    for other in (copy.copy(report), copy.deepcopy(report), pickle.loads(pickle.dumps(report))):
        assert type(other) is records.WorldReport and other.steps == report.steps
        assert type(other.energy) is records.Energy


@pytest.fixture
def falling_world():
    world = hs.World(law=hs.Law(normal_stiffness=1e7))
    world.add_material(density=2000)
    world.add_block(hs.Shape.rectangle(4, 1), (0, -0.5), kind="fixed")
    world.add_block(hs.Shape.rectangle(1, 1), (0, 0.499))
    world.step(2)
    return world
