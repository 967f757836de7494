//! A context can use the program's allocator: all memory comes from it and is released to it, and
//! without memory calls return an error. It is a program without the test harness, whose threads
//! would be counted as well.

use std::alloc::{GlobalAlloc, Layout, System};
use std::ptr;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use halfspace::{BlockDef, Context, ErrorKind, Pose, Shape, World, WorldDef};

/// Counts allocations, and refuses those above a limit.
struct Ledger;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static LIMIT: AtomicUsize = AtomicUsize::new(usize::MAX);

unsafe impl GlobalAlloc for Ledger {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.size() > LIMIT.load(Relaxed) {
            return ptr::null_mut();
        }
        IN_USE.fetch_add(layout.size(), Relaxed);
        System.alloc(layout)
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Relaxed);
        System.dealloc(memory, layout);
    }
}

#[global_allocator]
static LEDGER: Ledger = Ledger;

fn circle(count: usize) -> Vec<[f64; 2]> {
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / count as f64;
    (0..count)
        .map(|i| [angle(i).cos(), angle(i).sin()])
        .collect()
}

fn world_of_circles(context: &Context, points: &[[f64; 2]]) -> World {
    let circle = Shape::polygon(context, points).unwrap();
    let mut world = World::new(context, &WorldDef::in_plane().time_step(1e-4)).unwrap();
    let wood = world.add_material(700.0).unwrap();
    for i in 0..20 {
        world
            .add_block(
                &circle,
                &BlockDef::rigid(wood).at(Pose::at([0.0, 2.0 * f64::from(i), 0.0])),
            )
            .unwrap();
    }
    world.step(10).unwrap();
    world
}

fn all_memory_comes_from_the_program_and_goes_back() {
    let points = circle(100);
    let before = IN_USE.load(Relaxed);
    let with_own = world_of_circles(&Context::with_global_allocator().unwrap(), &points);
    // Vertices and half-spaces of 20 blocks alone.
    assert!(IN_USE.load(Relaxed) - before > 20 * 100 * 5 * 8);
    drop(with_own);
    assert_eq!(IN_USE.load(Relaxed), before);

    let with_the_other = world_of_circles(&Context::new().unwrap(), &points);
    assert!(IN_USE.load(Relaxed) - before < 1000);
    drop(with_the_other);
    assert_eq!(IN_USE.load(Relaxed), before);
}

fn without_memory_there_is_an_error() {
    let context = Context::with_global_allocator().unwrap();
    let points = circle(20_000);
    let before = IN_USE.load(Relaxed);
    LIMIT.store(100_000, Relaxed);
    let refused = Shape::polygon(&context, &points);
    LIMIT.store(usize::MAX, Relaxed);
    let error = refused.unwrap_err();
    assert_eq!(error.kind(), ErrorKind::OutOfMemory);
    assert_eq!(
        error.to_string(),
        "hs_polygon_create: the allocator returned no memory"
    );
    drop(error);
    assert_eq!(IN_USE.load(Relaxed), before);
    assert_eq!(
        Shape::polygon(&context, &points)
            .unwrap()
            .properties()
            .vertex_count,
        20_000
    );
}

fn main() {
    all_memory_comes_from_the_program_and_goes_back();
    without_memory_there_is_an_error();
}
