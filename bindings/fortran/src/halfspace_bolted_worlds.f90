!> Bolts and water of a world.
module halfspace_bolted_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_sizeof
  use halfspace_bonded_worlds, only: bonded_world
  use halfspace_c, only: hs_mutable_view, hs_water_def, hs_water_def_init, hs_world_add_bolt, hs_world_get_block_at, &
    hs_world_get_bolts, hs_world_get_water_loads, hs_world_remove_bolt, hs_world_set_water, HS_OK
  use halfspace_contacts, only: halfspace_block, id_of
  use halfspace_errors, only: conclude, had_memory
  use halfspace_properties, only: halfspace_bolt
  use halfspace_records, only: halfspace_bolt_state
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of, view
  implicit none
  private
  public :: bolted_world, halfspace_bolt_state

  !> A world with bolts and water; halfspace_world extends it.
  type, extends(bonded_world) :: bolted_world
  contains
    procedure :: add_bolt
    procedure :: remove_bolt
    procedure :: bolts
    procedure :: block_at
    procedure :: set_water
    procedure :: water_loads
  end type bolted_world

contains

  !> Adds a bolt between the current positions of two places, each carried by a block, or by the ground where the block
  !! is missing. The removal of a block removes its bolts. HS_ERROR_STATE if neither block moves.
  subroutine add_bolt(self, bolt, place_a, place_b, block_a, block_b, number, stat, errmsg)
    class(bolted_world), intent(inout) :: self
    type(halfspace_bolt), intent(in) :: bolt
    real(c_double), intent(in) :: place_a(:)  !< m, 3 values (2D: or 2)
    real(c_double), intent(in) :: place_b(:)  !< m, 3 values (2D: or 2)
    type(halfspace_block), intent(in), optional :: block_a
    type(halfspace_block), intent(in), optional :: block_b
    integer(c_int64_t), intent(out), target, optional :: number  !< >= 0, which no later bolt gets
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_bolt) :: def
    if (present(number)) number = -1
    if (.not. is_vector(place_a, 'place_a', 2, stat, errmsg)) return
    if (.not. is_vector(place_b, 'place_b', 2, stat, errmsg)) return
    def = bolt
    def%place_a = three_of(place_a)
    def%place_b = three_of(place_b)
    if (present(block_a)) def%block_a = id_of(block_a)
    if (present(block_b)) def%block_b = id_of(block_b)
    call conclude(hs_world_add_bolt(self%c_handle(), def, address_of(number)), self%c_context(), stat, errmsg)
  end subroutine add_bolt

  !> Removes a bolt. HS_ERROR_STALE_ID if there is no such bolt.
  subroutine remove_bolt(self, number, stat, errmsg)
    class(bolted_world), intent(inout) :: self
    integer(c_int64_t), intent(in) :: number
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_remove_bolt(self%c_handle(), number), self%c_context(), stat, errmsg)
  end subroutine remove_bolt

  !> All bolts, in ascending order of their numbers.
  subroutine bolts(self, list, stat, errmsg)
    class(bolted_world), intent(in) :: self
    type(halfspace_bolt_state), intent(inout), allocatable, target :: list(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_bolts(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(list)) deallocate (list)
      allocate (list(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_bolts(self%c_handle(), c_loc(list), count, c_null_ptr)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine bolts

  !> The block in which a place is deepest; no block, halfspace_block(), if it is outside of all blocks.
  subroutine block_at(self, place, block, stat, errmsg)
    class(bolted_world), intent(in) :: self
    real(c_double), intent(in) :: place(:)  !< m, 3 values (2D: or 2)
    type(halfspace_block), intent(out) :: block
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: found
    integer(c_int32_t) :: status
    if (.not. is_vector(place, 'place', 2, stat, errmsg)) return
    found = 0
    status = hs_world_get_block_at(self%c_handle(), three_of(place), found)
    block = transfer(found, block)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine block_at

  !> Sets the water, in place of the water before. Without points there is no water.
  subroutine set_water(self, table, density, factor, rows, columns, stat, errmsg)
    class(bolted_world), intent(inout) :: self
    !> in 2D the corners of a polyline, in ascending order of x, level beyond its ends; in 3D one point of a level
    !! plane, three points of a plane, or the points of a height map row by row
    real(c_double), intent(in), target :: table(:,:)
    real(c_double), intent(in), optional :: density  !< kg/m3; default 1000
    real(c_double), intent(in), optional :: factor  !< multiplies the pressure; default 1
    logical, intent(in), optional :: rows  !< layout of the table
    integer, intent(in), optional :: columns  !< 3D: points in each row of a height map; default 0: a plane
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_water_def) :: def
    integer(c_int32_t) :: status
    if (.not. are_points(table, 'table', rows, stat, errmsg)) return
    status = hs_water_def_init(def, c_sizeof(def))
    if (present(density)) def%density = density
    if (present(factor)) def%factor = factor
    if (present(columns)) def%columns = int(columns, c_int32_t)
    status = hs_world_set_water(self%c_handle(), def, view(table, rows))
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine set_water

  !> The current loads of water on all blocks.
  subroutine water_loads(self, force, torque, rows, stat, errmsg)
    class(bolted_world), intent(in) :: self
    real(c_double), intent(inout), target :: force(:,:)  !< on each block, N
    real(c_double), intent(inout), target, optional :: torque(:,:)  !< about each centroid, N m
    logical, intent(in), optional :: rows  !< layout of both
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_mutable_view) :: torques
    if (.not. are_points(force, 'force', rows, stat, errmsg)) return
    if (present(torque)) then
      if (.not. are_points(torque, 'torque', rows, stat, errmsg)) return
      torques = mutable_view(torque, rows)
    end if
    call conclude(hs_world_get_water_loads(self%c_handle(), mutable_view(force, rows), torques), self%c_context(), &
                  stat, errmsg)
  end subroutine water_loads

end module halfspace_bolted_worlds
