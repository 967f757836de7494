! Motions and loads in time, against analysis: tables and nodes are counted from 1.
program test_actions
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, int64, real64
  implicit none

  real(real64), parameter :: density = 2000, square(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: at_once(1) = 0
  integer(int32), parameter :: all_nodes(4) = [1, 2, 3, 4], both_axes = HS_AXIS_X + HS_AXIS_Y

  call impulse()
  call prescribed_motion()
  call rotations_that_start_later()
  call held_axes_and_places()
  call all_blocks()
  call servo()
  call nodes_follow_tables()
  call goes_on_bit_for_bit()
  call refusals()
  call finish()

contains

  !> Without gravity, with steps of 0.01 s.
  subroutine make_world(world, time_step)
    type(halfspace_world), intent(inout) :: world
    real(real64), intent(in), optional :: time_step
    integer(int32) :: stone
    call world%create(gravity=[0.0_real64, 0.0_real64], time_step=0.01_real64)
    if (present(time_step)) call world%set_time_step(time_step)
    call world%add_material(density, stone)
  end subroutine make_world

  subroutine add_square(world, block, x, y, kind)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: block
    real(real64), intent(in) :: x, y
    integer(int32), intent(in), optional :: kind
    type(halfspace_shape) :: shape
    call shape%create_polygon(square)
    call world%add_block(shape, block, kind=kind, pose=halfspace_pose(x, y))
  end subroutine add_square

  !> A table of numbers, for all components.
  subroutine add_numbers(world, times, values, table)
    type(halfspace_world), intent(inout) :: world
    real(real64), intent(in) :: times(:), values(:)
    integer(int32), intent(out) :: table
    call world%add_table(times, spread(values, 1, 3), table)
  end subroutine add_numbers

  subroutine impulse()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    real(real64), parameter :: values(2, 4) = reshape([real(real64) :: 0, 0, 300, -100, 0, 50, 0, 0], [2, 4])
    integer(int32) :: pulse, in_rows, turning
    call make_world(world)
    call add_square(world, block, 0.0_real64, 0.0_real64)
    call world%add_table([0.0_real64, 0.013_real64, 0.013_real64, 0.05_real64], values, pulse)
    call world%add_table([0.0_real64, 0.013_real64, 0.013_real64, 0.05_real64], transpose(values), in_rows, rows=.true.)
    call add_numbers(world, [0.0_real64, 0.1_real64, 0.1_real64], [0.0_real64, 40.0_real64, 0.0_real64], turning)
    call expect(pulse == 1 .and. in_rows == 2 .and. turning == 3, 'tables are counted from 1')
    call world%add_action(HS_ACTION_FORCE, pulse, block)
    call world%add_action(HS_ACTION_FORCE, in_rows, block, scale=[1.0_real64, 0.0_real64])
    call world%add_action(HS_ACTION_TORQUE, turning, block)
    call world%step(20)
    call world%block_state(block, state)
    call expect_close(state%velocity(:2) * density, [2 * 0.013_real64 * 150, -0.013_real64 * 50 + 0.037_real64 * 25], &
                      1e-12_real64, 'momentum of both pulses')
    call expect_close(state%angular_velocity(3:) * density / 6, [2.0_real64], 1e-12_real64, 'angular momentum')
  end subroutine impulse

  subroutine prescribed_motion()
    type(halfspace_world) :: world
    type(halfspace_block) :: ground, other
    type(halfspace_block_state) :: state
    integer(int32) :: growing
    call make_world(world)
    call add_square(world, ground, 0.0_real64, 0.0_real64, HS_BLOCK_PRESCRIBED)
    call add_square(world, other, 5.0_real64, 0.0_real64, HS_BLOCK_PRESCRIBED)
    call add_numbers(world, [0.0_real64, 0.1_real64], [0.0_real64, 6.0_real64], growing)
    call world%add_action(HS_ACTION_ACCELERATION, growing, ground, scale=[1.0_real64, 0.0_real64])
    call world%step(10)
    call world%block_state(ground, state)
    call expect_close(state%velocity(:2), [0.3_real64, 0.0_real64], 1e-12_real64, 'the integral of the acceleration')
    call expect_close(state%pose%position(:1), [0.01_real64], 1e-12_real64, 'and that of the velocity')

    call world%end_actions(ground)
    call world%prescribe_velocities([other, ground], reshape([real(real64) :: 0, 0, 2, 1], [2, 2]), &
                                    reshape([real(real64) :: 0, 0, 0, 0, 0, 0.5_real64], [3, 2]))
    call world%step(10)
    call world%block_state(ground, state)
    call expect_close([state%pose%position(:2), state%angle], [0.21_real64, 0.1_real64, 0.05_real64], 1e-12_real64, &
                      'the prescribed velocity')
    call world%prescribe_velocities([ground], reshape([0.0_real64, 0.0_real64], [1, 2]), rows=.true.)
    call world%block_state(ground, state)
    call expect(all(state%velocity == 0) .and. state%angular_velocity(3) == 0.5_real64, 'the angular velocity stays')
  end subroutine prescribed_motion

  subroutine rotations_that_start_later()
    type(halfspace_world) :: world
    type(halfspace_block) :: wheel, arm
    type(halfspace_block_state) :: state
    integer(int32) :: jump
    call make_world(world)
    call add_square(world, wheel, 0.0_real64, 0.0_real64, HS_BLOCK_PRESCRIBED)
    call add_square(world, arm, 3.0_real64, 0.0_real64, HS_BLOCK_PRESCRIBED)
    call add_numbers(world, [0.0_real64, 0.0_real64], [0.0_real64, 1.0_real64], jump)
    call world%add_action(HS_ACTION_ANGULAR_VELOCITY, jump, wheel, start=0.05_real64)
    call world%add_action(HS_ACTION_ANGULAR_ACCELERATION, jump, arm, scale=[0.0_real64, 0.0_real64, 2.0_real64])
    call world%add_action(HS_ACTION_VELOCITY, jump, arm, start=0.08_real64)
    call world%step(10)
    call world%block_state(wheel, state)
    call expect_close([state%angle], [0.05_real64], 1e-12_real64, 'a rotation of half the time')
    call world%block_state(arm, state)
    call expect_close([state%angle, state%pose%position(2)], [0.01_real64, 0.02_real64], 1e-12_real64, &
                      'an accelerated rotation, and a motion that begins late')
  end subroutine rotations_that_start_later

  subroutine held_axes_and_places()
    type(halfspace_world) :: world
    type(halfspace_block) :: block, other
    type(halfspace_block_state) :: state
    integer(int32) :: force
    call make_world(world)
    call add_square(world, block, 0.0_real64, 0.0_real64)
    call world%add_table(at_once, reshape([5.0_real64, 7.0_real64], [2, 1]), force)
    call world%hold_block(block, HS_AXIS_X + HS_AXIS_ROTATION)
    call world%add_action(HS_ACTION_FORCE, force, block, at=[0.5_real64, 0.0_real64])
    call world%step(10)
    call world%block_state(block, state)
    call expect(state%velocity(1) == 0 .and. state%angular_velocity(3) == 0, 'held axes stay')
    call expect_close(state%velocity(2:2), [7 / density * 0.1_real64], 1e-15_real64, 'the free axis')
    call world%hold_block(block, 0)
    call world%step(1)
    call world%block_state(block, state)
    call expect_close(state%angular_velocity(3:), [0.5_real64 * 7 / (density / 6) * 0.01_real64], 1e-9_real64, &
                      'the freed block rotates')

    call add_square(world, other, 9.0_real64, 0.0_real64)
    call world%add_action(HS_ACTION_FORCE, force, other)
    call world%add_action(HS_ACTION_FORCE, force, other, at=[9.0_real64, -0.25_real64], place=HS_PLACE_FIXED)
    call world%step(1)
    call world%block_state(other, state)
    call expect_close(state%angular_velocity(3:), [0.25_real64 * 5 / (density / 6) * 0.01_real64], 1e-7_real64, &
                      'the arm of a force at a point in space')
    call expect_close(state%velocity(:1), [2 * 5 / density * 0.01_real64], 1e-15_real64, 'loads add up')
  end subroutine held_axes_and_places

  subroutine all_blocks()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    integer(int32) :: wind
    call make_world(world)
    call add_square(world, block, 0.0_real64, 0.0_real64)
    call world%add_table(at_once, reshape([3.0_real64, -1.0_real64], [2, 1]), wind)
    call world%add_action(HS_ACTION_ACCELERATION, wind)
    call world%step(10)
    call world%end_actions()
    call world%step(10)
    call world%block_state(block, state)
    call expect_close(state%velocity(:2), [0.3_real64, -0.1_real64], 1e-12_real64, 'a body force until it ends')
  end subroutine all_blocks

  subroutine servo()
    type(halfspace_world) :: world
    type(halfspace_block) :: base, middle, press
    type(halfspace_contact), allocatable :: contacts(:)
    integer(int32) :: force
    call make_world(world, 1e-4_real64)
    call world%set_damping(0.3_real64, 0.0_real64)
    call world%set_law(halfspace_law(1e8_real64, normal_damping=0.3_real64, stiffness_kind=HS_STIFFNESS_PER_AREA))
    call add_square(world, base, 0.0_real64, 0.0_real64, HS_BLOCK_FIXED)
    call add_square(world, middle, 0.0_real64, 1.0_real64)
    call add_square(world, press, 0.0_real64, 2.0_real64, HS_BLOCK_PRESCRIBED)
    call add_numbers(world, at_once, [1e5_real64], force)
    call world%add_action(HS_ACTION_SERVO, force, press, scale=[0.0_real64, -1.0_real64], max_speed=1.0_real64)
    call world%step(10000)
    call world%contacts(contacts)
    call expect_close(contacts%normal_force, [1e5_real64, 1e5_real64], 1e2_real64, 'the force of a servo')
  end subroutine servo

  subroutine add_body(world, body)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_body), intent(out) :: body
    type(halfspace_mesh) :: mesh
    call world%set_elasticity(1, halfspace_elasticity(1e6_real64))
    call mesh%create(square, HS_CELL_QUAD, reshape(all_nodes, [4, 1]))
    call world%add_mesh(mesh, body)
  end subroutine add_body

  subroutine nodes_follow_tables()
    type(halfspace_world) :: world
    type(halfspace_world_report) :: report
    type(halfspace_body) :: body
    type(halfspace_body_state) :: state
    real(real64) :: from(2, 4), to(2, 4)
    real(real64), parameter :: shares(4, 2) = &
      reshape([real(real64) :: 1, 1, 0, 0, 0, 0, 0.5_real64, 0.5_real64], [4, 2])
    integer(int32) :: pulse, moved
    call make_world(world, 1e-3_real64)
    call add_body(world, body)
    call add_numbers(world, [0.0_real64, 0.01_real64, 0.01_real64], [0.0_real64, 80.0_real64, 0.0_real64], pulse)
    call world%add_node_action(body, [1, 4, 2, 3], HS_ACTION_FORCE, pulse, shares, rows=.true.)
    call world%step(20)
    call world%body_state(body, state)
    call expect_close(state%momentum(:2), [0.8_real64, 0.4_real64], 1e-10_real64, 'the momentum of a traction')

    call world%end_node_actions(body)
    call world%hold_nodes(body, all_nodes, both_axes)
    call world%add_table([0.0_real64, 1.0_real64], reshape([real(real64) :: 0, 2, 4, 2], [2, 2]), moved)
    call world%report(report)
    call world%node_positions(body, from)
    call world%add_node_action(body, all_nodes, HS_ACTION_VELOCITY, moved, spread([1.0_real64, 1.0_real64], 2, 4), &
                               start=report%time)
    call world%step(100)
    call world%node_positions(body, to)
    call expect_close(to(1, :) - from(1, :), spread(0.02_real64, 1, 4), 1e-10_real64, 'nodes move along x')
    call expect_close(to(2, :) - from(2, :), spread(0.2_real64, 1, 4), 1e-10_real64, 'and along y')
  end subroutine nodes_follow_tables

  subroutine goes_on_bit_for_bit()
    type(halfspace_world) :: world, restored
    type(halfspace_block) :: block
    type(halfspace_block_state) :: expected, got
    integer(int8), allocatable :: bytes(:)
    integer(int32) :: table
    call make_world(world)
    call add_square(world, block, 0.0_real64, 0.0_real64)
    call add_numbers(world, [0.0_real64, 1.0_real64], [1.0_real64, 5.0_real64], table)
    call world%add_action(HS_ACTION_FORCE, table, block, at=[0.1_real64, 0.2_real64])
    call world%hold_block(block, HS_AXIS_Y)
    call world%step(7)
    call world%save(bytes)
    call restored%restore(bytes)
    call world%step(7)
    call restored%step(7)
    call world%block_state(block, expected)
    call restored%block_state(block, got)
    call expect(all(got%velocity == expected%velocity) .and. got%velocity(1) > 0, 'a restored world keeps its actions')
    call expect(got%angle == expected%angle .and. got%angle < 0, 'and their places')
  end subroutine goes_on_bit_for_bit

  subroutine refusals()
    type(halfspace_world) :: world
    type(halfspace_block) :: block, nothing
    type(halfspace_body) :: body
    real(real64), parameter :: one(2, 1) = 1
    integer(int32) :: table, no_table
    integer :: stat
    character(200) :: text
    call make_world(world)
    call add_square(world, block, 0.0_real64, 0.0_real64)
    call add_body(world, body)
    call add_numbers(world, [0.0_real64, 1.0_real64], [0.0_real64, 1.0_real64], table)
    call world%add_action(HS_ACTION_VELOCITY, table, block, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_STATE, 'is not prescribed')
    call world%add_action(HS_ACTION_FORCE, table, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'only HS_ACTION_ACCELERATION')
    call world%add_action(HS_ACTION_ACCELERATION, table, nothing, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'block: is none')
    call world%end_actions(nothing, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'block: is none')
    call world%add_action(HS_ACTION_FORCE, 4, block, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_STALE_ID, 'def.table is 3')
    call world%add_action(HS_ACTION_FORCE, table, block, scale=[1.0_real64], stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'scale: has 1 values')
    call world%add_action(HS_ACTION_FORCE, table, block, at=[1.0_real64], stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'at: has 1 values')
    call world%add_action(HS_ACTION_SERVO, table, block, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'def.max_speed is 0')
    call world%add_table([1.0_real64, 0.0_real64], spread(one(:, 1), 2, 2), no_table, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'times[1] is 0')
    call expect(no_table == 0, 'no table')
    call world%add_table([1.0_real64, 2.0_real64], one, no_table, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'times: has 2 values; values has 1 vectors')
    call world%add_table([1.0_real64], reshape([1.0_real64], [1, 1]), no_table, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'values: extent 1 is 1')
    call world%add_node_action(body, [1, 2], HS_ACTION_FORCE, table, one, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'nodes: has 2 values; scales has 1 vectors')
    call world%add_node_action(body, [5], HS_ACTION_FORCE, table, one, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'nodes[0] is 4; the body has 4 nodes')
    call world%hold_block(block, HS_AXIS_Z, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'axes is 4')
    call world%prescribe_velocities([block], one, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_STATE, 'is not prescribed')
    call world%prescribe_velocities([block, block], one, stat=stat, errmsg=text)
    call expect_refusal(stat, text, HS_ERROR_ARGUMENT, 'blocks: has 2 values; linear has 1 vectors')
    call world%remove_body(body)
    call world%end_node_actions(body, stat=stat)
    call expect(stat == HS_ERROR_STALE_ID, 'a body that is gone')
  end subroutine refusals

  subroutine expect_refusal(stat, text, status, part)
    integer, intent(in) :: stat, status
    character(*), intent(in) :: text, part
    call expect(stat == status, 'the status of: '//part)
    call expect_text(text, part)
  end subroutine expect_refusal

end program test_actions
