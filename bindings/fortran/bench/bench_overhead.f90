! Overhead of the modules relative to calls from C: step, detection and forces of 4 blocks, where the call dominates,
! and of 1e5, and one pair. Passes alternate, and the minimum time of each is used; the ratio of C to itself shows the
! scatter. No timing decides. --quick: a smaller world.
program bench_overhead
  use halfspace
  use halfspace_c, only: hs_mutable_view
  use halfspace_views, only: mutable_view
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t, c_ptr
  use, intrinsic :: iso_fortran_env, only: dp => real64
  implicit none

  interface
    function thread_seconds() bind(c)
      import
      real(c_double) :: thread_seconds
    end function thread_seconds

    function seconds_of_step(world, calls) bind(c)
      import
      type(c_ptr), value :: world
      integer(c_int64_t), value :: calls
      real(c_double) :: seconds_of_step
    end function seconds_of_step

    function seconds_of_detect(world, calls, poses, count) bind(c)
      import
      type(c_ptr), value :: world
      integer(c_int64_t), value :: calls, count
      type(halfspace_pose), intent(in) :: poses(*)
      real(c_double) :: seconds_of_detect
    end function seconds_of_detect

    function seconds_of_forces(world, calls, forces, torques) bind(c)
      import
      type(c_ptr), value :: world
      integer(c_int64_t), value :: calls
      type(hs_mutable_view), value :: forces, torques
      real(c_double) :: seconds_of_forces
    end function seconds_of_forces

    function seconds_of_pairs(shape, lower, uppers, count, cache, contact) bind(c)
      import
      type(c_ptr), value :: shape
      type(halfspace_pose), intent(in) :: lower, uppers(*)
      integer(c_int64_t), value :: count
      type(halfspace_pair_cache), intent(inout) :: cache
      type(halfspace_contact), intent(inout) :: contact
      real(c_double) :: seconds_of_pairs
    end function seconds_of_pairs
  end interface

  type(halfspace_shape) :: square
  integer :: passes, pair_calls
  logical :: quick
  character(20) :: option

  call get_command_argument(1, option)
  quick = option == '--quick'
  passes = merge(2, 40, quick)
  pair_calls = merge(1000, 10000, quick)

  call square%create_polygon(reshape([real(dp) :: -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5], [2, 4]))
  call compare_world(columns=2, rows=2, calls=merge(10, 20000, quick))
  call compare_world(columns=merge(10, 1000, quick), rows=merge(10, 100, quick), calls=1)
  call compare_pairs()

contains

  ! Columns of squares on one floor.
  subroutine make_world(columns, rows, world)
    integer, intent(in) :: columns, rows
    type(halfspace_world), intent(inout) :: world
    type(halfspace_shape) :: floor
    integer :: row, column, stone
    real(dp) :: corners(2, 4)
    corners(1, :) = 2 * columns * [real(dp) :: -1, 1, 1, -1]
    corners(2, :) = [real(dp) :: -1, -1, 0, 0]
    call floor%create_polygon(corners)
    call world%create(time_step=1e-4_dp)
    call world%set_law(halfspace_law(normal_stiffness=1e8_dp, shear_stiffness=1e8_dp, friction_angle=0.5_dp))
    call world%add_material(2000.0_dp, stone)
    call world%add_block(floor, kind=HS_BLOCK_FIXED)
    do column = 1, columns
      do row = 1, rows
        call world%add_block(square, pose=halfspace_pose(1.25_dp * column, 0.999_dp * row - 0.5_dp))
      end do
    end do
  end subroutine make_world

  !> Times of a pass with the given number of calls of each kind.
  subroutine compare_world(columns, rows, calls)
    integer, intent(in) :: columns, rows, calls
    type(halfspace_world) :: world
    type(halfspace_pose), allocatable :: poses(:)
    real(dp), allocatable :: force(:,:), torque(:,:)
    real(dp) :: in_c(3), in_c_again(3), in_fortran(3)
    integer :: pass, n
    call make_world(columns, rows, world)
    n = int(world%block_count())
    allocate (poses(n), force(3, n), torque(3, n))
    call world%poses(poses)
    in_c = huge(in_c)
    in_c_again = huge(in_c_again)
    in_fortran = huge(in_fortran)
    ! The order changes, as the first one warms the caches for the next.
    do pass = 1, passes
      if (mod(pass, 2) == 0) in_c = min(in_c, pass_in_c(world, calls, poses, force, torque))
      in_fortran = min(in_fortran, pass_in_fortran(world, calls, poses, force, torque))
      in_c_again = min(in_c_again, pass_in_c(world, calls, poses, force, torque))
      if (mod(pass, 2) == 1) in_c = min(in_c, pass_in_c(world, calls, poses, force, torque))
    end do
    print '(i0, " blocks", t20, "C, us  C again / C  Fortran / C  over C, us")', n
    call tell('step', in_c(1), in_c_again(1), in_fortran(1))
    call tell('detect', in_c(2), in_c_again(2), in_fortran(2))
    call tell('forces', in_c(3), in_c_again(3), in_fortran(3))
  end subroutine compare_world

  !> Seconds of a step, of setting poses and detection there, and of forces.
  function pass_in_fortran(world, calls, poses, force, torque) result(seconds)
    type(halfspace_world), intent(inout) :: world
    integer, intent(in) :: calls
    type(halfspace_pose), intent(inout), contiguous :: poses(:)
    real(dp), intent(inout) :: force(:,:), torque(:,:)
    real(dp) :: seconds(3), start
    integer :: call_number
    start = thread_seconds()
    do call_number = 1, calls
      call world%step(1)
    end do
    seconds(1) = (thread_seconds() - start) / calls
    start = thread_seconds()
    do call_number = 1, calls
      call world%set_poses(poses)
      call world%detect()
    end do
    seconds(2) = (thread_seconds() - start) / calls
    start = thread_seconds()
    do call_number = 1, calls
      call world%forces(0.0_dp, force, torque)
    end do
    seconds(3) = (thread_seconds() - start) / calls
  end function pass_in_fortran

  function pass_in_c(world, calls, poses, force, torque) result(seconds)
    type(halfspace_world), intent(inout) :: world
    integer, intent(in) :: calls
    type(halfspace_pose), intent(inout), contiguous :: poses(:)
    real(dp), intent(inout) :: force(:,:), torque(:,:)
    real(dp) :: seconds(3)
    integer(c_int64_t) :: count
    count = int(calls, c_int64_t)
    seconds(1) = seconds_of_step(world%c_handle(), count)
    seconds(2) = seconds_of_detect(world%c_handle(), count, poses, size(poses, kind=c_int64_t))
    seconds(3) = seconds_of_forces(world%c_handle(), count, mutable_view(force), mutable_view(torque))
    seconds = seconds / calls
  end function pass_in_c

  subroutine tell(what, in_c, in_c_again, in_fortran)
    character(*), intent(in) :: what
    real(dp), intent(in) :: in_c, in_c_again, in_fortran
    print '(a8, f17.3, f13.4, f13.4, sp, f12.3)', what, 1e6_dp * in_c, in_c_again / in_c, in_fortran / in_c, &
      1e6_dp * (in_fortran - in_c)
  end subroutine tell

  subroutine compare_pairs()
    call compare_pair('apart, by the proof in the cache', halfspace_pose(0.0_dp, 2.0_dp))
    call compare_pair('in contact', halfspace_pose(0.25_dp, 0.875_dp))
  end subroutine compare_pairs

  subroutine compare_pair(what, upper)
    character(*), intent(in) :: what
    type(halfspace_pose), intent(in) :: upper
    type(halfspace_pose) :: lower, uppers(pair_calls)
    type(halfspace_contact) :: contact
    type(halfspace_pair_cache) :: cache, cache_in_c
    real(dp) :: in_c, in_fortran, start
    integer :: pass, call_number
    lower = halfspace_pose(0.0_dp, 0.0_dp)
    uppers = upper
    in_c = huge(in_c)
    in_fortran = huge(in_fortran)
    do pass = 1, passes
      in_c = min(in_c, &
        seconds_of_pairs(square%c_handle(), lower, uppers, int(pair_calls, c_int64_t), cache_in_c, contact))
      start = thread_seconds()
      do call_number = 1, pair_calls
        call halfspace_detect_pair(square, lower, square, uppers(call_number), contact, cache)
      end do
      in_fortran = min(in_fortran, thread_seconds() - start)
    end do
    print '("one pair, ", a, ": C ", f6.1, " ns  Fortran ", f6.1, " ns  over C ", f6.1, " ns")', what, &
      1e9_dp * in_c / pair_calls, 1e9_dp * in_fortran / pair_calls, 1e9_dp * (in_fortran - in_c) / pair_calls
  end subroutine compare_pair

end program bench_overhead
