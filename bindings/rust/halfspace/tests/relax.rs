//! Relaxation, and the factor of safety.

use halfspace::{
    Block, BlockDef, Context, ErrorKind, Family, Law, Pose, Relaxation, Result, Shape,
    StrengthSearch, World, WorldDef,
};

const DENSITY: f64 = 2000.0;
const STIFFNESS: f64 = 1e8;
const GRAVITY: f64 = 9.81;

/// A square on a fixed slab that is inclined, with friction of 30 degrees.
fn block_on_slope(context: &Context, angle: f64) -> Result<(World, Block)> {
    let slab = Shape::polygon(
        context,
        &[[-4.0, -1.0], [4.0, -1.0], [4.0, 0.0], [-4.0, 0.0]],
    )?;
    let square = Shape::polygon(context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    let mut world = World::new(context, &WorldDef::in_plane())?;
    let rough = Law::default()
        .per_area()
        .normal_stiffness(STIFFNESS)
        .friction_angle(30f64.to_radians());
    world.set_default_law(&rough)?;
    let stone = world.add_material(DENSITY)?;
    let (sine, cosine) = angle.sin_cos();
    let along_normal = |distance: f64| Pose::in_plane(-distance * sine, distance * cosine, angle);
    world.add_block(&slab, &BlockDef::fixed(stone).at(along_normal(-0.5)))?;
    let block = world.add_block(&square, &BlockDef::rigid(stone).at(along_normal(0.5)))?;
    Ok((world, block))
}

#[test]
fn a_block_settles_under_gravity() -> Result<()> {
    let (mut world, block) = block_on_slope(&Context::new()?, 0.0)?;
    assert!((world.balance()?.mean - 1.0).abs() < 1e-12, "it falls");
    let too_short = world.relax(&Relaxation::default().max_steps(20))?;
    assert_eq!((too_short.is_at_rest, too_short.steps), (false, 20));

    let relaxed = world.relax(&Relaxation::default().by_largest().ratio(1e-6))?;
    assert!(relaxed.is_at_rest && relaxed.steps > 0);
    assert!(relaxed.balance.largest <= 1e-6 && relaxed.balance.mean <= 1e-6);
    assert!(relaxed.balance.largest_force <= 2e-6 * DENSITY * GRAVITY);
    assert_eq!(relaxed.balance.largest_force_block, Some(block));
    let state = world.block_state(block)?;
    let overlap = DENSITY * GRAVITY / STIFFNESS;
    assert!((state.pose.position[1] - 0.5 + overlap).abs() < 1e-4 * overlap);
    assert_eq!(
        (state.velocity, state.angular_velocity),
        ([0.0; 3], [0.0; 3])
    );
    assert!(world.balance()?.mean < 2e-6);

    world.set_gravity([0.0, -2.0 * GRAVITY, 0.0])?;
    assert!(world.balance()?.largest > 0.1);
    let by_local_damping = Relaxation::default()
        .by_mean()
        .adaptive(false)
        .local_damping(0.8)
        .hold_bonds(false);
    assert!(world.relax(&by_local_damping)?.is_at_rest);
    let state = world.block_state(block)?;
    assert!((state.pose.position[1] - 0.5 + 2.0 * overlap).abs() < 1e-4 * overlap);
    Ok(())
}

#[test]
fn damping_and_time_step_change_while_a_world_lives() -> Result<()> {
    let (mut world, block) = block_on_slope(&Context::new()?, 0.0)?;
    let away = Pose::in_plane(0.0, 100.0, 0.0);
    world.set_pose(block, &away)?;
    world.set_gravity([0.0; 3])?;
    world.set_velocity(block, [1.0, 0.0, 0.0], [0.0; 3])?;
    world.set_time_step(1.0 / 1024.0)?;
    world.set_damping(0.0, 2.0)?;
    world.step(1024)?;
    assert_eq!(world.report()?.time_step, 1.0 / 1024.0);
    let speed = world.block_state(block)?.velocity[0];
    assert!((speed - (-2f64).exp()).abs() < 1e-3);
    world.set_time_step(0.0)?;
    let report = world.report()?;
    assert_eq!(report.time_step, 0.5 * report.stable_time_step);

    for (error, text) in [
        (world.set_damping(1.0, 0.0), "local_damping is 1"),
        (world.set_damping(0.0, -1.0), "mass_damping is -1"),
        (world.set_time_step(-1.0), "time_step is -1"),
        (world.set_gravity([0.0, f64::NAN, 0.0]), "gravity"),
        (world.set_strength_factor(0.0), "factor is 0"),
    ] {
        let error = error.unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Argument);
        assert!(error.to_string().contains(text), "{error}");
    }
    let error = world.relax(&Relaxation::default().ratio(0.0)).unwrap_err();
    assert!(error.to_string().contains("def.ratio is 0"));
    let error = world
        .find_strength_factor(&StrengthSearch::default().low(6.0))
        .unwrap_err();
    assert!(error.to_string().contains("def.high is 5"));
    Ok(())
}

/// The tangents of friction and slope have the ratio 1.586.
#[test]
fn a_block_on_a_slope_has_its_factor_of_safety() -> Result<()> {
    let context = Context::new()?;
    let (mut world, block) = block_on_slope(&context, 20f64.to_radians())?;
    assert!(world.relax(&Relaxation::default())?.is_at_rest);
    let before = world.save();
    let found = world.find_strength_factor(&StrengthSearch::default().low(1.0).high(3.0))?;
    assert!(before == world.save(), "the world stays as it is");
    let expected = 30f64.to_radians().tan() / 20f64.to_radians().tan();
    assert!(found.stands_at_low && found.falls_at_high && found.trials > 5);
    assert!((found.factor - expected).abs() < 0.005, "{}", found.factor);
    assert!(found.low < found.factor && found.factor < found.high);
    assert!(found.high - found.low <= 0.005);

    let mut fallen = found.fallen.expect("a world that fell");
    assert_eq!(fallen.blocks(), world.blocks());
    let (there, here) = (fallen.block_state(block)?, world.block_state(block)?);
    assert!(there.pose.position[0] < here.pose.position[0] - 0.01);
    fallen.step(1)?;
    drop(context);
    let world = Family::gather(world).expect_err("the fallen world is of its context");
    assert!(Family::gather((world, fallen)).is_ok());
    Ok(())
}

#[test]
fn a_search_may_end_at_once() -> Result<()> {
    let (mut world, block) = block_on_slope(&Context::new()?, 20f64.to_radians())?;
    assert!(world.relax(&Relaxation::default())?.is_at_rest);
    let search = StrengthSearch::default().ratio(1e-4).max_displacement(0.05);
    let found = world.find_strength_factor(&search.high(1.5).max_steps(20_000))?;
    assert!(found.stands_at_low && !found.falls_at_high && found.fallen.is_none());
    let found = world.find_strength_factor(&search.low(1.7).resolution(0.1))?;
    assert!(!found.stands_at_low && !found.falls_at_high && found.fallen.is_some());
    assert_eq!(found.trials, 1);

    world.set_strength_factor(1.7)?;
    world.step(2000)?;
    assert!(world.block_state(block)?.velocity[0] < -1e-3);
    world.set_strength_factor(1.0)?;
    assert!(world.relax(&Relaxation::default())?.is_at_rest);
    Ok(())
}
