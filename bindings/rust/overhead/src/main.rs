//! Overhead of the crate `halfspace` relative to calls from C, alternately in one process.
//! `--quick` only checks that it runs.

mod calls_in_c;
mod host_in_c;
mod pairs;
mod timing;
mod worlds;

fn main() -> halfspace::Result<()> {
    let quick = std::env::args().any(|argument| argument == "--quick");
    let (passes, side) = if quick { (2, 20) } else { (21, 316) };
    pairs::run(20 * passes)?;
    worlds::run(2, 20 * passes, 100)?;
    worlds::run(side, passes, 1)
}
