//! Shapes: the Rust interface beyond the shared cases.

use std::cell::Cell;

use halfspace::{ContactType, Context, Detector, FaultKind, Pose, Result, Shape};

const CUBE: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 2.0],
    [2.0, 0.0, 2.0],
    [2.0, 2.0, 2.0],
    [0.0, 2.0, 2.0],
];

const FACES: [[usize; 4]; 6] = [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 1, 5, 4],
    [1, 2, 6, 5],
    [2, 3, 7, 6],
    [3, 0, 4, 7],
];

#[test]
fn a_polyhedron_gives_back_what_it_was_made_from() -> Result<()> {
    let cube = Shape::polyhedron(&Context::new()?, &CUBE, &FACES)?;
    assert_eq!(cube.vertices(), CUBE);
    assert_eq!(cube.faces(), FACES);
    let edges = cube.edges();
    assert_eq!(edges.len(), 12);
    assert!(edges
        .iter()
        .all(|&[start, end]| start.abs_diff(end) != 2 && start != end && start < 8 && end < 8));
    Ok(())
}

#[test]
fn half_spaces_make_the_same_polyhedron() -> Result<()> {
    let context = Context::new()?;
    let cube = Shape::polyhedron(&context, &CUBE, &FACES)?;
    let halfspaces = cube.halfspaces();
    assert!(halfspaces.iter().all(|halfspace| halfspace.offset == 1.0));
    let centered = Shape::polyhedron_from_halfspaces(&context, &halfspaces)?;
    assert_eq!(centered.properties().volume, 8.0);
    assert_eq!(centered.properties().centroid, [0.0; 3]);
    Ok(())
}

#[test]
fn facets_are_fitted_within_a_tolerance() -> Result<()> {
    let context = Context::new()?;
    let mut rounded = CUBE;
    rounded[6][2] += 1e-3;
    let (shape, report) = Shape::polyhedron_fitted(&context, &rounded, &FACES, 2e-3)?;
    assert_eq!(shape.faces().len(), 6);
    assert!(report.moved > 1e-4 && report.moved < 2e-3);
    let no_facets: [[usize; 3]; 0] = [];
    let (_, report) = Shape::polyhedron_fitted(&context, &CUBE, &no_facets, 0.0)?;
    assert_eq!((report.merged, report.moved), (0, 0.0));
    rounded[6][2] -= 0.5;
    let error = Shape::polyhedron_fitted(&context, &rounded, &FACES, 1e-3).unwrap_err();
    assert!(error.to_string().contains("tolerance"), "{error}");
    Ok(())
}

#[test]
fn a_plane_beside_a_shape_leaves_it_whole() -> Result<()> {
    let cube = Shape::polyhedron(&Context::new()?, &CUBE, &FACES)?;
    let parts = cube.cut([3.0, 0.0, 0.0], [1.0, 0.0, 0.0])?;
    assert!(parts.ahead.is_none());
    assert_eq!(parts.behind.expect("the whole").vertices(), CUBE);
    Ok(())
}

#[test]
fn faults_name_vertex_and_face() -> Result<()> {
    let context = Context::new()?;
    assert_eq!(context.check_polyhedron(&CUBE, &FACES)?, None);
    let mut dented = CUBE;
    dented[6] = [1.9, 2.0, 2.0];
    let fault = context
        .check_polyhedron(&dented, &FACES)?
        .expect("a face is not plane");
    assert_eq!(fault.kind, FaultKind::FaceNotPlane);
    assert!(FACES[fault.face.expect("a face")].contains(&6));
    assert_eq!(
        context
            .check_polygon(&[[0.0, 0.0], [1.0, 0.0]])?
            .expect("too few")
            .vertex,
        None
    );
    Ok(())
}

/// A face that alternately returns no vertices and all vertices.
struct Fickle {
    vertices: [usize; 4],
    asked: Cell<usize>,
}

impl AsRef<[usize]> for Fickle {
    fn as_ref(&self) -> &[usize] {
        self.asked.set(self.asked.get() + 1);
        &self.vertices[..if self.asked.get() % 2 == 0 { 4 } else { 0 }]
    }
}

/// Sizes and vertices from different calls would make the library read past the end of the
/// vertices.
#[test]
fn faces_are_asked_once() -> Result<()> {
    let context = Context::new()?;
    for (asked, fault) in [(0, Some(FaultKind::FaceTooShort)), (1, None)] {
        let faces = FACES.map(|vertices| Fickle {
            vertices,
            asked: Cell::new(asked),
        });
        let found = context.check_polyhedron(&CUBE, &faces)?;
        assert_eq!(found.map(|found| found.kind), fault);
        assert!(faces.iter().all(|face| face.asked.get() == asked + 1));
    }
    Ok(())
}

#[test]
fn a_polygon_is_cleaned_up() -> Result<()> {
    let clockwise = [
        [0.0, 0.0],
        [0.0, 1.0],
        [0.0, 1.0],
        [1.0, 1.0],
        [1.0, 0.5],
        [1.0, 0.0],
    ];
    let cleaned = Context::new()?.clean_polygon(&clockwise, 0.0)?;
    assert_eq!(
        (cleaned.welded, cleaned.straightened, cleaned.reversed),
        (1, 1, true)
    );
    assert_eq!(cleaned.vertices.len(), 4);
    assert!(cleaned
        .vertices
        .iter()
        .all(|vertex| clockwise.contains(vertex)));
    Ok(())
}

#[test]
fn polygons_with_a_skin_touch_within_the_margin() -> Result<()> {
    let context = Context::new()?;
    let square = Shape::polygon(&context, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    let (below, above) = (Pose::default(), Pose::at([0.25, 1.25, 0.0]));
    let (a, b) = (square.at(&below), square.at(&above));
    assert!(!halfspace::detect(a, b)?.is_touching());
    let skinned = Detector::default().margin(0.5);
    let contact = skinned.detect(a, b)?;
    assert_eq!(
        (contact.kind(), contact.gap()),
        (ContactType::EdgeEdge, 0.25)
    );
    let bare = skinned.without_region().detect(a, b)?;
    assert_eq!((bare.kind(), bare.gap()), (ContactType::VertexEdge, 0.25));
    assert!(bare.points().is_empty());
    Ok(())
}
