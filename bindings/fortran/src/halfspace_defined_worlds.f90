!> What a world was given: settings, materials, laws, tables and actions, as they are at present.
module halfspace_defined_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_sizeof
  use halfspace_bolted_worlds, only: bolted_world
  use halfspace_c, only: hs_mutable_view, hs_setting_get_usual, hs_setting_usual_text, hs_world_check, &
    hs_world_get_actions, hs_world_get_def, hs_world_get_default_law, hs_world_get_densities, hs_world_get_elasticity, &
    hs_world_get_law, hs_world_get_table, HS_OK, halfspace_action => hs_action_def, halfspace_world_def => hs_world_def
  use halfspace_contacts, only: halfspace_block, id_of
  use halfspace_properties, only: halfspace_elasticity, halfspace_law
  use halfspace_errors, only: conclude, had_memory, refuse, text_at
  use halfspace_records, only: halfspace_note
  use halfspace_views, only: mutable_view
  implicit none
  private
  public :: defined_world, halfspace_action, halfspace_note, halfspace_usual_range, halfspace_usual_text, &
    halfspace_world_def

  !> A world that returns what it was given; halfspace_world extends it.
  type, extends(bolted_world) :: defined_world
  contains
    procedure :: definition
    procedure :: densities
    procedure :: elasticity
    procedure, private :: default_law
    procedure, private :: law_between
    generic :: law => default_law, law_between
    procedure :: table
    procedure :: actions
    procedure :: check
  end type defined_world

contains

  !> The settings, with gravity, damping and time step as they were set last.
  subroutine definition(self, def, stat, errmsg)
    class(defined_world), intent(in) :: self
    type(halfspace_world_def), intent(out) :: def
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_def(self%c_handle(), def, c_sizeof(def)), self%c_context(), stat, errmsg)
  end subroutine definition

  !> Densities of all materials, kg/m3.
  subroutine densities(self, list, stat, errmsg)
    class(defined_world), intent(in) :: self
    real(c_double), intent(inout), allocatable, target :: list(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_densities(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(list)) deallocate (list)
      allocate (list(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_densities(self%c_handle(), c_loc(list), count, c_null_ptr)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine densities

  !> The elasticity of a material; its young_modulus is 0 if the material has none.
  subroutine elasticity(self, material, value, stat, errmsg)
    class(defined_world), intent(in) :: self
    integer(c_int32_t), intent(in) :: material
    type(halfspace_elasticity), intent(out) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_elasticity(self%c_handle(), material - 1, value, c_sizeof(value)), self%c_context(), &
                  stat, errmsg)
  end subroutine elasticity

  !> The law of all pairs of materials without a law of their own.
  subroutine default_law(self, value, stat, errmsg)
    class(defined_world), intent(in) :: self
    type(halfspace_law), intent(out) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_default_law(self%c_handle(), value, c_sizeof(value)), self%c_context(), stat, errmsg)
  end subroutine default_law

  !> The law of two materials, in either order: their own, or the default law. Its strengths are those that were given,
  !! before division by the factor of set_strength_factor().
  subroutine law_between(self, value, material_a, material_b, stat, errmsg)
    class(defined_world), intent(in) :: self
    type(halfspace_law), intent(out) :: value
    integer(c_int32_t), intent(in) :: material_a, material_b  !< may be the same
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_law(self%c_handle(), material_a - 1, material_b - 1, value, c_sizeof(value)), &
                  self%c_context(), stat, errmsg)
  end subroutine law_between

  !> The rows of a table.
  subroutine table(self, index, times, values, stat, errmsg)
    class(defined_world), intent(in) :: self
    integer(c_int32_t), intent(in) :: index  !< from add_table()
    real(c_double), intent(inout), allocatable, target :: times(:)  !< s
    real(c_double), intent(inout), allocatable, target :: values(:,:)  !< columns of three components
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    integer :: failure
    type(hs_mutable_view) :: none
    status = hs_world_get_table(self%c_handle(), index - 1, c_null_ptr, none, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(times)) deallocate (times)
      if (allocated(values)) deallocate (values)
      allocate (times(count), values(3, count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_table(self%c_handle(), index - 1, c_loc(times), mutable_view(values), c_null_ptr)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine table

  !> The actions on a block, in the order in which they were added. Where a later motion ended one along some axes, its
  !! scale is 0 there. A point that the block carries is where it is now.
  subroutine actions(self, list, block, stat, errmsg)
    class(defined_world), intent(in) :: self
    type(halfspace_action), intent(inout), allocatable, target :: list(:)
    type(halfspace_block), intent(in), optional :: block  !< absent: those on all blocks
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_action) :: one
    integer(c_int64_t), target :: count
    integer(c_int64_t) :: id
    integer(c_int32_t) :: status
    integer :: failure
    id = 0
    if (present(block)) id = id_of(block)
    if (present(block) .and. id == 0) then
      call refuse('block: is none; it must be of the world, or absent for all', stat, errmsg)
      return
    end if
    status = hs_world_get_actions(self%c_handle(), id, c_null_ptr, c_sizeof(one), 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(list)) deallocate (list)
      allocate (list(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_actions(self%c_handle(), id, c_loc(list), c_sizeof(one), count, c_null_ptr)
      list%table = list%table + 1
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine actions

  !> The settings with unusual values, which are probably in another unit.
  subroutine check(self, notes, stat, errmsg)
    class(defined_world), intent(in) :: self
    type(halfspace_note), intent(inout), allocatable, target :: notes(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_check(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(notes)) deallocate (notes)
      allocate (notes(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_check(self%c_handle(), c_loc(notes), count, c_null_ptr)
      notes%material_a = notes%material_a + 1
      notes%material_b = notes%material_b + 1
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine check

  !> The smallest usual value of a setting but 0, which is usual, too, and the largest one; both 0 for a number that is
  !! no HS_SETTING_ value.
  subroutine halfspace_usual_range(setting, low, high)
    integer(c_int32_t), intent(in) :: setting
    real(c_double), intent(out) :: low, high
    if (hs_setting_get_usual(setting, low, high) == HS_OK) return
    low = 0
    high = 0
  end subroutine halfspace_usual_range

  !> The usual range of a setting in words.
  function halfspace_usual_text(setting) result(text)
    integer(c_int32_t), intent(in) :: setting
    character(:), allocatable :: text
    text = text_at(hs_setting_usual_text(setting))
  end function halfspace_usual_text

end module halfspace_defined_worlds
