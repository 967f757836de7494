//! Contacts without springs: a square falls onto a fixed one, and rests on it with its weight.

use halfspace::{BlockDef, Context, Law, Pose, Result, Shape, World, WorldDef};

const GAP: f64 = 0.05;
const WEIGHT: f64 = 20000.0;

#[test]
fn a_square_falls_and_rests_with_its_weight() -> Result<()> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    let def = WorldDef::in_plane()
        .gravity([0.0, -10.0, 0.0])
        .time_step(1e-3);
    let mut world = World::new(&context, &def)?;
    let stone = world.add_material(2000.0)?;
    world.set_default_law(&Law::default().without_spring())?;
    world.add_block(&square, &BlockDef::fixed(stone))?;
    let above = Pose::in_plane(0.5, 1.5 + GAP, 0.0);
    let block = world.add_block(&square, &BlockDef::rigid(stone).at(above))?;
    assert!(world.contacts().is_empty());
    world.step(200)?;
    let report = world.report()?;
    let contacts = world.contacts();
    assert_eq!(report.contact_count, contacts.len());
    assert!(report.touch_count >= 1 && report.iteration_count > 0);
    let force: f64 = contacts
        .iter()
        .map(|contact| {
            let (_, on) = contact.blocks().unwrap();
            if on == block {
                contact.force()[1]
            } else {
                -contact.force()[1]
            }
        })
        .sum();
    assert!((force / WEIGHT - 1.0).abs() < 1e-9);
    // The impact loss uses the mean velocity of the step: gravity adds g dt / 2 to 1 m/s.
    assert!((report.impact_loss / (WEIGHT * GAP) - 1.0).abs() < 0.011);
    assert!(contacts
        .iter()
        .all(|contact| (contact.touched_at() - 0.1).abs() < 1e-4));
    assert!(world.plan(0)?.hard_contacts);
    Ok(())
}
