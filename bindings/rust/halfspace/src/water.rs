//! Water below a table.

use halfspace_sys as sys;

use crate::call::call;
use crate::mutable_view::ViewMut;
use crate::view::View;
use crate::world::World;
use crate::Result;

/// Properties of water: its density, and a factor of its pressure.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Water {
    pub(crate) raw: sys::hs_water_def,
}

/// Water.
impl World {
    /// Sets the water of a world, in place of the water before. The table has in 2D the corners of
    /// a polyline, in ascending order of x, level beyond its ends; in 3D one point of a level plane,
    /// three points of a plane, or a height map with [`Water::columns`] points in each row. Without
    /// points there is no water.
    ///
    /// ```
    /// # use halfspace::{BlockDef, Context, Pose, Relaxation, Shape, World, WorldDef};
    /// use halfspace::{View, Water};
    ///
    /// # let context = Context::new()?;
    /// # let plank = Shape::polygon(&context, &[[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]])?;
    /// # let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// # let wood = world.add_material(600.0)?;
    /// let raft = world.add_block(&plank, &BlockDef::rigid(wood).at(Pose::in_plane(2.0, 0.5, 0.0)))?;
    /// world.set_water(&Water::default(), View::from(&[[0.0, 0.0]]))?;
    /// world.relax(&Relaxation::default().ratio(1e-8))?;
    /// assert!((world.block_state(raft)?.pose.position[1] + 0.1).abs() < 1e-5);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn set_water(&mut self, water: &Water, table: View) -> Result<()> {
        call!(mut self => hs_world_set_water(&water.raw, table))
    }

    /// Writes the current loads of water: the force on each block, in the order of
    /// [`World::blocks`], and its torque about the centroid.
    pub fn water_loads(&self, forces: ViewMut, torques: ViewMut) -> Result<()> {
        call!(self => hs_world_get_water_loads(forces, torques))
    }
}
