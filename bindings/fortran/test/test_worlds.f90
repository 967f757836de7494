! Worlds: a block at rest and in free fall compared with formulas, stages, snapshots, ids of blocks, materials from 1.
program test_worlds
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, int64, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5], &
                                                     [2, 4])
  real(real64), parameter :: ground(2, 4) = reshape([real(real64) :: -4, -1, 4, -1, 4, 0, -4, 0], [2, 4])
  real(real64), parameter :: time_step = 1e-3_real64, density = 2000

  call free_fall()
  call pressed_block()
  call materials_and_laws()
  call names_of_blocks()
  call snapshot()
  call in_space()
  call finish()

contains

  subroutine make_scene(world, block, height)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: block
    real(real64), intent(in) :: height
    type(halfspace_shape) :: square, floor
    integer(int32) :: stone
    call square%create_polygon(corners)
    call floor%create_polygon(ground)
    call world%create(time_step=time_step)
    call world%set_law(halfspace_law(normal_stiffness=1e7_real64, shear_stiffness=1e7_real64, &
                                     friction_angle=0.5_real64))
    call world%add_material(density, stone)
    call world%add_block(floor, kind=HS_BLOCK_FIXED)
    call world%add_block(square, block, material=stone, pose=halfspace_pose(0.25_real64, height))
  end subroutine make_scene

  ! Constant acceleration is exact in velocity Verlet, up to rounding.
  subroutine free_fall()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_world_report) :: report
    real(real64) :: vertices(2, 4)
    call make_scene(world, block, 5.0_real64)
    call world%set_velocity(block, [1.0_real64, 0.0_real64], [2.0_real64])
    call world%step(500)
    call world%block_state(block, state)
    call expect_close(state%pose%position, [0.75_real64, 5 - 9.81_real64 / 8, 0.0_real64], 1e-12_real64, 'position')
    call expect_close(state%velocity, [1.0_real64, -9.81_real64 / 2, 0.0_real64], 1e-12_real64, 'velocity')
    call expect_close([state%angle, halfspace_angle(state%pose)], [1.0_real64, 1.0_real64], 1e-12_real64, 'angle')
    call expect(state%material == 1 .and. state%kind == HS_BLOCK_RIGID, 'material and kind')
    call expect_close([state%mass], [density], 1e-12_real64, 'mass')
    call world%block_vertices(block, vertices)
    call expect_close(sum(vertices, 2) / 4, state%pose%position(1:2), 1e-14_real64, 'vertices where the block is')
    call world%step()
    call world%report(report)
    call expect(report%steps == 501 .and. report%block_count == 2 .and. report%contact_count == 0, 'the report')
    call expect(abs(report%energy%residual) <= 1e-9_real64 * report%energy%kinetic, 'energy')
  end subroutine free_fall

  ! With an overlap of 1/1024 m and a stiffness of 1e7 N/m, the force on a block is 1e7 / 1024 N, at its centroid.
  subroutine pressed_block()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_contact), allocatable :: contacts(:)
    type(halfspace_block), allocatable :: names(:)
    real(real64) :: force(2, 2), torque(3, 2)
    integer(int64) :: touching
    integer :: stat
    character(200) :: text
    call make_scene(world, block, 0.5_real64 - 1.0_real64 / 1024)
    call world%forces(0.0_real64, force, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_STATE, 'forces before detection')
    call expect_text(text, 'hs_world_forces')
    call world%detect(touching)
    call expect(touching == 1, 'the block touches the floor')
    call world%forces(0.0_real64, force, torque)
    call expect_close(force(:, 2), [0.0_real64, 1e7_real64 / 1024], 1e-8_real64, 'force on the block')
    call expect_close(force(:, 1), [0.0_real64, -1e7_real64 / 1024], 1e-8_real64, 'force on the floor')
    call expect_close(torque(:, 2), [real(real64) :: 0, 0, 0], 1e-8_real64, 'no torque on the block')
    call world%contacts(contacts)
    call world%blocks(names)
    call expect(size(contacts) == 1, 'one contact')
    call expect(contacts(1)%block_a == names(1) .and. contacts(1)%block_b == block, 'between floor and block')
    call expect(contacts(1)%block_a /= block, 'which are not the same')
    call expect_close([contacts(1)%normal_force], [1e7_real64 / 1024], 1e-8_real64, 'its normal force')
    call expect(contacts(1)%feature_a >= 1 .and. contacts(1)%feature_a <= 4, 'its feature, counted from 1')
    call world%set_shear_force(names(1), block, [500.0_real64, 0.0_real64])
    call world%forces(0.0_real64, force)
    call expect_close(force(:, 2), [500.0_real64, 1e7_real64 / 1024], 1e-8_real64, &
                      'force with a preloaded shear spring')
  end subroutine pressed_block

  subroutine materials_and_laws()
    type(halfspace_world) :: world
    type(halfspace_law) :: law, soft
    integer(int32) :: stone, wood
    integer :: stat
    character(200) :: text
    law = halfspace_law()
    soft = halfspace_law(normal_stiffness=5e5_real64, stiffness_kind=HS_STIFFNESS_PER_AREA)
    call expect(law%normal_stiffness == 1e9_real64 .and. law%stiffness_kind == HS_STIFFNESS_PER_CONTACT, &
                'defaults of a law')
    call expect(soft%normal_stiffness == 5e5_real64 .and. soft%shear_stiffness == law%shear_stiffness, &
                'what is given alone')
    call world%create()
    call world%add_material(2500.0_real64, stone)
    call world%add_material(600.0_real64, wood)
    call expect(stone == 1 .and. wood == 2, 'materials are counted from 1')
    call world%set_law(law)
    call world%set_law(soft, stone, wood)
    call world%set_law(soft, stone, 3, stat, text)
    call expect(stat == HS_ERROR_STALE_ID, 'there is no third material')
    call world%set_law(halfspace_law(friction_angle=2.0_real64), stat=stat, errmsg=text)
    call expect_text(text, 'law.friction_angle is 2')
  end subroutine materials_and_laws

  subroutine names_of_blocks()
    type(halfspace_world) :: world
    type(halfspace_block) :: block, none
    type(halfspace_block), allocatable :: names(:)
    type(halfspace_block_state) :: state
    type(halfspace_pose) :: poses(3)
    integer :: stat
    character(200) :: text
    call make_scene(world, block, 3.0_real64)
    call world%poses(poses(1:3:2))
    call expect(poses(3)%position(1) == 0.25_real64 .and. poses(3)%position(2) == 3, 'poses of a section with gaps')
    call world%blocks(names)
    call expect(size(names) == 2, 'two names')
    call expect(world%block_count() == 2, 'two blocks')
    call expect(names(2) == block .and. all(names /= none), 'their names')
    call world%remove_block(block)
    call expect(world%block_count() == 1, 'one is left')
    call world%block_state(block, state, stat, text)
    call expect(stat == HS_ERROR_STALE_ID, 'the name is stale')
    call expect_text(text, 'hs_world_get_block_state')
    call world%remove_block(none, stat)
    call expect(stat < 0, 'no block is not a block')
    call world%set_velocity(names(1), [1.0_real64, 0.0_real64], stat=stat)
    call expect(stat == HS_ERROR_STATE, 'a fixed block takes no velocity')
  end subroutine names_of_blocks

  subroutine snapshot()
    type(halfspace_world) :: world, other
    type(halfspace_block) :: block
    type(halfspace_block_state) :: here, there
    integer(int8), allocatable :: bytes(:)
    integer :: stat
    character(200) :: text
    call make_scene(world, block, 0.6_real64)
    call world%step(100)
    call world%save(bytes)
    call other%restore(bytes)
    call world%step(300)
    call other%step(300)
    call world%block_state(block, here)
    call other%block_state(block, there)
    call expect(all(here%pose%position == there%pose%position) .and. all(here%velocity == there%velocity), &
                'a restored world goes on bit for bit')
    call other%restore(bytes(:20), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_FORMAT .and. other%exists(), 'a torn snapshot is refused, and the world stays')
    call expect_text(text, 'hs_world_restore')
  end subroutine snapshot

  ! A cube on a floor: the sum of the forces balances its weight, here with an overlap of 2^-10 and the same stiffness.
  subroutine in_space()
    type(halfspace_world) :: world
    type(halfspace_shape) :: cube
    type(halfspace_block) :: block
    real(real64) :: box(3, 8), force(3, 2), flat(2, 2)
    integer(int32) :: stone
    integer :: i, stat
    character(200) :: text
    do i = 0, 7
      box(:, i + 1) = real([iand(i, 1), iand(i / 2, 1), i / 4], real64)
    end do
    call cube%create_polyhedron_hull(box)
    call world%create(dimension=3, gravity=[real(real64) :: 0, 0, -9.81], time_step=time_step)
    call world%set_law(halfspace_law(normal_stiffness=1e7_real64))
    call world%add_material(density, stone)
    call world%add_block(cube, kind=HS_BLOCK_FIXED)
    call world%add_block(cube, block)
    call world%set_pose(block, halfspace_pose([0.5_real64, 0.5_real64, 1.5_real64 - 1.0_real64 / 1024], &
                                              [real(real64) :: 0, 0, 0, 1]))
    call world%detect()
    call world%forces(0.0_real64, force)
    call expect_close(force(:, 2), [0.0_real64, 0.0_real64, 1e7_real64 / 1024], 1e-8_real64, 'force on the cube')
    call world%forces(0.0_real64, flat, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'forces in space have three components')
    call expect_text(text, 'forces.z is NULL')
  end subroutine in_space

end program test_worlds
