! A world cut into two shares moves with the bits of the whole one; what shares refuse.
program test_shares
  use checking
  use halfspace
  use halfspace_c, only: HS_SUM_COUNT
  use, intrinsic :: iso_c_binding, only: c_int8_t, c_size_t
  use, intrinsic :: iso_fortran_env, only: int32, int64, real64
  implicit none

  integer, parameter :: grains = 24  ! their keys are 1 to 24, that of the floor is 0
  integer, parameter :: left = 1, right = 2

  ! The host: two shares, and which of them owns a grain.
  type(halfspace_world) :: left_share, right_share
  integer :: owner(grains)
  integer(int64), allocatable :: left_copies(:), right_copies(:)
  integer :: assemblies = 0, migrations = 0

  call same_bits()
  call refusals()
  call finish()

contains

  subroutine make_heap(world)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_shape) :: floor, grain
    integer(int32) :: stone
    integer :: i
    call floor%create_polygon(reshape([real(real64) :: -2, -1, 12, -1, 12, 0, -2, 0], [2, 4]))
    call grain%create_polygon(reshape([0.0_real64, 0.0_real64, 0.5_real64, 0.0_real64, 0.4_real64, 0.5_real64, &
                                       0.1_real64, 0.6_real64], [2, 4]))
    call world%create(time_step=5e-4_real64, local_damping=0.1_real64)
    call world%add_material(2500.0_real64, stone)
    call world%set_law(halfspace_law(normal_stiffness=1e7_real64, friction_angle=0.4_real64))
    call world%add_block(floor, kind=HS_BLOCK_FIXED)
    do i = 0, grains - 1
      call world%add_block(grain, pose=halfspace_pose(0.55_real64 * mod(i, 8), 0.4_real64 + 0.55_real64 * (i / 8), &
                                                      0.7_real64 * i), &
                           velocity=[2.0_real64 * (mod(i, 3) - 1), -2.0_real64])
    end do
  end subroutine make_heap

  subroutine same_bits()
    type(halfspace_world) :: whole, joined
    integer :: step
    call make_heap(whole)
    left_share = whole  ! the same world, of which the first cut makes two
    right_share = whole
    owner = left
    call cut()
    call left_share%begin()
    call right_share%begin()
    call carry_loads()
    call left_share%end_begin()
    call right_share%end_begin()
    do step = 1, 400
      call make_step()
    end do
    call whole%step(400)
    call expect(assemblies > 1, 'shares were assembled on the way')
    call expect(migrations > 0, 'grains have gone to the other share')
    call expect_share(left_share, count(owner == left), size(left_copies))
    call expect_share(right_share, count(owner == right), size(right_copies))
    call join(joined)
    call compare(joined, whole)
    call whole%step(50)
    call joined%step(50)
    call compare(joined, whole)
  end subroutine same_bits

  subroutine expect_share(share, own, copies)
    type(halfspace_world), intent(in) :: share
    integer, intent(in) :: own, copies
    type(halfspace_share_info) :: info
    call share%share_info(info)
    call expect(info%own_count == own .and. info%neighbor_count == copies .and. copies > 0, 'own grains and copies')
    call expect(info%everywhere_count == 1, 'the floor')
    call expect(info%is_whole == 0 .and. info%lost_pairs == 0, 'a sound share')
  end subroutine expect_share

  subroutine make_step()
    type(halfspace_share_plan) :: plans(2)
    logical :: needs_list
    call plan(plans)
    needs_list = any(plans%needs_list == 1)
    if (needs_list .or. any(plans%needs_assembly == 1)) then
      call cut()
      call plan(plans)
      if (needs_list .or. any(plans%needs_list == 1)) then
        call left_share%renew_list(plans(left))
        call right_share%renew_list(plans(right))
      end if
    end if
    call expect(all(plans%refusal == HS_OK), 'no refusal')
    call left_share%move()
    call right_share%move()
    call carry_loads()
    call left_share%end_step()
    call right_share%end_step()
  end subroutine make_step

  subroutine plan(plans)
    type(halfspace_share_plan), intent(out) :: plans(2)
    call left_share%plan_motion(plans(left))
    call right_share%plan_motion(plans(right))
  end subroutine plan

  subroutine carry_loads()
    real(real64), allocatable :: loads(:,:)
    type(halfspace_share_info) :: info
    call left_share%share_info(info)
    allocate (loads(info%load_length, size(left_copies)))
    call right_share%loads(left_copies, loads)
    call left_share%set_loads(left_copies, loads)
    deallocate (loads)
    allocate (loads(info%load_length, size(right_copies)))
    call left_share%loads(right_copies, loads)
    call right_share%set_loads(right_copies, loads)
  end subroutine carry_loads

  !> Cuts the grains near their mean x. The cut goes to and fro, as by a balance of load.
  subroutine cut()
    type(halfspace_world) :: new_left, new_right
    type(halfspace_share_info) :: of_left, of_right
    real(real64) :: x(grains), halo
    integer :: new_owner(grains)
    call find_places(left_share, x)
    call find_places(right_share, x)
    call left_share%share_info(of_left)
    call right_share%share_info(of_right)
    halo = max(of_left%halo, of_right%halo)
    new_owner = merge(left, right, x < sum(x) / grains + 0.4_real64 * mod(assemblies, 2))
    left_copies = near(new_owner == left, x, halo)
    right_copies = near(new_owner == right, x, halo)
    call assemble(left, new_owner == left, left_copies, new_left)
    call assemble(right, new_owner == right, right_copies, new_right)
    if (assemblies > 0) migrations = migrations + count(new_owner /= owner)
    assemblies = assemblies + 1
    left_share = new_left
    right_share = new_right
    owner = new_owner
  end subroutine cut

  !> x of the own grains of a share.
  subroutine find_places(share, x)
    type(halfspace_world), intent(in) :: share
    real(real64), intent(inout) :: x(grains)
    integer(int64), allocatable :: keys(:)
    integer(int32), allocatable :: roles(:)
    real(real64), allocatable :: px(:), py(:)
    integer :: i
    call share%keys(keys)
    call share%roles(roles)
    allocate (px(size(keys)), py(size(keys)))
    call share%poses(px, py)
    do i = 1, size(keys)
      if (roles(i) == HS_ROLE_OWN) x(keys(i)) = px(i)
    end do
  end subroutine find_places

  !> Keys of other grains within the halo of own ones.
  function near(is_own, x, halo) result(keys)
    logical, intent(in) :: is_own(grains)
    real(real64), intent(in) :: x(grains), halo
    integer(int64), allocatable :: keys(:)
    integer(int64) :: key
    real(real64) :: low, high
    low = minval(x, mask=is_own) - halo
    high = maxval(x, mask=is_own) + halo
    keys = pack([(key, key=1, grains)], .not. is_own .and. x >= low .and. x <= high)
  end function near

  !> Makes a share of the grains that it keeps, and of those that both shares until now pack for it.
  subroutine assemble(side, is_own, copies, share)
    integer, intent(in) :: side
    logical, intent(in) :: is_own(grains)
    integer(int64), intent(in) :: copies(:)
    type(halfspace_world), intent(inout) :: share
    type(halfspace_packed) :: blocks(0:grains)
    integer(c_int8_t), allocatable, target :: bytes(:), of_right(:)
    integer(c_size_t), allocatable :: ends(:), ends_of_right(:)
    integer(int64), allocatable :: sent(:)
    logical :: is_sent(grains)
    integer(int64) :: key
    integer :: count_of_blocks, i
    is_sent = [(any(copies == key), key=1, grains)] .or. (is_own .and. owner /= side)
    sent = pack([(key, key=1, grains)], is_sent .and. owner == left)
    call left_share%pack(sent, bytes, ends)
    sent = [sent, pack([(key, key=1, grains)], is_sent .and. owner == right)]
    call right_share%pack(sent(size(ends) + 1:), of_right, ends_of_right)
    ends = [0_c_size_t, ends, size(bytes) + ends_of_right]
    bytes = [bytes, of_right]
    blocks(0) = halfspace_packed(0_int64, HS_ROLE_EVERYWHERE)
    count_of_blocks = 1
    do key = 1, grains
      if (is_sent(key)) then
        i = findloc(sent, key, dim=1)
        blocks(count_of_blocks) = halfspace_packed(key, merge(HS_ROLE_OWN, HS_ROLE_NEIGHBOR, is_own(key)), &
                                                   bytes(ends(i) + 1:ends(i + 1)))
      else if (is_own(key)) then
        blocks(count_of_blocks) = halfspace_packed(key)
      else
        cycle
      end if
      count_of_blocks = count_of_blocks + 1
    end do
    if (side == left) call left_share%assemble(blocks(:count_of_blocks - 1), share)
    if (side == right) call right_share%assemble(blocks(:count_of_blocks - 1), share)
  end subroutine assemble

  !> The whole world again.
  subroutine join(joined)
    type(halfspace_world), intent(inout) :: joined
    real(real64) :: of_left(HS_SUM_COUNT), of_right(HS_SUM_COUNT)
    call assemble(left, spread(.true., 1, grains), [integer(int64) ::], joined)
    call left_share%sums(of_left)
    call right_share%sums(of_right)
    call joined%set_sums(of_left + of_right)
  end subroutine join

  subroutine compare(joined, whole)
    type(halfspace_world), intent(in) :: joined, whole
    type(halfspace_share_info) :: info
    integer(int64), allocatable :: keys(:)
    integer(int64) :: key
    integer(c_int8_t), allocatable :: bytes(:), expected(:)
    integer(c_size_t), allocatable :: ends(:)
    real(real64) :: sums(HS_SUM_COUNT), of_whole(HS_SUM_COUNT)
    call joined%share_info(info)
    call expect(info%is_whole == 1 .and. info%own_count == grains, 'joined')
    call joined%keys(keys)
    call expect(all(keys == [(key, key=0, grains)]), 'all keys')
    call joined%pack(keys(2:), bytes, ends)
    call whole%pack(keys(2:), expected, ends)
    call expect(size(bytes) == size(expected), 'lengths')
    if (size(bytes) == size(expected)) call expect(all(bytes == expected), 'the same bits')
    call joined%sums(sums)
    call whole%sums(of_whole)
    call expect_close(sums(:16), of_whole(:16), 1e-12_real64 * maxval(abs(of_whole(:16))), 'energies')
  end subroutine compare

  subroutine refusals()
    type(halfspace_world) :: world, copy, share
    integer(c_int8_t), target :: damaged(3)
    integer(c_int8_t), allocatable :: bytes(:), without_shapes(:)
    integer(c_size_t), allocatable :: ends(:)
    integer(int64), allocatable :: keys(:)
    integer(int64) :: key
    integer :: stat
    character(200) :: text
    call make_heap(world)
    call world%set_keys([(10 * key, key=0, grains)])
    call world%keys(keys)
    call expect(all(keys == [(10 * key, key=0, grains)]), 'keys that were set')
    call world%set_keys([1_int64, 1_int64], stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. index(text, 'count is 2') > 0, 'too few keys')
    call world%pack([10_int64], bytes, ends)
    call world%pack([10_int64], without_shapes, ends, with_shapes=.false.)
    call expect(size(without_shapes) < size(bytes) .and. ends(1) == size(without_shapes), 'without shapes')
    call world%pack([7_int64], bytes, ends, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_STALE_ID .and. index(text, 'keys[0] is 7') > 0, 'no such key')
    damaged = 1
    call world%assemble([halfspace_packed(10_int64, HS_ROLE_NEIGHBOR, damaged)], share, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_FORMAT .and. .not. share%exists(), 'damaged bytes')
    call world%set_loads([10_int64], reshape([1.0_real64, 2.0_real64], [2, 1]), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'loads of another shape')
    call expect_text(text, 'it must be (3, 1)')
    copy = world
    call copy%set_elasticity(1, halfspace_elasticity(1e8_real64))
    call world%set_loads([10_int64], reshape([1.0_real64, 2.0_real64], [2, 1]), stat=stat, errmsg=text)
    call expect_text(text, 'it must be (7, 1)')
    call world%move(stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_STATE .and. index(text, 'hs_world_plan_motion') > 0, 'not planned')
    call share%keys(keys, stat=stat, errmsg=text)
    call expect(stat < 0, 'no world')
  end subroutine refusals

end program test_shares
