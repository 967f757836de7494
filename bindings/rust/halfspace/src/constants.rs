//! The library's integer constants as Rust enums, and its definitions as builders.

/// An enum over constants of the library. A later version of it may know more of them.
macro_rules! constants {
    ($(#[$about:meta])* $name:ident {
        $($(#[$meaning:meta])* $variant:ident = $value:ident,)*
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$meaning])* $variant,)*
            /// What only a later version of the library knows.
            Other(i32),
        }

        impl $name {
            pub(crate) fn from_raw(value: i32) -> Self {
                match value {
                    $(halfspace_sys::$value => Self::$variant,)*
                    other => Self::Other(other),
                }
            }
        }
    };
}

/// Builder-like setters of a definition's fields, for an `impl` of a struct with the definition in
/// `raw`.
macro_rules! setters {
    ($($(#[$meaning:meta])* $field:ident: $type:ty,)*) => {
        $(
            $(#[$meaning])*
            pub fn $field(mut self, $field: $type) -> Self {
                self.raw.$field = $field;
                self
            }
        )*
    };
}

pub(crate) use {constants, setters};
