!> Shares of a world, for hosts that spread one world over processes.
module halfspace_spread_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int8_t, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_size_t, &
    c_sizeof
  use halfspace_block_worlds, only: row_length_of, takes_world
  use halfspace_c, only: hs_world_assemble, hs_world_begin, hs_world_end_begin, hs_world_end_step, hs_world_get_keys, &
    hs_world_get_loads, hs_world_get_roles, hs_world_get_share_info, hs_world_get_sums, hs_world_move, hs_world_pack, &
    hs_world_plan_motion, hs_world_renew_list, hs_world_set_keys, hs_world_set_loads, hs_world_set_sums, HS_OK, &
    HS_ROLE_OWN, HS_SUM_COUNT, halfspace_packed => hs_packed, halfspace_share_info => hs_share_info, &
    halfspace_share_plan => hs_share_plan
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_plane_worlds, only: plane_world
  implicit none
  private
  public :: halfspace_packed, halfspace_share_info, halfspace_share_plan, spread_world

  !> halfspace_packed(key, role, bytes): a block of a share to be assembled.
  interface halfspace_packed
    module procedure packed
  end interface

  !> A world of which each process holds a share: its own blocks, copies of their neighbours, and the fixed and
  !! prescribed blocks, which are everywhere. All processes make the same calls, and the host carries packed blocks and
  !! loads between them, as by MPI:
  !!
  !!     plan --> does any need a list or an assembly? -- yes: pack, carry, assemble, plan; renew the lists
  !!       `----> move --> loads, carry, set_loads --> end_step
  !!
  !! The motion has the same bits as by step() of the whole world, for any number of shares. Shares hold rigid and
  !! affine blocks, laws with springs and potential laws, water and applied forces; the world needs a given time step.
  !! halfspace_world extends it.
  type, extends(plane_world) :: spread_world
  contains
    procedure :: set_keys
    procedure :: keys
    procedure :: roles
    procedure :: share_info
    procedure :: pack => pack_blocks
    procedure :: assemble
    procedure :: sums
    procedure :: set_sums
    procedure :: begin
    procedure :: end_begin
    procedure :: plan_motion
    procedure :: renew_list
    procedure :: move
    procedure :: loads
    procedure :: set_loads
    procedure :: end_step
  end type spread_world

contains

  !> It refers to the bytes, which must keep their place until assemble() returns: pass a variable or a contiguous
  !! section of one, with the attribute target.
  function packed(key, role, bytes)
    integer(c_int64_t), intent(in) :: key  !< name of the block in all shares
    integer(c_int32_t), intent(in), optional :: role  !< HS_ROLE_OWN (default), _NEIGHBOR or _EVERYWHERE
    !> from pack() of the share that owns the block; default: as the world that assembles the share has it, of which the
    !! block is its own or everywhere
    integer(c_int8_t), intent(in), target, contiguous, optional :: bytes(:)
    type(halfspace_packed) :: packed
    packed%key = key
    packed%role = HS_ROLE_OWN
    if (present(role)) packed%role = role
    if (.not. present(bytes)) return
    packed%bytes = c_loc(bytes)
    packed%size = size(bytes, kind=c_size_t)
  end function packed

  !> Names the blocks of a whole world. By default a block's key is its place in blocks(), from 0. Blocks that are added
  !! or removed later end these keys.
  subroutine set_keys(self, keys, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)  !< ascending, in the order of blocks()
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_set_keys(self%c_handle(), c_loc(keys), size(keys, kind=c_int64_t)), self%c_context(), &
                  stat, errmsg)
  end subroutine set_keys

  !> The keys of all blocks, in the order of blocks(), which is ascending.
  subroutine keys(self, list, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(inout), allocatable, target :: list(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    integer :: failure
    allocate (found(self%block_count()), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    status = hs_world_get_keys(self%c_handle(), c_loc(found), size(found, kind=c_int64_t), c_null_ptr)
    if (status == HS_OK) call move_alloc(found, list)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine keys

  !> The roles of all blocks, HS_ROLE_ values, in the order of blocks(). In a whole world fixed and prescribed blocks
  !! are everywhere, all others own.
  subroutine roles(self, list, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int32_t), intent(inout), allocatable, target :: list(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    integer :: failure
    allocate (found(self%block_count()), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    status = hs_world_get_roles(self%c_handle(), c_loc(found), size(found, kind=c_int64_t), c_null_ptr)
    if (status == HS_OK) call move_alloc(found, list)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine roles

  !> Numbers of blocks, and how far copies must reach, after plan_motion().
  subroutine share_info(self, info, stat, errmsg)
    class(spread_world), intent(in) :: self
    type(halfspace_share_info), intent(out) :: info
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_share_info(self%c_handle(), info, c_sizeof(info)), self%c_context(), stat, errmsg)
  end subroutine share_info

  !> Packs own blocks, or blocks that are everywhere: their motion, and the memory of their pairs, in the machine's
  !! format of numbers. HS_ERROR_STALE_ID if no such block has a key.
  subroutine pack_blocks(self, keys, bytes, ends, with_shapes, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)  !< in any order
    integer(c_int8_t), intent(inout), allocatable, target :: bytes(:)  !< of all blocks, one after the other
    integer(c_size_t), intent(inout), allocatable, target :: ends(:)  !< index of the last byte of each block
    logical, intent(in), optional :: with_shapes  !< default .true.: with outlines, for shares without the block
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: written(:)
    integer(c_size_t), allocatable, target :: last(:)
    integer(c_size_t) :: needed, again
    integer(c_int64_t) :: count
    integer(c_int32_t) :: shapes, status
    integer :: failure
    shapes = 1
    if (present(with_shapes)) shapes = merge(1, 0, with_shapes)
    count = size(keys, kind=c_int64_t)
    needed = 0
    status = hs_world_pack(self%c_handle(), c_loc(keys), count, shapes, c_null_ptr, 0_c_size_t, c_null_ptr, needed)
    if (status >= HS_OK) then
      allocate (written(needed), last(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_pack(self%c_handle(), c_loc(keys), count, shapes, c_loc(written), needed, c_loc(last), again)
      if (status == HS_OK) then
        call move_alloc(written, bytes)
        call move_alloc(last, ends)
      end if
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine pack_blocks

  !> Makes a world of blocks, in the same context: a share, or the whole world again where all its blocks are own ones.
  !! Settings, laws, clock, list of pairs and losses are those of self, which does not change. HS_ERROR_STATE if it has
  !! what shares cannot hold, HS_ERROR_FORMAT for damaged bytes.
  subroutine assemble(self, blocks, share, stat, errmsg)
    class(spread_world), intent(in) :: self
    !> in ascending order of keys: all own blocks of the share, copies of all blocks within its halo, packed in the
    !! present motion, and all blocks that are everywhere
    type(halfspace_packed), intent(in), target, contiguous :: blocks(:)
    class(spread_world), intent(inout) :: share  !< another variable than self; it may be assigned to it afterwards
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    status = hs_world_assemble(self%c_context(), self%c_handle(), c_loc(blocks), size(blocks, kind=c_int64_t), object)
    if (status == HS_OK) then
      if (.not. takes_world(share, object, self, stat, errmsg)) return
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine assemble

  !> Energies and losses (16, J), powers (5, W), linear momentum (3, N s) and angular momentum about the origin
  !> (3, N m s), as numbers that add up over shares to those of the whole world.
  subroutine sums(self, values, stat, errmsg)
    class(spread_world), intent(in) :: self
    real(c_double), intent(out), target :: values(HS_SUM_COUNT)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_sums(self%c_handle(), c_loc(values)), self%c_context(), stat, errmsg)
  end subroutine sums

  !> Sets them, all but the momentum: to the sums over the shares whose blocks the world has taken over.
  subroutine set_sums(self, values, stat, errmsg)
    class(spread_world), intent(inout) :: self
    real(c_double), intent(in), target :: values(HS_SUM_COUNT)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_set_sums(self%c_handle(), c_loc(values)), self%c_context(), stat, errmsg)
  end subroutine set_sums

  !> Begins after blocks were added, or laws, velocities or forces changed: computes contacts and forces where blocks
  !! are. Then loads are carried, and end_begin() follows.
  subroutine begin(self, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_begin(self%c_handle()), self%c_context(), stat, errmsg)
  end subroutine begin

  !> Computes accelerations and energies of the beginning, from the loads.
  subroutine end_begin(self, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_end_begin(self%c_handle()), self%c_context(), stat, errmsg)
  end subroutine end_begin

  !> Plans the motion of a step, without moving any block. The host combines the plans of all shares: the maximum of
  !! needs_list and of needs_assembly, the minimum of refusal.
  subroutine plan_motion(self, plan, stat, errmsg)
    class(spread_world), intent(inout) :: self
    type(halfspace_share_plan), intent(out) :: plan
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_plan_motion(self%c_handle(), plan), self%c_context(), stat, errmsg)
  end subroutine plan_motion

  !> Renews the list of pairs for the planned motion, in all shares if the plan of any needs it.
  subroutine renew_list(self, plan, stat, errmsg)
    class(spread_world), intent(inout) :: self
    type(halfspace_share_plan), intent(out) :: plan  !< with the new list: of it, `refusal` counts
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_renew_list(self%c_handle(), plan), self%c_context(), stat, errmsg)
  end subroutine renew_list

  !> Makes the planned motion, which must be without a refusal, and computes contacts and forces after it.
  subroutine move(self, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_move(self%c_handle()), self%c_context(), stat, errmsg)
  end subroutine move

  !> Returns the loads of the contacts on own blocks, for the shares that have copies.
  subroutine loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)
    !> a column per key, of load_length numbers of share_info(): force, torque, and in worlds with elastic materials
    !! the virial
    real(c_double), intent(inout), target, contiguous :: values(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_loads(self, keys, values, stat, errmsg)) return
    call conclude(hs_world_get_loads(self%c_handle(), c_loc(keys), size(keys, kind=c_int64_t), c_loc(values)), &
                  self%c_context(), stat, errmsg)
  end subroutine loads

  !> Sets the loads of the contacts on copies, as loads() of their owner returned them.
  subroutine set_loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)
    real(c_double), intent(in), target, contiguous :: values(:,:)  !< a column per key
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_loads(self, keys, values, stat, errmsg)) return
    call conclude(hs_world_set_loads(self%c_handle(), c_loc(keys), size(keys, kind=c_int64_t), c_loc(values)), &
                  self%c_context(), stat, errmsg)
  end subroutine set_loads

  !> Ends the step: computes velocities and energies at the end of the motion, from the loads.
  subroutine end_step(self, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_end_step(self%c_handle()), self%c_context(), stat, errmsg)
  end subroutine end_step

  !> Have the loads a column per key, as long as the library's? Refuses others.
  logical function are_loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in) :: keys(:)
    real(c_double), intent(in) :: values(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer :: length
    character(120) :: text
    length = row_length_of(self)
    are_loads = length == 0 .or. (size(values, 1) == length .and. size(values, 2) == size(keys))
    if (are_loads) return  ! without a world the library refuses
    write (text, '("values: has the shape (", i0, ", ", i0, "); it must be (", i0, ", ", i0, ")")') &
      shape(values), length, size(keys)
    call refuse(trim(text), stat, errmsg)
  end function are_loads

end module halfspace_spread_worlds
