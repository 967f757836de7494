//! Links the calls in C, which CMake has built into the folder HALFSPACE_CALLS_IN_C_DIR.

use std::env;
use std::process::exit;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=HALFSPACE_CALLS_IN_C_DIR");
    match env::var("HALFSPACE_CALLS_IN_C_DIR") {
        Ok(directory) => println!("cargo:rustc-link-search=native={directory}"),
        Err(_) => {
            eprintln!("HALFSPACE_CALLS_IN_C_DIR is not set; CMake sets it, builds and runs this");
            exit(1);
        }
    }
    println!("cargo:rustc-link-lib=static=halfspace_calls_in_c");
}
