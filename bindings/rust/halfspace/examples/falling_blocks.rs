//! A complete world: bricks fall onto a floor and come to rest in a heap.

use halfspace::{BlockDef, Context, Law, Pose, Result, Shape, World, WorldDef};

fn main() -> Result<()> {
    let context = Context::new()?;
    let floor = Shape::polygon(
        &context,
        &[[-10.0, -1.0], [10.0, -1.0], [10.0, 0.0], [-10.0, 0.0]],
    )?;
    let brick = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5]])?;

    let mut world = World::new(&context, &WorldDef::in_plane())?;
    let clay = world.add_material(1800.0)?;
    world.set_default_law(
        &Law::default()
            .normal_stiffness(1e8)
            .shear_stiffness(5e7)
            .friction_angle(30f64.to_radians())
            .normal_damping(0.2),
    )?;

    world.add_block(&floor, &BlockDef::fixed(clay))?;
    for i in 0..40 {
        let (column, row) = (f64::from(i % 4), f64::from(i / 4));
        let pose = Pose::in_plane(
            1.3 * column - 2.0,
            1.0 + 1.3 * row,
            0.4 * column - 0.1 * row,
        );
        world.add_block(&brick, &BlockDef::rigid(clay).at(pose))?;
    }

    println!("   time  contacts  fastest brick    kinetic energy");
    println!("      s                      m/s                 J");
    let start = world.report()?;
    let mut contacts = Vec::new();
    while world.report()?.time < 5.0 {
        world.step((0.5 / start.time_step) as u64)?;
        let report = world.report()?;
        println!(
            "{:7.2}  {:8}  {:13.2e}  {:16.3e}",
            report.time, report.contact_count, report.largest_speed, report.energy.kinetic
        );
    }

    let strongest = world
        .contacts_into(&mut contacts)
        .iter()
        .max_by(|a, b| a.normal_force().total_cmp(&b.normal_force()))
        .expect("the bricks lie on the floor");
    println!(
        "The largest contact force is {:.1} kN, {:?}.",
        1e-3 * strongest.normal_force(),
        strongest.kind()
    );
    println!(
        "{:.1} kJ have gone into friction.",
        1e-3 * world.report()?.energy.friction_loss
    );
    Ok(())
}
