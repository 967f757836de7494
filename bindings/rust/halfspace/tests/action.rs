//! Motions and loads in time, against analysis.

use halfspace::{
    Action, Axes, Block, BlockDef, Body, BodyDef, Cell, Context, Elasticity, ErrorKind, Law,
    Material, Mesh, Pose, Result, Shape, Table, View, World, WorldDef,
};

const DENSITY: f64 = 2000.0;
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
const STONE: fn() -> Material = || Material::from_index(0);

/// Without gravity, with steps of 0.01 s.
fn empty_world() -> Result<World> {
    let def = WorldDef::in_plane().gravity([0.0; 3]).time_step(0.01);
    let mut world = World::new(&Context::new()?, &def)?;
    world.add_material(DENSITY)?;
    Ok(world)
}

fn add_square(world: &mut World, def: BlockDef, x: f64, y: f64) -> Result<Block> {
    let square = Shape::polygon(&world.context(), &SQUARE)?;
    world.add_block(&square, &def.at(Pose::in_plane(x, y, 0.0)))
}

/// A table of numbers, for all components.
fn add_numbers(world: &mut World, times: &[f64], values: &[f64]) -> Result<Table> {
    world.add_table(times, View::components([values, values, values]))
}

fn is_close(got: f64, expected: f64, tolerance: f64) -> bool {
    (got - expected).abs() <= tolerance * expected.abs()
}

#[test]
fn an_impulse_gives_its_momentum() -> Result<()> {
    let mut world = empty_world()?;
    let block = add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 0.0)?;
    let rows = [[0.0, 0.0], [300.0, -100.0], [0.0, 50.0], [0.0, 0.0]];
    let pulse = world.add_table(&[0.0, 0.013, 0.013, 0.05], &rows)?;
    let turning = add_numbers(&mut world, &[0.0, 0.1, 0.1], &[0.0, 40.0, 0.0])?;
    assert_eq!((pulse.index(), turning.index()), (0, 1));
    assert_eq!(Table::from_index(1), turning);
    world.add_action(block, &Action::force(pulse))?;
    world.add_action(block, &Action::torque(turning))?;
    world.step(20)?;
    let state = world.block_state(block)?;
    assert!(is_close(state.velocity[0] * DENSITY, 0.013 * 150.0, 1e-12));
    let along_y = -0.013 * 50.0 + 0.037 * 25.0;
    assert!(is_close(state.velocity[1] * DENSITY, along_y, 1e-12));
    assert!(is_close(
        state.angular_velocity[2] * DENSITY / 6.0,
        2.0,
        1e-12
    ));
    Ok(())
}

#[test]
fn a_prescribed_block_follows_its_table() -> Result<()> {
    let mut world = empty_world()?;
    let ground = add_square(&mut world, BlockDef::prescribed(STONE()), 0.0, 0.0)?;
    let growing = add_numbers(&mut world, &[0.0, 0.1], &[0.0, 6.0])?;
    let along_x = Action::acceleration(growing).scale([1.0, 0.0, 0.0]);
    world.add_action(ground, &along_x)?;
    world.step(10)?;
    let state = world.block_state(ground)?;
    assert!(is_close(state.velocity[0], 0.3, 1e-12) && state.velocity[1] == 0.0);
    assert!(is_close(state.pose.position[0], 0.01, 1e-12));

    world.end_actions(ground)?;
    world.prescribe_velocities(&[ground], &[[2.0, 1.0]], &[[0.0, 0.0, 0.5]])?;
    world.step(10)?;
    let state = world.block_state(ground)?;
    assert!(is_close(state.pose.position[0], 0.21, 1e-12));
    assert!(is_close(state.pose.position[1], 0.1, 1e-12));
    assert!(is_close(state.angle, 0.05, 1e-12));

    // Without angular velocities they stay.
    let kept: [[f64; 3]; 0] = [];
    world.prescribe_velocities(&[ground], &[[0.0, 0.0]], &kept)?;
    assert_eq!(world.block_state(ground)?.angular_velocity[2], 0.5);
    Ok(())
}

#[test]
fn motions_start_later_and_turn() -> Result<()> {
    let mut world = empty_world()?;
    let wheel = add_square(&mut world, BlockDef::prescribed(STONE()), 0.0, 0.0)?;
    let arm = add_square(&mut world, BlockDef::prescribed(STONE()), 3.0, 0.0)?;
    let one = add_numbers(&mut world, &[0.0, 0.0], &[0.0, 1.0])?;
    world.add_action(wheel, &Action::angular_velocity(one).start(0.05))?;
    world.add_action(
        arm,
        &Action::angular_acceleration(one).scale([0.0, 0.0, 2.0]),
    )?;
    world.add_action(arm, &Action::velocity(one).start(0.08))?;
    world.step(10)?;
    assert!(is_close(world.block_state(wheel)?.angle, 0.05, 1e-12));
    let state = world.block_state(arm)?;
    assert!(is_close(state.angle, 0.01, 1e-12));
    assert!(is_close(state.pose.position[1], 0.02, 1e-12));
    Ok(())
}

#[test]
fn axes_are_held_and_forces_have_places() -> Result<()> {
    let mut world = empty_world()?;
    let block = add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 0.0)?;
    let force = world.add_table(&[0.0], &[[5.0, 7.0]])?;
    world.hold_block(block, Axes::X | Axes::ROTATION)?;
    world.add_action(block, &Action::force(force).at_carried([0.5, 0.0, 0.0]))?;
    world.step(10)?;
    let state = world.block_state(block)?;
    assert_eq!((state.velocity[0], state.angular_velocity[2]), (0.0, 0.0));
    assert!(is_close(state.velocity[1], 7.0 / DENSITY * 0.1, 1e-12));
    world.hold_block(block, Axes::NONE)?;
    world.step(1)?;
    let spin = world.block_state(block)?.angular_velocity[2];
    assert!(is_close(spin, 0.5 * 7.0 / (DENSITY / 6.0) * 0.01, 1e-5));

    // At rest a force at a point in space turns it by its arm, and one at the centroid does not.
    let other = add_square(&mut world, BlockDef::rigid(STONE()), 9.0, 0.0)?;
    world.add_action(other, &Action::force(force).at_centroid())?;
    world.add_action(other, &Action::force(force).at_fixed([9.0, -0.25, 0.0]))?;
    world.step(1)?;
    let state = world.block_state(other)?;
    assert!(is_close(
        state.angular_velocity[2],
        0.25 * 5.0 / (DENSITY / 6.0) * 0.01,
        1e-3
    ));
    assert!(is_close(
        state.velocity[0],
        2.0 * 5.0 / DENSITY * 0.01,
        1e-12
    ));
    Ok(())
}

#[test]
fn all_blocks_are_accelerated_until_it_ends() -> Result<()> {
    let mut world = empty_world()?;
    let block = add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 0.0)?;
    let wind = world.add_table(&[0.0], &[[3.0, -1.0]])?;
    world.add_action(None, &Action::acceleration(wind))?;
    world.step(10)?;
    let velocity = world.block_state(block)?.velocity;
    assert!(is_close(velocity[0], 0.3, 1e-12) && is_close(velocity[1], -0.1, 1e-12));
    world.end_actions(None)?;
    world.step(10)?;
    assert_eq!(world.block_state(block)?.velocity, velocity);
    Ok(())
}

#[test]
fn a_servo_keeps_its_force() -> Result<()> {
    let mut world = empty_world()?;
    world.set_time_step(1e-4)?;
    world.set_damping(0.3, 0.0)?;
    let springs = Law::default().per_area().normal_stiffness(1e8);
    world.set_default_law(&springs.normal_damping(0.3))?;
    add_square(&mut world, BlockDef::fixed(STONE()), 0.0, 0.0)?;
    add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 1.0)?;
    let press = add_square(&mut world, BlockDef::prescribed(STONE()), 0.0, 2.0)?;
    let force = add_numbers(&mut world, &[0.0], &[1e5])?;
    let down = Action::servo(force, 1.0).scale([0.0, -1.0, 0.0]);
    world.add_action(press, &down)?;
    world.step(10_000)?;
    let contacts = world.contacts();
    assert_eq!(contacts.len(), 2);
    for contact in contacts {
        assert!(is_close(contact.normal_force(), 1e5, 1e-3));
    }
    Ok(())
}

/// A square of one cell.
fn add_body(world: &mut World) -> Result<Body> {
    let mesh = Mesh::in_plane(&world.context(), &SQUARE, &[Cell::Quad([0, 1, 2, 3])])?;
    world.set_elasticity(STONE(), &Elasticity::default().young_modulus(1e6))?;
    world.add_mesh(&mesh, &BodyDef::of(STONE()))
}

#[test]
fn nodes_follow_tables() -> Result<()> {
    let mut world = empty_world()?;
    world.set_time_step(1e-3)?;
    let body = add_body(&mut world)?;
    let pulse = add_numbers(&mut world, &[0.0, 0.01, 0.01], &[0.0, 80.0, 0.0])?;
    let action = Action::force(pulse);
    let shares = [[1.0, 0.0], [1.0, 0.0], [0.0, 0.5], [0.0, 0.5]];
    world.add_node_action(body, &[0, 3, 1, 2], &shares, &action)?;
    world.step(20)?;
    let momentum = world.body_state(body)?.momentum;
    assert!(is_close(momentum[0], 0.8, 1e-10) && is_close(momentum[1], 0.4, 1e-10));

    world.end_node_actions(body)?;
    world.hold_nodes(body, &[0, 1, 2, 3], Axes::X | Axes::Y, [0.0; 3])?;
    let moved = world.add_table(&[0.0, 1.0], &[[0.0, 2.0], [4.0, 2.0]])?;
    let now = world.report()?.time;
    let start = world.node_positions(body)?;
    let action = Action::velocity(moved).start(now);
    world.add_node_action(body, &[0, 1, 2, 3], &[[1.0, 1.0]; 4], &action)?;
    world.step(100)?;
    for (from, to) in start.iter().zip(world.node_positions(body)?) {
        assert!(is_close(to[0] - from[0], 0.02, 1e-10));
        assert!(is_close(to[1] - from[1], 0.2, 1e-10));
    }
    Ok(())
}

#[test]
fn a_restored_world_keeps_its_actions() -> Result<()> {
    let mut world = empty_world()?;
    let block = add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 0.0)?;
    let table = add_numbers(&mut world, &[0.0, 1.0], &[1.0, 5.0])?;
    world.add_action(block, &Action::force(table).at_carried([0.1, 0.2, 0.0]))?;
    world.hold_block(block, Axes::Y)?;
    world.step(7)?;
    let mut restored = World::restore(&Context::new()?, &world.save())?;
    world.step(7)?;
    restored.step(7)?;
    assert_eq!(world.block_state(block)?, restored.block_state(block)?);
    restored.add_action(block, &Action::force(Table::from_index(0)))?;
    Ok(())
}

#[test]
fn what_cannot_be_is_refused() -> Result<()> {
    let mut world = empty_world()?;
    let block = add_square(&mut world, BlockDef::rigid(STONE()), 0.0, 0.0)?;
    let body = add_body(&mut world)?;
    let table = add_numbers(&mut world, &[0.0, 1.0], &[0.0, 1.0])?;
    let force = Action::force(table);
    let square = [[1.0, 1.0]];
    let kept: [[f64; 3]; 0] = [];
    for (refused, kind, text) in [
        (
            world.add_action(block, &Action::velocity(table)),
            ErrorKind::State,
            "is not prescribed",
        ),
        (
            world.add_action(None, &force),
            ErrorKind::Argument,
            "only HS_ACTION_ACCELERATION",
        ),
        (
            world.add_action(block, &Action::force(Table::from_index(3))),
            ErrorKind::StaleId,
            "def.table is 3",
        ),
        (
            world.add_action(block, &Action::servo(table, 0.0)),
            ErrorKind::Argument,
            "def.max_speed is 0",
        ),
        (
            world.add_table(&[1.0, 0.0], &[[0.0; 2]; 2]).map(drop),
            ErrorKind::Argument,
            "times[1] is 0",
        ),
        (
            world.add_table(&[1.0], &[[0.0; 2]; 2]).map(drop),
            ErrorKind::Argument,
            "World::add_table: times has 1 entries; there are 2 rows",
        ),
        (
            world.add_node_action(body, &[0, 1], &square, &force),
            ErrorKind::Argument,
            "World::add_node_action: nodes has 2 entries; there are 1 scales",
        ),
        (
            world.add_node_action(body, &[4], &square, &force),
            ErrorKind::Argument,
            "nodes[0] is 4; the body has 4 nodes",
        ),
        (
            world.add_node_action(body, &[usize::MAX], &square, &force),
            ErrorKind::Argument,
            "World::add_node_action: nodes: an index is above 2^31 - 1",
        ),
        (
            world.hold_block(block, Axes::Z),
            ErrorKind::Argument,
            "axes is 4",
        ),
        (
            world.prescribe_velocities(&[block], &square, &kept),
            ErrorKind::State,
            "which is not prescribed",
        ),
        (
            world.prescribe_velocities(&[block; 2], &square, &kept),
            ErrorKind::Argument,
            "World::prescribe_velocities: blocks has 2 entries; there are 1 velocities",
        ),
    ] {
        let error = refused.unwrap_err();
        assert_eq!(error.kind(), kind, "{error}");
        assert!(error.to_string().contains(text), "{error}");
    }
    world.remove_body(body)?;
    assert_eq!(
        world.end_node_actions(body).unwrap_err().kind(),
        ErrorKind::StaleId
    );
    Ok(())
}
