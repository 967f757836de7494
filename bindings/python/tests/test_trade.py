"""Error against cost, of a block that falls and of one that slides."""
import math

import pytest

import halfspace as hs
from halfspace.trade import grid, trade

SLOPE, FRICTION = math.radians(30), math.radians(20)
WAY = 0.5 * 9.81 * (math.sin(SLOPE) - math.cos(SLOPE) * math.tan(FRICTION)) * 0.25


def sliding(stiffness=1e8, **settings):
    """A block on a plane with inclined gravity."""
    gravity = (9.81 * math.sin(SLOPE), -9.81 * math.cos(SLOPE), 0)
    law = hs.Law(normal_stiffness=stiffness, friction_angle=FRICTION)
    world = hs.World(gravity=gravity, law=law, **settings)
    world.add_material(2000)
    world.add_block(hs.Shape.rectangle(20, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    world.add_block(hs.Shape.rectangle(1, 1), (0, 0.5))
    return world


def way_of(world):
    """Extrapolated to the duration, which is seldom a whole number of steps."""
    state = world.state(world.blocks[1])
    return state.pose.position[0] + (0.5 - world.time) * state.velocity[0]


def test_stiffer_springs_are_nearer():
    found = trade(sliding, way_of, duration=0.5, reference=WAY, settings=grid(stiffness=[1e6, 1e7, 1e8]))
    assert [trial.setting for trial in found.trials] == [{"stiffness": k} for k in (1e6, 1e7, 1e8)]
    errors = [trial.error for trial in found.trials]
    assert errors[0] > 5 * errors[1] > 25 * errors[2]
    assert found.cheapest(1.01 * errors[2]).error <= 1.01 * errors[2]
    assert found.cheapest(errors[2] / 2) is None
    assert all(trial.cost > 0 for trial in found.trials)
    front = found.front()
    assert [t.error for t in front] == sorted((t.error for t in front), reverse=True)
    assert [t.cost for t in front] == sorted(t.cost for t in front)


def test_without_a_reference_the_finest_run_is_it():
    found = trade(sliding, way_of, duration=0.5)
    assert [trial.setting["safety"] for trial in found.trials] == [1, 0.5, 0.25, 0.125]
    assert found.reference == pytest.approx(WAY, rel=1e-3)
    assert found.scale == found.reference


def test_unstable_runs_have_no_value():
    settings = grid(stiffness=[1e12], time_step=[2e-5, 5e-3])
    found = trade(sliding, way_of, duration=0.5, reference=WAY, settings=settings)
    whole, unstable = found.trials
    assert whole.is_whole and not unstable.is_whole and math.isnan(unstable.error)
    assert unstable not in found.front()
    with pytest.raises(ValueError, match="no run reached the end"):
        trade(sliding, way_of, duration=0.5, settings=settings[1:])


def test_a_duration_of_nothing_is_refused():
    with pytest.raises(ValueError, match="duration is 0"):
        trade(sliding, way_of, duration=0)


def test_a_record_is_gone_on_with(tmp_path):
    record = tmp_path / "trade.json"
    begun = []

    def counted(stiffness):
        begun.append(stiffness)
        return sliding(stiffness=stiffness)

    def run(values, **options):
        return trade(
            counted, way_of, duration=0.5, reference=WAY, settings=grid(stiffness=values), record=record, **options
        )

    nothing = run([1e6, 1e7], budget=0)
    assert nothing.trials == [] and nothing.left_out == grid(stiffness=[1e6, 1e7]) and begun == []
    first = run([1e6])
    assert set(begun) == {1e6}
    begun.clear()
    both = run([1e6, 1e7])
    assert set(begun) == {1e7}
    assert both.trials[0] == first.trials[0] and both.left_out == []
    # Stored runs use no budget.
    assert len(run([1e6, 1e7, 1e8], budget=0).trials) == 2
    with pytest.raises(ValueError, match="holds no trade of 0.25 s"):
        trade(counted, way_of, duration=0.25, settings=grid(stiffness=[1e6]), record=record)


def test_a_budget_is_0_or_more():
    with pytest.raises(ValueError, match="budget is -1"):
        trade(sliding, way_of, duration=0.5, budget=-1)
