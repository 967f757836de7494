//! Reads the text cases that all languages share; `tests/cases/README.md` says what they mean.
//! Their folder is that of the environment variable HALFSPACE_CASES, by default where it is in the
//! repository.

mod expect;
mod fields;
mod scene;
mod words;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use scene::Scene;
use words::Words;

fn folder() -> PathBuf {
    let in_repository = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../tests/cases");
    env::var_os("HALFSPACE_CASES").map_or_else(|| in_repository.into(), PathBuf::from)
}

/// Carries out a file's statements in their order. Panics at the first that does not do as the file
/// says.
fn run(path: &Path) {
    let text =
        fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let statements: Vec<(usize, Words)> = text
        .lines()
        .enumerate()
        .map(|(i, line)| (i + 1, Words::new(line)))
        .filter(|(_, words)| !words.is_empty())
        .collect();

    let mut scene = Scene::new();
    let mut next = statements.iter().peekable();
    while let Some((line, words)) = next.next() {
        let refused = next
            .next_if(|(_, words)| words.first() == "refused")
            .map(|(_, words)| words);
        let outcome = match (scene.carry_out(words), refused) {
            (outcome, None) => outcome.map_err(|error| error.to_string()),
            (Ok(()), Some(_)) => Err("it was not refused".to_owned()),
            (Err(error), Some(refused)) => expect::refusal(&error, refused),
        };
        if let Err(why) = outcome {
            panic!(
                "{}:{line}: {words}: {why} (in case {})",
                path.display(),
                scene.title()
            );
        }
    }
    println!("{}: {} statements", path.display(), statements.len());
}

#[test]
fn every_case_is_as_its_file_says() {
    let entries = fs::read_dir(folder()).expect("the folder of cases");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| {
        path.extension()
            .map_or(false, |extension| extension == "case")
    });
    files.sort();
    assert!(!files.is_empty(), "{} holds no cases", folder().display());
    files.iter().for_each(|path| run(path));
}
