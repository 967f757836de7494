!> Motions and loads in time: tables that blocks and nodes follow, force control, and held axes.
submodule(halfspace_worlds) halfspace_worlds_actions
  use halfspace_bodies, only: id_of_body
  use halfspace_contacts, only: id_of
  use halfspace_errors, only: conclude, refuse
  use halfspace_meshes, only: are_from_0
  use halfspace_views, only: are_points, is_vector, three_of, view
  implicit none

contains

  module procedure add_table
    type(hs_view) :: all
    integer(c_int32_t) :: status
    table = 0
    if (.not. are_points(values, 'values', rows, stat, errmsg)) return
    all = view(values, rows)
    if (.not. are_as_many(size(times, kind=c_int64_t), 'times', all%count, 'values', stat, errmsg)) return
    status = hs_world_add_table(self%c_handle(), c_loc(times), all, table)
    table = merge(table + 1, 0, status == HS_OK)
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure add_table

  module procedure add_action
    type(hs_action_def) :: def
    integer(c_int64_t) :: id
    if (.not. names_block(block, id, stat, errmsg)) return
    def = definition(kind, table, start)
    if (present(scale)) then
      if (.not. is_vector(scale, 'scale', 2, stat, errmsg)) return
      def%scale = three_of(scale)
    end if
    if (present(at)) then
      if (.not. is_vector(at, 'at', 2, stat, errmsg)) return
      def%point = three_of(at)
      def%place = HS_PLACE_CARRIED
      if (present(place)) def%place = place
    end if
    if (present(max_speed)) def%max_speed = max_speed
    call conclude(hs_world_add_action(self%c_handle(), id, def), self%c_context(), stat, errmsg)
  end procedure add_action

  module procedure end_actions
    integer(c_int64_t) :: id
    if (.not. names_block(block, id, stat, errmsg)) return
    call conclude(hs_world_end_actions(self%c_handle(), id), self%c_context(), stat, errmsg)
  end procedure end_actions

  module procedure add_node_action
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(hs_view) :: factors
    if (.not. are_points(scales, 'scales', rows, stat, errmsg)) return
    factors = view(scales, rows)
    if (.not. are_as_many(size(nodes, kind=c_int64_t), 'nodes', factors%count, 'scales', stat, errmsg)) return
    if (.not. are_from_0(nodes, from_0, stat, errmsg)) return
    call conclude(hs_world_add_node_action(self%c_handle(), id_of_body(body), c_loc(from_0), factors, &
                                           definition(kind, table, start)), self%c_context(), stat, errmsg)
  end procedure add_node_action

  module procedure end_node_actions
    call conclude(hs_world_end_node_actions(self%c_handle(), id_of_body(body)), self%c_context(), stat, errmsg)
  end procedure end_node_actions

  module procedure set_node_viscosity
    integer(c_int32_t), allocatable, target :: from_0(:)
    if (.not. are_from_0(nodes, from_0, stat, errmsg)) return
    call conclude(hs_world_set_node_viscosity(self%c_handle(), id_of_body(body), c_loc(from_0), &
                                              size(from_0, kind=c_int64_t), viscosity), self%c_context(), stat, errmsg)
  end procedure set_node_viscosity

  module procedure hold_block
    call conclude(hs_world_hold_block(self%c_handle(), id_of(block), axes), self%c_context(), stat, errmsg)
  end procedure hold_block

  module procedure prescribe_velocities
    type(hs_view) :: velocities, spins
    if (.not. are_points(linear, 'linear', rows, stat, errmsg)) return
    velocities = view(linear, rows)
    if (.not. are_as_many(size(blocks, kind=c_int64_t), 'blocks', velocities%count, 'linear', stat, errmsg)) return
    if (present(angular)) then
      if (.not. are_points(angular, 'angular', rows, stat, errmsg)) return
      spins = view(angular, rows)
    end if
    call conclude(hs_world_prescribe_velocities(self%c_handle(), c_loc(blocks), velocities, spins), &
                  self%c_context(), stat, errmsg)
  end procedure prescribe_velocities

  !> Missing arguments have the defaults of the library.
  type(hs_action_def) function definition(kind, table, start) result(def)
    integer(c_int32_t), intent(in) :: kind, table
    real(c_double), intent(in), optional :: start
    ! A definition whose initialisation fails keeps size 0, and is refused on use.
    if (hs_action_def_init(def, c_sizeof(def)) /= HS_OK) return
    def%kind = kind
    def%table = table - 1
    if (present(start)) def%start = start
  end function definition

  !> The id of a block, or 0, which stands for all blocks, if it is absent. Refuses a block that was never added.
  logical function names_block(block, id, stat, errmsg)
    type(halfspace_block), intent(in), optional :: block
    integer(c_int64_t), intent(out) :: id
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    id = 0
    if (present(block)) id = id_of(block)
    names_block = id /= 0 .or. .not. present(block)
    if (.not. names_block) call refuse('block: is none; it must be of the world, or absent for all', stat, errmsg)
  end function names_block

  !> C reads as many entries as the view has vectors.
  logical function are_as_many(count, name, expected, of_view, stat, errmsg)
    integer(c_int64_t), intent(in) :: count, expected
    character(*), intent(in) :: name, of_view
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(len(name) + len(of_view) + 80) :: text
    are_as_many = count == expected
    if (are_as_many) return
    write (text, '(a, ": has ", i0, " values; ", a, " has ", i0, " vectors")') name, count, of_view, expected
    call refuse(trim(text), stat, errmsg)
  end function are_as_many

end submodule halfspace_worlds_actions
