//! A host with its own arrays and its own integrator; the library computes contacts and forces.
//!
//! A block slides down a slope of 30 degrees (Wang et al. 2021, section 4.1, in the plane); the
//! distance is known: s = 1/2 (g sin - g cos tan(phi)) t^2. The block starts in equilibrium with
//! its springs.

use halfspace::{
    Block, BlockDef, Context, Law, Pose, Result, Shape, View, ViewMut, World, WorldDef,
};

const SLOPE: f64 = 30.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const GRAVITY: f64 = 9.81;
const WIDTH: f64 = 5.0;
const HEIGHT: f64 = 4.0;
const DENSITY: f64 = 2500.0;
const STIFFNESS: f64 = 1e10;
const DURATION: f64 = 5.0;
const TIME_STEP: f64 = 1e-5;
/// Relative to the distance.
const LARGEST_ERROR: f64 = 1e-3;

fn main() -> Result<()> {
    let mut within = true;
    for friction in [15.0, 20.0, 25.0] {
        let distance = slide(friction * DEGREE)?;
        let acceleration = GRAVITY * (SLOPE.sin() - SLOPE.cos() * (friction * DEGREE).tan());
        let exact = 0.5 * acceleration * DURATION * DURATION;
        let error = distance / exact - 1.0;
        println!(
            "friction {friction:2} degrees: slid {distance:.9} m, relative error {error:9.2e}"
        );
        within &= error.abs() <= LARGEST_ERROR;
    }
    std::process::exit(if within { 0 } else { 1 });
}

/// A body of this host. The library reads and writes the fields in place.
#[derive(Clone, Default)]
struct Body {
    mass: f64,
    moment_of_inertia: f64,
    angle: f64,
    position: [f64; 2],
    velocity: [f64; 2],
    spin: [f64; 3],
    force: [f64; 2],
    torque: [f64; 3],
}

/// Computes the distance that the block slides.
fn slide(friction: f64) -> Result<f64> {
    let context = Context::new()?;
    // The world has no gravity: the host has its own.
    let mut world = World::new(
        &context,
        &WorldDef::in_plane().gravity([0.0; 3]).time_step(TIME_STEP),
    )?;
    let law = Law::default()
        .normal_stiffness(STIFFNESS)
        .shear_stiffness(STIFFNESS)
        .friction_angle(friction);
    world.set_default_law(&law)?;
    let rock = world.add_material(DENSITY)?;

    let ground = Shape::polygon(&context, &rectangle(400.0, 1.0))?;
    let block = Shape::polygon(&context, &rectangle(WIDTH, HEIGHT))?;
    let properties = block.properties();
    let weight = DENSITY * properties.volume * GRAVITY;
    let rest = Rest::of(weight, friction);

    // The slope's upper side goes through the origin, where the block starts.
    let upward = [SLOPE.sin(), SLOPE.cos()];
    let bodies = vec![
        Body {
            position: upward.map(|u| -0.5 * u),
            angle: -SLOPE,
            ..Body::default()
        },
        Body {
            position: upward.map(|u| rest.height * u),
            angle: -SLOPE - rest.tilt,
            mass: DENSITY * properties.volume,
            moment_of_inertia: DENSITY
                * (properties.second_moment[0] + properties.second_moment[1]),
            ..Body::default()
        },
    ];
    let fixed = world.add_block(&ground, &BlockDef::fixed(rock))?;
    let sliding = world.add_block(&block, &BlockDef::rigid(rock).at(pose_of(&bodies[1])))?;
    let mut host = Host {
        poses: vec![Pose::default(); bodies.len()],
        world,
        bodies,
    };
    host.preload(fixed, sliding, rest.shear_force)?;

    let from = host.bodies[1].position;
    for _ in 0..(DURATION / TIME_STEP).round() as u64 {
        host.step()?;
    }
    let to = host.bodies[1].position;
    Ok((to[0] - from[0]) * SLOPE.cos() - (to[1] - from[1]) * SLOPE.sin())
}

struct Host {
    world: World,
    bodies: Vec<Body>,
    /// Poses in the layout of the library; all other data are read from the bodies.
    poses: Vec<Pose>,
}

impl Host {
    /// Velocity Verlet.
    fn step(&mut self) -> Result<()> {
        self.kick();
        for body in self.bodies.iter_mut().filter(|body| body.mass > 0.0) {
            for (position, velocity) in body.position.iter_mut().zip(body.velocity) {
                *position += velocity * TIME_STEP;
            }
            body.angle += body.spin[2] * TIME_STEP;
        }
        self.evaluate_forces(TIME_STEP)?;
        self.kick();
        Ok(())
    }

    /// Half a step of velocity.
    fn kick(&mut self) {
        for body in self.bodies.iter_mut().filter(|body| body.mass > 0.0) {
            let half = 0.5 * TIME_STEP;
            body.velocity[0] += half * body.force[0] / body.mass;
            body.velocity[1] += half * (body.force[1] / body.mass - GRAVITY);
            body.spin[2] += half * body.torque[2] / body.moment_of_inertia;
        }
    }

    fn evaluate_forces(&mut self, elapsed: f64) -> Result<()> {
        self.detect()?;
        let (forces, torques) =
            ViewMut::of_two(&mut self.bodies, |body| (&mut body.force, &mut body.torque));
        self.world.forces(elapsed, forces, torques)
    }

    fn detect(&mut self) -> Result<()> {
        for (pose, body) in self.poses.iter_mut().zip(&self.bodies) {
            *pose = pose_of(body);
        }
        self.world.set_poses(&self.poses)?;
        let velocities = View::of(&self.bodies, |body| &body.velocity);
        let spins = View::of(&self.bodies, |body| &body.spin);
        self.world.set_velocities(velocities, spins)?;
        self.world.detect()?;
        Ok(())
    }

    /// The shear spring between two blocks starts with a force up the slope.
    fn preload(&mut self, fixed: Block, sliding: Block, shear_force: f64) -> Result<()> {
        self.detect()?;
        let up_the_slope = [-shear_force * SLOPE.cos(), shear_force * SLOPE.sin(), 0.0];
        self.world.set_shear_force(fixed, sliding, up_the_slope)?;
        self.evaluate_forces(0.0)
    }
}

fn pose_of(body: &Body) -> Pose {
    Pose::in_plane(body.position[0], body.position[1], body.angle)
}

fn rectangle(width: f64, height: f64) -> [[f64; 2]; 4] {
    let (x, y) = (0.5 * width, 0.5 * height);
    [[-x, -y], [x, -y], [x, y], [-x, y]]
}

/// Equilibrium of the block on its springs: height of the centroid above the slope, forward tilt,
/// shear force.
struct Rest {
    height: f64,
    tilt: f64,
    shear_force: f64,
}

impl Rest {
    /// The shear force acts at the base and turns the block until the normal force is ahead of the
    /// centroid: springs K/2 under both corners, at (+-w/2 cos - h/2 sin, +-w/2 sin) relative to
    /// the middle of the base; sum of depths = 2 N/K, sum of moments = K w^2 sin cos / 4 - N h sin
    /// / 2 = y T. Found by iteration: the tilt is of the order of the overlap.
    fn of(weight: f64, friction: f64) -> Self {
        let normal_force = weight * SLOPE.cos();
        let shear_force = normal_force * friction.tan();
        let mut rest = Self {
            height: 0.5 * HEIGHT,
            tilt: 0.0,
            shear_force,
        };
        for _ in 0..50 {
            let cosine = rest.tilt.cos();
            rest.height = 0.5 * HEIGHT * cosine - normal_force / STIFFNESS;
            let moment_per_tilt =
                0.25 * STIFFNESS * WIDTH * WIDTH * cosine - 0.5 * normal_force * HEIGHT;
            rest.tilt = (rest.height * shear_force / moment_per_tilt).asin();
        }
        rest
    }
}
