//! What a world was given: settings, materials, laws, tables and actions.

use std::ffi::CStr;
use std::mem::size_of;

use halfspace_sys as sys;

use crate::action::{Action, Table};
use crate::affine::Elasticity;
use crate::block::{Block, Material};
use crate::call::{call, counted, known, known_list, listed, written};
use crate::kinds::Setting;
use crate::law::Law;
use crate::mutable_view::ViewMut;
use crate::records::Note;
use crate::world::{World, WorldDef};
use crate::Result;

/// What it was given, as it is at present.
impl World {
    /// Returns the settings, with gravity, damping and time step as they were set last.
    ///
    /// ```
    /// use halfspace::{Context, World, WorldDef};
    ///
    /// # let context = Context::new()?;
    /// let mut world = World::new(&context, &WorldDef::in_space().local_damping(0.1))?;
    /// world.set_gravity([0.0, 0.0, -1.62])?;
    /// let other = World::new(&context, &world.definition())?;
    /// assert_eq!(other.definition().values().gravity, [0.0, 0.0, -1.62]);
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn definition(&self) -> WorldDef {
        let raw = known(|def, size| call!(self => hs_world_get_def(def, size)));
        WorldDef { raw }
    }

    /// Returns the densities of all materials, in kg/m3, by their index.
    pub fn densities(&self) -> Vec<f64> {
        known_list(|room, count| call!(self => hs_world_get_densities([mut room], count)))
    }

    /// Returns the elasticity of a material; `None` if it was given none.
    pub fn elasticity(&self, material: Material) -> Result<Option<Elasticity>> {
        let raw: sys::hs_elasticity_def =
            written(|def, size| call!(self => hs_world_get_elasticity(material, def, size)))?;
        Ok((raw.young_modulus > 0.0).then_some(Elasticity { raw }))
    }

    /// Returns the law of all pairs of materials without a law of their own.
    pub fn default_law(&self) -> Law {
        let raw = known(|law, size| call!(self => hs_world_get_default_law(law, size)));
        Law { raw }
    }

    /// Returns the law of two materials, in either order: their own, or the default law. Its
    /// strengths are those that were given, before division by the factor of
    /// [`World::set_strength_factor`].
    pub fn law(&self, a: Material, b: Material) -> Result<Law> {
        let raw = written(|law, size| call!(self => hs_world_get_law(a, b, law, size)))?;
        Ok(Law { raw })
    }

    /// Returns the times, in s, and the rows of a table.
    pub fn table(&self, table: Table) -> Result<(Vec<f64>, Vec<[f64; 3]>)> {
        let length = counted(
            |count| call!(self => hs_world_get_table(table, None, ViewMut::none(), count)),
        )?;
        let (mut times, mut rows) = (vec![0.0; length], vec![[0.0; 3]; length]);
        let (room, view) = (times.as_mut_ptr(), ViewMut::from(&mut rows));
        // SAFETY: there is one time per row.
        call!(self => hs_world_get_table(table, unsafe room, view, &mut 0))?;
        Ok((times, rows))
    }

    /// Returns the actions on a block, or with `None` those on all blocks, in the order in which
    /// they were added. Where a later motion ended one along some axes, its scale is 0 there. A
    /// point that the block carries is where it is now.
    pub fn actions(&self, block: impl Into<Option<Block>>) -> Result<Vec<Action>> {
        let (block, size) = (block.into(), size_of::<sys::hs_action_def>());
        let actions = listed(|room: &mut [sys::hs_action_def], count| {
            let (first, capacity) = (room.as_mut_ptr(), room.len());
            // SAFETY: the array is as long as said.
            call!(self => hs_world_get_actions(block, unsafe first, size, capacity, count))
        })?;
        Ok(actions.into_iter().map(|raw| Action { raw }).collect())
    }

    /// Returns the settings with unusual values, which are probably in another unit.
    ///
    /// ```
    /// use halfspace::{Context, Setting, World, WorldDef};
    ///
    /// # let context = Context::new()?;
    /// let mut world = World::new(&context, &WorldDef::in_plane())?;
    /// world.add_material(2.7)?;
    /// let notes = world.notes();
    /// assert_eq!((notes[0].setting, notes[0].value), (Setting::Density, 2.7));
    /// assert_eq!(Setting::Density.usual_text(), "50 to 19500 kg/m3, 2700 of rock");
    /// # Ok::<(), halfspace::Error>(())
    /// ```
    pub fn notes(&self) -> Vec<Note> {
        known_list(|room, count| call!(self => hs_world_check([mut room], count)))
    }
}

impl Setting {
    /// The smallest usual value but 0, which is usual, too, and the largest one; `None` for a
    /// setting of a later version of the library.
    pub fn usual_range(self) -> Option<(f64, f64)> {
        let (mut low, mut high) = (0.0, 0.0);
        // SAFETY: both numbers are written.
        let status = unsafe { sys::hs_setting_get_usual(self.value(), &mut low, &mut high) };
        (status == sys::HS_OK).then_some((low, high))
    }

    /// The usual range in words, with the unit.
    pub fn usual_text(self) -> &'static str {
        // SAFETY: the library returns a static string, never NULL.
        let text = unsafe { CStr::from_ptr(sys::hs_setting_usual_text(self.value())) };
        text.to_str().unwrap_or("")
    }
}
