//! What a world was given: settings, materials, laws, tables and actions.

use std::ffi::CStr;
use std::mem::size_of;
use std::ptr;

use halfspace_sys as sys;

use crate::action::{Action, Table};
use crate::affine::Elasticity;
use crate::block::{Block, Material};
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
        // SAFETY: the world lives, and the size is that of the struct.
        let (status, raw) =
            written(|def, size| unsafe { sys::hs_world_get_def(self.handle(), def, size) });
        self.owner().expect(status);
        WorldDef { raw }
    }

    /// Returns the densities of all materials, in kg/m3, by their index.
    pub fn densities(&self) -> Vec<f64> {
        let mut count = 0;
        // SAFETY: the world lives, and no density is written.
        unsafe { sys::hs_world_get_densities(self.handle(), ptr::null_mut(), 0, &mut count) };
        let mut densities = vec![0.0; count as usize];
        let room = densities.as_mut_ptr();
        // SAFETY: the world lives, and the array is as long as said.
        self.owner().expect(unsafe {
            sys::hs_world_get_densities(self.handle(), room, count, ptr::null_mut())
        });
        densities
    }

    /// Returns the elasticity of a material; `None` if it was given none.
    pub fn elasticity(&self, material: Material) -> Result<Option<Elasticity>> {
        // SAFETY: the world lives, and the size is that of the struct.
        let (status, raw) = written(|def, size| unsafe {
            sys::hs_world_get_elasticity(self.handle(), material.0, def, size)
        });
        self.check(status)?;
        Ok((raw.young_modulus > 0.0).then_some(Elasticity { raw }))
    }

    /// Returns the law of all pairs of materials without a law of their own.
    pub fn default_law(&self) -> Law {
        // SAFETY: the world lives, and the size is that of the struct.
        let (status, raw) =
            written(|def, size| unsafe { sys::hs_world_get_default_law(self.handle(), def, size) });
        self.owner().expect(status);
        Law { raw }
    }

    /// Returns the law of two materials, in either order: their own, or the default law. Its
    /// strengths are those that were given, before division by the factor of
    /// [`World::set_strength_factor`].
    pub fn law(&self, a: Material, b: Material) -> Result<Law> {
        // SAFETY: the world lives, and the size is that of the struct.
        let (status, raw) = written(|def, size| unsafe {
            sys::hs_world_get_law(self.handle(), a.0, b.0, def, size)
        });
        self.check(status)?;
        Ok(Law { raw })
    }

    /// Returns the times, in s, and the rows of a table.
    pub fn table(&self, table: Table) -> Result<(Vec<f64>, Vec<[f64; 3]>)> {
        let (index, none, mut count) = (table.index(), ViewMut::none().raw(), 0);
        // SAFETY: the world lives, and no row is written.
        self.check(unsafe {
            sys::hs_world_get_table(self.handle(), index, ptr::null_mut(), none, &mut count)
        })?;
        let (mut times, mut rows) = (vec![0.0; count as usize], vec![[0.0; 3]; count as usize]);
        let (room, view) = (times.as_mut_ptr(), ViewMut::from(&mut rows).raw());
        // SAFETY: the world lives, there is one time per row, and the view borrows what it says.
        self.check(unsafe {
            sys::hs_world_get_table(self.handle(), index, room, view, &mut count)
        })?;
        Ok((times, rows))
    }

    /// Returns the actions on a block, or with `None` those on all blocks, in the order in which
    /// they were added. Where a later motion ended one along some axes, its scale is 0 there. A
    /// point that the block carries is where it is now.
    pub fn actions(&self, block: impl Into<Option<Block>>) -> Result<Vec<Action>> {
        let (id, size) = (
            block.into().map_or(0, Block::id),
            size_of::<sys::hs_action_def>(),
        );
        let get = |room, capacity, count| {
            // SAFETY: the world lives, and the array is as long as said.
            self.check(unsafe {
                sys::hs_world_get_actions(self.handle(), id, room, size, capacity, count)
            })
        };
        let mut count = 0;
        get(ptr::null_mut(), 0, &mut count)?;
        let mut actions = vec![sys::hs_action_def::default(); count as usize];
        get(actions.as_mut_ptr(), count, &mut count)?;
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
        let mut count = 0;
        // SAFETY: the world lives, and no note is written.
        unsafe { sys::hs_world_check(self.handle(), ptr::null_mut(), 0, &mut count) };
        let mut notes = vec![sys::hs_note::default(); count as usize];
        let room = notes.as_mut_ptr();
        // SAFETY: the world lives, and the array is as long as said.
        self.owner()
            .expect(unsafe { sys::hs_world_check(self.handle(), room, count, ptr::null_mut()) });
        notes.into_iter().map(Into::into).collect()
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

/// The status and what a function of the library wrote.
fn written<Def: Default>(
    write: impl FnOnce(*mut Def, usize) -> sys::hs_status,
) -> (sys::hs_status, Def) {
    let mut raw = Def::default();
    let status = write(&mut raw, size_of::<Def>());
    (status, raw)
}
