!> The blocks of a world: what they are made of, where they are, and how they move and strain.
module halfspace_block_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr, &
    c_size_t, c_sizeof
  use halfspace_c, halfspace_block_state => hs_block_state
  use halfspace_contacts, only: halfspace_block
  use halfspace_contexts, only: halfspace_context
  use halfspace_definitions, only: halfspace_elasticity, halfspace_law, halfspace_pose
  use halfspace_deformations, only: halfspace_deformation
  use halfspace_handles, only: shared_handle
  use halfspace_shapes, only: halfspace_shape
  implicit none
  private
  public :: block_world, halfspace_block_state, takes_world

  !> The owner of the world, which bonded_world extends, and that halfspace_world.
  type :: block_world
    private
    type(shared_handle) :: handle
  contains
    procedure :: create
    procedure :: restore
    procedure :: save => save_state
    procedure :: destroy
    procedure :: exists
    procedure :: add_material
    procedure, private :: set_default_law
    procedure, private :: set_law_between
    generic :: set_law => set_default_law, set_law_between
    procedure :: add_block
    procedure :: remove_block
    procedure :: blocks
    procedure :: block_count
    procedure :: block_state
    procedure :: block_vertices
    procedure :: set_pose
    procedure :: set_velocity
    procedure :: set_applied_force
    procedure :: poses
    procedure :: set_poses
    procedure :: velocities
    procedure :: set_velocities
    procedure :: set_elasticity
    procedure :: deformation
    procedure :: deformations
    procedure :: set_deformation
    procedure :: set_stress
    procedure :: add_surface_load
    procedure :: clear_surface_loads
    procedure :: c_handle
    procedure :: c_context
    procedure, private :: share
    generic :: assignment(=) => share
  end type block_world

  ! The parts of a world: halfspace_worlds_make.f90.
  interface

    !> Makes an empty world; what it was before is dropped. What is not given is the library's default.
    module subroutine create(self, dimension, gravity, time_step, safety, local_damping, mass_damping, skin, &
                             parallel_angle, vertex_zone, potential_length, fast_blocks, sleep_tolerance, context, &
                             stat, errmsg)
      class(block_world), intent(inout) :: self
      integer, intent(in), optional :: dimension  !< 2 (default) or 3
      real(c_double), intent(in), optional :: gravity(:)  !< acceleration; default 9.81 downwards: -y, in 3D -z
      real(c_double), intent(in), optional :: time_step  !< > 0; default: safety times the stable time step
      real(c_double), intent(in), optional :: safety  !< (0, 1]; default 0.5
      real(c_double), intent(in), optional :: local_damping  !< [0, 1): share of the force
      real(c_double), intent(in), optional :: mass_damping  !< 1/s, >= 0
      real(c_double), intent(in), optional :: skin  !< reach of the neighbour list, share of a block's size; default 0.1
      real(c_double), intent(in), optional :: parallel_angle  !< rad, [0, 0.5]; default 0.01
      real(c_double), intent(in), optional :: vertex_zone  !< [0, 0.5]; default 1e-6
      !> H of HS_STIFFNESS_POTENTIAL, > 0; default: all edges' mean
      real(c_double), intent(in), optional :: potential_length
      integer(c_int32_t), intent(in), optional :: fast_blocks  !< HS_FAST_DIVIDE (default) or HS_FAST_REFUSE
      !> m, >= 0: of its way that a block may miss over a run by sleep; default 0: none sleeps
      real(c_double), intent(in), optional :: sleep_tolerance
      type(halfspace_context), intent(in), optional :: context
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine create

    !> Adds a material of some density.
    module subroutine add_material(self, density, material, stat, errmsg)
      class(block_world), intent(inout) :: self
      real(c_double), intent(in) :: density  !< > 0
      integer(c_int32_t), intent(out) :: material  !< its index, counted from 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_material

    !> Sets the law of all pairs of materials that have none of their own.
    module subroutine set_default_law(self, law, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_law), intent(in) :: law
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_default_law

    !> Sets the law between two materials, in either order.
    module subroutine set_law_between(self, law, material_a, material_b, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_law), intent(in) :: law
      integer(c_int32_t), intent(in) :: material_a, material_b
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_law_between

    !> Adds a block. The world copies the shape.
    module subroutine add_block(self, shape, block, kind, material, pose, velocity, angular_velocity, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_shape), intent(in) :: shape
      type(halfspace_block), intent(out), optional :: block  !< its name
      integer(c_int32_t), intent(in), optional :: kind  !< HS_BLOCK_RIGID (default), _FIXED, _PRESCRIBED or _AFFINE
      integer(c_int32_t), intent(in), optional :: material  !< from add_material(); default 1, the first
      type(halfspace_pose), intent(in), optional :: pose  !< default: where the shape's vertices were given
      real(c_double), intent(in), optional :: velocity(:)  !< of the centroid, 3 values (2D: or 2); default 0
      real(c_double), intent(in), optional :: angular_velocity(:)  !< rad/s, 3 values (2D: or 1, about z); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_block

    !> Removes a block; its name becomes stale. The cost grows with the size of the world.
    module subroutine remove_block(self, block, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_block

    !> Makes a world from saved bytes, with its blocks, their names, materials and laws. It goes on bit for bit.
    module subroutine restore(self, bytes, context, stat, errmsg)
      class(block_world), intent(inout) :: self
      integer(c_int8_t), intent(in), target, contiguous :: bytes(:)  !< from save()
      type(halfspace_context), intent(in), optional :: context
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine restore

    !> Saves the whole state of motion and contact.
    module subroutine save_state(self, bytes, stat, errmsg)
      class(block_world), intent(in) :: self
      integer(c_int8_t), intent(inout), allocatable, target :: bytes(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine save_state

    !> Gives up this reference now instead of at the end of the scope.
    impure elemental module subroutine destroy(self)
      class(block_world), intent(inout) :: self
    end subroutine destroy

    !> Is there a world?
    elemental module function exists(self)
      class(block_world), intent(in) :: self
      logical :: exists
    end function exists

    !> The handle, for calls of halfspace_c; the object stays the owner.
    module function c_handle(self)
      class(block_world), intent(in) :: self
      type(c_ptr) :: c_handle
    end function c_handle

    !> The C context that has the text of the last error, likewise.
    module function c_context(self)
      class(block_world), intent(in) :: self
      type(c_ptr) :: c_context
    end function c_context

    impure elemental module subroutine share(self, other)
      class(block_world), intent(inout) :: self
      class(block_world), intent(in) :: other
    end subroutine share

    !> Becomes the owner of a world of C that was made in the context of another one, or no world if it is NULL. Without
    !! memory to keep account of it, that is ended, and self stays what it was.
    module function takes_world(self, object, origin, stat, errmsg) result(takes)
      class(block_world), intent(inout) :: self
      type(c_ptr), intent(in) :: object
      class(block_world), intent(in) :: origin
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      logical :: takes
    end function takes_world

  end interface

  ! Where the blocks are and how they move: halfspace_worlds_motion.f90.
  interface

    !> The names of all blocks.
    module subroutine blocks(self, names, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(inout), allocatable, target :: names(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine blocks

    !> Number of living blocks; 0 if there is no world.
    module function block_count(self) result(count)
      class(block_world), intent(in) :: self
      integer(c_int64_t) :: count
    end function block_count

    !> One block's motion; its material is counted from 1.
    module subroutine block_state(self, block, state, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_block_state), intent(out) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine block_state

    !> One block's vertices where they are now, in 2D counter-clockwise.
    module subroutine block_vertices(self, block, points, rows, count, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(inout), target :: points(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< number of vertices, also when they do not fit
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine block_vertices

    !> Puts a block elsewhere.
    module subroutine set_pose(self, block, pose, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_pose), intent(in) :: pose
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_pose

    !> Sets a block's velocity; a fixed block takes none.
    module subroutine set_velocity(self, block, velocity, angular_velocity, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: velocity(:)  !< of the centroid, 3 values (2D: or 2)
      real(c_double), intent(in), optional :: angular_velocity(:)  !< rad/s, 3 values (2D: or 1, about z); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_velocity

    !> Sets the force and torque that act on a rigid or affine block from outside until set again.
    module subroutine set_applied_force(self, block, force, torque, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: force(:)  !< at the centroid, 3 values (2D: or 2)
      real(c_double), intent(in), optional :: torque(:)  !< about the centroid, 3 values (2D: or 1, about z); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_applied_force

    !> Poses of all blocks.
    module subroutine poses(self, values, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_pose), intent(inout), target, contiguous :: values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine poses

    !> Sets the poses of all blocks; after an error, none has moved.
    module subroutine set_poses(self, values, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_pose), intent(in), target, contiguous :: values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_poses

    !> Velocities of all blocks.
    module subroutine velocities(self, linear, angular, rows, stat, errmsg)
      class(block_world), intent(in) :: self
      real(c_double), intent(inout), target :: linear(:,:)
      real(c_double), intent(inout), target, optional :: angular(:,:)
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine velocities

    !> Sets the velocities of all blocks; entries of fixed blocks are ignored. Without `angular`, spins stay.
    module subroutine set_velocities(self, linear, angular, rows, stat, errmsg)
      class(block_world), intent(inout) :: self
      real(c_double), intent(in), target :: linear(:,:)
      real(c_double), intent(in), target, optional :: angular(:,:)
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_velocities

  end interface

  ! The strains of blocks: halfspace_worlds_affine.f90.
  interface

    !> Makes a material elastic, for affine blocks and meshes; others do not read it. Blocks that have it keep their
    !! strain.
    module subroutine set_elasticity(self, material, elasticity, stat, errmsg)
      class(block_world), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      type(halfspace_elasticity), intent(in) :: elasticity
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_elasticity

    !> The turn and strain of a block of any kind.
    module subroutine deformation(self, block, values, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_deformation), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine deformation

    !> The turns and strains of all blocks.
    module subroutine deformations(self, values, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_deformation), intent(inout), target, contiguous :: values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine deformations

    !> Turns and strains an affine block, and sets how fast it goes on. Its centroid and velocity stay.
    module subroutine set_deformation(self, block, gradient, rate, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: gradient(:,:)  !< (row, column), 3 of each (2D: or 2); its determinant is > 0
      real(c_double), intent(in), optional :: rate(:,:)  !< of the gradient, 1/s, likewise; default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_deformation

    !> Says how an affine block is stressed now, e.g. in situ. What it is strained by from now on adds to that.
    module subroutine set_stress(self, block, stress, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      !> Cauchy's, (row, column), 3 of each (2D: or 2), symmetric, Pa, tension > 0
      real(c_double), intent(in) :: stress(:,:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_stress

    !> Adds a load on a face of an affine block. It keeps its direction, and its size as the face is strained.
    module subroutine add_surface_load(self, block, face, traction, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer(c_int32_t), intent(in) :: face  !< counted from 1; in 2D the edge that starts at the vertex of that number
      real(c_double), intent(in) :: traction(:)  !< force per area of the face as it was given, Pa, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_surface_load

    !> Takes all surface loads off an affine block.
    module subroutine clear_surface_loads(self, block, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine clear_surface_loads

  end interface

end module halfspace_block_worlds
