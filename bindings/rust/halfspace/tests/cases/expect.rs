//! What came of the statements, compared with what the file says.

use halfspace::{Error, ErrorKind, Pose};

use crate::fields;
use crate::words::{number, Words};

/// Why an expectation is not met.
pub type Outcome = Result<(), String>;

/// `refused STATUS TEXT`
pub fn refusal(error: &Error, refused: &Words) -> Outcome {
    let status = fields::constant(refused.word(1)).expect("a status");
    let (kind, text) = (ErrorKind::from_value(status), refused.text_from(2));
    if error.kind() == kind && error.to_string().contains(&text) {
        return Ok(());
    }
    Err(format!(
        "refused as {:?} with \"{error}\", not as {kind:?} with \"{text}\"",
        error.kind()
    ))
}

/// `VALUE ... [within T ...]`: one tolerance for all values or one for each.
fn values(got: &[f64], expected: &[String]) -> Outcome {
    let split = expected
        .iter()
        .position(|word| word == "within")
        .unwrap_or(expected.len());
    let wanted: Vec<f64> = expected[..split].iter().map(|word| number(word)).collect();
    let tolerances: Vec<f64> = expected[split..]
        .iter()
        .skip(1)
        .map(|word| number(word))
        .collect();
    let tolerance = |i: usize| match tolerances.len() {
        0 => 0.0,
        1 => tolerances[0],
        _ => tolerances[i],
    };
    let met = got.len() == wanted.len()
        && got
            .iter()
            .zip(&wanted)
            .enumerate()
            .all(|(i, (got, wanted))| (got - wanted).abs() <= tolerance(i));
    if met {
        Ok(())
    } else {
        Err(format!("got {got:?}"))
    }
}

/// As above of a field; `None` stands for one that the struct does not have.
pub fn field(got: Option<Vec<f64>>, name: &str, expected: &[String]) -> Outcome {
    let got = got.ok_or_else(|| format!("{name} is not a field of it"))?;
    values(&got, expected)
}

/// FNV-1a, 64 bits, over the bytes of all poses in their order.
pub fn hash(poses: &[Pose], expected: &str) -> Outcome {
    let numbers = poses
        .iter()
        .flat_map(|pose| pose.position.iter().chain(&pose.rotation));
    let hash = numbers
        .flat_map(|number| number.to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
    let got = format!("{hash:016x}");
    if got == expected {
        Ok(())
    } else {
        Err(format!("got {got}"))
    }
}
