//! Contexts in several threads, and moved between threads. With the thread sanitizer this checks
//! that contexts share nothing.

use std::thread;

use halfspace::{
    BlockDef, Contact, Context, Detector, Error, Family, Law, Material, Mesh, PairCache, Pose,
    Shape, View, ViewMut, World, WorldDef,
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
    let context = square.context();
    drop(world);
    assert!(Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).is_err());
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
    fn may_go<T: Send>() {}
    may_go::<Family<(Context, Vec<Shape>, World)>>();
    may_go::<Family<(Mesh, World)>>();
}
