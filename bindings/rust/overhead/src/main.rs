//! What a call through the crate `halfspace` costs over the same call from C, both in this process,
//! in turns. `--quick` only shows that it runs.

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
