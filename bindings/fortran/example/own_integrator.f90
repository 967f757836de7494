! A DEM driver with its own arrays and its own integrator; the library computes contacts and forces only. A block of 5 x
! 4 m slides down a slope of 30 degrees, friction angle 15 degrees (Wang et al. 2021, section 4.1): s = 1/2 (g sin - g
! cos tan(phi)) t^2. Exits with an error if the error of the distance is more than 0.1 %.
program own_integrator
  use halfspace
  use, intrinsic :: iso_fortran_env, only: dp => real64
  implicit none

  real(dp), parameter :: degree = acos(-1.0_dp) / 180, gravity = 9.81_dp
  real(dp), parameter :: slope = 30 * degree, friction = 15 * degree, density = 2500, stiffness = 1e10_dp
  real(dp), parameter :: width = 5, height = 4, time_step = 1e-5_dp, duration = 5
  real(dp), parameter :: downhill(2) = [cos(slope), -sin(slope)], upward(2) = [sin(slope), cos(slope)]
  integer, parameter :: plane = 1, slider = 2, n = 2

  ! The driver's own state.
  real(dp) :: position(2, n), velocity(2, n), angle(n), spin(3, n), mass(n), inertia(n)
  real(dp) :: force(2, n), torque(3, n), start(2)
  real(dp) :: distance, exact, acceleration
  type(halfspace_world) :: world
  type(halfspace_block) :: blocks(n)
  integer :: step

  call make_blocks()
  call contact_forces(0.0_dp)
  ! Friction acts from the start, as if the block had been sliding before.
  call world%set_shear_force(blocks(plane), blocks(slider), -tan(friction) * weight_on_slope() * downhill)
  call contact_forces(0.0_dp)
  start = position(:, slider)

  ! Velocity Verlet.
  do step = 1, nint(duration / time_step)
    call kick(time_step / 2)
    position(:, slider) = position(:, slider) + time_step * velocity(:, slider)
    angle(slider) = angle(slider) + time_step * spin(3, slider)
    call contact_forces(time_step)
    call kick(time_step / 2)
  end do

  distance = dot_product(position(:, slider) - start, downhill)
  acceleration = gravity * (sin(slope) - cos(slope) * tan(friction))
  exact = acceleration * duration**2 / 2
  print '("slid ", f0.6, " m in ", f0.1, " s; exact: ", f0.6, " m; relative error ", es8.1)', &
    distance, duration, exact, distance / exact - 1
  if (.not. abs(distance / exact - 1) <= 1e-3_dp) error stop 'the block did not slide as the formula says'

contains

  subroutine make_blocks()
    type(halfspace_shape) :: shapes(n)
    type(halfspace_shape_properties) :: properties
    integer :: i, stone
    call shapes(plane)%create_polygon(rectangle(300.0_dp, 1.0_dp))
    call shapes(slider)%create_polygon(rectangle(width, height))
    do i = 1, n
      call shapes(i)%properties(properties)
      mass(i) = density * properties%volume
      inertia(i) = density * (properties%second_moment(1) + properties%second_moment(2))
    end do

    ! The block starts in equilibrium: the springs of its overlap carry its weight.
    position(:, plane) = -0.5_dp * upward
    position(:, slider) = (height / 2 - weight_on_slope() / stiffness) * upward
    angle = -slope
    velocity = 0
    spin = 0

    call world%create(gravity=[0.0_dp, 0.0_dp])  ! the driver has its own
    call world%set_law(halfspace_law(normal_stiffness=stiffness, shear_stiffness=stiffness, friction_angle=friction))
    call world%add_material(density, stone)
    call world%add_block(shapes(plane), blocks(plane), kind=HS_BLOCK_FIXED)
    call world%add_block(shapes(slider), blocks(slider))
  end subroutine make_blocks

  function rectangle(along, across) result(corners)
    real(dp), intent(in) :: along, across
    real(dp) :: corners(2, 4)
    corners(1, :) = along / 2 * [-1, 1, 1, -1]
    corners(2, :) = across / 2 * [-1, -1, 1, 1]
  end function rectangle

  real(dp) function weight_on_slope()
    weight_on_slope = mass(slider) * gravity * cos(slope)
  end function weight_on_slope

  ! The calls of the library: force and torque on every block at the current poses.
  subroutine contact_forces(elapsed)
    real(dp), intent(in) :: elapsed
    call world%set_poses(halfspace_pose(position(1, :), position(2, :), angle))
    call world%set_velocities(velocity, spin)
    call world%detect()
    call world%forces(elapsed, force, torque)
  end subroutine contact_forces

  subroutine kick(duration)
    real(dp), intent(in) :: duration
    velocity(:, slider) = velocity(:, slider) + duration * (force(:, slider) / mass(slider) - [0.0_dp, gravity])
    spin(3, slider) = spin(3, slider) + duration * torque(3, slider) / inertia(slider)
  end subroutine kick

end program own_integrator
