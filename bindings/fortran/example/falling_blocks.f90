! A complete world: a pile of squares falls onto a floor and comes to rest.
program falling_blocks
  use halfspace
  use, intrinsic :: iso_fortran_env, only: dp => real64
  implicit none

  type(halfspace_world) :: world
  type(halfspace_shape) :: square, floor
  type(halfspace_world_report) :: report
  integer :: row, column, stone

  call square%create_polygon(reshape([real(dp) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4]))
  call floor%create_polygon(reshape([real(dp) :: -20, -1, 20, -1, 20, 0, -20, 0], [2, 4]))

  call world%create(local_damping=0.3_dp)
  call world%set_law(halfspace_law(normal_stiffness=1e7_dp, shear_stiffness=1e7_dp, friction_angle=0.5_dp))
  call world%add_material(density=2000.0_dp, material=stone)
  call world%add_block(floor, kind=HS_BLOCK_FIXED)
  do row = 1, 5
    do column = 1, 6 - row
      call world%add_block(square, pose=halfspace_pose(1.1_dp * column + 0.55_dp * row, 1.2_dp * row))
    end do
  end do

  print '(a)', '  time    fastest   contacts      kinetic    friction loss'
  do
    call world%step(200)
    call world%report(report)
    print '(f6.2, es12.2, i9, 2es14.3)', report%time, report%largest_speed, report%contact_count, &
      report%energy%kinetic, report%energy%friction_loss
    if (report%largest_speed < 1e-3_dp .or. report%time > 20) exit
  end do
end program falling_blocks
