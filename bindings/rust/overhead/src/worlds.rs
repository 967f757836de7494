//! Calls for a whole world: in C, in C again to show the scatter, and in Rust.

use halfspace::{BlockDef, Contact, Context, Law, Pose, Result, Shape, World, WorldDef};

use crate::host_in_c::HostInC;
use crate::timing::medians;

/// A world of side x side blocks; each pass has the given number of calls of each kind. In Rust no
/// call has work per block besides that of the library, so the overhead is the same in small and
/// large worlds.
pub fn run(side: usize, passes: usize, calls: i64) -> Result<()> {
    let bytes = grid(side)?.save();
    // All are restored, so that their memory layouts are alike.
    let mut in_c = HostInC::restore(&bytes);
    let mut again = HostInC::restore(&bytes);
    let mut host = Host::restore(&bytes)?;
    println!(
        "\n{:6} blocks, {:6} contacts         C, us  C again / C  safe Rust / C  over C, us",
        host.poses.len(),
        host.contacts.len()
    );

    type InC = fn(&mut HostInC, i64);
    let mut compare = |name, of_c: InC, of_rust: fn(&mut Host) -> Result<()>| {
        let works: [&mut dyn FnMut(); 3] = [
            &mut || of_c(&mut in_c, calls),
            &mut || of_c(&mut again, calls),
            &mut || (0..calls).for_each(|_| of_rust(&mut host).expect("a host that works")),
        ];
        let [c, again, safe] = medians(passes, works).map(|seconds| 1e6 * seconds / calls as f64);
        let (chance, ratio) = (again / c, safe / c);
        println!(
            "{name:30} {c:12.3}  {chance:11.4}  {ratio:13.4}  {:+10.3}",
            safe - c
        );
        assert!(in_c.poses_are(&host.poses), "both worlds are alike");
    };
    compare("set poses and detect", HostInC::detect, Host::detect);
    compare("forces", HostInC::forces, Host::forces);
    compare("contacts", HostInC::get_contacts, Host::get_contacts);
    compare("step", HostInC::step, Host::step);
    compare("poses", HostInC::get_poses, Host::get_poses);
    Ok(())
}

/// A world with the arrays of its host.
struct Host {
    world: World,
    poses: Vec<Pose>,
    forces: Vec<[f64; 3]>,
    torques: Vec<[f64; 3]>,
    contacts: Vec<Contact>,
}

impl Host {
    fn restore(bytes: &[u8]) -> Result<Self> {
        let mut world = World::restore(&Context::new()?, bytes)?;
        world.detect()?;
        let none = vec![[0.0; 3]; world.block_count()];
        let (poses, contacts) = (world.poses(), world.contacts());
        Ok(Self {
            world,
            poses,
            forces: none.clone(),
            torques: none,
            contacts,
        })
    }

    /// Setting poses, also equal ones, requires a new detection.
    fn detect(&mut self) -> Result<()> {
        self.world.set_poses(&self.poses)?;
        self.world.detect().map(drop)
    }

    fn forces(&mut self) -> Result<()> {
        self.world.forces(0.0, &mut self.forces, &mut self.torques)
    }

    fn get_poses(&mut self) -> Result<()> {
        self.world.poses_into(&mut self.poses)
    }

    fn get_contacts(&mut self) -> Result<()> {
        self.world.contacts_into(&mut self.contacts);
        Ok(())
    }

    fn step(&mut self) -> Result<()> {
        self.world.step(1)
    }
}

/// Squares with small overlaps with their four neighbours.
fn grid(side: usize) -> Result<World> {
    let context = Context::new()?;
    let square = Shape::polygon(
        &context,
        &[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]],
    )?;
    let mut world = World::new(
        &context,
        &WorldDef::in_plane().gravity([0.0; 3]).time_step(1e-4),
    )?;
    world.set_default_law(
        &Law::default()
            .normal_stiffness(1e6)
            .shear_stiffness(1e6)
            .friction_angle(0.5),
    )?;
    let stone = world.add_material(2000.0)?;
    for row in 0..side {
        for column in 0..side {
            // Every second row is shifted by a quarter, so that no corners meet.
            let x = 0.999 * column as f64 + 0.25 * (row % 2) as f64;
            let pose = Pose::at([x, 0.999 * row as f64, 0.0]);
            world.add_block(&square, &BlockDef::rigid(stone).at(pose))?;
        }
    }
    Ok(world)
}
