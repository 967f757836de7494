//! What came of the statements, compared with what the file says.

use halfspace::{
    BlockState, Contact, Deformation, Energy, Error, Impact, Pose, Report, ShapeProperties,
};

use crate::constants;
use crate::words::{number, Words};

/// Why an expectation is not met.
pub type Outcome = Result<(), String>;

/// `refused STATUS TEXT`
pub fn refusal(error: &Error, refused: &Words) -> Outcome {
    let (kind, text) = (constants::error_kind(refused.word(1)), refused.text_from(2));
    if error.kind() == kind && error.to_string().contains(&text) {
        return Ok(());
    }
    Err(format!(
        "refused as {:?} with \"{error}\", not as {kind:?} with \"{text}\"",
        error.kind()
    ))
}

/// `VALUE ... [within T ...]`: one tolerance for all values or one for each.
pub fn values(got: &[f64], expected: &[String]) -> Outcome {
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

pub fn of_shape(shape: &ShapeProperties, field: &str) -> Vec<f64> {
    match field {
        "dimension" => vec![shape.dimension as f64],
        "vertex_count" => vec![shape.vertex_count as f64],
        "edge_count" => vec![shape.edge_count as f64],
        "face_count" => vec![shape.face_count as f64],
        "volume" => vec![shape.volume],
        "centroid" => shape.centroid.to_vec(),
        "second_moment" => shape.second_moment.to_vec(),
        "bounding_radius" => vec![shape.bounding_radius],
        "shortest_edge" => vec![shape.shortest_edge],
        _ => unknown(field),
    }
}

pub fn of_contact(contact: &Contact, field: &str) -> Vec<f64> {
    let index = |feature: Option<usize>| vec![feature.map_or(-1.0, |index| index as f64)];
    match field {
        "type" => vec![f64::from(constants::contact_type(contact.kind()))],
        "pair_kind" => vec![f64::from(constants::pair_kind(contact.pair_kind()))],
        "feature_a" => index(contact.features().0),
        "feature_b" => index(contact.features().1),
        "point_count" => vec![contact.points().len() as f64],
        "normal" => contact.normal().to_vec(),
        "gap" => vec![contact.gap()],
        "area" => vec![contact.area()],
        "length" => vec![contact.length()],
        "center" => contact.center().to_vec(),
        "force" => contact.force().to_vec(),
        "normal_force" => vec![contact.normal_force()],
        "shear_force" => contact.shear_force().to_vec(),
        _ => unknown(field),
    }
}

pub fn of_impact(impact: &Impact, field: &str) -> Vec<f64> {
    match field {
        "state" => vec![f64::from(constants::impact_state(impact.state()))],
        "pair_kind" => vec![f64::from(constants::pair_kind(impact.pair_kind()))],
        "feature_a" => vec![impact.features().0 as f64],
        "feature_b" => vec![impact.features().1 as f64],
        "time" => vec![impact.time()],
        "gap" => vec![impact.gap()],
        "normal" => impact.normal().to_vec(),
        "point" => impact.point().to_vec(),
        _ => unknown(field),
    }
}

pub fn of_block(block: &BlockState, field: &str) -> Vec<f64> {
    match field {
        "position" => block.pose.position.to_vec(),
        "rotation" => block.pose.rotation.to_vec(),
        "velocity" => block.velocity.to_vec(),
        "angular_velocity" => block.angular_velocity.to_vec(),
        "force" => block.force.to_vec(),
        "torque" => block.torque.to_vec(),
        "mass" => vec![block.mass],
        _ => unknown(field),
    }
}

pub fn of_deformation(deformation: &Deformation, field: &str) -> Vec<f64> {
    match field {
        "gradient" => deformation.gradient.concat(),
        "rate" => deformation.rate.concat(),
        "strain" => deformation.strain.concat(),
        "stress" => deformation.stress.concat(),
        "strain_energy" => vec![deformation.strain_energy],
        _ => unknown(field),
    }
}

pub fn of_report(report: &Report, field: &str) -> Vec<f64> {
    match field {
        "dimension" => vec![report.dimension as f64],
        "steps" => vec![report.steps as f64],
        "time" => vec![report.time],
        "contact_count" => vec![report.contact_count as f64],
        "largest_overlap" => vec![report.largest_overlap],
        "potential_length" => vec![report.potential_length],
        "block_strain_energy" => vec![report.block_strain_energy],
        "block_damping_loss" => vec![report.block_damping_loss],
        "divided_steps" => vec![report.divided_steps as f64],
        "max_penetration_ratio" => vec![report.max_penetration_ratio],
        "peak_overlap" => vec![report.peak_overlap],
        "peak_speed" => vec![report.peak_speed],
        "sleeping_count" => vec![report.sleeping_count as f64],
        "max_sleep_error" => vec![report.max_sleep_error],
        _ => unknown(field),
    }
}

pub fn of_energy(energy: &Energy, field: &str) -> Vec<f64> {
    match field {
        "kinetic" => vec![energy.kinetic],
        "gravity" => vec![energy.gravity],
        "strain" => vec![energy.strain],
        "friction_loss" => vec![energy.friction_loss],
        "contact_damping_loss" => vec![energy.contact_damping_loss],
        "residual" => vec![energy.residual],
        _ => unknown(field),
    }
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

fn unknown(field: &str) -> Vec<f64> {
    panic!("{field} is not a field that cases look at")
}
