//! The C interface of libhalfspace: types, constants and functions, generated from its headers.
//!
//! Names and conventions are those of C: null pointers, status codes, handles that the caller
//! destroys. The crate `halfspace` is the safe interface on top of this one.
//!
//! The library is found in the folder of the environment variable `HALFSPACE_LIB_DIR`, else by
//! pkg-config.

// Formatted by its generator.
#[rustfmt::skip]
mod raw;

pub use raw::*;
