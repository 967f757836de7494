//! Affine blocks: the Rust interface beyond the shared cases.

use halfspace::{
    Block, BlockDef, BlockKind, Context, Deformation, Elasticity, ErrorKind, Pose, Result, Shape,
    Tensor, World, WorldDef,
};

const SQUARE: [[f64; 2]; 4] = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
const ZERO: Tensor = [[0.0; 3]; 3];
/// A stretch by 1.25 along x, then a rotation by 90 degrees, which maps x to y.
const STRETCHED_AND_TURNED: Tensor = [[0.0, -1.0, 0.0], [1.25, 0.0, 0.0], [0.0, 0.0, 1.0]];

/// An affine square whose material has 1e6 for both of Lame's constants, and a rigid one.
fn two_squares() -> Result<(World, [Block; 2])> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &SQUARE)?;
    let mut world = World::new(
        &context,
        &WorldDef::in_plane().gravity([0.0; 3]).time_step(1e-3),
    )?;
    let rubber = world.add_material(1000.0)?;
    world.set_elasticity(rubber, &Elasticity::default().young_modulus(2.5e6))?;
    let affine = BlockDef::affine(rubber).at(Pose::in_plane(3.0, 4.0, 0.0));
    let rigid = BlockDef::rigid(rubber).at(Pose::in_plane(9.0, 9.0, 0.5));
    let blocks = [
        world.add_block(&square, &affine)?,
        world.add_block(&square, &rigid)?,
    ];
    Ok((world, blocks))
}

#[test]
fn a_tensor_is_its_rows() -> Result<()> {
    let (mut world, [affine, _]) = two_squares()?;
    let rate = [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0], [0.0; 3]];
    world.set_deformation(affine, &STRETCHED_AND_TURNED, &rate)?;
    // (1/2, -1/2) goes to (1/2, 5/8) from the centroid.
    assert_eq!(world.block_vertices(affine)?[1], [3.5, 4.625, 0.0]);
    let deformation = world.deformation(affine)?;
    assert_eq!(deformation.gradient, STRETCHED_AND_TURNED);
    assert_eq!(deformation.rate, rate);
    assert_eq!(world.block_state(affine)?.kind, BlockKind::Affine);
    Ok(())
}

#[test]
fn all_blocks_are_those_one_by_one() -> Result<()> {
    let (mut world, [affine, rigid]) = two_squares()?;
    world.set_deformation(affine, &STRETCHED_AND_TURNED, &ZERO)?;
    let deformations = world.deformations();
    assert_eq!(
        deformations,
        [world.deformation(affine)?, world.deformation(rigid)?]
    );
    assert_eq!(deformations[1].strain_energy, 0.0);
    assert!((deformations[1].gradient[1][0] - 0.5f64.sin()).abs() < 1e-15);

    let mut buffer = [Deformation::default(); 2];
    world.deformations_into(&mut buffer)?;
    assert_eq!(buffer[..], deformations);
    let error = world.deformations_into(&mut buffer[..1]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "World::deformations_into: deformations has 1 entries; the world has 2 blocks"
    );
    Ok(())
}

#[test]
fn loads_on_faces_are_taken_off_again() -> Result<()> {
    let (mut world, [affine, _]) = two_squares()?;
    world.add_surface_load(affine, 1, [1e3, 0.0, 0.0])?;
    world.clear_surface_loads(affine)?;
    world.step(1)?;
    assert_eq!(world.deformation(affine)?.rate, ZERO);
    // 1000 N on 1000 kg.
    world.add_surface_load(affine, 1, [1e3, 0.0, 0.0])?;
    world.step(1)?;
    let velocity = world.block_state(affine)?.velocity[0];
    assert!((velocity - 1e-3).abs() < 1e-18);
    Ok(())
}

#[test]
fn what_is_not_affine_is_not_strained() -> Result<()> {
    let (mut world, [affine, rigid]) = two_squares()?;
    for error in [
        world.set_deformation(rigid, &STRETCHED_AND_TURNED, &ZERO),
        world.set_stress(rigid, &ZERO),
        world.add_surface_load(rigid, 0, [0.0; 3]),
        world.clear_surface_loads(rigid),
    ] {
        assert_eq!(error.unwrap_err().kind(), ErrorKind::State);
    }
    let error = world
        .add_surface_load(affine, usize::MAX, [0.0; 3])
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    world.remove_block(affine)?;
    assert_eq!(
        world.deformation(affine).unwrap_err().kind(),
        ErrorKind::StaleId
    );
    Ok(())
}
