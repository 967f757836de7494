! Water and bolts: a raft has the draught of Archimedes, a cable carries its block.
program test_loads
  use checking
  use halfspace
  use halfspace_c, only: hs_bolt
  use, intrinsic :: iso_fortran_env, only: int32, int64, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 4, 0, 4, 1, 0, 1], [2, 4])
  real(real64), parameter :: density = 600, weight = 4 * density * 9.81_real64

  call draught()
  call cable()
  call refusals()
  call finish()

contains

  subroutine make_raft(world, raft)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: raft
    type(halfspace_shape) :: plank
    integer(int32) :: wood
    call plank%create_polygon(corners)
    call world%create(gravity=[0.0_real64, -9.81_real64])
    call world%add_material(density, wood)
    call world%add_block(plank, raft)
  end subroutine make_raft

  subroutine draught()
    type(halfspace_world) :: world
    type(halfspace_block) :: raft
    type(halfspace_block_state) :: state
    real(real64) :: force(2, 1), level(2, 1)
    call make_raft(world, raft)
    level(:, 1) = [0.0_real64, 2.0_real64]
    call world%set_water(level)
    call world%relax(ratio=1e-8_real64)
    call world%block_state(raft, state)
    call expect_close([state%pose%position(2)], [1.9_real64], 1e-6_real64, 'draught')
    call world%water_loads(force)
    call expect_close(force(:, 1), [0.0_real64, weight], 1e-5_real64 * weight, 'the force of water')
    call world%set_water(reshape([real(real64) ::], [2, 0]))
    call world%water_loads(force)
    call expect_close(force(:, 1), [0.0_real64, 0.0_real64], 0.0_real64, 'no water')
  end subroutine draught

  subroutine cable()
    type(halfspace_world) :: world
    type(halfspace_block) :: raft, found
    type(halfspace_bolt_state), allocatable :: bolts(:)
    integer(int64) :: number
    call expect(storage_size(hs_bolt()) == storage_size(halfspace_bolt_state()), 'size of a state')
    call make_raft(world, raft)
    call world%block_at([1.0_real64, 0.2_real64], found)
    call expect(found == raft, 'the block at a place')
    call world%add_bolt(halfspace_bolt(stiffness=1e7_real64, pretension=weight), [2.0_real64, 3.0_real64], &
                        [2.0_real64, 0.5_real64], block_b=raft, number=number)
    call world%step(100)
    call world%bolts(bolts)
    call expect(size(bolts) == 1 .and. bolts(1)%number == number, 'the number of a bolt')
    call expect_close([bolts(1)%tension], [weight], 1e-6_real64 * weight, 'tension')
    call world%remove_bolt(number)
    call world%bolts(bolts)
    call expect(size(bolts) == 0, 'no bolt is left')
  end subroutine cable

  subroutine refusals()
    type(halfspace_world) :: world
    type(halfspace_block) :: raft
    integer :: stat
    character(200) :: text
    call make_raft(world, raft)
    call world%add_bolt(halfspace_bolt(pretension=-1.0_real64), [0.0_real64, 3.0_real64], [0.0_real64, 0.0_real64], &
                        block_b=raft, stat=stat, errmsg=text)
    call expect(stat < 0 .and. index(text, 'def.pretension is -1') > 0, 'pressure in a cable')
    call world%remove_bolt(7_int64, stat=stat, errmsg=text)
    call expect(stat < 0 .and. index(text, 'number is 7') > 0, 'no such bolt')
  end subroutine refusals

end program test_loads
