//! The library's integer constants as Rust enums.

/// An enum of constants of the library. A later version of the library may have more.
macro_rules! constants {
    ($(#[$about:meta])* $name:ident {
        $($(#[$meaning:meta])* $variant:ident = $value:ident,)*
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$meaning])* $variant,)*
            /// A constant of a later version of the library.
            Other(i32),
        }

        impl $name {
            /// The variant of a constant of the C interface.
            pub fn from_value(value: i32) -> Self {
                match value {
                    $(halfspace_sys::$value => Self::$variant,)*
                    other => Self::Other(other),
                }
            }

            /// The constant of the C interface.
            pub fn value(self) -> i32 {
                match self {
                    $(Self::$variant => halfspace_sys::$value,)*
                    Self::Other(value) => value,
                }
            }
        }
    };
}

pub(crate) use constants;
