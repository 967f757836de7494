//! Finds libhalfspace in HALFSPACE_LIB_DIR, else by pkg-config, else builds it by CMake from the
//! sources around this crate. HALFSPACE_STATIC=1 links it statically, with the dependencies from
//! pkg-config.

use std::env;
use std::path::Path;
use std::process::{exit, Command};

const LIB_DIR: &str = "HALFSPACE_LIB_DIR";
const STATIC: &str = "HALFSPACE_STATIC";
const NEEDED: &str = "halfspace >= 0.1, halfspace < 0.2";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    for variable in [
        LIB_DIR,
        STATIC,
        "PKG_CONFIG",
        "PKG_CONFIG_PATH",
        "PKG_CONFIG_LIBDIR",
    ] {
        println!("cargo:rerun-if-env-changed={variable}");
    }
    let is_static = matches!(env::var(STATIC), Ok(value) if value != "0");
    let found = match env::var(LIB_DIR) {
        Ok(_) if is_static => Err(format!(
            "{STATIC} takes pkg-config, which knows what the archive needs; unset {LIB_DIR}"
        )),
        Ok(directory) => named_by_the_user(&directory),
        Err(_) if is_static => known_to_pkg_config(is_static),
        Err(_) => known_to_pkg_config(is_static)
            .or_else(|unknown| built_from_sources().map_err(|why| format!("{unknown}; {why}"))),
    };
    match found {
        Ok(flags) => link(&flags, is_static),
        Err(reason) => {
            eprintln!("libhalfspace was not found: {reason}");
            eprintln!("Install it, or set {LIB_DIR} to the folder of libhalfspace.so,");
            eprintln!("or PKG_CONFIG_PATH to that of halfspace.pc.");
            exit(1);
        }
    }
}

/// Linker flags: -L and a folder, -l and a library.
type Flags = Vec<String>;

fn named_by_the_user(directory: &str) -> Result<Flags, String> {
    let library = Path::new(directory).join("libhalfspace.so");
    if library.exists() {
        Ok(vec![format!("-L{directory}"), "-lhalfspace".to_owned()])
    } else {
        Err(format!(
            "{LIB_DIR} is {directory}, but there is no {}",
            library.display()
        ))
    }
}

/// Runs pkg-config directly, without a crate.
fn known_to_pkg_config(is_static: bool) -> Result<Flags, String> {
    let program = env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".to_owned());
    let answer = Command::new(&program)
        // Default folders of the linker are listed as well, to be searched first.
        .env("PKG_CONFIG_ALLOW_SYSTEM_LIBS", "1")
        .args(is_static.then_some("--static"))
        .args(["--print-errors", "--libs", NEEDED])
        .output()
        .map_err(|error| format!("{program} does not run: {error}"))?;
    if !answer.status.success() {
        return Err(String::from_utf8_lossy(&answer.stderr).trim().to_owned());
    }
    let flags = String::from_utf8_lossy(&answer.stdout);
    Ok(flags.split_whitespace().map(str::to_owned).collect())
}

/// Builds the shared library alone, where the crate lies in the sources of libhalfspace.
fn built_from_sources() -> Result<Flags, String> {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    if !sources.join("capi/CMakeLists.txt").exists() {
        return Err("there are no sources of it around the crate".to_owned());
    }
    let build = Path::new(&env::var("OUT_DIR").expect("cargo sets OUT_DIR")).join("libhalfspace");
    let parts = [
        "CLI",
        "TESTS",
        "BENCHMARKS",
        "DOCS",
        "BOX2D",
        "FORTRAN",
        "PYTHON",
        "RUST",
        "LAMMPS",
    ];
    let off = parts.map(|part| format!("-DHALFSPACE_BUILD_{part}=OFF"));
    let mut configure = Command::new("cmake");
    configure
        .arg("-S")
        .arg(&sources)
        .arg("-B")
        .arg(&build)
        .args(off);
    configure.arg("-DCMAKE_BUILD_TYPE=Release");
    let mut make = Command::new("cmake");
    make.arg("--build").arg(&build);
    make.args(["--target", "halfspace", "--parallel"]);
    make.arg(env::var("NUM_JOBS").expect("cargo sets NUM_JOBS"));
    for command in [&mut configure, &mut make] {
        let answer = command
            .output()
            .map_err(|error| format!("cmake does not run: {error}"))?;
        if !answer.status.success() {
            let errors = String::from_utf8_lossy(&answer.stderr).trim().to_owned();
            return Err(format!("cmake could not build it: {errors}"));
        }
    }
    println!("cargo:rerun-if-changed={}", sources.join("core").display());
    println!("cargo:rerun-if-changed={}", sources.join("capi").display());
    Ok(vec![
        format!("-L{}", build.join("capi").display()),
        "-lhalfspace".to_owned(),
    ])
}

fn link(flags: &[String], is_static: bool) {
    for flag in flags {
        if let Some(directory) = flag.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={directory}");
            // For build scripts of dependent crates: DEP_HALFSPACE_LIB_DIR.
            println!("cargo:lib_dir={directory}");
        } else if let Some(library) = flag.strip_prefix("-l") {
            let kind = if is_static && library == "halfspace" {
                "static"
            } else {
                "dylib"
            };
            println!("cargo:rustc-link-lib={kind}={library}");
        }
    }
}
