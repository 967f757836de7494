//! Concave blocks: compounds of convex parts with one mass and one motion.

use std::mem::{size_of, MaybeUninit};
use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, BlockDef};
use crate::error::Error;
use crate::pose::Pose;
use crate::shape::Shape;
use crate::world::World;
use crate::Result;

/// Concave blocks.
impl World {
    /// Adds a fixed, prescribed or rigid compound of convex parts, which touch or are apart. `poses`
    /// are those of the parts in one frame, one per shape; without any, parts are at the coordinates
    /// of their vertices. The pose of the definition is that of the centroid of all parts.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Shape, World, WorldDef};
    /// # let context = Context::new()?;
    /// let foot = Shape::polygon(&context, &[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]])?;
    /// let leg = Shape::polygon(&context, &[[0.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # let stone = world.add_material(2000.0)?;
    /// let hook = world.add_compound(&[&foot, &leg], &[], &BlockDef::rigid(stone))?;
    /// assert_eq!(world.block_state(hook)?.mass, 10000.0);
    /// let parts = world.compound_parts(hook)?;
    /// assert_eq!(world.compound_of_block(parts[1])?, Some((hook, 1)));
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::Geometry`](crate::ErrorKind::Geometry) for parts that overlap.
    pub fn add_compound(
        &mut self,
        shapes: &[&Shape],
        poses: &[Pose],
        def: &BlockDef,
    ) -> Result<Block> {
        if !poses.is_empty() && poses.len() != shapes.len() {
            return Err(Error::argument(&format!(
                "World::add_compound: poses has {} entries; there are {} shapes",
                poses.len(),
                shapes.len()
            )));
        }
        let handles: Vec<_> = shapes.iter().map(|shape| shape.handle()).collect();
        let places: Vec<sys::hs_pose> = poses.iter().map(|pose| (*pose).into()).collect();
        let places = if places.is_empty() {
            ptr::null()
        } else {
            places.as_ptr()
        };
        let count = shapes.len() as i64;
        let mut raw = MaybeUninit::<sys::hs_block_def>::zeroed();
        let mut id = 0;
        // SAFETY: the size is that of the struct, for which all zero is valid; world and shapes live, and
        // the arrays are as long as said.
        self.check(unsafe {
            let size = size_of::<sys::hs_block_def>();
            sys::hs_compound_def_init(raw.as_mut_ptr(), size, handles.as_ptr(), places, count);
            let raw = def.changed(raw.assume_init());
            sys::hs_world_add_compound(
                self.handle(),
                handles.as_ptr(),
                places,
                count,
                &raw,
                &mut id,
            )
        })?;
        self.block_count += 1 + shapes.len();
        Block::from_raw(id)
            .ok_or_else(|| Error::argument("World::add_compound: the library returned the id 0"))
    }

    /// The parts of a compound, in the order in which they were given; none for other blocks.
    pub fn compound_parts(&self, block: Block) -> Result<Vec<Block>> {
        let mut count = 0;
        // SAFETY: the world lives, and no part is written.
        self.check(unsafe {
            let none = ptr::null_mut();
            sys::hs_world_get_compound_parts(self.handle(), block.id(), none, 0, &mut count)
        })?;
        let mut ids = vec![0; count as usize];
        // SAFETY: the world lives, and the array is as long as said.
        self.check(unsafe {
            let room = ids.as_mut_ptr();
            sys::hs_world_get_compound_parts(
                self.handle(),
                block.id(),
                room,
                count,
                ptr::null_mut(),
            )
        })?;
        Ok(ids.into_iter().filter_map(Block::from_raw).collect())
    }

    /// The compound of a part, and the index of the part; `None` for a block that is not a part.
    pub fn compound_of_block(&self, block: Block) -> Result<Option<(Block, usize)>> {
        let (mut compound, mut part) = (0, -1);
        // SAFETY: the world lives.
        self.check(unsafe {
            sys::hs_world_get_compound_of_block(self.handle(), block.id(), &mut compound, &mut part)
        })?;
        Ok(Block::from_raw(compound).map(|compound| (compound, part as usize)))
    }
}
