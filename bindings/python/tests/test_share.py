"""A world cut into shares moves with the bits of the whole one; errors name their argument."""
import numpy as np
import pytest

import halfspace as hs


def heap():
    """40 grains that fall on a floor."""
    world = hs.World(time_step=5e-4, law=hs.Law(1e7, friction_angle=0.4), local_damping=0.1)
    stone = world.add_material(2500)
    world.add_block(hs.Shape.rectangle(14, 1), (5, -0.5), kind="fixed")
    for i in range(40):
        angles = np.arange(3 + i % 5) * 2 * np.pi / (3 + i % 5)
        grain = hs.Shape.hull(0.35 * np.column_stack([np.cos(angles), np.sin(angles)]))
        world.add_block(grain, (0.72 * (i % 13), 0.45 + 0.72 * (i // 13)), 0.7 * i, material=stone, velocity=(0.5, -2))
    return world


def total(plans):
    """The plans of all shares as one."""
    needs_list, needs_assembly = max(plan.needs_list for plan in plans), max(plan.needs_assembly for plan in plans)
    return needs_list, needs_assembly, min(plan.refusal for plan in plans)


class Host:
    """Two shares, left and right of a cut, with copies of the neighbours within a halo."""

    def __init__(self, world):
        self.shares = [world, world]  # the same world, of which the first cut makes two
        self.owner = np.zeros(len(world), int)  # per key
        self.migrations = self.assemblies = 0
        self.assemble()
        for share in self.shares:
            share.begin()
        self.carry_loads()
        for share in self.shares:
            share.end_begin()

    def places(self):
        """x of all blocks, by key, and whether they are everywhere."""
        x, everywhere = np.empty(len(self.owner)), np.zeros(len(self.owner), bool)
        for share in self.shares:
            known = share.roles != hs.Role.NEIGHBOR
            x[share.keys[known]] = share.positions[known, 0]
            everywhere[share.keys] = share.roles == hs.Role.EVERYWHERE
        return x, everywhere

    def assemble(self):
        x, everywhere = self.places()
        halo = max(share.share_info().halo for share in self.shares)
        owner = np.where(x < np.median(x[~everywhere]), 0, 1)
        self.migrations += int(np.sum((owner != self.owner)[~everywhere]))
        shares = []
        self.copies = []  # keys per share
        for i, share in enumerate(self.shares):
            own = x[~everywhere & (owner == i)]
            is_near = (x >= own.min() - halo) & (x <= own.max() + halo)
            copies = np.flatnonzero(~everywhere & (owner != i) & is_near)
            self.copies.append(copies)
            keys = np.sort(np.concatenate([copies, np.flatnonzero(everywhere | (owner == i))]))
            shares.append(share.assemble([self.packed(key, i, owner[key] == i, everywhere[key]) for key in keys]))
        self.shares, self.owner = shares, owner
        self.assemblies += 1

    def packed(self, key, share, is_own, is_everywhere):
        role = hs.Role.EVERYWHERE if is_everywhere else hs.Role.OWN if is_own else hs.Role.NEIGHBOR
        if is_everywhere or (is_own and share == self.owner[key]):
            return hs.Packed(key, role)
        return hs.Packed(key, role, self.shares[self.owner[key]].pack([key])[0])

    def carry_loads(self):
        for share, other, copies in zip(self.shares, reversed(self.shares), self.copies):
            share.set_loads(copies, other.loads(copies))

    def step(self):
        needs_list, needs_assembly, refusal = total([share.plan_motion() for share in self.shares])
        if needs_list or needs_assembly:
            self.assemble()
            again, _, refusal = total([share.plan_motion() for share in self.shares])
            if needs_list or again:
                _, _, refusal = total([share.renew_list() for share in self.shares])
        assert refusal == 0, hs.status_text(refusal)
        for share in self.shares:
            share.move()
        self.carry_loads()
        for share in self.shares:
            share.end_step()

    def joined(self):
        first, second = self.shares
        of_second = second.keys[second.roles == hs.Role.OWN]
        packed = [hs.Packed(key, data=data) for key, data in zip(of_second, second.pack(of_second))]
        kept = [hs.Packed(key, role) for key, role in zip(first.keys, first.roles) if role != hs.Role.NEIGHBOR]
        world = first.assemble(sorted(packed + kept, key=lambda block: block.key))
        world.sums = first.sums + second.sums
        return world


def test_two_shares_move_with_the_bits_of_the_whole_world():
    whole = heap()
    host = Host(whole)
    for _ in range(500):
        host.step()
    whole.step(500)
    assert whole.report.contact_count > 10
    assert host.assemblies > 1 and host.migrations > 0
    for share in host.shares:
        info = share.share_info()
        assert info.lost_pairs == 0 and not info.is_whole and info.neighbor_count > 0

    joined = host.joined()
    assert joined.share_info().is_whole
    assert (joined.keys == np.arange(41)).all()
    assert joined.poses.tobytes() == whole.poses.tobytes()
    for of_joined, of_whole in zip(joined.get_velocities(), whole.get_velocities()):
        assert of_joined.tobytes() == of_whole.tobytes()
    free = whole.keys[whole.roles == hs.Role.OWN]
    assert joined.pack(free) == whole.pack(free)
    energies = slice(16)  # the others are powers
    assert joined.sums[energies] == pytest.approx(whole.sums[energies], rel=0, abs=1e-12 * np.abs(whole.sums).max())

    whole.step(100)
    joined.step(100)
    assert joined.poses.tobytes() == whole.poses.tobytes()


def test_keys_name_blocks():
    world = heap()
    assert (world.keys == np.arange(41)).all()
    world.keys = 100 + 2 * np.arange(41)
    assert world.keys[[0, -1]].tolist() == [100, 180]
    assert world.roles.tolist() == [hs.Role.EVERYWHERE] + 40 * [hs.Role.OWN]
    without = world.pack([102, 180], with_shapes=False)
    assert len(without) == 2 and len(world.pack([180])[0]) > len(without[1])
    assert world.pack([]) == []
    with pytest.raises(hs.ArgumentError, match=r"keys\[1\] is 1"):
        world.keys = [1, 1, *range(2, 41)]
    with pytest.raises(ValueError, match="64-bit"):
        world.pack([0.5])
    with pytest.raises(hs.StaleIdError, match=r"keys\[0\] is 7"):
        world.pack([7])


def test_bad_blocks_and_loads_are_refused():
    world = heap()
    with pytest.raises(hs.ArgumentError, match=r"blocks\[1\].key is 0"):
        world.assemble([hs.Packed(1), hs.Packed(0)])
    with pytest.raises(hs.FormatError, match=r"blocks\[0\].bytes"):
        world.assemble([hs.Packed(1, "neighbor", b"no block")])
    with pytest.raises(hs.StateError, match="hs_world_begin"):
        world.loads([1])
    with pytest.raises(ValueError, match=r"it must be \(1, 3\)"):
        world.set_loads([1], [[1.0, 2.0]])
    with pytest.raises(ValueError, match=r"it must be \(27,\)"):
        world.sums = [0.0]
    share = world.assemble([hs.Packed(0, "everywhere"), hs.Packed(1)])
    assert share.share_info().own_count == 1
    again = hs.World.restore(share.save())
    assert again.keys.tolist() == [0, 1] and not again.share_info().is_whole
    share.sums = share.sums
    with pytest.raises(hs.StateError):
        share.step(1)
