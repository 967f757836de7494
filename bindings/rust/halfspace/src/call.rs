//! Calls of functions of the library: what types can check of them is checked here, once.

use std::mem::{size_of, MaybeUninit};
use std::os::raw::c_void;
use std::ptr;

use halfspace_sys as sys;

use crate::action::Table;
use crate::affine::Tensor;
use crate::block::{Block, Material};
use crate::body::{Axes, Body};
use crate::contact::Contact;
use crate::mesh::Mesh;
use crate::mutable_view::ViewMut;
use crate::pose::Pose;
use crate::records::{CellState, Deformation};
use crate::shape::Shape;
use crate::shape_input::FaceLists;
use crate::share::Sums;
use crate::view::View;
use crate::world::World;
use crate::Result;

/// Calls a function of the library with the handle of an object and arguments, and converts its status. `mut` stands
/// before an object that the function changes.
///
/// Arguments are values and references. `[array]` stands for two of them, the first element and the number of
/// elements; `[mut array]` is written. A pointer has `unsafe` before it, e.g. to an array whose length is that of
/// another one: whoever calls the function ensures that it may use the memory. Arguments are computed before the call,
/// and temporary values live until it ends.
macro_rules! call {
    (mut $object:expr => $function:ident($($arguments:tt)*)) => {
        match $object.object.handle_mut() {
            handle => call!(@ $object, handle, $function, () $($arguments)*),
        }
    };
    (@ $object:expr, $handle:ident, $function:ident, ($($done:ident,)*)) => {{
        // SAFETY: the object lives, and is borrowed mutably if the function changes it. References are valid during
        // the call, arrays are as long as said, and the caller answers for pointers.
        let status = unsafe { halfspace_sys::$function($handle, $($done),*) };
        $object.object.owner().check(status)
    }};
    (@ $object:expr, $handle:ident, $function:ident, ($($done:ident,)*) [mut $array:expr] $(, $($rest:tt)*)?) => {
        match ($crate::call::Array::first_mut(&mut $array[..]), $crate::call::Argument::raw($array.len())) {
            (first, length) => call!(@ $object, $handle, $function, ($($done,)* first, length,) $($($rest)*)?),
        }
    };
    (@ $object:expr, $handle:ident, $function:ident, ($($done:ident,)*) [$array:expr] $(, $($rest:tt)*)?) => {
        match ($crate::call::Array::first(&$array[..]), $crate::call::Argument::raw($array.len())) {
            (first, length) => call!(@ $object, $handle, $function, ($($done,)* first, length,) $($($rest)*)?),
        }
    };
    (@ $object:expr, $handle:ident, $function:ident, ($($done:ident,)*) unsafe $pointer:expr $(, $($rest:tt)*)?) => {
        match $pointer {
            pointer => call!(@ $object, $handle, $function, ($($done,)* pointer,) $($($rest)*)?),
        }
    };
    (@ $object:expr, $handle:ident, $function:ident, ($($done:ident,)*) $argument:expr $(, $($rest:tt)*)?) => {
        match $crate::call::Argument::raw($argument) {
            argument => call!(@ $object, $handle, $function, ($($done,)* argument,) $($($rest)*)?),
        }
    };
    ($object:expr => $function:ident($($arguments:tt)*)) => {
        match $object.object.handle() {
            handle => call!(@ $object, handle, $function, () $($arguments)*),
        }
    };
}

/// Calls a function likewise that creates an object in a context: its last argument receives the handle.
macro_rules! create {
    ($context:expr => $function:ident($($arguments:tt)*)) => {
        $crate::object::Object::make($context, |object| call!($context => $function($($arguments)*, object)))
    };
}

pub(crate) use {call, create};

/// What `call!` takes for an argument of a type of C.
pub(crate) trait Argument<Raw> {
    fn raw(self) -> Raw;
}

macro_rules! arguments {
    ($($name:ident: $safe:ty => $raw:ty = $value:expr;)*) => {
        $(impl Argument<$raw> for $safe {
            #[inline]
            fn raw(self) -> $raw {
                let $name = self;
                $value
            }
        })*
    };
}

arguments! {
    number: i32 => i32 = number;
    number: i64 => i64 = number;
    number: u64 => u64 = number;
    number: f64 => f64 = number;
    size: usize => usize = size;
    size: usize => i64 = i64::try_from(size).unwrap_or(i64::MAX);
    number: u64 => i64 = i64::try_from(number).unwrap_or(i64::MAX);
    is_so: bool => i32 = is_so.into();
    block: Block => u64 = block.id();
    block: Option<Block> => u64 = block.map_or(0, Block::id);
    body: Body => u64 = body.id();
    material: Material => i32 = material.index();
    table: Table => i32 = table.index();
    axes: Axes => i32 = axes.0;
    shape: &Shape => *const sys::hs_shape = shape.handle();
    mesh: &Mesh => *const sys::hs_mesh = mesh.object.handle();
    world: &mut World => *mut sys::hs_world = world.object.handle_mut();
    pose: &Pose => *const sys::hs_pose = pose.raw();
    tensor: &Tensor => *const [f64; 9] = (tensor as *const Tensor).cast();
    deformation: &mut Deformation => *mut sys::hs_deformation = (deformation as *mut Deformation).cast();
    tensors: &[Tensor; 3] => *const [f64; 27] = tensors.as_ptr().cast();
    sums: &Sums => *const f64 = sums.as_ptr();
    sums: &mut Sums => *mut f64 = sums.as_mut_ptr();
    faces: &FaceLists => *const i32 = faces.vertices.as_ptr();
    view: View<'_> => sys::hs_view = view.raw();
    view: ViewMut<'_> => sys::hs_mutable_view = view.raw();
}

impl<T> Argument<*const T> for &T {
    #[inline]
    fn raw(self) -> *const T {
        self
    }
}

impl<T> Argument<*const T> for Option<&T> {
    #[inline]
    fn raw(self) -> *const T {
        self.map_or(ptr::null(), |value| value)
    }
}

impl<T> Argument<*mut T> for Option<&mut T> {
    #[inline]
    fn raw(self) -> *mut T {
        self.map_or(ptr::null_mut(), |value| value)
    }
}

impl<T> Argument<*mut T> for &mut T {
    #[inline]
    fn raw(self) -> *mut T {
        self
    }
}

/// Elements with the layout of those of the library.
pub(crate) trait Array<Raw> {
    fn first(&self) -> *const Raw;
    fn first_mut(&mut self) -> *mut Raw;
}

impl<T> Array<T> for [T] {
    #[inline]
    fn first(&self) -> *const T {
        self.as_ptr()
    }

    #[inline]
    fn first_mut(&mut self) -> *mut T {
        self.as_mut_ptr()
    }
}

macro_rules! arrays {
    ($($safe:ty => $raw:ty;)*) => {
        $(impl Array<$raw> for [$safe] {
            #[inline]
            fn first(&self) -> *const $raw {
                self.as_ptr().cast()
            }

            #[inline]
            fn first_mut(&mut self) -> *mut $raw {
                self.as_mut_ptr().cast()
            }
        })*
    };
}

arrays! {
    Pose => sys::hs_pose;
    Deformation => sys::hs_deformation;
    CellState => sys::hs_cell_state;
    MaybeUninit<Contact> => sys::hs_contact;
    [i32; 2] => i32;
    u8 => c_void;
}

/// What a function of the library writes; most are told its size.
#[inline]
pub(crate) fn written<Raw: Default, T: From<Raw>>(
    write: impl FnOnce(&mut Raw, usize) -> Result<()>,
) -> Result<T> {
    let mut raw = Raw::default();
    write(&mut raw, size_of::<Raw>())?;
    Ok(raw.into())
}

/// Likewise, by a getter that cannot fail.
#[track_caller]
pub(crate) fn known<Raw: Default, T: From<Raw>>(
    write: impl FnOnce(&mut Raw, usize) -> Result<()>,
) -> T {
    sure(written(write))
}

/// A number of things that a function of the library writes.
#[inline]
pub(crate) fn counted(count: impl FnOnce(&mut i64) -> Result<()>) -> Result<usize> {
    written(|number, _| count(number)).map(|number: i64| number as usize)
}

/// A list of known length.
pub(crate) fn filled<Raw: Clone + Default>(
    length: usize,
    fill: impl FnOnce(&mut [Raw]) -> Result<()>,
) -> Result<Vec<Raw>> {
    let mut list = vec![Raw::default(); length];
    fill(&mut list)?;
    Ok(list)
}

/// A list whose length a first call returns, which has no room to write to.
pub(crate) fn listed<Raw: Clone + Default, T: From<Raw>>(
    get: impl Fn(&mut [Raw], &mut i64) -> Result<()>,
) -> Result<Vec<T>> {
    let length = counted(|count| get(&mut [], count))?;
    let list = filled(length, |room| get(room, &mut 0))?;
    Ok(list.into_iter().map(T::from).collect())
}

/// Likewise, by a getter that cannot fail.
#[track_caller]
pub(crate) fn known_list<Raw: Clone + Default, T: From<Raw>>(
    get: impl Fn(&mut [Raw], &mut i64) -> Result<()>,
) -> Vec<T> {
    sure(listed(get))
}

/// A list of points, of which a getter returns the number.
pub(crate) fn listed_points(get: impl Fn(ViewMut<'_>) -> Result<usize>) -> Result<Vec<[f64; 3]>> {
    let mut points = vec![[0.0; 3]; get(ViewMut::none())?];
    get((&mut points).into())?;
    Ok(points)
}

/// The result of a getter that cannot fail, as this crate chooses its arguments.
#[track_caller]
pub(crate) fn sure<T>(result: Result<T>) -> T {
    result.unwrap_or_else(|error| panic!("a getter of libhalfspace failed: {error}"))
}

/// A definition as a function of the library fills it.
pub(crate) fn initial<Def: Default>(init: impl FnOnce(*mut Def, usize) -> sys::hs_status) -> Def {
    let mut raw = Def::default();
    init(&mut raw, size_of::<Def>());
    raw
}

/// A definition with the library's defaults.
pub(crate) fn defaults<Def: Default>(
    init: unsafe extern "C" fn(*mut Def, usize) -> sys::hs_status,
) -> Def {
    // SAFETY: the size is that of the struct.
    initial(|def, size| unsafe { init(def, size) })
}
