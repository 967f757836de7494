//! Alternating passes: disturbances of the machine affect all alike.

use crate::calls_in_c::thread_seconds;

/// The median of repeated passes of each work, in processor seconds of this thread.
pub fn medians<const N: usize>(passes: usize, works: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut seconds = [(); N].map(|()| Vec::with_capacity(passes));
    for pass in 0..passes {
        for i in 0..N {
            let turn = (pass + i) % N;
            seconds[turn].push(seconds_of(works[turn]));
        }
    }
    seconds.map(|mut seconds| {
        seconds.sort_by(f64::total_cmp);
        seconds[passes / 2]
    })
}

fn seconds_of(work: &mut dyn FnMut()) -> f64 {
    // SAFETY: it takes nothing and reads a clock.
    let start = unsafe { thread_seconds() };
    work();
    // SAFETY: likewise.
    unsafe { thread_seconds() - start }
}
