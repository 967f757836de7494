//! Bolts and cables: lines between two places that blocks carry, or between a block and the ground.

use halfspace_sys as sys;

use crate::block::Block;
use crate::call::{call, known_list, written};
use crate::records::BoltState;
use crate::world::World;
use crate::Result;

/// Properties of a bolt: an axial force, linear in its elongation, with yield and rupture.
///
/// ```
/// use halfspace::Bolt;
/// let anchor = Bolt::default().place_b([5.0, 1.0, 0.0]).stiffness(2e7).pretension(1e5);
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Bolt {
    pub(crate) raw: sys::hs_bolt_def,
}

impl Bolt {
    /// A bolt between the current positions of two places. `None` is the ground: the place stays.
    pub fn between(
        a: Option<Block>,
        place_a: [f64; 3],
        b: Option<Block>,
        place_b: [f64; 3],
    ) -> Self {
        let mut bolt = Self::default().place_a(place_a).place_b(place_b);
        bolt.raw.block_a = a.map_or(0, Block::id);
        bolt.raw.block_b = b.map_or(0, Block::id);
        bolt
    }
}

/// Bolts.
impl World {
    /// Adds a bolt, and returns its number, which no later bolt gets. The removal of a block
    /// removes its bolts.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Pose, Shape, World, WorldDef};
    /// use halfspace::Bolt;
    ///
    /// # let context = Context::new()?;
    /// # let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # let stone = world.add_material(2000.0)?;
    /// let lamp = world.add_block(&square, &BlockDef::rigid(stone).at(Pose::in_plane(0.5, 0.5, 0.0)))?;
    /// let cable = Bolt::between(None, [0.5, 3.0, 0.0], Some(lamp), [0.5, 0.5, 0.0]).pretension(2000.0 * 9.81);
    /// world.add_bolt(&cable)?;
    /// world.step(100)?;
    /// assert!((world.bolts()[0].tension - 2000.0 * 9.81).abs() < 1e-6);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::State`](crate::ErrorKind::State) if neither block moves.
    pub fn add_bolt(&mut self, bolt: &Bolt) -> Result<u64> {
        let number: i64 =
            written(|number, _| call!(mut self => hs_world_add_bolt(&bolt.raw, number)))?;
        Ok(number as u64)
    }

    /// Removes a bolt.
    ///
    /// # Errors
    /// [`ErrorKind::StaleId`](crate::ErrorKind::StaleId) if there is no such bolt.
    pub fn remove_bolt(&mut self, number: u64) -> Result<()> {
        call!(mut self => hs_world_remove_bolt(number))
    }

    /// Returns all bolts, in ascending order of their numbers.
    pub fn bolts(&self) -> Vec<BoltState> {
        known_list(|room, count| call!(self => hs_world_get_bolts([mut room], count)))
    }

    /// Finds the block in which a place is deepest; `None` if it is outside of all blocks.
    pub fn block_at(&self, place: [f64; 3]) -> Result<Option<Block>> {
        let block = written(|block, _| call!(self => hs_world_get_block_at(&place, block)))?;
        Ok(Block::from_id(block))
    }
}
