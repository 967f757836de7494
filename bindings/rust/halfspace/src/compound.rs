//! Concave blocks: compounds of convex parts with one mass and one motion.

use std::ptr;

use halfspace_sys as sys;

use crate::block::{Block, BlockDef};
use crate::call::{call, initial, listed};
use crate::error::{require_entries, Error};
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
        let name = "World::add_compound: poses";
        if !poses.is_empty() {
            require_entries(name, poses.len(), shapes.len(), "shapes")?;
        }
        let handles: Vec<_> = shapes.iter().map(|shape| shape.handle()).collect();
        let (first, count) = (handles.as_ptr(), shapes.len() as i64);
        let places = if poses.is_empty() {
            ptr::null()
        } else {
            poses.as_ptr()
        }
        .cast();
        // SAFETY: the size is that of the struct, the shapes live, and the arrays are as long as said.
        let raw = def.changed(initial(|def, size| unsafe {
            sys::hs_compound_def_init(def, size, first, places, count)
        }));
        let mut id = 0;
        // SAFETY: both arrays are as long as said.
        call!(mut self => hs_world_add_compound(unsafe first, unsafe places, count, &raw, &mut id))?;
        self.block_count += 1 + shapes.len();
        Block::from_id(id)
            .ok_or_else(|| Error::argument("World::add_compound: the library returned the id 0"))
    }

    /// The parts of a compound, in the order in which they were given; none for other blocks.
    pub fn compound_parts(&self, block: Block) -> Result<Vec<Block>> {
        let ids = listed(
            |room, count| call!(self => hs_world_get_compound_parts(block, [mut room], count)),
        )?;
        Ok(ids.into_iter().filter_map(Block::from_id).collect())
    }

    /// The compound of a part, and the index of the part; `None` for a block that is not a part.
    pub fn compound_of_block(&self, block: Block) -> Result<Option<(Block, usize)>> {
        let (mut compound, mut part) = (0, -1);
        call!(self => hs_world_get_compound_of_block(block, &mut compound, &mut part))?;
        Ok(Block::from_id(compound).map(|compound| (compound, part as usize)))
    }
}
