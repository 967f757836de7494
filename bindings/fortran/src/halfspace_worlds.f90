!> A world: blocks, materials, laws, and time. Used whole (step) or stage by stage (detect, forces), by hosts
!! that integrate themselves.
!!
!! Bulk arrays have one entry per block, in the order of blocks(). Points and vectors are columns, x(2,n) or
!! x(3,n); with rows = .true. they are rows, x(n,2) or x(n,3). Sections of arrays are read and written where they
!! are. Angular velocities and torques have three components, in the plane of which z alone counts.
module halfspace_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c, halfspace_energy => hs_energy, halfspace_world_plan => hs_world_plan, &
    halfspace_world_report => hs_world_report
  use halfspace_block_worlds, only: halfspace_block_state
  use halfspace_bodies, only: halfspace_body, halfspace_body_state, halfspace_cell_state
  use halfspace_bonded_worlds, only: bonded_world
  use halfspace_contacts, only: halfspace_block, halfspace_contact
  use halfspace_definitions, only: halfspace_pose
  use halfspace_meshes, only: halfspace_mesh
  implicit none
  private
  public :: halfspace_block_state, halfspace_energy, halfspace_world, halfspace_world_plan, halfspace_world_report

  !> Assignment shares: all copies are the same world, which ends with the last of them. To have a second one,
  !! restore() what save() gave. What concerns single blocks is declared in halfspace_block_worlds, bonds and rest in
  !! halfspace_bonded_worlds.
  type, extends(bonded_world) :: halfspace_world
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
    procedure :: detect
    procedure :: forces
    procedure :: step
    procedure :: report
    procedure :: plan
    procedure :: contacts
    procedure :: set_shear_force
  end type halfspace_world

  ! Bodies of finite elements: halfspace_worlds_meshes.f90. Arrays are in the order of the mesh's nodes or cells, which
  ! are counted from 1.
  interface

    !> Puts a mesh into the world. The cells at its surface become blocks of the kind HS_BLOCK_MESH.
    module subroutine add_mesh(self, mesh, body, material, pose, velocity, cell_materials, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_mesh), intent(in) :: mesh  !< of the world's dimension
      type(halfspace_body), intent(out), optional :: body  !< its name
      integer(c_int32_t), intent(in), optional :: material  !< made elastic by set_elasticity(); default 1, the first
      type(halfspace_pose), intent(in), optional :: pose  !< of the nodes' frame; default: where they were given
      real(c_double), intent(in), optional :: velocity(:)  !< of all nodes, m/s, 3 values (2D: or 2); default 0
      integer(c_int32_t), intent(in), optional :: cell_materials(:)  !< one for each cell, instead of `material`
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_mesh

    !> Takes a body out of the world, with the blocks at its surface; its name becomes stale.
    module subroutine remove_body(self, body, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_body

    !> A body's motion: its mass, centroid, momentum and energies.
    module subroutine body_state(self, body, state, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      type(halfspace_body_state), intent(out) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine body_state

    !> The body that a block is at the surface of. A block of another kind gives no body, and cell 0.
    module subroutine body_of_block(self, block, body, cell, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_body), intent(out) :: body
      integer(c_int32_t), intent(out), optional :: cell  !< of the body's mesh
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine body_of_block

    !> The places of a body's nodes, m.
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

    !> All forces on a body's nodes at the end of the last step, N, in 2D per unit thickness: of cells, contacts,
    !! gravity, and applied ones. At rest they are 0, but at nodes that are held: there they are what these press on
    !! their support.
    module subroutine node_forces(self, body, forces, rows, count, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(inout), target :: forces(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< likewise
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_forces

    !> Sets the velocities of all nodes of a body, also of those that are held.
    module subroutine set_node_velocities(self, body, velocities, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(in), target :: velocities(:,:)  !< m/s, one for each node
      logical, intent(in), optional :: rows
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_node_velocities

    !> Holds nodes along axes: there they go on with a velocity that stays, whatever the forces. Along other axes they
    !! are free from now on.
    module subroutine hold_nodes(self, body, nodes, axes, velocity, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
      integer(c_int32_t), intent(in) :: axes  !< a sum of HS_AXIS_ values, or 0: free
      !> along the axes held, m/s, 3 values (2D: or 2); default 0
      real(c_double), intent(in), optional :: velocity(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine hold_nodes

    !> Sets the force that acts on each of these nodes from outside, from now on.
    module subroutine set_node_force(self, body, nodes, force, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
      real(c_double), intent(in) :: force(:)  !< N, in 2D per unit thickness, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_node_force

    !> Takes cells out of a body: excavation. Cells and nodes that stay keep their numbers.
    module subroutine remove_cells(self, body, cells, released, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      integer(c_int32_t), intent(in) :: cells(:)  !< of the mesh
      !> receives the force that these cells exerted on each node, which set_node_force can fade out
      real(c_double), intent(inout), target, optional :: released(:,:)
      logical, intent(in), optional :: rows
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_cells

    !> Stresses the cells of a body as they are now, each by the stress at its middle.
    module subroutine set_body_stress(self, body, stress, gradient, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_body), intent(in) :: body
      real(c_double), intent(in) :: stress(3,3)  !< Cauchy's at the origin, Pa, tension > 0
      real(c_double), intent(in), optional :: gradient(3,3,3)  !< along axis k: gradient(:,:,k), Pa/m
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

  ! Stages, steps and what they give: halfspace_worlds_stages.f90.
  interface

    !> Stage: neighbour search and detection at the present poses.
    module subroutine detect(self, touching, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      integer(c_int64_t), intent(out), target, optional :: touching  !< number of pairs in contact
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine detect

    !> Stage: contact forces at the present poses and velocities, after detect().
    module subroutine forces(self, elapsed, force, torque, rows, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      !> time since the last call, >= 0: shear springs grow by velocity times this
      real(c_double), intent(in) :: elapsed
      real(c_double), intent(inout), target :: force(:,:)  !< on each block
      real(c_double), intent(inout), target, optional :: torque(:,:)  !< about each centroid
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine forces

    !> Steps the world. After HS_ERROR_UNSTABLE it stays at the last good step, and can be read or saved.
    module subroutine step(self, steps, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      integer, intent(in), optional :: steps  !< >= 0; default 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine step

    !> Time, time step, counts, energies. After a change of the world it detects and evaluates forces first.
    module subroutine report(self, values, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_world_report), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine report

    !> The parts that the world computes, the limit of its step, and the times of so many steps of a copy. Blocks are
    !! numbers as halfspace_block has them; iand(values%parts, HS_PART_FRICTION) > 0 tells that friction is active.
    module subroutine plan(self, values, steps, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_world_plan), intent(out) :: values
      integer, intent(in), optional :: steps  !< >= 0; default 0: no times are measured
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine plan

    !> The contacts of the last detection, sorted by block, a before b; none after a change of poses, blocks or
    !! laws. Memory is allocated only when their number has changed.
    module subroutine contacts(self, list, stat, errmsg)
      class(halfspace_world), intent(in) :: self
      type(halfspace_contact), intent(inout), allocatable, target :: list(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine contacts

    !> Preloads the shear spring of a contact, for example to start from equilibrium. After detect() or step().
    module subroutine set_shear_force(self, block_a, block_b, shear_force, stat, errmsg)
      class(halfspace_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block_a, block_b
      !> on block_b, 3 values (2D: or 2); what lies in the contact plane counts
      real(c_double), intent(in) :: shear_force(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_shear_force

  end interface

end module halfspace_worlds
