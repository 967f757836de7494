! Bonds: they hold below their strength and fail above it; bonds and their points are counted from 1.
program test_bonds
  use checking
  use halfspace
  use halfspace_c, only: hs_bond, hs_bond_event
  use, intrinsic :: iso_fortran_env, only: int32, int64, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: strength = 1e5, stiffness = 1e9, nothing(2) = 0
  real(real64), parameter :: one(1) = 1

  call definitions()
  call below_and_above()
  call held()
  call by_shear()
  call materials()
  call refusals()
  call finish()

contains

  subroutine make_squares(world, lower, upper)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: lower, upper
    type(halfspace_shape) :: square
    integer(int32) :: stone
    call square%create_polygon(corners)
    call world%create(gravity=nothing)
    call world%add_material(2000.0_real64, stone)
    call world%add_block(square, lower, kind=HS_BLOCK_FIXED)
    call world%add_block(square, upper, pose=halfspace_pose(0.5_real64, 1.5_real64))
  end subroutine make_squares

  type(halfspace_bond) function mortar()
    mortar = halfspace_bond(normal_stiffness=stiffness, tensile_strength=strength, cohesion=strength, &
                            friction_angle=0.5_real64)
  end function mortar

  ! A force is applied, the world relaxes with suspended failure of bonds, then failure is resumed.
  subroutine pull(world, block, force)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(in) :: block
    real(real64), intent(in) :: force
    type(halfspace_bond_state), allocatable :: bonds(:)
    call world%set_applied_force(block, [0.0_real64, force])
    call world%relax(ratio=1e-8_real64)
    call world%bonds(bonds)
    call expect_close([bonds(1)%normal_force, bonds(1)%shear_force], [force, 0.0_real64, 0.0_real64, 0.0_real64], &
                      1e-6_real64 * force, 'the force that it bears')
    call world%step(10)
  end subroutine pull

  subroutine definitions()
    type(halfspace_bond) :: bond
    call expect(storage_size(hs_bond()) == storage_size(halfspace_bond_state()), 'size of a state')
    call expect(storage_size(hs_bond_event()) == storage_size(halfspace_bond_event()), 'size of an event')
    bond = halfspace_bond()
    call expect(bond%normal_stiffness == 1e11_real64 .and. bond%cohesion == 0, 'defaults')
    bond = halfspace_bond(1.0_real64, 2.0_real64, 3.0_real64, 4.0_real64, 0.5_real64, 3.5_real64, 0.25_real64, &
                          5.0_real64, 6.0_real64)
    call expect_close([bond%normal_stiffness, bond%shear_stiffness, bond%tensile_strength, bond%cohesion, &
                       bond%friction_angle, bond%residual_cohesion, bond%residual_friction_angle, &
                       bond%tensile_fracture_energy, bond%shear_fracture_energy], &
                      [1.0_real64, 2.0_real64, 3.0_real64, 4.0_real64, 0.5_real64, 3.5_real64, 0.25_real64, &
                       5.0_real64, 6.0_real64], 0.0_real64, 'all that a bond may have')
  end subroutine definitions

  subroutine below_and_above()
    type(halfspace_world) :: world
    type(halfspace_block) :: lower, upper, none
    type(halfspace_bond_state), allocatable :: bonds(:)
    type(halfspace_bond_event), allocatable :: events(:), last(:)
    type(halfspace_bond_report) :: report
    type(halfspace_world_plan) :: plan
    integer :: i
    call make_squares(world, lower, upper)
    call world%bonds(bonds)
    call expect(size(bonds) == 0, 'there is no bond yet')
    call world%bond_blocks(upper, lower, mortar())
    call pull(world, upper, 0.9_real64 * strength)
    call world%bonds(bonds)
    call expect(size(bonds) == 1, 'one bond')
    call expect(bonds(1)%block_a == lower .and. bonds(1)%block_b == upper, 'its blocks')
    call world%plan(plan)
    call expect(plan%limiting_bond == 1 .and. plan%limiting_cell == 0, 'it limits the time step, and is counted from 1')
    call expect(bonds(1)%is_joint == 1 .and. bonds(1)%point_count == 3 .and. bonds(1)%broken_count == 0, 'it holds')
    call expect_close([bonds(1)%area, bonds(1)%damage], [1.0_real64, 0.0_real64], 1e-14_real64, 'area and damage')
    call world%bond_report(report)
    call expect(report%bond_count == 1 .and. report%joint_count == 1 .and. report%event_count == 0, 'numbers')
    call expect_close([report%strain_energy], 0.5_real64 * (0.9_real64 * strength)**2 / stiffness * one, &
                      1e-4_real64, 'energy in its springs')
    call world%bond_events(events)
    call expect(size(events) == 0, 'nothing has failed')

    call pull(world, upper, 1.1_real64 * strength)
    call world%bonds(bonds)
    call expect(bonds(1)%is_joint == 0 .and. bonds(1)%broken_count == 3 .and. bonds(1)%damage == 1, 'it has failed')
    call world%bond_report(report)
    call expect(report%joint_count == 0 .and. report%event_count == 3 .and. report%fracture_loss > 0, 'numbers then')
    call expect_close([report%crack_area], one, 1e-14_real64, 'the area that has cracked')
    call world%bond_events(events)
    call expect(size(events) == 3, 'each point has failed')
    call expect(all(events%failure == HS_BOND_TENSION .and. events%bond == 1), 'by tension')
    call expect(all([(any(events%point == i), i = 1, 3)]), 'points are counted from 1')
    call expect(all(events%step > 0 .and. events%time > 0 .and. events%energy > 0), 'when')
    do i = 1, 3
      call expect_close([events(i)%position(2), events(i)%normal], [real(real64) :: 1, 0, 1, 0], 1e-3_real64, 'where')
      call expect_close([events(i)%normal_traction, events(i)%shear_traction], [1.1_real64, 0.0_real64] * strength, &
                        1e-3_real64 * strength, 'under which traction')
    end do
    call expect_close([sum(events%area)], one, 1e-14_real64, 'shares of the face')
    call world%bond_events(last, first=3_int64)
    call expect(size(last) == 1, 'from the third one on')
    call expect(last(1)%point == events(3)%point .and. last(1)%bond == 1, 'the third one')
    call world%bond_events(last, first=9_int64)
    call expect(size(last) == 0, 'there is no ninth')
    call world%remove_block(upper)
    call world%bonds(bonds)
    call expect(bonds(1)%block_a == none .and. bonds(1)%block_b == none, 'a bond of a removed block')
  end subroutine below_and_above

  subroutine held()
    type(halfspace_world) :: world
    type(halfspace_block) :: lower, upper
    type(halfspace_bond_report) :: report
    integer :: i
    call make_squares(world, lower, upper)
    call world%bond_blocks(lower, upper, mortar())
    call world%set_applied_force(upper, [0.0_real64, 3 * strength])
    call world%hold_bonds(.true.)
    call world%step(50)
    call world%bond_report(report)
    call expect(report%joint_count == 1, 'a held bond does not fail')
    call world%hold_bonds(.false.)
    do i = 1, 1000
      call world%step(10)
      call world%bond_report(report)
      if (report%joint_count == 0) exit
    end do
    call expect(report%joint_count == 0, 'it fails when it is let go')
  end subroutine held

  subroutine by_shear()
    type(halfspace_world) :: world
    type(halfspace_block) :: lower, upper
    type(halfspace_bond) :: bond
    type(halfspace_bond_event), allocatable :: events(:)
    integer :: i
    call make_squares(world, lower, upper)
    bond = mortar()
    bond%tensile_strength = 100 * strength
    call world%bond_blocks(lower, upper, bond)
    call world%set_applied_force(upper, [1.5_real64 * strength, 0.0_real64])
    do i = 1, 10000
      call world%step()
      call world%bond_events(events)
      if (size(events) > 0) exit
    end do
    call expect(size(events) > 0, 'it fails')
    if (size(events) > 0) call expect(events(1)%failure == HS_BOND_SHEAR, 'by shear')
  end subroutine by_shear

  subroutine materials()
    type(halfspace_world) :: world
    type(halfspace_block) :: lower, upper
    type(halfspace_bond_report) :: report
    integer(int32) :: wood
    integer(int64) :: count
    call make_squares(world, lower, upper)
    call world%add_material(700.0_real64, wood)
    call world%bond_materials(wood, 1, mortar(), count)
    call expect(count == 0, 'no block is of wood')
    call world%bond_materials(1, 1, mortar(), count)
    call expect(count == 1, 'both are of stone')
    call world%bond_materials(1, 1, mortar())
    call world%bond_report(report)
    call expect(report%bond_count == 1, 'what holds together already stays as it is')
  end subroutine materials

  subroutine refusals()
    type(halfspace_world) :: world, none
    type(halfspace_block) :: lower, upper
    type(halfspace_bond) :: bond
    type(halfspace_bond_event), allocatable :: events(:)
    integer(int64) :: count
    integer :: stat
    character(200) :: text
    call make_squares(world, lower, upper)
    call world%bond_blocks(lower, upper, mortar())
    call world%bond_blocks(lower, upper, mortar(), stat, text)
    call expect(stat == HS_ERROR_STATE, 'twice')
    call expect_text(text, 'are bonded already')
    call world%bond_materials(1, 2, mortar(), count, stat, text)
    call expect(stat == HS_ERROR_STALE_ID .and. count == 0, 'there is no second material')
    call world%bond_materials(1, 1, halfspace_bond(residual_cohesion=1.0_real64), stat=stat, errmsg=text)
    call expect_text(text, 'def.residual_cohesion is 1')
    call world%bond_materials(1, 1, bond, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a bond that was not made by halfspace_bond()')
    call world%bond_events(events, 0_int64, stat, text)
    call expect(stat == HS_ERROR_ARGUMENT, 'events are counted from 1')
    call none%hold_bonds(.true., stat, text)
    call expect_text(text, 'was not created')
  end subroutine refusals

end program test_bonds
