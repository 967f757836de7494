!> Creation of worlds, materials, laws and blocks.
submodule(halfspace_block_worlds) halfspace_worlds_make
  use halfspace_contacts, only: id_of
  use halfspace_contexts, only: own_or_given
  use halfspace_errors, only: conclude, had_memory
  use halfspace_views, only: is_vector, three_of
  implicit none

contains

  module procedure create
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
  end procedure create

  module procedure add_material
    integer(c_int32_t) :: status, from_0
    status = hs_world_add_material(self%handle%object(), density, from_0)
    material = 0
    if (status == HS_OK) material = from_0 + 1
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure add_material

  module procedure set_default_law
    call conclude(hs_world_set_default_law(self%handle%object(), law), self%handle%context(), stat, errmsg)
  end procedure set_default_law

  module procedure set_law_between
    call conclude(hs_world_set_law(self%handle%object(), material_a - 1, material_b - 1, law), self%handle%context(), &
                  stat, errmsg)
  end procedure set_law_between

  module procedure add_block
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
  end procedure add_block

  module procedure remove_block
    call conclude(hs_world_remove_block(self%handle%object(), id_of(block)), self%handle%context(), stat, errmsg)
  end procedure remove_block

  module procedure save_state
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
  end procedure save_state

  module procedure restore
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_world_restore(owner%object(), c_loc(bytes), size(bytes, kind=c_size_t), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_world_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end procedure restore

  module procedure destroy
    call self%handle%drop()
  end procedure destroy

  module procedure exists
    exists = self%handle%owns()
  end procedure exists

  module procedure c_handle
    c_handle = self%handle%object()
  end procedure c_handle

  module procedure c_context
    c_context = self%handle%context()
  end procedure c_context

  module procedure share
    self%handle = other%handle
  end procedure share

  module procedure takes_world
    takes = self%handle%takes(object, hs_world_destroy, origin%handle, stat=stat, errmsg=errmsg)
  end procedure takes_world

end submodule halfspace_worlds_make
