//! A world cut into two shares moves with the bits of the whole one; errors name their argument.

use halfspace::{
    Block, BlockDef, Context, ErrorKind, Law, Packed, Pose, Result, Role, Shape, SharePlan, Sums,
    World, WorldDef,
};

const GRAINS: usize = 24; // their keys are 1 to 24, that of the floor is 0

fn heap() -> Result<World> {
    let context = Context::new()?;
    let floor = Shape::polygon(
        &context,
        &[[-2.0, -1.0], [12.0, -1.0], [12.0, 0.0], [-2.0, 0.0]],
    )?;
    let grain = Shape::polygon(&context, &[[0.0, 0.0], [0.5, 0.0], [0.4, 0.5], [0.1, 0.6]])?;
    let def = WorldDef::in_plane().time_step(5e-4).local_damping(0.1);
    let mut world = World::new(&context, &def)?;
    world.set_default_law(&Law::default().normal_stiffness(1e7).friction_angle(0.4))?;
    let stone = world.add_material(2500.0)?;
    world.add_block(&floor, &BlockDef::fixed(stone))?;
    for i in 0..GRAINS {
        let (column, row) = ((i % 8) as f64, (i / 8) as f64);
        let pose = Pose::in_plane(0.55 * column, 0.4 + 0.55 * row, 0.7 * i as f64);
        let block = world.add_block(&grain, &BlockDef::rigid(stone).at(pose))?;
        world.set_velocity(block, [2.0 * (i % 3) as f64 - 2.0, -2.0, 0.0], [0.0; 3])?;
    }
    Ok(world)
}

/// The shares left and right of a cut, with copies of the neighbours within a halo.
struct Host {
    shares: [World; 2],
    owner: [usize; GRAINS + 1], // per key
    copies: [Vec<i64>; 2],
    assemblies: usize,
    migrations: usize,
}

impl Host {
    fn new(whole: &World) -> Result<Self> {
        let bytes = whole.save();
        let context = whole.context();
        let mut host = Host {
            shares: [
                World::restore(&context, &bytes)?,
                World::restore(&context, &bytes)?,
            ],
            owner: [0; GRAINS + 1],
            copies: Default::default(),
            assemblies: 0,
            migrations: 0,
        };
        host.cut()?;
        host.each(World::begin)?;
        host.carry_loads()?;
        host.each(World::end_begin)?;
        Ok(host)
    }

    fn each<T>(&mut self, call: impl Fn(&mut World) -> Result<T>) -> Result<[T; 2]> {
        let [left, right] = &mut self.shares;
        Ok([call(left)?, call(right)?])
    }

    /// Cuts the grains near their mean x. The cut goes to and fro, as by a balance of load.
    fn cut(&mut self) -> Result<()> {
        let mut x = [0.0; GRAINS + 1];
        let mut halo = 0.0_f64;
        for share in &mut self.shares {
            halo = halo.max(share.share_info().halo);
            let known = share.keys().into_iter().zip(share.roles());
            for ((key, role), pose) in known.zip(share.poses()) {
                if role == Role::Own {
                    x[key as usize] = pose.position[0];
                }
            }
        }
        let mean = x[1..].iter().sum::<f64>() / GRAINS as f64;
        let middle = mean + 0.4 * (self.assemblies % 2) as f64;
        let owner = x.map(|x| usize::from(x >= middle));
        let mut shares = Vec::new();
        for side in 0..2 {
            let own: Vec<f64> = (1..=GRAINS)
                .filter(|&k| owner[k] == side)
                .map(|k| x[k])
                .collect();
            let low = own.iter().copied().fold(f64::INFINITY, f64::min) - halo;
            let high = own.iter().copied().fold(f64::NEG_INFINITY, f64::max) + halo;
            self.copies[side] = (1..=GRAINS)
                .filter(|&k| owner[k] != side && low <= x[k] && x[k] <= high)
                .map(|k| k as i64)
                .collect();
            let is_own = |key: usize| owner[key] == side;
            shares.push(self.assembled(side, is_own, &self.copies[side].clone())?);
        }
        if self.assemblies > 0 {
            self.migrations += (1..=GRAINS).filter(|&k| owner[k] != self.owner[k]).count();
        }
        self.assemblies += 1;
        self.shares = shares.try_into().expect("two shares");
        self.owner = owner;
        Ok(())
    }

    /// A share of the grains that it keeps, and of those that the other packs for it.
    fn assembled(
        &mut self,
        side: usize,
        is_own: impl Fn(usize) -> bool,
        copies: &[i64],
    ) -> Result<World> {
        let mut packed = vec![None]; // the floor
        for key in 1..=GRAINS {
            let is_copy = copies.contains(&(key as i64));
            let is_sent = is_copy || (is_own(key) && self.owner[key] != side);
            let owner = &mut self.shares[self.owner[key]];
            packed.push(if is_sent {
                Some(owner.pack(&[key as i64], true)?.0)
            } else {
                None
            });
        }
        let role_of = |key: usize| match key {
            0 => Some(Role::Everywhere),
            _ if is_own(key) => Some(Role::Own),
            _ => packed[key].as_ref().map(|_| Role::Neighbor),
        };
        let blocks: Vec<Packed> = (0..=GRAINS)
            .filter_map(|key| {
                let (role, bytes) = (role_of(key)?, packed[key].as_deref());
                Some(Packed {
                    key: key as i64,
                    role,
                    bytes,
                })
            })
            .collect();
        self.shares[side].assemble(&blocks)
    }

    fn carry_loads(&mut self) -> Result<()> {
        for side in 0..2 {
            let loads = self.shares[1 - side].loads(&self.copies[side])?;
            self.shares[side].set_loads(&self.copies[side], &loads)?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<()> {
        let mut plans = self.each(World::plan_motion)?;
        let needs_list = |plans: &[SharePlan; 2]| plans.iter().any(|plan| plan.needs_list);
        let first = needs_list(&plans);
        if first || plans.iter().any(|plan| plan.needs_assembly) {
            self.cut()?;
            plans = self.each(World::plan_motion)?;
            if first || needs_list(&plans) {
                plans = self.each(World::renew_list)?;
            }
        }
        assert!(plans.iter().all(|plan| plan.refusal.is_none()), "{plans:?}");
        self.each(World::move_blocks)?;
        self.carry_loads()?;
        self.each(World::end_step)?;
        Ok(())
    }

    fn sums(&self) -> Sums {
        let [left, right] = [self.shares[0].sums(), self.shares[1].sums()];
        std::array::from_fn(|i| left[i] + right[i])
    }

    fn joined(mut self) -> Result<World> {
        let mut whole = self.assembled(0, |_| true, &[])?;
        whole.set_sums(&self.sums())?;
        Ok(whole)
    }
}

fn grains_of(world: &mut World) -> Result<Vec<u8>> {
    let keys: Vec<i64> = (1..=GRAINS as i64).collect();
    Ok(world.pack(&keys, true)?.0)
}

#[test]
fn two_shares_move_with_the_bits_of_the_whole_world() -> Result<()> {
    let mut whole = heap()?;
    let mut host = Host::new(&whole)?;
    for _ in 0..400 {
        host.step()?;
    }
    whole.step(400)?;
    assert!(host.assemblies > 1 && host.migrations > 0);
    for side in 0..2 {
        let info = host.shares[side].share_info();
        assert!(!info.is_whole && info.lost_pairs == 0 && info.everywhere_count == 1);
        assert_eq!(info.neighbor_count, host.copies[side].len());
        assert!(info.neighbor_count > 0);
    }

    let mut joined = host.joined()?;
    assert!(joined.share_info().is_whole);
    assert_eq!(joined.keys(), (0..=GRAINS as i64).collect::<Vec<_>>());
    assert_eq!(grains_of(&mut joined)?, grains_of(&mut whole)?);
    let (sums, expected) = (joined.sums(), whole.sums());
    let energies = 0..16; // the others are powers
    let largest = expected[energies.clone()]
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    for i in energies {
        assert!(
            (sums[i] - expected[i]).abs() <= 1e-12 * largest,
            "sums[{i}]"
        );
    }

    whole.step(50)?;
    joined.step(50)?;
    assert_eq!(grains_of(&mut joined)?, grains_of(&mut whole)?);
    Ok(())
}

#[test]
fn keys_name_blocks() -> Result<()> {
    let mut world = heap()?;
    let keys: Vec<i64> = (0..=GRAINS as i64).map(|key| 10 * key).collect();
    world.set_keys(&keys)?;
    assert_eq!(world.keys(), keys);
    assert_eq!(world.roles()[..2], [Role::Everywhere, Role::Own]);
    let (bytes, ends) = world.pack(&[10, 240], false)?;
    assert!(ends[0] < ends[1] && ends[1] == bytes.len());
    assert!(bytes.len() < world.pack(&[10, 240], true)?.0.len());
    let error = world.set_keys(&[1, 1]).unwrap_err();
    assert!(error.to_string().contains("count is 2"), "{error}");
    let error = world.pack(&[7], true).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::StaleId);
    Ok(())
}

#[test]
fn bad_blocks_and_loads_are_refused() -> Result<()> {
    let mut world = heap()?;
    let damaged = Packed {
        key: 1,
        role: Role::Neighbor,
        bytes: Some(b"no block"),
    };
    assert_eq!(
        world.assemble(&[damaged]).unwrap_err().kind(),
        ErrorKind::Format
    );
    let own = |key| Packed {
        key,
        role: Role::Own,
        bytes: None,
    };
    let error = world.assemble(&[own(1), own(1)]).unwrap_err();
    assert!(error.to_string().contains("blocks[1].key is 1"), "{error}");
    let error = world.set_loads(&[1], &[0.0; 2]).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("loads has 2 numbers; 1 keys take 3"),
        "{error}"
    );
    assert_eq!(world.move_blocks().unwrap_err().kind(), ErrorKind::State);

    let error = world.assemble(&[own(1), own(2)]).unwrap_err();
    assert!(
        error.to_string().contains("0 blocks that are everywhere"),
        "{error}"
    );
    let floor = Packed {
        key: 0,
        role: Role::Everywhere,
        bytes: None,
    };
    let mut share = world.assemble(&[floor, own(1), own(2)])?;
    let blocks: Vec<Block> = share.blocks();
    assert_eq!((share.block_count(), share.share_info().own_count), (3, 2));
    assert!(share.remove_block(blocks[1]).is_err());
    let mut sums = share.sums();
    share.set_sums(&sums)?;
    sums[0] = f64::NAN;
    let error = share.set_sums(&sums).unwrap_err();
    assert!(error.to_string().contains("sums[0]"), "{error}");
    Ok(())
}
