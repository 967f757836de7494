//! Objects of the library and their context.

use std::fmt;
use std::ptr::{self, NonNull};
use std::sync::Arc;

use halfspace_sys as sys;

use crate::context::{Context, Owner};
use crate::error::Error;
use crate::Result;

/// The only owner of an object of the library, which is destroyed before its context.
pub(crate) struct Object<Raw: Destroy> {
    handle: NonNull<Raw>,
    owner: Arc<Owner>,
}

/// How objects of a type are destroyed.
pub(crate) trait Destroy {
    const DESTROY: unsafe extern "C" fn(*mut Self);
}

impl Destroy for sys::hs_shape {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::hs_shape_destroy;
}

impl Destroy for sys::hs_mesh {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::hs_mesh_destroy;
}

impl Destroy for sys::hs_world {
    const DESTROY: unsafe extern "C" fn(*mut Self) = sys::hs_world_destroy;
}

impl<Raw: Destroy> Object<Raw> {
    /// An object that a function of the library creates in a context.
    pub(crate) fn make(
        context: &Context,
        create: impl FnOnce(&mut *mut Raw) -> Result<()>,
    ) -> Result<Self> {
        let mut handle = ptr::null_mut();
        create(&mut handle)?;
        // SAFETY: the library has just created it in this context, for this caller.
        unsafe { Self::own(context.owner(), handle) }
            .ok_or_else(|| Error::argument("the library returned no object"))
    }

    /// Takes ownership; `None` for NULL.
    ///
    /// # Safety
    /// The handle is NULL, or of an object of that context which nothing else owns.
    pub(crate) unsafe fn own(owner: &Arc<Owner>, handle: *mut Raw) -> Option<Self> {
        Some(Self {
            handle: NonNull::new(handle)?,
            owner: Arc::clone(owner),
        })
    }

    #[inline]
    pub(crate) fn handle(&self) -> *const Raw {
        self.handle.as_ptr()
    }

    /// For functions that change the object.
    #[inline]
    pub(crate) fn handle_mut(&mut self) -> *mut Raw {
        self.handle.as_ptr()
    }

    #[inline]
    pub(crate) fn owner(&self) -> &Arc<Owner> {
        &self.owner
    }
}

impl<Raw: Destroy> fmt::Debug for Object<Raw> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.handle.fmt(f)
    }
}

impl<Raw: Destroy> Drop for Object<Raw> {
    fn drop(&mut self) {
        // SAFETY: it is the only owner of the handle, and the context lives as long as `owner`.
        unsafe { Raw::DESTROY(self.handle.as_ptr()) }
    }
}
