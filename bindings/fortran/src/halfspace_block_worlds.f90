!> Blocks of a world: materials, laws, poses, velocities, deformation.
module halfspace_block_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr, &
    c_size_t, c_sizeof
  use halfspace_c, halfspace_block_state => hs_block_state
  use halfspace_contacts, only: halfspace_block
  use halfspace_contexts, only: halfspace_context
  use halfspace_definitions, only: halfspace_pose
  use halfspace_properties, only: halfspace_elasticity, halfspace_law
  use halfspace_deformations, only: halfspace_deformation
  use halfspace_handles, only: shared_handle
  use halfspace_shapes, only: halfspace_shape
  implicit none
  private
  public :: block_world, halfspace_block_state, row_length_of, takes_world

  !> The owner of the world; bonded_world extends it, and halfspace_world extends that.
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
    procedure :: block_states
    procedure :: block_vertices
    procedure :: set_pose
    procedure :: set_velocity
    procedure :: set_applied_force
    procedure :: set_applied_forces
    procedure, private :: poses_of_blocks => poses
    procedure, private :: set_poses_of_blocks => set_poses
    procedure, private :: velocities_of_blocks => velocities
    procedure, private :: set_velocities_of_blocks => set_velocities
    generic :: poses => poses_of_blocks
    generic :: set_poses => set_poses_of_blocks
    generic :: velocities => velocities_of_blocks
    generic :: set_velocities => set_velocities_of_blocks
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

  ! Creation of worlds, materials, laws and blocks: halfspace_worlds_make.f90.
  interface

    !> Creates an empty world; the previous reference is dropped. Missing arguments have the defaults of the library.
    module subroutine create(self, dimension, gravity, time_step, safety, local_damping, mass_damping, skin, &
                             parallel_angle, vertex_zone, potential_length, fast_blocks, sleep_tolerance, context, &
                             stat, errmsg, impulse_tolerance, max_impulse_iterations, locate_impacts)
      class(block_world), intent(inout) :: self
      integer, intent(in), optional :: dimension  !< 2 (default) or 3
      real(c_double), intent(in), optional :: gravity(:)  !< m/s2, 3 values (2D: or 2); default 9.81 along -y, in 3D -z
      real(c_double), intent(in), optional :: time_step  !< s, > 0; default: safety times the stable time step
      real(c_double), intent(in), optional :: safety  !< factor of the stable time step, (0, 1]; default 0.5
      real(c_double), intent(in), optional :: local_damping  !< ratio of damping to unbalanced force, [0, 1); default 0
      real(c_double), intent(in), optional :: mass_damping  !< 1/s, >= 0; default 0
      !> skin of the neighbour list over a block's size, (0, 1]; default 0.1
      real(c_double), intent(in), optional :: skin
      real(c_double), intent(in), optional :: parallel_angle  !< rad, [0, 0.5]; default 0.01
      real(c_double), intent(in), optional :: vertex_zone  !< [0, 0.5]; default 1e-6
      !> length H of HS_STIFFNESS_POTENTIAL, m, > 0; default: mean length of all edges
      real(c_double), intent(in), optional :: potential_length
      integer(c_int32_t), intent(in), optional :: fast_blocks  !< HS_FAST_DIVIDE (default) or HS_FAST_REFUSE
      !> max displacement error of a block by sleep over a run, m, >= 0; default 0: no block sleeps
      real(c_double), intent(in), optional :: sleep_tolerance
      type(halfspace_context), intent(in), optional :: context
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      !> velocity that impulses of rigid blocks without springs may leave unbalanced, over gravity times step; 1e-6
      real(c_double), intent(in), optional :: impulse_tolerance
      !> max sweeps of their solver per half step where blocks move past each other, >= 1; default 200
      integer, intent(in), optional :: max_impulse_iterations
      logical, intent(in), optional :: locate_impacts  !< divide steps at their impacts; default false
    end subroutine create

    !> Adds a material.
    module subroutine add_material(self, density, material, stat, errmsg)
      class(block_world), intent(inout) :: self
      real(c_double), intent(in) :: density  !< > 0
      integer(c_int32_t), intent(out) :: material  !< its index, from 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_material

    !> Sets the law of all pairs of materials without a law of their own.
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
      type(halfspace_block), intent(out), optional :: block  !< its id
      integer(c_int32_t), intent(in), optional :: kind  !< HS_BLOCK_RIGID (default), _FIXED, _PRESCRIBED or _AFFINE
      integer(c_int32_t), intent(in), optional :: material  !< index from add_material(); default 1
      type(halfspace_pose), intent(in), optional :: pose  !< default: the coordinates of the shape's vertices
      real(c_double), intent(in), optional :: velocity(:)  !< of the centroid, 3 values (2D: or 2); default 0
      real(c_double), intent(in), optional :: angular_velocity(:)  !< rad/s, 3 values (2D: or 1, about z); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_block

    !> Removes a block; its id becomes stale. The cost is proportional to the size of the world.
    module subroutine remove_block(self, block, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_block

    !> Creates a world from a snapshot, with the same ids, materials and laws. It continues bit for bit.
    module subroutine restore(self, bytes, context, stat, errmsg)
      class(block_world), intent(inout) :: self
      integer(c_int8_t), intent(in), target, contiguous :: bytes(:)  !< from save()
      type(halfspace_context), intent(in), optional :: context
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine restore

    !> Saves a snapshot of the complete state.
    module subroutine save_state(self, bytes, stat, errmsg)
      class(block_world), intent(in) :: self
      integer(c_int8_t), intent(inout), allocatable, target :: bytes(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine save_state

    !> Drops this reference before the end of its scope.
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

    !> The C context, for the text of the last error; the object stays the owner.
    module function c_context(self)
      class(block_world), intent(in) :: self
      type(c_ptr) :: c_context
    end function c_context

    impure elemental module subroutine share(self, other)
      class(block_world), intent(inout) :: self
      class(block_world), intent(in) :: other
    end subroutine share

    !> Becomes the owner of a C world that was made in the context of `origin`, or no world if `object` is NULL. Without
    !! memory for the reference count, the C world is destroyed and self does not change.
    module function takes_world(self, object, origin, stat, errmsg) result(takes)
      class(block_world), intent(inout) :: self
      type(c_ptr), intent(in) :: object
      class(block_world), intent(in) :: origin
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      logical :: takes
    end function takes_world

    !> Numbers per block of the loads of a share, which are found once; 0 without a world.
    module function row_length_of(self) result(length)
      class(block_world), intent(in) :: self
      integer :: length
    end function row_length_of

  end interface

  ! Poses and velocities of blocks: halfspace_worlds_motion.f90.
  interface

    !> Ids of all blocks. All arrays of blocks have this order.
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

    !> Returns the motion of a block.
    module subroutine block_state(self, block, state, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_block_state), intent(out) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine block_state

    !> Returns the motion of all blocks.
    module subroutine block_states(self, states, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block_state), intent(inout), target, contiguous :: states(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine block_states

    !> Returns the current positions of a block's vertices, m, in 2D counter-clockwise.
    module subroutine block_vertices(self, block, points, rows, count, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(inout), target :: points(:,:)
      logical, intent(in), optional :: rows
      integer(c_int64_t), intent(out), target, optional :: count  !< number of vertices, also when they do not fit
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine block_vertices

    !> Sets the pose of a block.
    module subroutine set_pose(self, block, pose, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_pose), intent(in) :: pose
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_pose

    !> Sets the velocity of a block; fixed blocks are refused.
    module subroutine set_velocity(self, block, velocity, angular_velocity, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: velocity(:)  !< of the centroid, 3 values (2D: or 2)
      real(c_double), intent(in), optional :: angular_velocity(:)  !< rad/s, 3 values (2D: or 1, about z); default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_velocity

    !> Sets the external force and torque on a rigid or affine block, until set again.
    module subroutine set_applied_force(self, block, force, torque, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: force(:)  !< at the centroid, N, 3 values (2D: or 2)
      real(c_double), intent(in), optional :: torque(:)  !< about the centroid, N m, 3 values (2D: or 1, z); default 0
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

    !> Sets the poses of all blocks; after an error no block has moved.
    module subroutine set_poses(self, values, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_pose), intent(in), target, contiguous :: values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_poses

    !> Velocities, m/s, and angular velocities, rad/s, of all blocks.
    module subroutine velocities(self, linear, angular, rows, stat, errmsg)
      class(block_world), intent(in) :: self
      real(c_double), intent(inout), target :: linear(:,:)
      real(c_double), intent(inout), target, optional :: angular(:,:)
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine velocities

    !> Sets the velocities of all blocks; entries of fixed blocks are ignored. Without `angular`, angular velocities
    !! stay.
    module subroutine set_velocities(self, linear, angular, rows, stat, errmsg)
      class(block_world), intent(inout) :: self
      real(c_double), intent(in), target :: linear(:,:)
      real(c_double), intent(in), target, optional :: angular(:,:)
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_velocities

    !> Sets the external forces and torques on all rigid and affine blocks, until set again; entries of other blocks are
    !! ignored. Without `torque` the torques are 0.
    module subroutine set_applied_forces(self, force, torque, rows, stat, errmsg)
      class(block_world), intent(inout) :: self
      real(c_double), intent(in), target :: force(:,:)  !< at the centroids, N
      real(c_double), intent(in), target, optional :: torque(:,:)  !< about the centroids, N m; 3 values per block
      logical, intent(in), optional :: rows  !< layout of both
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_applied_forces

  end interface

  ! Deformation of blocks: halfspace_worlds_affine.f90.
  interface

    !> Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep their strain.
    module subroutine set_elasticity(self, material, elasticity, stat, errmsg)
      class(block_world), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      type(halfspace_elasticity), intent(in) :: elasticity
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_elasticity

    !> Returns deformation and stress of a block of any kind.
    module subroutine deformation(self, block, values, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_block), intent(in) :: block
      type(halfspace_deformation), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine deformation

    !> Deformation and stress of all blocks.
    module subroutine deformations(self, values, stat, errmsg)
      class(block_world), intent(in) :: self
      type(halfspace_deformation), intent(inout), target, contiguous :: values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine deformations

    !> Sets the deformation gradient of an affine block and its rate. Centroid and velocity do not change.
    module subroutine set_deformation(self, block, gradient, rate, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      real(c_double), intent(in) :: gradient(:,:)  !< (row, column), 3 x 3 (2D: or 2 x 2), determinant > 0
      real(c_double), intent(in), optional :: rate(:,:)  !< rate of the gradient, 1/s, of the same shape; default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_deformation

    !> Sets the current stress of an affine block, e.g. the in situ stress. Later strain adds to it.
    module subroutine set_stress(self, block, stress, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      !> Cauchy stress, (row, column), 3 x 3 (2D: or 2 x 2), symmetric, Pa, tension > 0
      real(c_double), intent(in) :: stress(:,:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_stress

    !> Adds a permanent load on a face of an affine block. Its direction does not change as the block moves, nor its
    !! magnitude as the face is strained.
    module subroutine add_surface_load(self, block, face, traction, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer(c_int32_t), intent(in) :: face  !< index from 1; in 2D of the edge that starts at that vertex
      real(c_double), intent(in) :: traction(:)  !< force per area of the face as it was given, Pa, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_surface_load

    !> Removes all surface loads of an affine block.
    module subroutine clear_surface_loads(self, block, stat, errmsg)
      class(block_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine clear_surface_loads

  end interface

end module halfspace_block_worlds
