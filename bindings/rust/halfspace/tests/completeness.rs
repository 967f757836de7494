//! The safe interface uses every function and every constant of the C interface.

use std::fs;
use std::path::Path;

const RAW: &str = include_str!("../../halfspace-sys/src/raw.rs");

/// What follows `before` on its line, up to a character that no name has.
fn names_after<'a>(text: &'a str, before: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(before).skip(1).map(|rest| {
        rest.split(|c: char| !c.is_alphanumeric() && c != '_')
            .next()
            .unwrap()
    })
}

/// The code without comments.
fn safe_layer() -> String {
    let sources = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).unwrap();
    sources
        .map(|file| without_comments(&fs::read_to_string(file.unwrap().path()).unwrap()))
        .collect()
}

fn without_comments(source: &str) -> String {
    source
        .lines()
        .flat_map(|line| [line.split("//").next().unwrap(), "\n"])
        .collect()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
}

#[test]
fn every_function_and_constant_is_used() {
    let source = safe_layer();
    let used: std::collections::HashSet<&str> = words(&source).collect();
    // A note is no error, the regions' size is that of an array's type, and tasks are for schedulers of C.
    let not_needed = ["HS_NOTE_TRUNCATED", "HS_CONTACT_POINTS", "hs_task_run"];
    let declared = names_after(RAW, "pub fn ").chain(names_after(RAW, "pub const "));
    let missing: Vec<&str> = declared
        .filter(|name| !used.contains(name) && !not_needed.contains(name))
        .collect();
    assert!(
        missing.is_empty(),
        "not reached by the safe layer: {missing:?}"
    );
}
