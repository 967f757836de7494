! Contacts without springs: a square falls onto a fixed one, and rests on it with its weight.
program test_contacts_without_springs
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: gravity(2) = [0.0_real64, -10.0_real64], gap = 0.05_real64

  call falling_square()
  call finish()

contains

  subroutine falling_square()
    type(halfspace_world) :: world
    type(halfspace_shape) :: square
    type(halfspace_block) :: lower, upper
    type(halfspace_contact), allocatable :: contacts(:)
    type(halfspace_world_report) :: report
    integer(int32) :: stone
    call square%create_polygon(corners)
    call world%create(gravity=gravity, time_step=1e-3_real64)
    call world%add_material(2000.0_real64, stone)
    call world%set_law(halfspace_law(stiffness_kind=HS_STIFFNESS_NONE))
    call world%add_block(square, lower, kind=HS_BLOCK_FIXED)
    call world%add_block(square, upper, pose=halfspace_pose(0.5_real64, 1.5_real64 + gap))
    call world%contacts(contacts)
    call expect(size(contacts) == 0, 'no contact yet')
    call world%step(200)
    call world%contacts(contacts)
    call world%report(report)
    call expect(size(contacts) == report%contact_count .and. size(contacts) == 1, 'two faces')
    call expect_close([sum(abs(contacts%force(2)))], [20000.0_real64], 1e-6_real64, 'the weight')
    ! The impact loss uses the mean velocity of the step: gravity adds g dt / 2 to 1 m/s.
    call expect_close([report%impact_loss], [20000 * gap], 11.0_real64, 'all that it had fallen with')
    call expect(all(abs(contacts%touched_at - 0.1_real64) < 1e-4_real64), 'the time of the touch')
  end subroutine falling_square

end program test_contacts_without_springs
