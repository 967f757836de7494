//! Finds libhalfspace: where HALFSPACE_LIB_DIR says, else where pkg-config says.

use std::env;
use std::path::Path;
use std::process::{exit, Command};

const LIB_DIR: &str = "HALFSPACE_LIB_DIR";
const NEEDED: &str = "halfspace >= 0.1";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    for variable in [
        LIB_DIR,
        "PKG_CONFIG",
        "PKG_CONFIG_PATH",
        "PKG_CONFIG_LIBDIR",
    ] {
        println!("cargo:rerun-if-env-changed={variable}");
    }
    let found = match env::var(LIB_DIR) {
        Ok(directory) => named_by_the_user(&directory),
        Err(_) => known_to_pkg_config(),
    };
    match found {
        Ok(directories) => link(&directories),
        Err(reason) => {
            eprintln!("libhalfspace was not found: {reason}");
            eprintln!("Install it, or set {LIB_DIR} to the folder of libhalfspace.so,");
            eprintln!("or PKG_CONFIG_PATH to that of halfspace.pc.");
            exit(1);
        }
    }
}

fn named_by_the_user(directory: &str) -> Result<Vec<String>, String> {
    let library = Path::new(directory).join("libhalfspace.so");
    if library.exists() {
        Ok(vec![directory.to_owned()])
    } else {
        Err(format!(
            "{LIB_DIR} is {directory}, but there is no {}",
            library.display()
        ))
    }
}

/// Asks the program itself, which takes no crate.
fn known_to_pkg_config() -> Result<Vec<String>, String> {
    let program = env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".to_owned());
    let answer = Command::new(&program)
        // A folder that the linker would search by itself is named as well, to be searched first.
        .env("PKG_CONFIG_ALLOW_SYSTEM_LIBS", "1")
        .args(["--print-errors", "--libs-only-L", NEEDED])
        .output()
        .map_err(|error| format!("{program} does not run: {error}"))?;
    if !answer.status.success() {
        return Err(String::from_utf8_lossy(&answer.stderr).trim().to_owned());
    }
    let flags = String::from_utf8_lossy(&answer.stdout);
    Ok(flags
        .split_whitespace()
        .filter_map(|flag| flag.strip_prefix("-L"))
        .map(str::to_owned)
        .collect())
}

fn link(directories: &[String]) {
    for directory in directories {
        println!("cargo:rustc-link-search=native={directory}");
        // For build scripts of crates that stand on this one: DEP_HALFSPACE_LIB_DIR.
        println!("cargo:lib_dir={directory}");
    }
    println!("cargo:rustc-link-lib=dylib=halfspace");
}
