//! Worlds: the Rust interface beyond the shared cases.

use halfspace::{
    Block, BlockDef, BlockKind, Context, ErrorKind, Law, Pose, Result, Shape, View, ViewMut, World,
    WorldDef,
};

const SQUARE: [[f64; 2]; 4] = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
const STIFFNESS: f64 = 1e7;
const TIME_STEP: f64 = 1e-3;

/// A square on a fixed one, with an overlap of 1/8, and one that falls beside it.
fn three_squares() -> Result<(World, [Block; 3])> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &SQUARE)?;
    let mut world = World::new(&context, &WorldDef::in_plane().time_step(TIME_STEP))?;
    world.set_default_law(&Law::default().normal_stiffness(STIFFNESS))?;
    let stone = world.add_material(2000.0)?;
    let lower = world.add_block(&square, &BlockDef::fixed(stone))?;
    let upper = world.add_block(
        &square,
        &BlockDef::rigid(stone).at(Pose::in_plane(0.25, 0.875, 0.0)),
    )?;
    let falling = world.add_block(
        &square,
        &BlockDef::rigid(stone).at(Pose::in_plane(5.0, 0.0, 0.0)),
    )?;
    Ok((world, [lower, upper, falling]))
}

#[test]
fn contacts_know_their_blocks_and_forces() -> Result<()> {
    let (mut world, [lower, upper, _]) = three_squares()?;
    assert_eq!(world.detect()?, 1);
    let mut forces = [[0.0; 2]; 3];
    world.forces(0.0, &mut forces, ViewMut::none())?;
    assert_eq!(
        forces,
        [[0.0, -STIFFNESS / 8.0], [0.0, STIFFNESS / 8.0], [0.0, 0.0]]
    );

    let mut buffer = Vec::new();
    let contacts = world.contacts_into(&mut buffer);
    assert_eq!(contacts.len(), 1);
    assert_eq!(contacts[0].blocks(), Some((lower, upper)));
    assert_eq!(contacts[0].normal_force(), STIFFNESS / 8.0);
    assert_eq!(
        (contacts[0].points().len(), contacts[0].gaps()),
        (2, &[-0.125, -0.125][..])
    );

    let memory = buffer.as_ptr();
    world.contacts_into(&mut buffer);
    assert_eq!(buffer.as_ptr(), memory, "the buffer serves again");
    Ok(())
}

#[test]
fn a_removed_block_is_stale() -> Result<()> {
    let (mut world, [lower, upper, falling]) = three_squares()?;
    world.remove_block(upper)?;
    assert_eq!(world.block_count(), 2);
    assert_eq!(world.blocks(), [lower, falling]);
    assert_eq!(world.poses().len(), 2);
    for error in [
        world.block_state(upper).unwrap_err(),
        world.block_vertices(upper).unwrap_err(),
        world.remove_block(upper).unwrap_err(),
    ] {
        assert_eq!(error.kind(), ErrorKind::StaleId);
    }
    assert_eq!(world.block_count(), 2);
    assert_eq!(Block::from_id(falling.id()), Some(falling));
    assert_eq!(Block::from_id(0), None);
    Ok(())
}

#[test]
fn a_plan_says_what_is_active_and_limits_the_step() -> Result<()> {
    let (mut world, [lower, upper, falling]) = three_squares()?;
    world.remove_block(falling)?;
    let plan = world.plan(10)?;
    assert!(plan.contact_damping && !plan.strain && !plan.potential);
    assert_eq!((plan.fixed_count, plan.rigid_count), (1, 1));
    assert_eq!(plan.limiting_block, Some(upper));
    assert_eq!(plan.limiting_neighbor, Some(lower));
    assert_eq!(plan.stable_time_step, world.report()?.stable_time_step);
    assert_eq!((plan.measured_steps, world.report()?.steps), (10, 0));
    Ok(())
}

#[test]
fn a_restored_world_goes_on_bit_for_bit() -> Result<()> {
    let (mut world, [_, upper, _]) = three_squares()?;
    world.step(50)?;
    let mut restored = World::restore(&Context::new()?, &world.save())?;
    assert_eq!(restored.block_count(), 3);
    assert_eq!(restored.report()?.dimension, 2);
    world.step(50)?;
    restored.step(50)?;
    assert_eq!(world.poses(), restored.poses());
    assert_eq!(world.block_state(upper)?, restored.block_state(upper)?);
    Ok(())
}

#[test]
fn blocks_are_read_and_moved_one_by_one() -> Result<()> {
    let (mut world, [lower, upper, falling]) = three_squares()?;
    world.set_pose(falling, &Pose::at([7.0, 8.0, 0.0]))?;
    world.set_velocity(falling, [1.0, 0.0, 0.0], [0.0, 0.0, 2.0])?;
    let state = world.block_state(falling)?;
    assert_eq!((state.kind, state.mass), (BlockKind::Rigid, 2000.0));
    assert_eq!(
        (state.velocity, state.angular_velocity),
        ([1.0, 0.0, 0.0], [0.0, 0.0, 2.0])
    );
    assert_eq!(world.block_vertices(falling)?[0], [6.5, 7.5, 0.0]);
    let mut two = [[0.0; 2]; 2];
    assert_eq!(world.block_vertices_into(falling, &mut two)?, 4);
    assert_eq!(two, [[6.5, 7.5], [7.5, 7.5]]);
    assert_eq!(
        world
            .set_velocity(lower, [1.0, 0.0, 0.0], [0.0; 3])
            .unwrap_err()
            .kind(),
        ErrorKind::State
    );
    assert_eq!(
        world
            .set_shear_force(lower, upper, [1.0, 0.0, 0.0])
            .unwrap_err()
            .kind(),
        ErrorKind::State
    );

    // An external force balances the weight.
    world.set_applied_force(falling, [0.0, 2000.0 * 9.81, 0.0], [0.0; 3])?;
    world.step(1000)?;
    let state = world.block_state(falling)?;
    assert!(
        (state.pose.position[0] - 8.0).abs() < 1e-12
            && (state.pose.position[1] - 8.0).abs() < 1e-12
    );
    assert!((state.angle - 2.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn an_empty_view_leaves_the_spins_as_they_are() -> Result<()> {
    let (mut world, [_, _, falling]) = three_squares()?;
    world.set_velocity(falling, [0.0; 3], [0.0, 0.0, 2.0])?;
    world.set_velocities(
        &[[0.0, 0.0], [0.0, 0.0], [3.0, 0.0]],
        View::from(&[[0.0; 3]; 0]),
    )?;
    let state = world.block_state(falling)?;
    assert_eq!(
        (state.velocity, state.angular_velocity),
        ([3.0, 0.0, 0.0], [0.0, 0.0, 2.0])
    );
    Ok(())
}

#[test]
fn the_library_is_of_this_version() {
    assert_eq!(halfspace::version(), env!("CARGO_PKG_VERSION"));
}
