//! Calls for a single pair: in ns, over C.

use std::ptr;

use halfspace::{detect, Contact, Context, Detector, PairCache, Pose, Result, Shape};
use halfspace_sys as sys;

use crate::calls_in_c::{require_ok, seconds_of_pairs};
use crate::timing::medians;

static SQUARE: [[f64; 2]; 4] = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
const CALLS: usize = 10_000;

pub fn run(passes: usize) -> Result<()> {
    println!(
        "one pair of squares                 C, ns   raw Rust   safe, over C   by value, over C"
    );
    let apart: Vec<Pose> = poses(|share| Pose::at([0.3, 1.5 + 0.2 * share, 0.0]));
    let touching: Vec<Pose> = poses(|share| Pose::at([0.3 * share, 0.99, 0.0]));
    cold("apart, without memory", passes, &apart)?;
    cold("in contact", passes, &touching)?;
    cached("apart, with the proof in a cache", passes, &apart)
}

fn poses(at: impl Fn(f64) -> Pose) -> Vec<Pose> {
    (0..CALLS).map(|i| at(i as f64 / CALLS as f64)).collect()
}

fn cold(name: &str, passes: usize, uppers: &[Pose]) -> Result<()> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &SQUARE)?;
    let (raw, lower) = (RawSquare::new(), Pose::default());
    let mut contacts = [sys::hs_contact::default(); 2];
    let [of_c, of_raw] = &mut contacts;
    let mut contact = Contact::default();
    let detector = Detector::default();
    let raw_uppers: *const sys::hs_pose = uppers.as_ptr().cast();
    let raw_lower: *const sys::hs_pose = (&lower as *const Pose).cast();

    let times = medians(
        passes,
        [
            // SAFETY: the square lives, and there are as many poses as said.
            &mut || unsafe {
                let cache = ptr::null_mut();
                seconds_of_pairs(raw.shape, raw_lower, raw_uppers, CALLS as i64, cache, of_c);
            },
            &mut || {
                for i in 0..CALLS {
                    // SAFETY: likewise.
                    let status = unsafe {
                        let upper = raw_uppers.add(i);
                        sys::hs_pair_detect(
                            raw.shape,
                            raw_lower,
                            raw.shape,
                            upper,
                            ptr::null(),
                            ptr::null_mut(),
                            of_raw,
                        )
                    };
                    require_ok(status);
                }
            },
            &mut || {
                for upper in uppers {
                    detector
                        .detect_into(square.at(&lower), square.at(upper), &mut contact)
                        .expect("a verdict");
                }
            },
            &mut || {
                let gaps = uppers.iter().map(|upper| {
                    detect(square.at(&lower), square.at(upper))
                        .expect("a verdict")
                        .gap()
                });
                assert!(gaps.sum::<f64>().is_finite());
            },
        ],
    );
    assert_eq!(contacts[0].gap, contact.gap());
    print(name, &times);
    Ok(())
}

fn cached(name: &str, passes: usize, uppers: &[Pose]) -> Result<()> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &SQUARE)?;
    let (raw, lower) = (RawSquare::new(), Pose::default());
    let mut of_c = (sys::hs_pair_cache::default(), sys::hs_contact::default());
    let mut of_raw = of_c;
    let (mut cache, mut contact) = (PairCache::default(), Contact::default());
    let detector = Detector::default();
    let raw_uppers: *const sys::hs_pose = uppers.as_ptr().cast();
    let raw_lower: *const sys::hs_pose = (&lower as *const Pose).cast();

    let times = medians(
        passes,
        [
            // SAFETY: the square lives, and there are as many poses as said.
            &mut || unsafe {
                let (cache, contact) = (&mut of_c.0, &mut of_c.1);
                seconds_of_pairs(
                    raw.shape,
                    raw_lower,
                    raw_uppers,
                    CALLS as i64,
                    cache,
                    contact,
                );
            },
            &mut || {
                for i in 0..CALLS {
                    // SAFETY: likewise.
                    let status = unsafe {
                        let (upper, cache) = (raw_uppers.add(i), &mut of_raw.0);
                        sys::hs_pair_detect(
                            raw.shape,
                            raw_lower,
                            raw.shape,
                            upper,
                            ptr::null(),
                            cache,
                            &mut of_raw.1,
                        )
                    };
                    require_ok(status);
                }
            },
            &mut || {
                for upper in uppers {
                    let (a, b) = (square.at(&lower), square.at(upper));
                    detector
                        .detect_cached(a, b, &mut cache, &mut contact)
                        .expect("a verdict");
                }
            },
        ],
    );
    assert_eq!(of_c.1.gap, contact.gap());
    print(name, &times);
    Ok(())
}

fn print(name: &str, times: &[f64]) {
    let nanoseconds = |seconds: f64| 1e9 * seconds / CALLS as f64;
    print!(
        "{name:34} {:6.1}  {:+9.1}",
        nanoseconds(times[0]),
        nanoseconds(times[1] - times[0])
    );
    for safe in &times[2..] {
        print!("  {:+13.1}", nanoseconds(safe - times[0]));
    }
    println!();
}

/// A shape created and destroyed explicitly.
struct RawSquare {
    context: *mut sys::hs_context,
    shape: *mut sys::hs_shape,
}

impl RawSquare {
    fn new() -> Self {
        let mut square = Self {
            context: ptr::null_mut(),
            shape: ptr::null_mut(),
        };
        let stride = std::mem::size_of::<[f64; 2]>() as i64;
        let x = SQUARE.as_ptr().cast::<f64>();
        let view = sys::hs_view {
            x,
            y: x.wrapping_add(1),
            z: ptr::null(),
            stride,
            count: 4,
        };
        // SAFETY: the view is that of the corners, and both handles are places to write to.
        unsafe {
            require_ok(sys::hs_context_create(ptr::null(), &mut square.context));
            require_ok(sys::hs_polygon_create(
                square.context,
                view,
                &mut square.shape,
            ));
        }
        square
    }
}

impl Drop for RawSquare {
    fn drop(&mut self) {
        // SAFETY: nothing else was made from the context.
        unsafe {
            sys::hs_shape_destroy(self.shape);
            sys::hs_context_destroy(self.context);
        }
    }
}
