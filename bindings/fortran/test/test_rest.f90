! Relaxation, changes of settings, and the factor of safety.
program test_rest
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: slab_corners(2, 4) = reshape([real(real64) :: -4, -1, 4, -1, 4, 0, -4, 0], [2, 4])
  real(real64), parameter :: degree = acos(-1.0_real64) / 180, friction = 30 * degree
  real(real64), parameter :: density = 2000, stiffness = 1e8, gravity = 9.81_real64
  real(real64), parameter :: overlap = density * gravity / stiffness

  call settles()
  call changes()
  call slope()
  call ends_at_once()
  call refusals()
  call finish()

contains

  ! A square on a fixed slab that is inclined.
  subroutine make_slope(world, block, angle)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: block
    real(real64), intent(in) :: angle
    type(halfspace_shape) :: slab, square
    integer(int32) :: stone
    call slab%create_polygon(slab_corners)
    call square%create_polygon(corners)
    call world%create()
    call world%add_material(density, stone)
    call world%set_law(halfspace_law(normal_stiffness=stiffness, friction_angle=friction, &
                                     stiffness_kind=HS_STIFFNESS_PER_AREA))
    call world%add_block(slab, kind=HS_BLOCK_FIXED, &
                         pose=halfspace_pose(0.5_real64 * sin(angle), -0.5_real64 * cos(angle), angle))
    call world%add_block(square, block, &
                         pose=halfspace_pose(-0.5_real64 * sin(angle), 0.5_real64 * cos(angle), angle))
  end subroutine make_slope

  subroutine settles()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_balance) :: balance
    logical :: at_rest
    integer :: stat
    character(200) :: text
    call make_slope(world, block, 0.0_real64)
    call world%balance(balance)
    call expect_close([balance%mean], [1.0_real64], 1e-12_real64, 'it falls')
    call world%relax(at_rest, balance, max_steps=20)
    call expect(.not. at_rest .and. balance%steps == 20, '20 steps are not enough')
    call world%relax(at_rest, max_steps=20, stat=stat)
    call expect(.not. at_rest .and. stat == HS_OK, 'no error')
    call world%relax(max_steps=20, stat=stat, errmsg=text)
    call expect(stat == HS_NOTE_NOT_AT_REST, 'a note for who does not ask')
    call expect_text(text, 'still unbalanced')

    call world%relax(at_rest, balance, 1e-6_real64, HS_UNBALANCED_LARGEST)
    call expect(at_rest .and. balance%steps > 0, 'it comes to rest')
    call expect(balance%largest <= 1e-6_real64 .and. balance%mean <= 1e-6_real64, 'forces are balanced')
    call expect(balance%largest_force <= 2e-6_real64 * density * gravity, 'the largest that is not')
    call expect(balance%largest_force_block == block, 'on the only block that moves')
    call world%block_state(block, state)
    call expect_close(state%pose%position(1:2), [0.0_real64, 0.5_real64 - overlap], 1e-4_real64 * overlap, 'where')
    call expect(all(abs(state%velocity) <= 0) .and. all(abs(state%angular_velocity) <= 0), 'it is at rest')
    call world%balance(balance)
    call expect(balance%mean < 2e-6_real64 .and. balance%steps == 0, 'and stays there')

    call world%set_gravity([0.0_real64, -2 * gravity])
    call world%balance(balance)
    call expect(balance%largest > 0.1_real64, 'twice as heavy')
    call world%relax(measure=HS_UNBALANCED_MEAN, local_damping=0.8_real64, adaptive=.false., hold_bonds=.false.)
    call world%block_state(block, state)
    call expect_close(state%pose%position(2:2), [0.5_real64 - 2 * overlap], 1e-4_real64 * overlap, 'where then')
  end subroutine settles

  subroutine changes()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_world_report) :: report
    call make_slope(world, block, 0.0_real64)
    call world%set_pose(block, halfspace_pose(0.0_real64, 100.0_real64))
    call world%set_gravity([real(real64) :: 0, 0, 0])
    call world%set_velocity(block, [1.0_real64, 0.0_real64])
    call world%set_time_step(2.0_real64**(-10))
    call world%set_damping(mass_damping=2.0_real64)
    call world%step(1024)
    call world%block_state(block, state)
    call expect_close(state%velocity(1:2), [exp(-2.0_real64), 0.0_real64], 1e-3_real64, 'a second under damping')
    call world%set_damping()
    call world%step(1024)
    call world%block_state(block, state)
    call expect_close(state%velocity(1:1), [exp(-2.0_real64)], 1e-3_real64, 'and without')
    call world%report(report)
    call expect(abs(report%time_step - 2.0_real64**(-10)) <= 0, 'the step that was set')
    call world%set_time_step()
    call world%report(report)
    call expect_close([report%time_step], [0.5_real64 * report%stable_time_step], 1e-18_real64, 'the stable one')
  end subroutine changes

  ! The tangents of friction and slope have the ratio 1.586.
  subroutine slope()
    type(halfspace_world) :: world, fallen
    type(halfspace_block) :: block
    type(halfspace_block_state) :: here, there
    type(halfspace_strength_report) :: report
    integer(int8), allocatable :: before(:), after(:)
    call make_slope(world, block, 20 * degree)
    call world%relax()
    call world%save(before)
    call world%find_strength_factor(report, low=1.0_real64, high=3.0_real64, fallen=fallen)
    call world%save(after)
    call expect(all(before == after), 'the world stays as it is')
    call expect_close([report%factor], [tan(friction) / tan(20 * degree)], 0.005_real64, 'the factor of safety')
    call expect(report%stands_at_low == 1 .and. report%falls_at_high == 1 .and. report%trials > 5, 'it is found')
    call expect(report%low < report%factor .and. report%factor < report%high, 'the bracket')
    call expect(report%high - report%low <= 0.005_real64, 'is narrow')
    call world%block_state(block, here)
    call world%destroy()
    call expect(fallen%block_count() == 2, 'the fallen world outlives the other')
    call fallen%block_state(block, there)
    call expect(there%pose%position(1) < here%pose%position(1) - 0.01_real64, 'the block has slid')
    call fallen%step()
  end subroutine slope

  subroutine ends_at_once()
    type(halfspace_world) :: world, fallen
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_strength_report) :: report
    call make_slope(world, block, 20 * degree)
    call world%relax()
    call fallen%create()
    call world%find_strength_factor(report, high=1.5_real64, ratio=1e-4_real64, max_steps=20000, fallen=fallen)
    call expect(report%stands_at_low == 1 .and. report%falls_at_high == 0, 'it stands even at the highest factor')
    call expect(.not. fallen%exists(), 'no world has fallen')
    call world%find_strength_factor(report, low=1.7_real64, resolution=0.1_real64, max_displacement=0.05_real64)
    call expect(report%stands_at_low == 0 .and. report%trials == 1, 'it falls even at the lowest factor')

    call world%set_strength_factor(1.7_real64)
    call world%step(2000)
    call world%block_state(block, state)
    call expect(state%velocity(1) < -1e-3_real64, 'a weaker slope lets it slide')
    call world%set_strength_factor(1.0_real64)
    call world%relax()
  end subroutine ends_at_once

  subroutine refusals()
    type(halfspace_world) :: world, none, fallen
    type(halfspace_block) :: block
    type(halfspace_strength_report) :: report
    logical :: at_rest
    integer :: stat
    character(200) :: text
    call make_slope(world, block, 0.0_real64)
    call world%relax(at_rest, ratio=0.0_real64, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. .not. at_rest, 'nothing is quite at rest')
    call expect_text(text, 'def.ratio is 0')
    call world%set_gravity([1.0_real64], stat, text)
    call expect_text(text, 'gravity: has 1 values')
    call world%set_damping(1.0_real64, stat=stat, errmsg=text)
    call expect_text(text, 'local_damping is 1')
    call world%set_time_step(-1.0_real64, stat, text)
    call expect_text(text, 'time_step is -1')
    call world%set_strength_factor(0.0_real64, stat, text)
    call expect_text(text, 'factor is 0')
    call fallen%create()
    call world%find_strength_factor(report, low=6.0_real64, fallen=fallen, stat=stat, errmsg=text)
    call expect_text(text, 'def.high is 5')
    call expect(fallen%exists(), 'after an error nothing has changed')
    call none%relax(at_rest, stat=stat, errmsg=text)
    call expect_text(text, 'was not created')
    call none%find_strength_factor(report, fallen=fallen, stat=stat, errmsg=text)
    call expect(stat < 0 .and. fallen%exists(), 'no world has no strength')
  end subroutine refusals

end program test_rest
