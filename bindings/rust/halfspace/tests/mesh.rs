//! Bodies of finite elements.

use halfspace::{
    Axes, BlockDef, BlockKind, Body, BodyDef, Cell, CellState, Context, Elasticity, ErrorKind,
    Mesh, Pose, Result, Shape, ViewMut, World, WorldDef,
};

/// Two adjacent squares; the right one is divided along its diagonal.
const NODES: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [1.0, 1.0],
    [0.0, 1.0],
    [2.0, 0.0],
    [2.0, 1.0],
];
const CELLS: [Cell; 3] = [
    Cell::Quad([0, 1, 2, 3]),
    Cell::Triangle([1, 4, 5]),
    Cell::Triangle([1, 5, 2]),
];
const DENSITY: f64 = 1000.0;
const YOUNG_MODULUS: f64 = 1e6;
const POISSON_RATIO: f64 = 0.25;
/// Green strain of a stretch by 1.25; the second Piola-Kirchhoff stress is the modulus times this.
const STRAIN: f64 = 9.0 / 32.0;
const FORCE: f64 = 1.25 * STRAIN * YOUNG_MODULUS;

fn rubber() -> Elasticity {
    Elasticity::default()
        .young_modulus(YOUNG_MODULUS)
        .poisson_ratio(POISSON_RATIO)
        .plane_stress()
}

fn body_in(def: &WorldDef, pose: Pose) -> Result<(World, Body)> {
    let context = Context::new()?;
    let mesh = Mesh::in_plane(&context, &NODES, &CELLS)?;
    let mut world = World::new(&context, &def.gravity([0.0; 3]))?;
    let material = world.add_material(DENSITY)?;
    world.set_elasticity(material, &rubber())?;
    let body = world.add_mesh(&mesh, &BodyDef::of(material).at(pose))?;
    Ok((world, body))
}

/// Held at its left side along x, and pulled to the right. The damping is about critical for
/// bending, the slowest mode, at about 8/s.
fn pulled_body() -> Result<(World, Body)> {
    let (mut world, body) = body_in(&WorldDef::in_plane().mass_damping(16.0), Pose::default())?;
    world.hold_nodes(body, &[0], Axes::X | Axes::Y, [0.0; 3])?;
    world.hold_nodes(body, &[3], Axes::X, [0.0; 3])?;
    world.set_node_force(body, &[4, 5], [FORCE / 2.0, 0.0, 0.0])?;
    Ok((world, body))
}

fn is_close(got: f64, expected: f64, tolerance: f64) -> bool {
    (got - expected).abs() <= tolerance
}

#[test]
fn a_mesh_has_nodes_cells_and_a_surface() -> Result<()> {
    let context = Context::new()?;
    let mesh = Mesh::in_plane(&context, &NODES, &CELLS)?;
    let properties = mesh.properties();
    assert_eq!((properties.dimension, properties.node_count), (2, 6));
    assert_eq!(
        (properties.cell_count, properties.surface_face_count),
        (3, 6)
    );
    assert!(is_close(properties.volume, 2.0, 1e-14));
    // Nodes with z are allowed in 2D.
    let with_z = NODES.map(|[x, y]| [x, y, 7.0]);
    let same = Mesh::in_plane(&mesh.context(), &with_z, &CELLS)?;
    assert_eq!(same.properties(), properties);
    assert_eq!(CELLS[1].nodes(), [1, 4, 5]);
    Ok(())
}

#[test]
fn a_pulled_body_comes_to_rest_stretched() -> Result<()> {
    let (mut world, body) = pulled_body()?;
    while world.report()?.time < 4.0 {
        world.step(100)?;
    }
    let thinner = (1.0 - 2.0 * POISSON_RATIO * STRAIN).sqrt();
    let forces = world.node_forces(body)?;
    for (i, [x, y, z]) in world.node_positions(body)?.into_iter().enumerate() {
        assert!(is_close(x, 1.25 * NODES[i][0], 1e-9) && is_close(y, thinner * NODES[i][1], 1e-9));
        let pressed = if NODES[i][0] == 0.0 { FORCE / 2.0 } else { 0.0 };
        assert!(is_close(forces[i][0], pressed, 1e-3) && is_close(forces[i][1], 0.0, 1e-3));
        assert_eq!((z, forces[i][2]), (0.0, 0.0));
    }
    let cells = world.cells(body)?;
    assert_eq!(cells.len(), 3);
    for cell in &cells {
        assert!(is_close(cell.strain[0][0], STRAIN, 1e-9));
        assert!(is_close(cell.strain[1][1], -POISSON_RATIO * STRAIN, 1e-9));
        assert!(is_close(cell.stress[0][0], FORCE / thinner, 1e-3));
        assert!(is_close(cell.stress[1][1], 0.0, 1e-3));
    }
    let state = world.body_state(body)?;
    let energy = YOUNG_MODULUS * STRAIN * STRAIN; // over 2, times the area
    let sum: f64 = cells.iter().map(|cell| cell.strain_energy).sum();
    assert!(is_close(state.strain_energy, energy, 1e-4) && is_close(sum, energy, 1e-4));
    assert_eq!((state.node_count, state.cell_count), (6, 3));
    assert_eq!(state.mass, 2.0 * DENSITY);
    assert!(is_close(state.centroid[0], 1.25, 1e-9));
    assert!(state.kinetic_energy < 1e-12 && state.momentum[0].abs() < 1e-6);
    Ok(())
}

#[test]
fn a_restored_body_goes_on_bit_for_bit() -> Result<()> {
    let (mut world, body) = pulled_body()?;
    world.step(20)?;
    let mut restored = World::restore(&Context::new()?, &world.save())?;
    assert_eq!(restored.block_count(), world.block_count());
    world.step(20)?;
    restored.step(20)?;
    assert_eq!(world.node_positions(body)?, restored.node_positions(body)?);
    let velocities = world.node_velocities(body)?;
    assert!(velocities[4][0] > 0.0);
    assert_eq!(velocities, restored.node_velocities(body)?);
    assert_eq!(Body::from_id(body.id()), Some(body));
    assert_eq!(Body::from_id(0), None);
    Ok(())
}

#[test]
fn nodes_are_set_and_read() -> Result<()> {
    // Rotated by 90 degrees about the origin of its frame, and placed at (3, 4).
    let pose = Pose::in_plane(3.0, 4.0, std::f64::consts::FRAC_PI_2);
    let (mut world, body) = body_in(&WorldDef::in_plane().time_step(1e-3), pose)?;
    let last = world.node_positions(body)?[5];
    assert!(is_close(last[0], 2.0, 1e-14) && is_close(last[1], 6.0, 1e-14));
    let mut two = [[0.0; 2]; 2];
    assert_eq!(world.node_positions_into(body, &mut two)?, 6);
    assert!(is_close(two[1][0], 3.0, 1e-14) && is_close(two[1][1], 5.0, 1e-14));

    let mut velocities = [[1.0, 2.0, 0.0]; 6];
    world.set_node_velocities(body, &velocities)?;
    world.hold_nodes(body, &[1], Axes::Y, [7.0, -3.0, 0.0])?;
    velocities[1][1] = -3.0;
    assert_eq!(
        world.node_velocities(body)?,
        velocities,
        "what is not held keeps its velocity"
    );
    let mut some = [[0.0; 2]; 3];
    assert_eq!(world.node_velocities_into(body, &mut some)?, 6);
    assert_eq!(some, [[1.0, 2.0], [1.0, -3.0], [1.0, 2.0]]);
    assert_eq!(world.node_forces_into(body, ViewMut::none())?, 6);

    let all = [0, 1, 2, 3, 4, 5];
    world.hold_nodes(body, &all, Axes::X | Axes::Y, [2.0, 0.5, 0.0])?;
    world.step(1000)?;
    let state = world.body_state(body)?;
    assert!(is_close(state.momentum[0], 4.0 * DENSITY, 1e-9));
    assert!(is_close(state.centroid[0], 4.5, 1e-9) && is_close(state.centroid[1], 5.5, 1e-9));
    world.hold_nodes(body, &all, Axes::NONE, [0.0; 3])?;
    assert_eq!(world.node_velocities(body)?[3], [2.0, 0.5, 0.0]);
    Ok(())
}

#[test]
fn each_cell_may_have_its_material() -> Result<()> {
    let context = Context::new()?;
    let mesh = Mesh::in_plane(&context, &NODES, &CELLS)?;
    let mut world = World::new(&context, &WorldDef::in_plane())?;
    let light = world.add_material(DENSITY)?;
    let heavy = world.add_material(2.0 * DENSITY)?;
    let rigid = world.add_material(DENSITY)?;
    for material in [light, heavy] {
        world.set_elasticity(material, &rubber())?;
    }
    let materials = [heavy, light, light];
    let def = BodyDef::of_each(&materials).velocity([1.0, -2.0, 0.0]);
    let body = world.add_mesh(&mesh, &def)?;
    let state = world.body_state(body)?;
    assert!(is_close(state.mass, 3.0 * DENSITY, 1e-9));
    assert!(is_close(state.momentum[1], -6.0 * DENSITY, 1e-9));

    let error = world
        .add_mesh(&mesh, &BodyDef::of_each(&materials[..2]))
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "World::add_mesh: cell_materials has 2 entries; the mesh has 3 cells"
    );
    let error = world.add_mesh(&mesh, &BodyDef::of(rigid)).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::State);
    assert!(error.to_string().contains("no elasticity"));
    Ok(())
}

#[test]
fn blocks_at_the_surface_are_of_the_body() -> Result<()> {
    let (mut world, body) = body_in(&WorldDef::in_plane(), Pose::default())?;
    let blocks = world.blocks();
    assert_eq!((blocks.len(), world.poses().len()), (4, 4));
    let mut met = [false; 3];
    for &block in &blocks {
        assert_eq!(world.block_state(block)?.kind, BlockKind::Mesh);
        let (of, cell) = world.body_of_block(block)?.expect("a body");
        assert_eq!(of, body);
        met[cell] = true;
    }
    assert_eq!(met, [true; 3], "all cells are at the surface");
    assert!(world.remove_block(blocks[0]).is_err());
    assert_eq!(world.block_count(), 4);

    let square = Shape::polygon(&world.context(), &NODES[..4])?;
    let material = world.block_state(blocks[0])?.material;
    let away = BlockDef::rigid(material).at(Pose::in_plane(9.0, 9.0, 0.0));
    let single = world.add_block(&square, &away)?;
    assert_eq!(world.body_of_block(single)?, None);
    world.remove_body(body)?;
    assert_eq!(world.blocks(), [single]);
    for error in [
        world.body_state(body).unwrap_err(),
        world.body_of_block(blocks[0]).unwrap_err(),
        world.node_positions(body).unwrap_err(),
        world.cells(body).unwrap_err(),
        world.remove_body(body).unwrap_err(),
    ] {
        assert_eq!(error.kind(), ErrorKind::StaleId);
    }
    Ok(())
}

#[test]
fn bodies_are_sheared_in_space() -> Result<()> {
    let context = Context::new()?;
    let nodes = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    let mesh = Mesh::in_space(&context, &nodes, &[Cell::Tetrahedron([0, 1, 2, 3])])?;
    let def = WorldDef::in_space()
        .gravity([0.0; 3])
        .time_step(1.0 / 1024.0);
    let mut world = World::new(&context, &def)?;
    let material = world.add_material(DENSITY)?;
    world.set_elasticity(material, &rubber().plane_strain())?;
    let body = world.add_mesh(&mesh, &BodyDef::of(material))?;
    let all = Axes::X | Axes::Y | Axes::Z;
    world.hold_nodes(body, &[0, 1, 2], all, [0.0; 3])?;
    world.hold_nodes(body, &[3], all, [128.0, 0.0, 0.0])?;
    world.step(2)?; // x grows by z / 4
    assert_eq!(world.node_positions(body)?[3], [0.25, 0.0, 1.0]);
    let mut cell = [CellState::default()];
    assert_eq!(world.cells_into(body, &mut cell)?, 1);
    assert!(is_close(cell[0].strain[0][2], 0.125, 1e-14));
    assert!(is_close(cell[0].strain[2][2], 0.03125, 1e-14));
    assert_eq!(cell[0].strain[2][0], cell[0].strain[0][2]);
    Ok(())
}

#[test]
fn a_cell_turned_inside_out_ends_the_step() -> Result<()> {
    let (mut world, body) = body_in(&WorldDef::in_plane().time_step(1e-3), Pose::default())?;
    let both = Axes::X | Axes::Y;
    world.hold_nodes(body, &[0, 1, 2, 3], both, [0.0; 3])?;
    world.hold_nodes(body, &[4, 5], both, [-4000.0, 0.0, 0.0])?;
    let before = world.node_positions(body)?;
    let error = world.step(1).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Inverted);
    assert!(error.to_string().starts_with("hs_world_step: "));
    assert_eq!(world.node_positions(body)?, before);
    Ok(())
}

#[test]
fn faulty_meshes_are_refused() -> Result<()> {
    let context = Context::new()?;
    let refused = |cells: &[Cell]| Mesh::in_plane(&context, &NODES, cells).unwrap_err();
    let mut cells = CELLS;
    cells[0] = Cell::Quad([3, 2, 1, 0]);
    let error = refused(&cells);
    assert_eq!(error.kind(), ErrorKind::Geometry);
    assert!(error.to_string().starts_with("hs_mesh_create: cell 0 "));
    cells[0] = Cell::Quad([0, 1, 2, 6]);
    assert_eq!(refused(&cells).kind(), ErrorKind::Argument);
    cells[0] = Cell::Tetrahedron([0, 1, 2, 3]);
    assert_eq!(refused(&cells).kind(), ErrorKind::Argument);
    cells[0] = Cell::Quad([0, 1, 2, usize::MAX]);
    assert_eq!(
        refused(&cells).to_string(),
        "a mesh: cells: an index is above 2^31 - 1"
    );
    assert_eq!(refused(&[]).kind(), ErrorKind::Argument);
    assert!(Mesh::in_space(&context, &NODES, &CELLS).is_err());
    Ok(())
}

#[test]
fn a_body_is_stressed_and_cut() -> Result<()> {
    let (mut world, body) = pulled_body()?;
    let stress = [[-2e6, 1e6, 0.0], [1e6, -5e6, 0.0], [0.0; 3]];
    world.set_body_stress(body, &stress, &[[[0.0; 3]; 3]; 3])?;
    let last = world.body_state(body)?.cell_count as usize - 1;
    for cell in world.cells(body)? {
        assert!((cell.stress[0][0] / -2e6 - 1.0).abs() < 1e-9);
        assert!((cell.stress[0][1] / 1e6 - 1.0).abs() < 1e-9);
    }
    let released = world.remove_cells(body, &[last])?;
    assert_eq!(released.len(), 6);
    let sum = released.iter().map(|force| force[0]).sum::<f64>();
    let size = released
        .iter()
        .map(|force| force[0].abs())
        .fold(0.0, f64::max);
    assert!(size > 1e3 && sum.abs() < 1e-9 * size);
    assert_eq!(world.cells(body)?[last].stress[0][0], 0.0);
    assert_eq!(world.block_count(), world.blocks().len());
    assert_eq!(world.block_count(), world.report()?.block_count);
    Ok(())
}

#[test]
fn what_no_body_has_is_refused() -> Result<()> {
    let (mut world, body) = pulled_body()?;
    let error = world.remove_cells(body, &[0, 9]).unwrap_err();
    assert!(error.to_string().contains("cells[1] is 9"));
    let lopsided = [[0.0, 1.0, 0.0], [0.0; 3], [0.0; 3]];
    let error = world
        .set_body_stress(body, &lopsided, &[[[0.0; 3]; 3]; 3])
        .unwrap_err();
    assert!(error.to_string().contains("the tensor must be symmetric"));
    let error = world
        .hold_nodes(body, &[5, 6], Axes::X, [0.0; 3])
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    assert!(error.to_string().contains("nodes[1] is 6; the body has 6"));
    let error = world.hold_nodes(body, &[0], Axes::Z, [0.0; 3]).unwrap_err();
    assert!(error.to_string().contains("axes is 4"));
    let error = world
        .set_node_force(body, &[usize::MAX], [0.0; 3])
        .unwrap_err();
    assert!(error.to_string().starts_with("World::set_node_force: "));
    let error = world.set_node_velocities(body, &[[0.0; 2]; 5]).unwrap_err();
    assert!(error.to_string().contains("the body has 6 nodes"));
    Ok(())
}
