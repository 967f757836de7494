//! The C interface of libhalfspace as it is: types, constants and functions, generated from its headers.
//!
//! Names and conventions are those of C: null pointers, statuses, handles that are destroyed by hand. The
//! crate `halfspace` is the safe layer on top of this one.
//!
//! The library is found in the folder that the environment variable `HALFSPACE_LIB_DIR` names, else by
//! pkg-config.

// As its generator lays it out.
#[rustfmt::skip]
mod raw;

pub use raw::*;
