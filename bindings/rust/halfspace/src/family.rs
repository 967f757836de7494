//! Moving contexts to another thread.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use crate::context::{Context, Owner};
use crate::mesh::Mesh;
use crate::shape::Shape;
use crate::world::World;

/// A context with everything made from it, which can be moved to another thread.
///
/// A context and everything made from it must be used by one thread at a time, so they can move
/// only together. A family holds all of them; [`Family::gather`] checks this by the reference
/// counts. The members cannot be used inside a family; [`Family::into_inner`] returns them, in any
/// thread.
///
/// ```
/// use halfspace::{BlockDef, Context, Family, Shape, World, WorldDef};
///
/// let context = Context::new()?;
/// let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let mut world = World::new(&context, &WorldDef::in_plane().time_step(1e-3))?;
/// let stone = world.add_material(2000.0)?;
/// world.add_block(&square, &BlockDef::rigid(stone))?;
/// drop(square); // the world has its own copy
///
/// let family = Family::gather((context, world)).expect("nothing is left outside");
/// let steps = std::thread::spawn(move || {
///     let (_context, mut world) = family.into_inner();
///     world.step(100)?;
///     Ok::<_, halfspace::Error>(world.report()?.steps)
/// });
/// assert_eq!(steps.join().unwrap()?, 100);
/// # Ok::<(), halfspace::Error>(())
/// ```
///
/// A reference to a family gives no access to its members, as a copy of a handle could remain
/// outside:
///
/// ```compile_fail,E0599
/// # let context = halfspace::Context::new().unwrap();
/// let family = halfspace::Family::gather(context).unwrap();
/// let left_behind = family.clone();
/// ```
pub struct Family<T: Members> {
    members: T,
}

// SAFETY: the members are all objects of their contexts, so no other thread shares reference counts
// or objects of the library with them. The library has no thread-local state, and the allocators of
// a context may be called from any thread.
unsafe impl<T: Members> Send for Family<T> {}

impl<T: Members> Family<T> {
    /// Gathers members of one or more contexts. Returns them as the error if a handle to one of
    /// their contexts, or an object made from it, is missing.
    pub fn gather(members: T) -> Result<Self, T> {
        let mut seen = BTreeMap::<*const Owner, (usize, usize)>::new();
        members.visit(&mut |owner| {
            seen.entry(Arc::as_ptr(owner))
                .or_insert((0, Arc::strong_count(owner)))
                .0 += 1;
        });
        if seen
            .values()
            .all(|(gathered, existing)| gathered == existing)
        {
            Ok(Self { members })
        } else {
            Err(members)
        }
    }

    /// Returns the members, for use in this thread.
    pub fn into_inner(self) -> T {
        self.members
    }
}

impl<T: Members> fmt::Debug for Family<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Family").finish_non_exhaustive()
    }
}

/// Types that can be members of a [`Family`]: [`Context`], [`Shape`], [`Mesh`], [`World`], and
/// vectors, options and tuples of them. No other type can implement it.
pub trait Members: sealed::Members {}

impl<T: sealed::Members> Members for T {}

mod sealed {
    use super::{Arc, Owner};

    /// For types that hold only handles; `visit` must visit all of them.
    pub trait Members {
        fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>));
    }
}

impl sealed::Members for Context {
    fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
        visitor(self.owner());
    }
}

macro_rules! with_object {
    ($($member:ty),*) => {
        $(impl sealed::Members for $member {
            fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
                visitor(self.object.owner());
            }
        })*
    };
}

with_object!(Shape, Mesh, World);

impl<T: sealed::Members> sealed::Members for Vec<T> {
    fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
        self.iter().for_each(|member| member.visit(visitor));
    }
}

impl<T: sealed::Members> sealed::Members for Option<T> {
    fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
        self.iter().for_each(|member| member.visit(visitor));
    }
}

impl<A: sealed::Members, B: sealed::Members> sealed::Members for (A, B) {
    fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
        self.0.visit(visitor);
        self.1.visit(visitor);
    }
}

impl<A: sealed::Members, B: sealed::Members, C: sealed::Members> sealed::Members for (A, B, C) {
    fn visit(&self, visitor: &mut dyn FnMut(&Arc<Owner>)) {
        self.0.visit(visitor);
        self.1.visit(visitor);
        self.2.visit(visitor);
    }
}
