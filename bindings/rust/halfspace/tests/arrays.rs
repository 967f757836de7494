//! Points in all layouts give the same results; invalid layouts are refused before any call of the
//! library.

use halfspace::{BlockDef, Context, Shape, View, ViewMut, World, WorldDef};

const CORNERS: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 4.0],
];

fn hull(points: View) -> Vec<[f64; 3]> {
    let context = Context::new().unwrap();
    Shape::polyhedron_hull(&context, points).unwrap().vertices()
}

fn component(k: usize) -> Vec<f64> {
    CORNERS.iter().map(|corner| corner[k]).collect()
}

#[derive(Clone, Copy)]
#[repr(C)]
struct Node {
    id: u8,
    position: [f64; 3],
    mass: f64,
}

#[test]
fn all_layouts_read_the_same_points() {
    let (x, y, z) = (component(0), component(1), component(2));
    let nodes = CORNERS.map(|position| Node {
        id: 7,
        position,
        mass: 1.0,
    });
    // Point by point with one number in between, then component by component, then backwards.
    let padded: Vec<f64> = CORNERS
        .iter()
        .flat_map(|c| [c[0], c[1], c[2], f64::NAN])
        .collect();
    let columns: Vec<f64> = [x.clone(), y.clone(), z.clone()].concat();
    let backwards: Vec<f64> = CORNERS.iter().rev().flatten().copied().collect();

    let expected = hull(View::from(&CORNERS));
    assert_eq!(expected.len(), 4);
    assert_eq!(hull(View::from(&CORNERS.to_vec())), expected);
    assert_eq!(hull(View::components([&x, &y, &z])), expected);
    assert_eq!(hull(View::of(&nodes, |node| &node.position)), expected);
    assert_eq!(hull(View::strided(&padded, [0, 1, 2], 4, 4)), expected);
    assert_eq!(hull(View::strided(&columns, [0, 4, 8], 1, 4)), expected);
    assert_eq!(
        hull(View::strided(&backwards, [9, 10, 11], -3, 4)),
        expected
    );
    assert!(nodes.iter().all(|node| node.id == 7 && node.mass == 1.0));
}

/// Two blocks whose velocity components are all different.
fn moving_world() -> World {
    let context = Context::new().unwrap();
    let corner = Shape::polyhedron_hull(&context, &CORNERS).unwrap();
    let mut world = World::new(&context, &WorldDef::in_space()).unwrap();
    let rock = world.add_material(1.0).unwrap();
    for velocity in VELOCITIES {
        world
            .add_block(&corner, &BlockDef::rigid(rock).velocity(velocity))
            .unwrap();
    }
    world
}

const VELOCITIES: [[f64; 3]; 2] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];

#[test]
fn all_layouts_are_written_where_they_are() {
    let world = moving_world();
    let mut points = [[0.0; 3]; 2];
    world.velocities_into(&mut points, ViewMut::none()).unwrap();
    assert_eq!(points, VELOCITIES);

    let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    world
        .velocities_into(
            ViewMut::components([&mut x, &mut y, &mut z]),
            ViewMut::none(),
        )
        .unwrap();
    assert_eq!([x, y, z], [[1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]);

    let mut nodes = [Node {
        id: 7,
        position: [9.0; 3],
        mass: 9.0,
    }; 2];
    world
        .velocities_into(
            ViewMut::of(&mut nodes, |node| &mut node.position),
            ViewMut::none(),
        )
        .unwrap();
    assert_eq!(nodes.map(|node| node.position), VELOCITIES);
    assert!(nodes.iter().all(|node| node.id == 7 && node.mass == 9.0));

    let mut values = [9.0; 8];
    world
        .velocities_into(
            ViewMut::strided(&mut values, [4, 5, 6], -4, 2),
            ViewMut::none(),
        )
        .unwrap();
    assert_eq!(values, [4.0, 5.0, 6.0, 9.0, 1.0, 2.0, 3.0, 9.0]);
}

#[test]
fn two_fields_of_the_same_items_are_written_at_once() {
    #[derive(Clone, Default)]
    struct Body {
        spin: [f64; 3],
        velocity: [f64; 3],
    }
    let mut world = moving_world();
    world
        .set_velocities(&VELOCITIES, &[[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])
        .unwrap();
    let mut bodies = vec![Body::default(); 2];
    let (velocities, spins) =
        ViewMut::of_two(&mut bodies, |body| (&mut body.velocity, &mut body.spin));
    world.velocities_into(velocities, spins).unwrap();
    assert_eq!([bodies[0].velocity, bodies[1].velocity], VELOCITIES);
    assert_eq!(
        [bodies[0].spin, bodies[1].spin],
        [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]]
    );
}

#[test]
fn states_and_forces_of_all_blocks_are_those_one_by_one() {
    let forces = [[1e3, 0.0, 0.0], [0.0, 2e3, 0.0]];
    let torques = [[0.0, 0.0, 3.0], [4.0, 0.0, 0.0]];
    let (mut world, mut other) = (moving_world(), moving_world());
    world.set_applied_forces(&forces, &torques).unwrap();
    for (block, (force, torque)) in other
        .blocks()
        .into_iter()
        .zip(forces.into_iter().zip(torques))
    {
        other.set_applied_force(block, force, torque).unwrap();
    }
    world.step(10).unwrap();
    other.step(10).unwrap();
    let single: Vec<_> = other
        .blocks()
        .into_iter()
        .map(|block| other.block_state(block).unwrap())
        .collect();
    assert_eq!(world.block_states(), single);
    assert_ne!(single, moving_world().block_states());
    assert!(world.set_applied_forces(&forces[..1], &torques).is_err());
}

#[test]
fn arrays_of_the_wrong_length_are_refused_before_anything_is_written() {
    let mut world = moving_world();
    let mut one = [[9.0; 3]; 1];
    let error = world
        .velocities_into(&mut one, ViewMut::none())
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "World::velocities_into: velocities has 1 entries; the world has 2 blocks"
    );
    world.detect().unwrap();
    assert!(world.forces(0.0, &mut one, ViewMut::none()).is_err());
    assert!(world.poses_into(&mut []).is_err());
    assert!(world.set_poses(&world.poses()[..1]).is_err());
    assert!(world
        .set_velocities(&one, View::from(&[[0.0; 3]; 0]))
        .is_err());
    assert_eq!(one, [[9.0; 3]]);
}

#[test]
fn nothing_is_a_view_of_nothing() {
    assert_eq!(View::from(&[[0.0; 2]; 0]).count(), 0);
    assert_eq!(View::strided(&[], [0, 0, 0], 0, 0).count(), 0);
    assert_eq!(View::strided(&[0.0; 2], [0, 1], isize::MAX, 1).count(), 1);
    assert_eq!(ViewMut::none().count(), 0);
    let empty: [Node; 0] = [];
    assert_eq!(View::of(&empty, |node| &node.position).count(), 0);
}

#[test]
#[should_panic(expected = "components of different lengths: [4, 3]")]
fn components_have_one_length() {
    View::components([&[0.0; 4], &[0.0; 3]]);
}

#[test]
#[should_panic(expected = "points from 2 to 11 in an array of 11 values")]
fn a_section_ends_within_its_array() {
    View::strided(&[0.0; 11], [0, 1, 2], 3, 4);
}

#[test]
#[should_panic(expected = "points from 5 to -1 in an array of 12 values")]
fn a_section_backwards_begins_within_its_array() {
    View::strided(&[0.0; 12], [6, 5, 8], -3, 3);
}

#[test]
#[should_panic(expected = "the stride of 2 points is 0")]
fn points_do_not_lie_on_each_other() {
    ViewMut::strided(&mut [0.0; 3], [0, 1, 2], 0, 2);
}

#[test]
#[should_panic(expected = "outside its item")]
fn a_field_behind_a_pointer_is_none() {
    View::of(&[Box::new([0.0; 3]), Box::new([0.0; 3])], |item| item);
}

#[test]
#[should_panic(expected = "outside its item")]
fn a_field_elsewhere_is_none() {
    static ELSEWHERE: [f64; 3] = [0.0; 3];
    View::of(&[[1.0; 3]; 2], |_| &ELSEWHERE);
}

#[test]
#[should_panic(expected = "different offsets")]
fn a_field_that_moves_about_is_none() {
    struct Item {
        points: [[f64; 2]; 2],
        chosen: usize,
    }
    let items = [0, 1].map(|chosen| Item {
        points: [[0.0; 2]; 2],
        chosen,
    });
    View::of(&items, |item| &item.points[item.chosen]);
}
