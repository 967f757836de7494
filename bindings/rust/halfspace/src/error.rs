//! Errors with the library's own text.

use std::ffi::CStr;
use std::fmt;

use halfspace_sys as sys;

use crate::constants::constants;

constants! {
    /// What kind of thing went wrong.
    ErrorKind {
        /// An argument is out of range or not finite.
        Argument = HS_ERROR_ARGUMENT,
        /// The vertices do not describe a convex shape.
        Geometry = HS_ERROR_GEOMETRY,
        /// The id does not name a living block, material or contact.
        StaleId = HS_ERROR_STALE_ID,
        /// The allocator returned no memory.
        OutOfMemory = HS_ERROR_OUT_OF_MEMORY,
        /// The object is not in a state that allows this call.
        State = HS_ERROR_STATE,
        /// The run became unstable: the time step is too large.
        Unstable = HS_ERROR_UNSTABLE,
        /// Two blocks meet too fast for the time step against their thickness.
        TooFast = HS_ERROR_TOO_FAST,
        /// A cell of a mesh would be turned inside out.
        Inverted = HS_ERROR_INVERTED,
        /// The bytes are not a snapshot that this library can read.
        Format = HS_ERROR_FORMAT,
        /// A defect of the library: please report it.
        Internal = HS_ERROR_INTERNAL,
    }
}

impl ErrorKind {
    /// The status code of the C interface.
    pub fn status(self) -> i32 {
        match self {
            Self::Argument => sys::HS_ERROR_ARGUMENT,
            Self::Geometry => sys::HS_ERROR_GEOMETRY,
            Self::StaleId => sys::HS_ERROR_STALE_ID,
            Self::OutOfMemory => sys::HS_ERROR_OUT_OF_MEMORY,
            Self::State => sys::HS_ERROR_STATE,
            Self::Unstable => sys::HS_ERROR_UNSTABLE,
            Self::TooFast => sys::HS_ERROR_TOO_FAST,
            Self::Inverted => sys::HS_ERROR_INVERTED,
            Self::Format => sys::HS_ERROR_FORMAT,
            Self::Internal => sys::HS_ERROR_INTERNAL,
            Self::Other(status) => status,
        }
    }
}

impl fmt::Display for ErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: any value is legal, and the text is static and ends with 0.
        let text = unsafe { CStr::from_ptr(sys::hs_status_string(self.status())) };
        f.write_str(&text.to_string_lossy())
    }
}

/// Why a call failed. It has changed nothing.
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
    /// Copies the text, as the next failing call overwrites it. Where there is no memory left for
    /// that, the text of the kind stands in.
    #[cold]
    pub(crate) fn new(kind: ErrorKind, text: &str) -> Self {
        let mut message = String::new();
        if message.try_reserve(text.len()).is_ok() {
            message.push_str(text);
        }
        Self { kind, message }
    }

    /// Of an argument that this crate refuses by itself.
    #[cold]
    pub(crate) fn argument(text: &str) -> Self {
        Self::new(ErrorKind::Argument, text)
    }

    /// What kind of thing went wrong.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }
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
