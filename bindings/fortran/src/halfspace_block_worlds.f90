!> Worlds: creation, snapshots, blocks, and ownership.
module halfspace_block_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr, &
    c_size_t, c_sizeof
  use halfspace_blocks, only: halfspace_block
  use halfspace_c
  use halfspace_contexts, only: halfspace_context, own_or_given
  use halfspace_definitions, only: halfspace_pose
  use halfspace_errors, only: conclude, had_memory
  use halfspace_handles, only: shared_handle
  use halfspace_properties, only: halfspace_elasticity
  use halfspace_shapes, only: halfspace_shape
  use halfspace_views, only: is_vector, three_of
  implicit none
  private
  public :: block_world, row_length_of, takes_world

  !> The owner of the world; forwarding_world extends it, and halfspace_world extends that.
  type :: block_world
    private
    type(shared_handle) :: handle
  contains
    procedure :: create
    procedure :: restore
    procedure :: save => save_state
    procedure :: destroy
    procedure :: exists
    procedure :: add_block
    procedure :: block_count
    procedure :: set_elasticity
    procedure :: c_handle
    procedure :: c_context
    procedure, private :: share
    generic :: assignment(=) => share
  end type block_world

contains

  !> Creates an empty world; the previous reference is dropped. Missing arguments have the defaults of the library.
  subroutine create(self, dimension, gravity, time_step, safety, local_damping, mass_damping, skin, &
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
    type(hs_world_def) :: def
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    if (present(gravity)) then
      if (.not. is_vector(gravity, 'gravity', 2, stat, errmsg)) return
    end if
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_world_def_init(def, c_sizeof(def), 2_c_int32_t)
    if (present(dimension)) then
      if (dimension == 3) status = hs_world_def_init(def, c_sizeof(def), 3_c_int32_t)
      def%dimension = dimension  ! values other than 2 or 3 are refused below, with an error text
    end if
    if (present(gravity)) def%gravity = three_of(gravity)
    if (present(time_step)) def%time_step = time_step
    if (present(safety)) def%safety = safety
    if (present(local_damping)) def%local_damping = local_damping
    if (present(mass_damping)) def%mass_damping = mass_damping
    if (present(skin)) def%skin = skin
    if (present(parallel_angle)) def%parallel_angle = parallel_angle
    if (present(vertex_zone)) def%vertex_zone = vertex_zone
    if (present(potential_length)) def%potential_length = potential_length
    if (present(fast_blocks)) def%fast_blocks = fast_blocks
    if (present(sleep_tolerance)) def%sleep_tolerance = sleep_tolerance
    if (present(impulse_tolerance)) def%impulse_tolerance = impulse_tolerance
    if (present(max_impulse_iterations)) def%max_impulse_iterations = int(max_impulse_iterations, c_int32_t)
    if (present(locate_impacts)) def%locate_impacts = merge(1_c_int32_t, 0_c_int32_t, locate_impacts)
    status = hs_world_create(owner%object(), def, object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_world_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create

  !> Creates a world from a snapshot, with the same ids, materials and laws. It continues bit for bit.
  subroutine restore(self, bytes, context, stat, errmsg)
    class(block_world), intent(inout) :: self
    integer(c_int8_t), intent(in), target, contiguous :: bytes(:)  !< from save()
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_world_restore(owner%object(), c_loc(bytes), size(bytes, kind=c_size_t), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_world_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine restore

  !> Saves a snapshot of the complete state.
  subroutine save_state(self, bytes, stat, errmsg)
    class(block_world), intent(in) :: self
    integer(c_int8_t), intent(inout), allocatable, target :: bytes(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_size_t) :: needed, written
    integer(c_int8_t), allocatable, target :: saved(:)
    integer(c_int32_t) :: status
    integer :: failure
    needed = 0
    status = hs_world_save(self%handle%object(), c_null_ptr, 0_c_size_t, needed)
    if (status >= HS_OK) then
      allocate (saved(needed), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_save(self%handle%object(), c_loc(saved), needed, written)
      if (status == HS_OK) call move_alloc(saved, bytes)
    end if
    call conclude(status, self%handle%context(), stat, errmsg)
  end subroutine save_state

  !> Drops this reference before the end of its scope.
  impure elemental subroutine destroy(self)
    class(block_world), intent(inout) :: self
    call self%handle%drop()
  end subroutine destroy

  !> Is there a world?
  elemental function exists(self)
    class(block_world), intent(in) :: self
    logical :: exists
    exists = self%handle%owns()
  end function exists

  !> Adds a block. The world copies the shape.
  subroutine add_block(self, shape, block, kind, material, pose, velocity, angular_velocity, stat, errmsg)
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
    type(hs_block_def) :: def
    integer(c_int32_t) :: status
    integer(c_int64_t) :: id
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    end if
    if (present(angular_velocity)) then
      if (.not. is_vector(angular_velocity, 'angular_velocity', 1, stat, errmsg)) return
    end if
    status = hs_block_def_init(def, c_sizeof(def), shape%c_handle())
    if (present(kind)) def%kind = kind
    if (present(material)) def%material = material - 1
    if (present(pose)) def%pose = pose
    if (present(velocity)) def%velocity = three_of(velocity)
    if (present(angular_velocity)) def%angular_velocity = three_of(angular_velocity)
    status = hs_world_add_block(self%handle%object(), shape%c_handle(), def, id)
    if (status == HS_OK .and. present(block)) block = transfer(id, block)
    call conclude(status, self%handle%context(), stat, errmsg)
  end subroutine add_block

  !> Number of living blocks; 0 if there is no world.
  function block_count(self) result(count)
    class(block_world), intent(in) :: self
    integer(c_int64_t) :: count
    integer(c_int64_t), target :: found
    count = 0
    if (hs_world_get_blocks(self%handle%object(), c_null_ptr, 0_c_int64_t, c_loc(found)) >= HS_OK) count = found
  end function block_count

  !> Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep their strain.
  subroutine set_elasticity(self, material, elasticity, stat, errmsg)
    class(block_world), intent(inout) :: self
    integer(c_int32_t), intent(in) :: material
    type(halfspace_elasticity), intent(in) :: elasticity
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%handle%remember_row_length(0)  ! virials are loads, too
    call conclude(hs_world_set_elasticity(self%handle%object(), material - 1, elasticity), self%handle%context(), &
                  stat, errmsg)
  end subroutine set_elasticity

  !> The handle, for calls of halfspace_c; the object stays the owner.
  function c_handle(self)
    class(block_world), intent(in) :: self
    type(c_ptr) :: c_handle
    c_handle = self%handle%object()
  end function c_handle

  !> The C context, for the text of the last error; the object stays the owner.
  function c_context(self)
    class(block_world), intent(in) :: self
    type(c_ptr) :: c_context
    c_context = self%handle%context()
  end function c_context

  impure elemental subroutine share(self, other)
    class(block_world), intent(inout) :: self
    class(block_world), intent(in) :: other
    self%handle = other%handle
  end subroutine share

  !> Becomes the owner of a C world that was made in the context of `origin`, or no world if `object` is NULL. Without
  !! memory for the reference count, the C world is destroyed and self does not change.
  function takes_world(self, object, origin, stat, errmsg) result(takes)
    class(block_world), intent(inout) :: self
    type(c_ptr), intent(in) :: object
    class(block_world), intent(in) :: origin
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    logical :: takes
    takes = self%handle%takes(object, hs_world_destroy, origin%handle, stat=stat, errmsg=errmsg)
  end function takes_world

  !> Numbers per block of the loads of a share, which are found once; 0 without a world.
  function row_length_of(self) result(length)
    class(block_world), intent(in) :: self
    integer :: length
    type(hs_share_info) :: info
    length = self%handle%row_length()
    if (length > 0) return
    if (hs_world_get_share_info(self%handle%object(), info, c_sizeof(info)) == HS_OK) length = info%load_length
    call self%handle%remember_row_length(length)
  end function row_length_of

end module halfspace_block_worlds
