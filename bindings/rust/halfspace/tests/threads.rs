//! Contexts in several threads, and moved between threads. With the thread sanitizer this checks
//! that contexts share nothing.

use std::thread;

use halfspace::{
    closest_points, detect, BlockDef, Bodies, Contact, Context, Detector, Error, ErrorKind, Family,
    Law, Material, Mesh, PairCache, Placed, Pose, Shape, View, ViewMut, World, WorldDef,
};

/// A square falls onto another and slides off.
fn scene(context: &Context) -> World {
    let square = Shape::polygon(
        context,
        &[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]],
    )
    .unwrap();
    let mut world = World::new(context, &WorldDef::in_plane().time_step(1e-3)).unwrap();
    let stone = world.add_material(2000.0).unwrap();
    world
        .set_default_law(
            &Law::default()
                .normal_stiffness(1e7)
                .shear_stiffness(1e7)
                .friction_angle(0.2),
        )
        .unwrap();
    world
        .add_block(
            &square,
            &BlockDef::fixed(stone).at(Pose::in_plane(0.0, 0.0, 0.3)),
        )
        .unwrap();
    world
        .add_block(
            &square,
            &BlockDef::rigid(stone).at(Pose::in_plane(0.1, 1.5, 0.1)),
        )
        .unwrap();
    world
}

fn run(mut world: World) -> Vec<Pose> {
    world.step(2000).unwrap();
    world.poses()
}

#[test]
fn threads_with_a_context_each_get_the_same_bits() {
    let alone = run(scene(&Context::new().unwrap()));
    let threads: Vec<_> = (0..4)
        .map(|_| thread::spawn(|| run(scene(&Context::new().unwrap()))))
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap(), alone);
    }
}

#[test]
fn a_family_goes_on_elsewhere() {
    let expected = run(scene(&Context::new().unwrap()));
    let mut world = scene(&Context::new().unwrap());
    world.step(1000).unwrap();
    let family = Family::gather(world).unwrap();
    let family = thread::spawn(move || {
        let mut world = family.into_inner();
        world.step(1000).unwrap();
        Family::gather(world).unwrap()
    });
    assert_eq!(family.join().unwrap().into_inner().poses(), expected);
}

#[test]
fn a_family_is_whole() {
    let context = Context::new().unwrap();
    let world = scene(&context);
    let shape = Shape::polygon_hull(&context, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();

    // The shape and the context stay outside.
    let world = Family::gather(world).unwrap_err();
    // A second handle to the context stays outside.
    let second = world.context();
    let (context, world, shape) = Family::gather((context, world, shape)).unwrap_err();
    drop(second);
    let family = Family::gather((context, vec![(world, Some(shape))])).unwrap();
    let (context, mut members) = family.into_inner();
    let (world, shape) = members.pop().unwrap();
    drop((context, world));
    assert_eq!(shape.unwrap().vertices().len(), 3);
}

#[test]
fn a_family_may_be_of_several_contexts() {
    let (one, other) = (
        scene(&Context::new().unwrap()),
        scene(&Context::new().unwrap()),
    );
    let left_behind = other.context();
    let [one, other] =
        <[World; 2]>::try_from(Family::gather(vec![one, other]).unwrap_err()).unwrap();
    drop(left_behind);
    assert!(Family::gather((one, other)).is_ok());
}

#[test]
fn a_context_outlives_its_handle() {
    let world = scene(&Context::new().unwrap());
    let square = Shape::polygon(&world.context(), &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    drop(world);
    assert!(square.cut([0.0; 3], [0.0; 3]).is_err());
}

#[test]
fn threads_share_shapes_whatever_fails() {
    let context = Context::new().unwrap();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let square = Shape::polygon(&context, &corners).unwrap();
    let other = Shape::polygon(&Context::new().unwrap(), &corners).unwrap();
    let bodies = Bodies::from_iter([&square, &other]);
    thread::scope(|scope| {
        for number in 1..5 {
            let (square, other, bodies) = (&square, &other, &bodies);
            scope.spawn(move || {
                let x = 1.0 + f64::from(number);
                let (here, there) = (Pose::default(), Pose::at([x, 0.0, 0.0]));
                for _ in 0..100 {
                    let (a, b) = (square.at(&here), other.at(&there));
                    assert_eq!(closest_points(a, b).unwrap().distance, x - 1.0);
                    assert_eq!(detect(a, b).unwrap().gap(), x - 1.0);
                    let hit = b.cast_ray([0.5, 0.0, 0.0], [1.0, 0.0, 0.0], 100.0).unwrap();
                    assert_eq!(hit.unwrap().distance, x - 1.0);
                    let error = a.cast_ray([0.5, 0.0, 0.0], [0.0; 3], x).unwrap_err();
                    assert_eq!(error.kind(), ErrorKind::Argument);
                    let parts = square.cut([0.5, 0.5, 0.0], [x, 1.0, 0.0]).unwrap();
                    assert!(parts.behind.is_some() && parts.ahead.is_some());
                }
                // A context of this thread, and shapes of others.
                let mine = Context::new().unwrap();
                let mut contacts = [Contact::default()];
                let touching = Detector::default()
                    .detect_pairs(
                        &mine,
                        bodies,
                        &[here, there],
                        &[[0, 1]],
                        &mut [],
                        &mut contacts,
                    )
                    .unwrap();
                assert_eq!((touching, contacts[0].gap()), (0, x - 1.0));
            });
        }
    });
}

#[test]
fn a_shape_outlives_its_context_elsewhere() {
    let square = Shape::polygon(
        &Context::new().unwrap(),
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    );
    let mut square = square.unwrap();
    let vertices = thread::spawn(move || {
        square
            .set_vertices(&[[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]])
            .unwrap();
        square.vertices()
    });
    assert_eq!(vertices.join().unwrap()[1], [2.0, 0.0, 0.0]);
}

#[test]
fn what_is_no_handle_is_free_to_go() {
    fn free<T: Send + Sync>() {}
    free::<(
        Pose,
        Contact,
        PairCache,
        Detector,
        Error,
        Law,
        Material,
        WorldDef,
        BlockDef,
    )>();
    free::<(View, ViewMut)>();
    free::<(Shape, Bodies, Placed)>();
    fn may_go<T: Send>() {}
    may_go::<Family<(Context, Vec<Shape>, World)>>();
    may_go::<Family<(Mesh, World)>>();
}
