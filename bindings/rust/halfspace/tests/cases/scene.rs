//! The shapes, the world and the settings of a case, and the statements that call the library.

use std::collections::HashMap;

use halfspace::{
    time_of_impact, Block, BlockDef, BlockKind, Contact, Context, Detector, Elasticity, HalfSpace,
    Impact, Law, Material, Motion, Pose, Result, Shape, ViewMut, World, WorldDef,
};

use halfspace_sys::{HS_FAST_DIVIDE, HS_PLANE_STRESS};

use crate::expect;
use crate::fields;
use crate::words::Words;

/// All that a case has made.
pub struct Scene {
    context: Context,
    title: String,
    faces: Vec<Vec<usize>>,
    shapes: HashMap<String, Shape>,
    poses: HashMap<String, Pose>,
    motions: HashMap<String, Motion>,
    detector: Detector,
    contact: Contact,
    impact: Impact,
    world: Option<World>,
    blocks: HashMap<String, Block>,
}

impl Scene {
    pub fn new() -> Self {
        Self {
            context: Context::new().expect("a context"),
            title: String::new(),
            faces: Vec::new(),
            shapes: HashMap::new(),
            poses: HashMap::new(),
            motions: HashMap::new(),
            detector: Detector::default(),
            contact: Contact::default(),
            impact: Impact::default(),
            world: None,
            blocks: HashMap::new(),
        }
    }

    pub fn title(&self) -> &str {
        &self.title
    }

    /// Calls the library, or looks at what came of it; an expectation that is not met panics.
    pub fn carry_out(&mut self, words: &Words) -> Result<()> {
        match words.first() {
            "case" => {
                *self = Self {
                    title: words.text_from(1),
                    ..Self::new()
                }
            }
            "faces" => self.faces = read_faces(&words.numbers_from(1)),
            "shape" => self.make_shape(words)?,
            "cut" => self.cut(words)?,
            "options" => self.set_options(words),
            "pose" => {
                self.poses.insert(words.word(1).to_owned(), pose(words, 2));
            }
            "pair" => self.detect_pair(words)?,
            "motion" => {
                self.motions.insert(words.word(1).to_owned(), motion(words));
            }
            "impact" => self.find_impact(words)?,
            "world" => self.world = Some(World::new(&self.context, &world_def(words))?),
            "restore" => drop(World::restore(&self.context, &bytes(words))?),
            "expect" => self.expect(words)?,
            _ => self.change_world(words)?,
        }
        Ok(())
    }

    fn make_shape(&mut self, words: &Words) -> Result<()> {
        let context = &self.context;
        let shape = match words.word(2) {
            "polygon" => Shape::polygon(context, &words.points_from::<2>(3))?,
            "polygon_hull" => Shape::polygon_hull(context, &words.points_from::<2>(3))?,
            "boundary" => {
                let numbers = words.numbers_from(3);
                let end = |i: usize| Some([*numbers.get(i)?, *numbers.get(i + 1)?]);
                let ends = [0, 2].map(|i| end(i).expect("an end"));
                Shape::boundary(context, ends, numbers[4], [end(5), end(7)])?
            }
            "polyhedron" => Shape::polyhedron(context, &words.points_from::<3>(3), &self.faces)?,
            "polyhedron_hull" => Shape::polyhedron_hull(context, &words.points_from::<3>(3))?,
            "halfspaces" => Shape::polyhedron_from_halfspaces(context, &halfspaces(words))?,
            kind => panic!("{kind} is not a kind of shape"),
        };
        self.shapes.insert(words.word(1).to_owned(), shape);
        Ok(())
    }

    fn cut(&mut self, words: &Words) -> Result<()> {
        let parts = self
            .shape(words.word(1))
            .cut(words.vector(2), words.vector(5))?;
        self.shapes.insert(
            words.word(8).to_owned(),
            parts.behind.expect("a part behind"),
        );
        self.shapes
            .insert(words.word(9).to_owned(), parts.ahead.expect("a part ahead"));
        Ok(())
    }

    fn set_options(&mut self, words: &Words) {
        for (field, values) in words.fields_from(1) {
            self.detector = match field {
                "parallel_angle" => self.detector.parallel_angle(values[0]),
                "vertex_zone" => self.detector.vertex_zone(values[0]),
                _ => panic!("{field} is not an option"),
            };
        }
    }

    fn detect_pair(&mut self, words: &Words) -> Result<()> {
        let pose_of = |name| self.poses.get(name).copied().unwrap_or_default();
        let (a, b) = (words.word(1), words.word(2));
        let (at_a, at_b) = (pose_of(a), pose_of(b));
        self.contact = self
            .detector
            .detect(self.shape(a).at(&at_a), self.shape(b).at(&at_b))?;
        Ok(())
    }

    fn find_impact(&mut self, words: &Words) -> Result<()> {
        let motion_of = |name| {
            let start = self.poses.get(name).copied().unwrap_or_default();
            let motion = self.motions.get(name).copied().unwrap_or_default();
            motion.start(start)
        };
        let (a, b) = (words.word(1), words.word(2));
        let (of_a, of_b) = (motion_of(a), motion_of(b));
        self.impact = time_of_impact(self.shape(a), &of_a, self.shape(b), &of_b, words.number(3))?;
        Ok(())
    }

    /// Statements that need the case's world.
    fn change_world(&mut self, words: &Words) -> Result<()> {
        let world = self.world.as_mut().expect("a world");
        let block = |i| {
            *self
                .blocks
                .get(words.word(i))
                .expect("a block of that name")
        };
        match words.first() {
            "material" => {
                world.add_material(words.number(1))?;
            }
            "default_law" => world.set_default_law(&law(words, 1))?,
            "law" => {
                let material = |i| Material::from_index(words.whole(i));
                world.set_law(material(1), material(2), &law(words, 3))?;
            }
            "elasticity" => {
                let material = Material::from_index(words.whole(1));
                world.set_elasticity(material, &elasticity(words))?;
            }
            "block" => {
                let shape = self
                    .shapes
                    .get(words.word(2))
                    .expect("a shape of that name");
                let block = world.add_block(shape, &block_def(words))?;
                self.blocks.insert(words.word(1).to_owned(), block);
            }
            "set_pose" => world.set_pose(block(1), &pose(words, 2))?,
            "velocity" => world.set_velocity(block(1), words.vector(2), words.vector(5))?,
            "applied_force" => {
                world.set_applied_force(block(1), words.vector(2), words.vector(5))?
            }
            "set_deformation" => {
                world.set_deformation(block(1), &words.tensor(2), &words.tensor(11))?
            }
            "set_stress" => world.set_stress(block(1), &words.tensor(2))?,
            "surface_load" => {
                world.add_surface_load(block(1), words.whole(2) as usize, words.vector(3))?
            }
            "clear_surface_loads" => world.clear_surface_loads(block(1))?,
            "remove" => world.remove_block(block(1))?,
            "detect" => {
                world.detect()?;
            }
            "forces" => world.forces(words.number(1), ViewMut::none(), ViewMut::none())?,
            "step" => world.step(words.number(1) as u64)?,
            "reopen" => {
                let bytes = world.save();
                self.world = Some(World::restore(&self.context, &bytes)?);
            }
            statement => panic!("{statement} is not a statement"),
        }
        if let ("detect" | "forces" | "step", Some(world)) = (words.first(), &self.world) {
            self.contact = world.contacts().first().copied().unwrap_or(self.contact);
        }
        Ok(())
    }

    fn expect(&mut self, words: &Words) -> Result<()> {
        let outcome = match words.word(1) {
            "hash" => expect::hash(&self.world().poses(), words.word(2)),
            _ => self.expect_field(words)?,
        };
        if let Err(why) = outcome {
            panic!("case {}: {words}: {why}", self.title);
        }
        Ok(())
    }

    fn expect_field(&mut self, words: &Words) -> Result<expect::Outcome> {
        // A subject that has no name of its own is followed by the field at once.
        let first = match words.word(1) {
            "shape" | "block" | "deformation" => 3,
            _ => 2,
        };
        let (subject, field) = (words.word(2), words.word(first));
        let found = match words.word(1) {
            "shape" => fields::of_shape(&self.shape(subject).properties(), field),
            "contact" => fields::of_contact(&self.contact, field),
            "impact" => fields::of_impact(&self.impact, field),
            "block" => {
                let block = self.block(subject);
                fields::of_block(&self.world().block_state(block)?, field)
            }
            "deformation" => {
                let block = self.block(subject);
                fields::of_deformation(&self.world().deformation(block)?, field)
            }
            "report" => fields::of_report(&self.world().report()?, field),
            "energy" => fields::of_energy(&self.world().report()?.energy, field),
            subject => panic!("{subject} is not an object with fields"),
        };
        Ok(expect::field(found, field, words.from(first + 1)))
    }

    fn shape(&self, name: &str) -> &Shape {
        self.shapes.get(name).expect("a shape of that name")
    }

    fn block(&self, name: &str) -> Block {
        *self.blocks.get(name).expect("a block of that name")
    }

    fn world(&mut self) -> &mut World {
        self.world.as_mut().expect("a world")
    }
}

fn pose(words: &Words, i: usize) -> Pose {
    Pose {
        position: words.vector(i),
        rotation: words.quaternion(i + 3),
    }
}

/// The number of a face's vertices, then their indices, face by face.
fn read_faces(numbers: &[f64]) -> Vec<Vec<usize>> {
    let mut faces = Vec::new();
    let mut rest = numbers.iter().map(|&number| number as usize);
    while let Some(size) = rest.next() {
        faces.push(rest.by_ref().take(size).collect());
    }
    faces
}

fn halfspaces(words: &Words) -> Vec<HalfSpace> {
    let numbers = words.numbers_from(3);
    numbers
        .chunks_exact(4)
        .map(|n| HalfSpace {
            normal: [n[0], n[1], n[2]],
            offset: n[3],
        })
        .collect()
}

fn bytes(words: &Words) -> Vec<u8> {
    words
        .numbers_from(1)
        .into_iter()
        .map(|number| number as u8)
        .collect()
}

/// A definition with the fields that the words from `i` on set.
fn with_fields<T>(
    words: &Words,
    i: usize,
    default: T,
    set: impl Fn(T, &str, &[f64]) -> Option<T>,
) -> T {
    let fields = words.fields_from(i);
    fields.iter().fold(default, |def, (field, values)| {
        set(def, field, values).unwrap_or_else(|| panic!("{field} is not a field of {words}"))
    })
}

fn world_def(words: &Words) -> WorldDef {
    let fields = words.fields_from(1);
    let dimension = fields
        .iter()
        .find(|(field, _)| *field == "dimension")
        .map_or(2, |(_, values)| values[0] as i32);
    let default = WorldDef::of_dimension(dimension);
    with_fields(words, 1, default, |def, field, values| match field {
        "dimension" => Some(def),
        "fast_blocks" => Some(def.divide_fast_blocks(values[0] as i32 == HS_FAST_DIVIDE)),
        _ => fields::set_world(def, field, values),
    })
}

fn law(words: &Words, i: usize) -> Law {
    with_fields(words, i, Law::default(), fields::set_law)
}

fn elasticity(words: &Words) -> Elasticity {
    let default = Elasticity::default();
    with_fields(words, 2, default, |elasticity, field, values| match field {
        "plane" if values[0] as i32 == HS_PLANE_STRESS => Some(elasticity.plane_stress()),
        "plane" => Some(elasticity.plane_strain()),
        _ => fields::set_elasticity(elasticity, field, values),
    })
}

fn motion(words: &Words) -> Motion {
    let row = |values: &[f64]| -> [f64; 3] { values.try_into().expect("three numbers") };
    let tensor = |values: &[f64]| [0, 3, 6].map(|i| row(&values[i..i + 3]));
    let default = Motion::default();
    with_fields(words, 2, default, |motion, field, values| match field {
        "gradient" => Some(motion.gradient(tensor(values))),
        "gradient_rate" => Some(motion.gradient_rate(tensor(values))),
        _ => fields::set_motion(motion, field, values),
    })
}

fn block_def(words: &Words) -> BlockDef {
    let material = Material::from_index(words.whole(4));
    let def = match BlockKind::from_value(words.whole(3)) {
        BlockKind::Fixed => BlockDef::fixed(material),
        BlockKind::Prescribed => BlockDef::prescribed(material),
        BlockKind::Affine => BlockDef::affine(material),
        _ => BlockDef::rigid(material),
    };
    def.at(pose(words, 5))
}
