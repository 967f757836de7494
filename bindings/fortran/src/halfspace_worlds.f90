!> A world: blocks, materials, laws and time. Use step(), or detect() and forces() with an integrator of the host.
!!
!! Bulk arrays have one entry per block, in the order of blocks(). Points and vectors are columns, x(2,n) or x(3,n);
!! with rows = .true. they are rows, x(n,2) or x(n,3). Array sections are accessed without a copy. Angular velocities
!! and torques have three components; in 2D only z is used.
module halfspace_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c, halfspace_energy => hs_energy, halfspace_world_plan => hs_world_plan, &
    halfspace_world_report => hs_world_report
  use halfspace_block_worlds, only: halfspace_block_state
  use halfspace_bodies, only: halfspace_body, halfspace_body_state, halfspace_cell_state
  use halfspace_contacts, only: halfspace_block, halfspace_contact
  use halfspace_definitions, only: halfspace_pose
  use halfspace_meshes, only: halfspace_mesh
  use halfspace_shapes, only: halfspace_shape
  use halfspace_spread_worlds, only: spread_world
  implicit none
  private
  public :: halfspace_block_state, halfspace_energy, halfspace_world, halfspace_world_plan, halfspace_world_report

  !> Assignment adds a reference: all copies are the same world, which the last one destroys. save() and restore() make
  !! a copy. Procedures for blocks are declared in halfspace_block_worlds, for bonds and relaxation in
  !! halfspace_bonded_worlds, for bolts and water in halfspace_bolted_worlds, for what a world was given in
  !! halfspace_defined_worlds, for separate arrays of components in the plane in halfspace_plane_worlds, for shares in
  !! halfspace_spread_worlds.
  type, extends(spread_world) :: halfspace_world
  contains
    procedure :: add_mesh
    procedure :: remove_body
    procedure :: body_state
    procedure :: body_of_block
    procedure :: node_positions
    procedure :: node_velocities
    procedure :: node_forces
    procedure :: set_node_velocities
    procedure :: hold_nodes
    procedure :: set_node_force
    procedure :: remove_cells
    procedure :: set_body_stress
    procedure :: cells
    procedure :: add_table
    procedure :: add_compound
    procedure :: compound_parts
    procedure :: compound_of_block
    procedure :: set_node_viscosity
    procedure :: add_action
    procedure :: end_actions
    procedure :: add_node_action
    procedure :: end_node_actions
    procedure :: hold_block
    procedure :: prescribe_velocities
    procedure :: detect
    procedure, private :: forces_on_blocks => forces
    generic :: forces => forces_on_blocks
    procedure :: step
    procedure :: report
    procedure :: plan
    procedure :: contacts
    procedure :: set_shear_force
  end type halfspace_world

  ! Bodies of finite elements: halfspace_worlds_meshes.f90. Arrays have the order of the nodes or cells of the mesh,
  ! which are counted from 1.
  interface

    !> Adds a copy of a mesh to the world. Its surface cells become blocks of the kind HS_BLOCK_MESH.
    module subroutine add_mesh(self, mesh, body, material, pose, velocity, cell_materials, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_mesh), intent(in) :: mesh  !< of the world's dimension
      type(halfspace_body), intent(out), optional :: body  !< its id
      integer(c_int32_t), intent(in), optional :: material  !< index of a material with elasticity; default 1
      type(halfspace_pose), intent(in), optional :: pose  !< pose of the frame of the mesh; default: identity
      real(c_double), intent(in), optional :: velocity(:)  !< of all nodes, m/s, 3 values (2D: or 2); default 0
      integer(c_int32_t), intent(in), optional :: cell_materials(:)  !< one index per cell, instead of `material`
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_mesh

    !> Removes a body and its surface blocks from the world; its id becomes stale.
    module subroutine remove_body(self, body, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_body

    !> Returns mass, centroid, momentum and energies of a body.
    module subroutine body_state(self, body, state, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      type(halfspace_body_state), intent(out) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine body_state

    !> Returns the body and cell of a surface block; no body and cell 0 for a block of another kind.
    module subroutine body_of_block(self, block, body, cell, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_body), intent(out) :: body
      integer(c_int32_t), intent(out), optional :: cell  !< index in the mesh
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine body_of_block

    !> Positions of a body's nodes, m.
    module subroutine node_positions(self, body, points, rows, count, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(inout), target :: points(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< number of nodes, also when they do not fit
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_positions

    !> The velocities of a body's nodes, m/s.
    module subroutine node_velocities(self, body, velocities, rows, count, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(inout), target :: velocities(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< likewise
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_velocities

    !> Total forces on a body's nodes at the end of the last step (cells, contacts, gravity, applied), N, in 2D per unit
    !! thickness. In equilibrium they are 0, except at held nodes: there they are the forces that press on the support.
    module subroutine node_forces(self, body, forces, rows, count, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(inout), target :: forces(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< likewise
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_forces

    !> Sets the velocities of all nodes of a body, including held ones.
    module subroutine set_node_velocities(self, body, velocities, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(in), target :: velocities(:,:)  !< m/s, one per node
      logical, intent(in), optional :: rows
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_node_velocities

    !> Prescribes a constant velocity of nodes along axes, in addition to axes held before; or frees the nodes along all
    !! axes.
    module subroutine hold_nodes(self, body, nodes, axes, velocity, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
      integer(c_int32_t), intent(in) :: axes  !< sum of HS_AXIS_ values, or 0: frees the nodes
      !> along the axes held, m/s, 3 values (2D: or 2); default 0
      real(c_double), intent(in), optional :: velocity(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine hold_nodes

    !> Sets the external force on each of these nodes, until set again.
    module subroutine set_node_force(self, body, nodes, force, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
      real(c_double), intent(in) :: force(:)  !< N, in 2D per unit thickness, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_node_force

    !> Removes cells of a body (excavation). Indices of the other cells and nodes do not change.
    module subroutine remove_cells(self, body, cells, released, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: cells(:)  !< of the mesh
      !> receives the force that these cells exerted on each node, N, to be applied by set_node_force() and reduced
      !! gradually
      real(c_double), intent(inout), target, optional :: released(:,:)
      logical, intent(in), optional :: rows
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_cells

    !> Sets the current stress of the cells of a body, linear in space: each cell gets the stress at its center.
    module subroutine set_body_stress(self, body, stress, gradient, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(in) :: stress(3,3)  !< Cauchy stress at the origin, Pa, tension > 0
      real(c_double), intent(in), optional :: gradient(3,3,3)  !< gradient(:,:,k): derivative along axis k, Pa/m
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_body_stress

    !> Strain and stress of a body's cells.
    module subroutine cells(self, body, values, count, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      type(halfspace_cell_state), intent(inout), target, contiguous :: values(:)
      integer(c_int64_t), intent(out), optional :: count  !< number of cells, also when they do not fit
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine cells

  end interface

  ! Concave blocks: halfspace_worlds_compounds.f90.
  interface

    !> Adds a compound of convex parts, which touch or are apart. The world copies the shapes.
    module subroutine add_compound(self, shapes, block, poses, kind, material, pose, velocity, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_shape), intent(in) :: shapes(:)  !< of the parts
      type(halfspace_block), intent(out), optional :: block  !< its id
      type(halfspace_pose), intent(in), optional :: poses(:)  !< of the parts in one frame; default: as their vertices
      integer(c_int32_t), intent(in), optional :: kind  !< HS_BLOCK_RIGID (default), _FIXED or _PRESCRIBED
      integer(c_int32_t), intent(in), optional :: material  !< index from add_material(); default 1
      type(halfspace_pose), intent(in), optional :: pose  !< of the centroid of all parts; default: as the parts
      real(c_double), intent(in), optional :: velocity(:)  !< of that centroid, 3 values (2D: or 2); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_compound

    !> The parts of a compound, in the order in which they were given; none for other blocks.
    module subroutine compound_parts(self, block, parts, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_block), intent(out), allocatable, target :: parts(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine compound_parts

    !> The compound of a part, and the index of the part from 1; 0 for a block that is not a part.
    module subroutine compound_of_block(self, block, compound, part, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_block), intent(out) :: compound
      integer(c_int32_t), intent(out) :: part
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine compound_of_block

  end interface

  ! Motions and loads in time, and held axes: halfspace_worlds_actions.f90. Within a step a load is constant, the mean
  ! of its table, and a prescribed block moves by the integral of its velocity, so both are exact for any time step.
  interface

    !> Adds a table: values at times, linear between them, before the first and after the last time constant.
    module subroutine add_table(self, times, values, table, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      real(c_double), intent(in), target, contiguous :: times(:)  !< s, in ascending order; two equal ones are a jump
      real(c_double), intent(in), target :: values(:,:)  !< one vector per time; without z, z is 0
      integer(c_int32_t), intent(out) :: table  !< its index, from 1
      logical, intent(in), optional :: rows  !< layout of `values`
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_table

    !> Sets the viscosity of nodes of a body: a dashpot connects each with the ground. 0 removes the dashpots.
    module subroutine set_node_viscosity(self, body, nodes, viscosity, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< from 1
      real(c_double), intent(in) :: viscosity(3,3)  !< of each node, symmetric, N s/m
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_node_viscosity

    !> Adds an action on a block, or without `block` on all blocks that move freely. Loads of one block add up; a motion
    !! ends the earlier ones along its axes.
    module subroutine add_action(self, kind, table, block, scale, at, place, start, max_speed, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      !> an HS_ACTION_ value: a motion of a prescribed block or along held axes, a load on a rigid or affine block, or
      !! HS_ACTION_SERVO; without `block` only HS_ACTION_ACCELERATION
      integer(c_int32_t), intent(in) :: kind
      integer(c_int32_t), intent(in) :: table  !< index from add_table()
      type(halfspace_block), intent(in), optional :: block
      !> factor of each component, 3 values (2D: or 2, z is 0 then); default 1. A motion does not change components of
      !! scale 0; a servo presses along the scale as a vector
      real(c_double), intent(in), optional :: scale(:)
      real(c_double), intent(in), optional :: at(:)  !< place of a force, m, 3 values (2D: or 2); default: the centroid
      !> HS_PLACE_CARRIED (default): the place moves with the block; or HS_PLACE_FIXED
      integer(c_int32_t), intent(in), optional :: place
      real(c_double), intent(in), optional :: start  !< time of the world at time 0 of the table, s; default 0
      real(c_double), intent(in), optional :: max_speed  !< of a servo, m/s, > 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_action

    !> Ends all actions on a block, or without `block` those on all blocks. A prescribed block keeps its last velocity.
    module subroutine end_actions(self, block, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_block), intent(in), optional :: block
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine end_actions

    !> Adds an action on nodes of a body, e.g. a traction: each node with a share of the area as scale.
    module subroutine add_node_action(self, body, nodes, kind, table, scales, rows, start, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
      !> HS_ACTION_FORCE, or along axes held by hold_nodes() HS_ACTION_VELOCITY or HS_ACTION_ACCELERATION
      integer(c_int32_t), intent(in) :: kind
      integer(c_int32_t), intent(in) :: table  !< index from add_table()
      real(c_double), intent(in), target :: scales(:,:)  !< factor of each component, one vector per node
      logical, intent(in), optional :: rows  !< layout of `scales`
      real(c_double), intent(in), optional :: start  !< as above
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_node_action

    !> Ends all actions on the nodes of a body. Held nodes keep their last velocity.
    module subroutine end_node_actions(self, body, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine end_node_actions

    !> Holds axes of a rigid block: the velocity along them stays, whatever the forces. Its contacts of laws without
    !! springs are points, without restitution.
    module subroutine hold_block(self, block, axes, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      !> sum of HS_AXIS_ values, with HS_AXIS_ROTATION it does not rotate; or 0: frees the block
      integer(c_int32_t), intent(in) :: axes
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine hold_block

    !> Sets the velocities of prescribed blocks between steps. Contacts and forces are kept, so it may be called at each
    !! step. Without `angular`, angular velocities stay.
    module subroutine prescribe_velocities(self, blocks, linear, angular, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_block), intent(in), target, contiguous :: blocks(:)
      real(c_double), intent(in), target :: linear(:,:)  !< of the centroids, m/s, one vector per block
      real(c_double), intent(in), target, optional :: angular(:,:)  !< rad/s
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine prescribe_velocities

  end interface

  ! Stages, steps and their results: halfspace_worlds_stages.f90.
  interface

    !> Stage: neighbour search and detection at the current poses.
    module subroutine detect(self, touching, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      integer(c_int64_t), intent(out), target, optional :: touching  !< number of pairs in contact
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine detect

    !> Stage: contact forces at the current poses and velocities, after detect().
    module subroutine forces(self, elapsed, force, torque, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      !> time since the last call, s, >= 0: shear springs extend by velocity times this
      real(c_double), intent(in) :: elapsed
      real(c_double), intent(inout), target :: force(:,:)  !< on each block, N
      real(c_double), intent(inout), target, optional :: torque(:,:)  !< about each centroid, N m
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine forces

    !> Steps the world. After an error it keeps the last valid state, and can be read or saved.
    module subroutine step(self, steps, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      integer, intent(in), optional :: steps  !< >= 0; default 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine step

    !> Returns time, time step, counts and energies. After a change of the world it detects contacts and evaluates
    !! forces first.
    module subroutine report(self, values, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_world_report), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine report

    !> Returns the active parts of the world, the limit of its step, and times of `steps` steps of a copy. Blocks are
    !! ids as in halfspace_block; friction is active if iand(values%parts, HS_PART_FRICTION) > 0.
    module subroutine plan(self, values, steps, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_world_plan), intent(out) :: values
      integer, intent(in), optional :: steps  !< >= 0; default 0: no times are measured
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine plan

    !> Contacts of the last detection, sorted by block, a before b; none after a change of poses, blocks or laws. `list`
    !! is reallocated only if their number has changed.
    module subroutine contacts(self, list, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_contact), intent(inout), allocatable, target :: list(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine contacts

    !> Preloads the shear spring of a contact, e.g. to start from equilibrium. Call it after detect() or step().
    module subroutine set_shear_force(self, block_a, block_b, shear_force, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block_a, block_b
      !> on block_b, N, 3 values (2D: or 2); only the component in the contact plane is used
      real(c_double), intent(in) :: shear_force(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_shear_force

  end interface

end module halfspace_worlds
