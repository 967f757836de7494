//! A world returns what it was given.

use halfspace::{
    Action, Block, BlockDef, Context, Elasticity, ErrorKind, Law, Material, Result, Setting, Shape,
    Table, World, WorldDef,
};

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

fn joint() -> Law {
    Law::default().friction_angle(0.6).cohesion(1.1e4)
}

/// Two materials, the second one elastic, with a law of their own, and a block.
fn make_world(context: &Context) -> Result<(World, Block)> {
    let mut world = World::new(context, &WorldDef::in_plane().local_damping(0.7))?;
    let (stone, steel) = (world.add_material(2700.1)?, world.add_material(7850.3)?);
    world.set_elasticity(
        steel,
        &Elasticity::default().poisson_ratio(0.3).plane_stress(),
    )?;
    world.set_law(stone, steel, &joint())?;
    let block = world.add_block(
        &Shape::polygon(context, &SQUARE)?,
        &BlockDef::prescribed(stone),
    )?;
    Ok((world, block))
}

#[test]
fn settings_materials_and_laws_are_those_that_were_given() -> Result<()> {
    let context = Context::new()?;
    let (mut world, _) = make_world(&context)?;
    let (stone, steel) = (Material::from_index(0), Material::from_index(1));
    world.set_gravity([0.5, -1.0, 0.0])?;
    world.set_strength_factor(1.7)?;
    for world in [&world, &World::restore(&context, &world.save())?] {
        let def = world.definition();
        assert_eq!(def.values().local_damping, 0.7);
        assert_eq!(def.values().gravity, [0.5, -1.0, 0.0]);
        assert_eq!(world.densities(), [2700.1, 7850.3]);
        assert!(world.elasticity(stone)?.is_none());
        let elasticity = world.elasticity(steel)?.unwrap();
        assert_eq!(elasticity.values().poisson_ratio, 0.3);
        assert_eq!(elasticity.values().plane, 1);
        let law = world.law(steel, stone)?;
        assert_eq!(law.values().friction_angle, 0.6);
        assert_eq!(law.values().cohesion, 1.1e4);
        assert_eq!(world.default_law().values().friction_angle, 0.0);
        assert_eq!(world.law(steel, steel)?.values().cohesion, 0.0);
    }
    let error = world.law(stone, Material::from_index(2)).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::StaleId);
    Ok(())
}

#[test]
fn tables_and_actions_are_those_that_were_given() -> Result<()> {
    let (mut world, block) = make_world(&Context::new()?)?;
    let table = world.add_table(&[0.0, 0.5], &[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])?;
    world.add_action(
        block,
        &Action::velocity(table).scale([1.0, 0.0, 0.0]).start(0.2),
    )?;
    world.add_action(None, &Action::acceleration(table))?;
    let (times, rows) = world.table(table)?;
    assert_eq!(times, [0.0, 0.5]);
    assert_eq!(rows, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    let actions = world.actions(block)?;
    assert_eq!(actions.len(), 1);
    assert_eq!(actions[0].values().start, 0.2);
    assert_eq!(actions[0].values().scale, [1.0, 0.0, 0.0]);
    assert_eq!(world.actions(None)?.len(), 1);
    let error = world.table(Table::from_index(1)).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::StaleId);
    Ok(())
}

#[test]
fn unusual_values_are_noted() -> Result<()> {
    let (mut world, _) = make_world(&Context::new()?)?;
    assert!(world.notes().is_empty());
    let (stone, steel) = (Material::from_index(0), Material::from_index(1));
    world.set_law(stone, steel, &joint().cohesion(5.0))?;
    let notes = world.notes();
    assert_eq!(notes.len(), 1);
    assert_eq!(notes[0].setting, Setting::Cohesion);
    assert_eq!(
        (notes[0].material_a, notes[0].material_b),
        (Some(0), Some(1))
    );
    assert_eq!(
        Some((notes[0].usual_low, notes[0].usual_high)),
        Setting::Cohesion.usual_range()
    );
    assert_eq!(Setting::Cohesion.usual_text(), "0, or 100 to 1e9 Pa");
    assert_eq!(Setting::Other(-1).usual_range(), None);
    Ok(())
}
