//! Safe Rust interface of libhalfspace: contact detection between convex polygons or polyhedra,
//! contact forces, and time integration of blocks. Each stage can be used alone.
//!
//! Contact of one pair of shapes at given poses:
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
//! A [`World`], stepped by the library:
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
//! An affine block has uniform strain, by the elasticity of its material:
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
//! A mesh is a body of finite elements:
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
//! A [`Bond`] connects two blocks of any kind until it fails. [`World::relax`] brings a world to
//! static equilibrium, and [`World::find_strength_factor`] computes its factor of safety.
//!
//! A host with its own integrator sets poses and velocities, calls [`World::detect`] and
//! [`World::forces`], and moves its bodies itself: see the example `own_integrator`.
//!
//! # Conventions
//! SI or any consistent set of units, angles in radians, right-handed axes, quaternions x, y, z, w.
//! A normal points from block a to block b; a gap below 0 is an overlap. Indices start at 0. In 2D
//! z components of arguments are ignored, those of results are 0, and areas and volumes are per
//! unit thickness. A [`Tensor`] is an array of rows.
//!
//! # Arrays
//! Arrays of points are accessed in the caller's memory, without a copy: `&[[f64; 2]]` or `&[[f64;
//! 3]]`, and through [`View`] and [`ViewMut`] separate arrays of x, y and z, fields of your own
//! structs, or any strided array.
//!
//! # Errors
//! Functions that can fail return a [`Result`]. Its [`Error`] has the text of the library:
//! function, argument, value. A failed call has changed nothing.
//!
//! # Threads
//! Shapes are [`Send`] and [`Sync`]: several threads may detect contacts of the same shapes. A
//! context, its meshes and its worlds must be used by one thread at a time; different contexts share
//! nothing. So [`Context`], [`Mesh`] and [`World`] are neither. Make a context in every thread, or
//! move a context to another thread with everything made from it, as a [`Family`].
//!
//! ```
//! # let context = halfspace::Context::new().unwrap();
//! let shape = halfspace::Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
//! std::thread::spawn(move || shape.properties()); // the context stays here
//! ```
//! ```compile_fail,E0277
//! # let context = halfspace::Context::new().unwrap();
//! let world = halfspace::World::new(&context, &halfspace::WorldDef::in_plane()).unwrap();
//! std::thread::scope(|scope| scope.spawn(|| world.block_count()).join()); // in two threads
//! ```
#![warn(missing_docs, unsafe_op_in_unsafe_fn)]

mod action;
mod affine;
mod block;
mod body;
mod bolt;
mod bond;
mod call;
mod compound;
mod constants;
mod contact;
mod context;
mod definition;
mod definitions;
mod error;
mod family;
mod impact;
mod kinds;
mod law;
mod mesh;
mod mutable_view;
mod object;
mod pair;
mod placed;
mod pose;
mod query;
mod records;
mod relax;
mod shape;
mod shape_input;
mod share;
mod strength;
mod view;
mod water;
mod world;
mod world_arrays;

pub use action::{Action, Table};
pub use affine::{Elasticity, Tensor};
pub use block::{Block, BlockDef, Material};
pub use body::{Axes, Body, BodyDef};
pub use bolt::Bolt;
pub use bond::Bond;
pub use contact::Contact;
pub use context::{version, Context};
pub use error::Error;
pub use family::{Family, Members};
pub use impact::{time_of_impact, Impact, Motion};
pub use kinds::*;
pub use law::Law;
pub use mesh::{Cell, Mesh};
pub use mutable_view::ViewMut;
pub use pair::{detect, Bodies, Detector, PairCache};
pub use placed::Placed;
pub use pose::Pose;
pub use query::{closest_points, find_box_pairs, order_along_curve};
pub use records::*;
pub use relax::{Relaxation, Relaxed};
pub use shape::{Cut, HalfSpace, Shape};
pub use share::{Packed, Sums};
pub use strength::StrengthSearch;
pub use view::{Point, View};
pub use water::Water;
pub use world::{World, WorldDef};

/// The result of functions of this crate that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The programs in the README compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
