! A world returns what it was given; materials and tables are counted from 1.
program test_definitions
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none

  real(real64), parameter :: square(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])

  call settings_and_materials()
  call tables_and_actions()
  call unusual_values()
  call refusals()
  call finish()

contains

  !> Two materials, the second one elastic, with a law of their own.
  subroutine make_world(world)
    type(halfspace_world), intent(inout) :: world
    integer(int32) :: stone, steel
    call world%create(local_damping=0.7_real64)
    call world%add_material(2700.1_real64, stone)
    call world%add_material(7850.3_real64, steel)
    call world%set_elasticity(steel, halfspace_elasticity(young_modulus=2.1e11_real64, poisson_ratio=0.3_real64))
    call world%set_law(halfspace_law(friction_angle=0.6_real64, cohesion=1.1e4_real64), stone, steel)
  end subroutine make_world

  subroutine settings_and_materials()
    type(halfspace_world) :: world
    type(halfspace_world_def) :: def
    type(halfspace_elasticity) :: elasticity
    type(halfspace_law) :: law
    real(real64), allocatable :: densities(:)
    call make_world(world)
    call world%set_gravity([0.5_real64, -1.0_real64])
    call world%set_strength_factor(1.7_real64)
    call world%definition(def)
    call expect(def%dimension == 2 .and. def%local_damping == 0.7_real64, 'settings as they were given')
    call expect(all(def%gravity == [0.5_real64, -1.0_real64, 0.0_real64]), 'gravity as it was set')
    call world%densities(densities)
    call expect(size(densities) == 2 .and. densities(2) == 7850.3_real64, 'densities')
    call world%elasticity(1, elasticity)
    call expect(elasticity%young_modulus == 0, 'no elasticity')
    call world%elasticity(2, elasticity)
    call expect(elasticity%young_modulus == 2.1e11_real64 .and. elasticity%poisson_ratio == 0.3_real64, 'elasticity')
    call world%law(law, 2, 1)
    call expect(law%friction_angle == 0.6_real64 .and. law%cohesion == 1.1e4_real64, 'a law of two materials')
    call world%law(law)
    call expect(law%friction_angle == 0 .and. law%normal_stiffness == 1e9_real64, 'the default law')
  end subroutine settings_and_materials

  subroutine tables_and_actions()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_shape) :: shape
    type(halfspace_action), allocatable :: actions(:)
    real(real64), parameter :: rows(3, 2) = reshape([real(real64) :: 1, 2, 3, 4, 5, 6], [3, 2])
    real(real64), allocatable :: times(:), values(:,:)
    integer(int32) :: unused, table
    call make_world(world)
    call shape%create_polygon(square)
    call world%add_block(shape, block, kind=HS_BLOCK_PRESCRIBED)
    call world%add_table([0.0_real64], rows(:, :1), unused)
    call world%add_table([0.0_real64, 0.5_real64], rows, table)
    call world%add_action(HS_ACTION_VELOCITY, table, block, start=0.2_real64)
    call world%table(table, times, values)
    call expect(all(times == [0.0_real64, 0.5_real64]) .and. all(values == rows), 'the rows of a table')
    call world%actions(actions, block)
    call expect(size(actions) == 1, 'the number of actions')
    call expect(actions(1)%kind == HS_ACTION_VELOCITY .and. actions(1)%table == table, 'an action')
    call expect(actions(1)%start == 0.2_real64, 'the start of an action')
    call world%actions(actions)
    call expect(size(actions) == 0, 'no action on all blocks')
  end subroutine tables_and_actions

  subroutine unusual_values()
    type(halfspace_world) :: world
    type(halfspace_note), allocatable :: notes(:)
    real(real64) :: low, high
    call make_world(world)
    call world%check(notes)
    call expect(size(notes) == 0, 'a world as usual')
    call world%set_law(halfspace_law(cohesion=5.0_real64), 1, 2)
    call world%check(notes)
    call expect(size(notes) == 1, 'one note')
    call expect(notes(1)%setting == HS_SETTING_COHESION .and. notes(1)%value == 5, 'the setting of a note')
    call expect(notes(1)%material_a == 1 .and. notes(1)%material_b == 2, 'the materials of a note')
    call halfspace_usual_range(HS_SETTING_COHESION, low, high)
    call expect(low == notes(1)%usual_low .and. high == notes(1)%usual_high, 'the range of a note')
    call expect(halfspace_usual_text(HS_SETTING_COHESION) == '0, or 100 to 1e9 Pa', 'a range in words')
    call halfspace_usual_range(-1_int32, low, high)
    call expect(low == 0 .and. high == 0, 'no setting')
  end subroutine unusual_values

  subroutine refusals()
    type(halfspace_world) :: world
    type(halfspace_block) :: none
    type(halfspace_law) :: law
    type(halfspace_action), allocatable :: actions(:)
    integer :: status
    call make_world(world)
    call world%law(law, 1, 3, stat=status)
    call expect(status == HS_ERROR_STALE_ID, 'a material that is none')
    call world%actions(actions, none, stat=status)
    call expect(status == HS_ERROR_ARGUMENT, 'a block that is none')
  end subroutine refusals

end program test_definitions
