//! The contact of two squares, as a query for hosts with their own bodies.

use halfspace::{detect, Context, Pose, Shape};

fn main() -> halfspace::Result<()> {
    let context = Context::new()?;
    let square = Shape::polygon(
        &context,
        &[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]],
    )?;
    let (lower, upper) = (
        Pose::in_plane(0.0, 0.0, 0.0),
        Pose::in_plane(0.25, 0.875, 0.0),
    );
    let contact = detect(square.at(&lower), square.at(&upper))?;
    println!("dist {} normal {:?}", contact.gap(), contact.normal());
    for (point, gap) in contact.points().iter().zip(contact.gaps()) {
        println!("point {:?} dist {}", point, gap);
    }
    Ok(())
}
