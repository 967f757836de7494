//! Finds the contacts between convex polygons or polyhedra, computes the contact forces and moves
//! the blocks in time: the safe Rust layer of libhalfspace. Use all of it or only the stage that
//! your program lacks.
//!
//! One pair of shapes, where you say they are:
//!
//! ```
//! use halfspace::{detect, ContactType, Context, Pose, Shape};
//!
//! let context = Context::new()?;
//! let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
//! let (lower, upper) = (Pose::default(), Pose::in_plane(0.25, 0.875, 0.0));
//!
//! let contact = detect(square.at(&lower), square.at(&upper))?;
//! assert_eq!(contact.kind(), ContactType::EdgeEdge);
//! assert_eq!((contact.gap(), contact.normal(), contact.area()), (-0.125, [0.0, 1.0, 0.0], 0.75));
//! # Ok::<(), halfspace::Error>(())
//! ```
//!
//! A whole [`World`], stepped by the library:
//!
//! ```
//! use halfspace::{BlockDef, Context, Law, Pose, Shape, World, WorldDef};
//!
//! let context = Context::new()?;
//! let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
//!
//! let mut world = World::new(&context, &WorldDef::in_plane().local_damping(0.2))?;
//! let law = Law::default().normal_stiffness(1e7).shear_stiffness(1e7).friction_angle(0.5);
//! world.set_default_law(&law)?;
//! let stone = world.add_material(2000.0)?;
//! world.add_block(&square, &BlockDef::fixed(stone))?;
//! let above = Pose::in_plane(0.5, 1.75, 0.0);
//! let upper = world.add_block(&square, &BlockDef::rigid(stone).at(above))?;
//!
//! world.step(1000)?;
//! assert!(world.block_state(upper)?.pose.position[1] < 1.75);
//! # Ok::<(), halfspace::Error>(())
//! ```
//!
//! An affine block strains as a whole, by the elasticity of its material:
//!
//! ```
//! # use halfspace::{BlockDef, Context, Shape, World, WorldDef};
//! use halfspace::Elasticity;
//!
//! # let context = Context::new()?;
//! # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
//! # let mut world = World::new(&context, &WorldDef::in_plane().gravity([0.0; 3]))?;
//! let rubber = world.add_material(1100.0)?;
//! world.set_elasticity(rubber, &Elasticity::default().young_modulus(1e6).poisson_ratio(0.45))?;
//! let block = world.add_block(&square, &BlockDef::affine(rubber))?;
//! world.add_surface_load(block, 1, [1e5, 0.0, 0.0])?;
//! world.add_surface_load(block, 3, [-1e5, 0.0, 0.0])?;
//! world.step(10)?;
//! assert!(world.deformation(block)?.strain[0][0] > 0.0);
//! # Ok::<(), halfspace::Error>(())
//! ```
//!
//! A mesh is a body of finite elements, which bends and carries waves:
//!
//! ```
//! # use halfspace::{Context, Elasticity, World, WorldDef};
//! use halfspace::{Axes, BodyDef, Cell, Mesh};
//!
//! # let context = Context::new()?;
//! # let mut world = World::new(&context, &WorldDef::in_plane().gravity([0.0; 3]))?;
//! # let rubber = world.add_material(1100.0)?;
//! # world.set_elasticity(rubber, &Elasticity::default().young_modulus(1e6))?;
//! let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
//! let mesh = Mesh::in_plane(&context, &nodes, &[Cell::Quad([0, 1, 2, 3])])?;
//! let body = world.add_mesh(&mesh, &BodyDef::of(rubber))?;
//! world.hold_nodes(body, &[0, 3], Axes::X | Axes::Y, [0.0; 3])?;
//! world.set_node_force(body, &[1, 2], [1e4, 0.0, 0.0])?;
//! world.step(10)?;
//! assert!(world.node_positions(body)?[1][0] > 1.0);
//! # Ok::<(), halfspace::Error>(())
//! ```
//!
//! A [`Bond`] holds two blocks of any kind together until it fails. [`World::relax`] brings a world to
//! rest, and [`World::find_strength_factor`] tells how many times weaker it could be until it falls.
//!
//! A host with its own integrator sets poses and velocities, calls [`World::detect`] and
//! [`World::forces`], and moves its bodies itself: see the example `own_integrator`.
//!
//! # Conventions
//! SI or any consistent set of units, angles in radians, right-handed axes, quaternions x, y, z, w.
//! A normal points from block a to block b; a gap below 0 is an overlap. Indices start at 0. In the
//! plane every z that goes in is ignored and every one that comes out is 0, and areas and volumes
//! are per unit thickness. A [`Tensor`] is its rows.
//!
//! # Arrays
//! Points are taken and given as they lie in your memory, without a copy: `&[[f64; 2]]` or `&[[f64;
//! 3]]`, and through [`View`] and [`ViewMut`] separate arrays of x, y and z, fields of your own
//! structs, or any strided array.
//!
//! # Errors
//! What can fail gives a [`Result`] whose [`Error`] carries the library's own text: function,
//! argument, value. A call that failed has changed nothing. What cannot fail gives its value.
//!
//! # Threads
//! A context and everything made from it belong to one thread at a time; different contexts share
//! nothing. So [`Context`], [`Shape`], [`Mesh`] and [`World`] are neither [`Send`] nor [`Sync`]. Make a
//! context in every thread, or hand a context over to another thread together with all that was
//! made from it, as a [`Family`].
//!
//! ```compile_fail,E0277
//! # let context = halfspace::Context::new().unwrap();
//! let shape = halfspace::Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
//! std::thread::spawn(move || shape.properties()); // its context stays behind
//! ```
//! ```compile_fail,E0277
//! # let context = halfspace::Context::new().unwrap();
//! let world = halfspace::World::new(&context, &halfspace::WorldDef::in_plane()).unwrap();
//! std::thread::scope(|scope| scope.spawn(|| world.block_count()).join()); // in two threads
//! ```
#![warn(missing_docs, unsafe_op_in_unsafe_fn)]

mod affine;
mod block;
mod body;
mod bond;
mod constants;
mod contact;
mod context;
mod error;
mod family;
mod impact;
mod law;
mod mesh;
mod mutable_view;
mod pair;
mod placed;
mod plan;
mod pose;
mod relax;
mod report;
mod shape;
mod shape_input;
mod strength;
mod view;
mod world;
mod world_arrays;

pub use affine::{Deformation, Elasticity, Tensor};
pub use block::{Block, BlockDef, BlockKind, BlockState, Material};
pub use body::{Axes, Body, BodyDef, BodyState, CellState};
pub use bond::{Bond, BondEvent, BondFailure, BondReport, BondState};
pub use contact::{Contact, ContactType, PairKind};
pub use context::{version, Context};
pub use error::{Error, ErrorKind};
pub use family::{Family, Members};
pub use impact::{time_of_impact, Impact, ImpactState, Motion};
pub use law::Law;
pub use mesh::{Cell, Mesh, MeshProperties};
pub use mutable_view::ViewMut;
pub use pair::{detect, Bodies, Detector, PairCache};
pub use placed::Placed;
pub use plan::Plan;
pub use pose::Pose;
pub use relax::{Balance, Relaxation, Relaxed};
pub use report::{Energy, Report};
pub use shape::{Cut, HalfSpace, Shape, ShapeProperties};
pub use shape_input::{Cleaned, Fault, FaultKind, FitReport};
pub use strength::{StrengthFound, StrengthSearch};
pub use view::{Point, View};
pub use world::{World, WorldDef};

/// What a call of this crate gives that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The programs in the README compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
