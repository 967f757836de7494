//! Errors with the text of the library.

use std::ffi::CStr;
use std::fmt;

use halfspace_sys as sys;

pub use crate::kinds::ErrorKind;
use crate::Result;

impl ErrorKind {
    /// The status code of the C interface.
    pub fn status(self) -> i32 {
        self.value()
    }
}

impl fmt::Display for ErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: any value is legal, and the text is static and ends with 0.
        let text = unsafe { CStr::from_ptr(sys::hs_status_string(self.status())) };
        f.write_str(&text.to_string_lossy())
    }
}

/// The error of a failed call. The call has changed nothing.
///
/// ```
/// use halfspace::{Context, ErrorKind, Shape};
///
/// let context = Context::new()?;
/// let dented = [[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]];
/// let error = Shape::polygon(&context, &dented).unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::Geometry);
/// assert!(error.to_string().starts_with("hs_polygon_create: "));
/// # Ok::<(), halfspace::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    kind: ErrorKind,
    message: String,
}

impl Error {
    /// Copies the text, as the next failing call overwrites it. Without memory for it, the text of
    /// the kind is used.
    #[cold]
    pub(crate) fn new(kind: ErrorKind, text: &str) -> Self {
        let mut message = String::new();
        if message.try_reserve(text.len()).is_ok() {
            message.push_str(text);
        }
        Self { kind, message }
    }

    /// An argument that this crate refuses.
    #[cold]
    pub(crate) fn argument(text: &str) -> Self {
        Self::new(ErrorKind::Argument, text)
    }

    /// The kind of the error.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }
}

/// Refuses arguments for which a condition does not hold.
pub(crate) fn require(holds: bool, text: impl FnOnce() -> String) -> Result<()> {
    if holds {
        return Ok(());
    }
    Err(Error::argument(&text()))
}

/// Refuses an array that does not have one entry for each of some things.
pub(crate) fn require_entries(name: &str, count: usize, needed: usize, of: &str) -> Result<()> {
    require(count == needed, || {
        format!("{name} has {count} entries; there are {needed} {of}")
    })
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.message.is_empty() {
            self.kind.fmt(f)
        } else {
            f.write_str(&self.message)
        }
    }
}

impl std::error::Error for Error {}
