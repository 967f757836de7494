//! The context: allocator, threads and text of the last error.

use std::alloc::{alloc, dealloc, Layout};
use std::ffi::CStr;
use std::marker::PhantomData;
use std::mem::{size_of, MaybeUninit};
use std::os::raw::{c_char, c_void};
use std::ptr::{self, NonNull};
use std::rc::Rc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::Arc;

use halfspace_sys as sys;

use crate::error::{Error, ErrorKind};
use crate::Result;

/// Context of shapes, meshes and worlds. It lives as long as anything made from it; a clone is
/// another handle to the same context.
///
/// A context, its meshes and its worlds must be used by one thread at a time, so none of them is
/// [`Send`] or [`Sync`]; a [`Family`](crate::Family) moves them to another thread. Its
/// [shapes](crate::Shape) are both.
///
/// ```compile_fail,E0277
/// fn needs_send<T: Send>() {}
/// needs_send::<halfspace::Context>();
/// ```
/// ```compile_fail,E0277
/// fn needs_sync<T: Sync>() {}
/// needs_sync::<halfspace::Context>();
/// ```
#[derive(Clone, Debug)]
pub struct Context {
    pub(crate) object: Arc<Owner>,
    of_one_thread: PhantomData<Rc<()>>,
}

impl Context {
    /// Creates a context that uses the allocator of the C library.
    pub fn new() -> Result<Self> {
        // SAFETY: NULL stands for the defaults.
        unsafe { Self::create(ptr::null()) }
    }

    /// Creates a context whose worlds are stepped by 1 to 256 threads. Results are bit-identical
    /// for any number.
    pub fn with_threads(threads: i32) -> Result<Self> {
        let mut def = defaults();
        def.threads = threads;
        // SAFETY: the definition is valid, except for the number, which the library checks.
        unsafe { Self::create(&def) }
    }

    /// Creates a context that uses the global allocator of the Rust program.
    pub fn with_global_allocator() -> Result<Self> {
        let mut def = defaults();
        def.allocate = Some(allocate);
        def.release = Some(release);
        // SAFETY: both functions are set and may be called at any time from any thread.
        unsafe { Self::create(&def) }
    }

    /// # Safety
    /// The definition is NULL or valid, with functions that may be called from any thread.
    unsafe fn create(def: *const sys::hs_context_def) -> Result<Self> {
        let mut handle = ptr::null_mut();
        // SAFETY: promised by the caller.
        let status = unsafe { sys::hs_context_create(def, &mut handle) };
        match NonNull::new(handle) {
            Some(handle) => Ok(Self {
                object: Arc::new(Owner(handle)),
                of_one_thread: PhantomData,
            }),
            None => Err(Error::new(ErrorKind::from_value(status), "")),
        }
    }

    pub(crate) fn of(owner: &Arc<Owner>) -> Self {
        Self {
            object: Arc::clone(owner),
            of_one_thread: PhantomData,
        }
    }

    pub(crate) fn owner(&self) -> &Arc<Owner> {
        &self.object
    }
}

/// Destroys the context after everything made from it. It is public only for the sealed trait of
/// families, which is not visible outside the crate.
#[derive(Debug)]
pub struct Owner(NonNull<sys::hs_context>);

// SAFETY: it only reads the text of the last error, byte by byte and atomically, as shapes of other
// threads may fail and write it so, and destroys the context when nothing made from it is left.
// The allocators of a context may be called from any thread.
unsafe impl Send for Owner {}
// SAFETY: likewise.
unsafe impl Sync for Owner {}

impl Owner {
    /// For calls with the context as the object: its functions may be called by any handle to it.
    pub(crate) fn handle(&self) -> *mut sys::hs_context {
        self.0.as_ptr()
    }

    /// Likewise: it has the text of its own errors.
    pub(crate) fn owner(&self) -> &Self {
        self
    }

    /// Converts the status of a call to a result; notes are no errors.
    #[inline]
    pub(crate) fn check(&self, status: sys::hs_status) -> Result<()> {
        if status >= sys::HS_OK {
            Ok(())
        } else {
            Err(self.last_error(status))
        }
    }

    #[cold]
    fn last_error(&self, status: sys::hs_status) -> Error {
        // SAFETY: the context lives, and so does its text, which ends with 0.
        let text = unsafe { read_atomically(sys::hs_context_last_error(self.0.as_ptr())) };
        Error::new(ErrorKind::from_value(status), &text)
    }
}

/// # Safety
/// The text lives and ends with 0; only atomic writes may change it.
unsafe fn read_atomically(text: *const c_char) -> String {
    let mut bytes = Vec::new();
    loop {
        // SAFETY: the text has not ended, and an atomic byte has the layout of a byte.
        let byte = unsafe { &*text.add(bytes.len()).cast::<AtomicU8>() };
        match byte.load(Ordering::Relaxed) {
            0 => return String::from_utf8_lossy(&bytes).into_owned(),
            byte => bytes.push(byte),
        }
    }
}

impl Drop for Owner {
    fn drop(&mut self) {
        // SAFETY: every shape, mesh and world holds its owner and is destroyed before it drops the
        // owner.
        unsafe { sys::hs_context_destroy(self.0.as_ptr()) }
    }
}

/// The version of the library at run time.
///
/// ```
/// println!("libhalfspace {}", halfspace::version());
/// ```
pub fn version() -> &'static str {
    // SAFETY: a static string, allowed any time.
    unsafe { CStr::from_ptr(sys::hs_version()) }
        .to_str()
        .unwrap_or_default()
}

/// It has pointers, so it has no `Default`.
fn defaults() -> sys::hs_context_def {
    let mut def = MaybeUninit::<sys::hs_context_def>::zeroed();
    // SAFETY: the size is that of the struct, for which all zero is valid.
    unsafe {
        sys::hs_context_def_init(def.as_mut_ptr(), size_of::<sys::hs_context_def>());
        def.assume_init()
    }
}

unsafe extern "C" fn allocate(bytes: usize, alignment: usize, _: *mut c_void) -> *mut c_void {
    match layout(bytes, alignment) {
        // SAFETY: the layout's size is above 0.
        Some(layout) => unsafe { alloc(layout).cast() },
        None => ptr::null_mut(),
    }
}

unsafe extern "C" fn release(memory: *mut c_void, bytes: usize, alignment: usize, _: *mut c_void) {
    if let Some(layout) = layout(bytes, alignment) {
        // SAFETY: the library releases memory of `allocate`, with the same size and alignment.
        unsafe { dealloc(memory.cast(), layout) }
    }
}

/// Rust's allocators must not be called with size 0.
fn layout(bytes: usize, alignment: usize) -> Option<Layout> {
    Layout::from_size_align(bytes.max(1), alignment).ok()
}
