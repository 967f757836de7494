//! Bonds: they hold below their strength and fail above it.

use halfspace::{
    Block, BlockDef, Bond, BondFailure, Context, ErrorKind, Pose, Relaxation, Result, Shape, World,
    WorldDef,
};

const STRENGTH: f64 = 1e5;

fn mortar() -> Bond {
    Bond::default()
        .normal_stiffness(1e9)
        .tensile_strength(STRENGTH)
        .cohesion(STRENGTH)
        .friction_angle(0.5)
}

/// A square on a fixed one, which it touches, without gravity.
fn two_squares() -> Result<(World, [Block; 2])> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    let mut world = World::new(&context, &WorldDef::in_plane().gravity([0.0; 3]))?;
    let stone = world.add_material(2000.0)?;
    let lower = world.add_block(&square, &BlockDef::fixed(stone))?;
    let above = Pose::in_plane(0.5, 1.5, 0.0);
    let upper = world.add_block(&square, &BlockDef::rigid(stone).at(above))?;
    Ok((world, [lower, upper]))
}

/// Applies a force, relaxes with suspended failure of bonds, then resumes it.
fn pull(world: &mut World, block: Block, force: f64) -> Result<()> {
    world.set_applied_force(block, [0.0, force, 0.0], [0.0; 3])?;
    assert!(world.relax(&Relaxation::default().ratio(1e-8))?.is_at_rest);
    let bond = world.bonds()[0];
    assert!((bond.normal_force / force - 1.0).abs() < 1e-6);
    assert!(bond.shear_force[0].abs() < 1e-6 * force);
    world.step(10)
}

#[test]
fn a_bond_holds_below_its_strength_and_fails_above() -> Result<()> {
    let (mut world, [lower, upper]) = two_squares()?;
    world.bond_blocks(upper, lower, &mortar())?;
    pull(&mut world, upper, 0.9 * STRENGTH)?;
    let bond = world.bonds()[0];
    assert_eq!(bond.blocks, Some((lower, upper)));
    assert_eq!((bond.point_count, bond.broken_count), (3, 0));
    assert_eq!((bond.is_joint, bond.damage), (true, 0.0));
    assert!((bond.area - 1.0).abs() < 1e-14);
    let report = world.bond_report();
    assert_eq!((report.bond_count, report.joint_count), (1, 1));
    assert_eq!((report.event_count, report.crack_area), (0, 0.0));
    let springs = 0.5 * (0.9 * STRENGTH).powi(2) / 1e9;
    assert!((report.strain_energy / springs - 1.0).abs() < 1e-5);
    assert!(world.bond_events(0).is_empty());

    pull(&mut world, upper, 1.1 * STRENGTH)?;
    let bond = world.bonds()[0];
    assert_eq!(
        (bond.broken_count, bond.is_joint, bond.damage),
        (3, false, 1.0)
    );
    let report = world.bond_report();
    assert_eq!((report.joint_count, report.event_count), (0, 3));
    assert!((report.crack_area - 1.0).abs() < 1e-14 && report.fracture_loss > 0.0);
    let events = world.bond_events(0);
    assert_eq!(events.len(), 3);
    for event in &events {
        assert_eq!((event.bond, event.failure), (0, BondFailure::Tension));
        assert!((event.normal_traction / STRENGTH - 1.1).abs() < 1e-3);
        assert!(event.shear_traction.abs() < 1.0 && event.energy > 0.0);
        assert!((event.position[1] - 1.0).abs() < 1e-3 && (event.normal[1] - 1.0).abs() < 1e-9);
        assert!(event.time > 0.0 && event.steps > 0);
    }
    let mut points: Vec<usize> = events.iter().map(|event| event.point).collect();
    points.sort_unstable();
    assert_eq!(points, [0, 1, 2]);
    assert_eq!(world.bond_events(2), events[2..]);
    assert!(world.bond_events(4).is_empty() && world.bond_events(usize::MAX).is_empty());
    Ok(())
}

#[test]
fn held_bonds_do_not_fail() -> Result<()> {
    let (mut world, [lower, upper]) = two_squares()?;
    world.bond_blocks(lower, upper, &mortar())?;
    world.set_applied_force(upper, [0.0, 3.0 * STRENGTH, 0.0], [0.0; 3])?;
    world.hold_bonds(true);
    world.step(50)?;
    assert_eq!(world.bond_report().joint_count, 1);
    world.hold_bonds(false);
    while world.bond_report().joint_count == 1 {
        world.step(10)?;
        assert!(world.report()?.steps < 10_000);
    }
    Ok(())
}

#[test]
fn a_bond_fails_by_shear() -> Result<()> {
    let (mut world, [lower, upper]) = two_squares()?;
    world.bond_blocks(lower, upper, &mortar().tensile_strength(100.0 * STRENGTH))?;
    world.set_applied_force(upper, [1.5 * STRENGTH, 0.0, 0.0], [0.0; 3])?;
    while world.bond_report().event_count == 0 {
        world.step(1)?;
        assert!(world.report()?.steps < 10_000);
    }
    assert_eq!(world.bond_events(0)[0].failure, BondFailure::Shear);
    Ok(())
}

#[test]
fn materials_are_bonded_along_all_common_faces() -> Result<()> {
    let (mut world, [lower, upper]) = two_squares()?;
    let stone = world.block_state(lower)?.material;
    let wood = world.add_material(700.0)?;
    assert_eq!(world.bond_materials(stone, wood, &mortar())?, 0);
    assert_eq!(world.bond_materials(stone, stone, &mortar())?, 1);
    assert_eq!(world.bond_materials(stone, stone, &mortar())?, 0, "once");
    let restored = World::restore(&world.context(), &world.save())?;
    assert_eq!(restored.bonds(), world.bonds());

    let error = world.bond_blocks(lower, upper, &mortar()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::State);
    assert!(error.to_string().contains("are bonded already"));
    world.remove_block(upper)?;
    assert_eq!(world.bonds()[0].blocks, None);
    let error = world.bond_blocks(lower, upper, &mortar()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::StaleId);
    let weaker_than_its_rest = mortar().residual_cohesion(2.0 * STRENGTH);
    let error = world
        .bond_materials(stone, stone, &weaker_than_its_rest)
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    assert!(error
        .to_string()
        .contains("def.residual_cohesion is 200000"));
    Ok(())
}
