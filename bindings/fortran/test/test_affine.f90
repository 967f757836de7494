! Affine blocks: tensors are (row, column), faces and materials are counted from 1.
program test_affine
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5], &
                                                     [2, 4])
  real(real64), parameter :: stretched_and_turned(2, 2) = reshape([0.0_real64, 1.25_real64, -1.0_real64, 0.0_real64], &
                                                                  [2, 2])
  real(real64), parameter :: density = 1000

  call elasticities()
  call tensors_in_plane()
  call tensors_in_space()
  call all_blocks()
  call load_on_a_face()
  call refusals()
  call finish()

contains

  !> Both of Lame's constants are 1e6.
  subroutine make_block(world, block)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: block
    type(halfspace_shape) :: square
    integer(int32) :: rock
    call square%create_polygon(corners)
    call world%create(gravity=[0.0_real64, 0.0_real64], time_step=2.0_real64**(-20))
    call world%add_material(density, rock)
    call world%set_elasticity(rock, halfspace_elasticity(young_modulus=2.5e6_real64))
    call world%add_block(square, block, kind=HS_BLOCK_AFFINE, material=rock, &
                         pose=halfspace_pose(3.0_real64, 4.0_real64))
  end subroutine make_block

  subroutine elasticities()
    type(halfspace_elasticity) :: default, given
    default = halfspace_elasticity()
    call expect(default%young_modulus == 1e9_real64 .and. default%poisson_ratio == 0.25_real64, &
                'defaults of an elasticity')
    call expect(default%damping_time == 0 .and. default%plane == HS_PLANE_STRAIN, 'its other defaults')
    given = halfspace_elasticity(2e10_real64, 0.3_real64, 1e-5_real64, HS_PLANE_STRESS)
    call expect(given%young_modulus == 2e10_real64 .and. given%poisson_ratio == 0.3_real64, 'what is given')
    call expect(given%damping_time == 1e-5_real64 .and. given%plane == HS_PLANE_STRESS, 'what else is given')
  end subroutine elasticities

  ! A stretch by 1.25 along x, then a rotation by 90 degrees, which maps x to y.
  subroutine tensors_in_plane()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_deformation) :: d
    real(real64) :: rate(2, 2), stress(2, 2), vertices(2, 4)
    call make_block(world, block)
    rate = reshape([1, 3, 2, 4], [2, 2])
    call world%set_deformation(block, stretched_and_turned, rate)
    call world%block_vertices(block, vertices)
    call expect_close(vertices(:, 2), [3.5_real64, 4.625_real64], 1e-15_real64, 'the vertex (1/2, -1/2) of the shape')
    call world%deformation(block, d)
    call expect(all(d%gradient(:2, :2) == stretched_and_turned) .and. d%gradient(3, 3) == 1, 'the gradient')
    call expect(d%rate(1, 2) == 2 .and. d%rate(2, 1) == 3, 'its rate')
    call expect_close([d%strain(1, 1), d%strain(2, 2)], [0.28125_real64, 0.0_real64], 1e-15_real64, &
                      'strain of the shape')
    call expect_close([d%stress(1, 1), d%stress(2, 2)], [225000.0_real64, 1054687.5_real64], 1e-9_real64, &
                      'stress in space')
    call expect_close([d%strain_energy], [118652.34375_real64], 1e-10_real64, 'strain energy')

    call world%set_deformation(block, stretched_and_turned)
    stress = reshape([-1000, 250, 250, 500], [2, 2])
    call world%set_stress(block, stress)
    call world%deformation(block, d)
    call expect(all(d%rate == 0), 'without a rate it is 0')
    call expect_close(pack(d%stress(:2, :2), .true.), pack(stress, .true.), 1e-9_real64, 'stress in situ')
  end subroutine tensors_in_plane

  ! Every axis becomes the next one, and that from x is stretched.
  subroutine tensors_in_space()
    type(halfspace_world) :: world
    type(halfspace_shape) :: tetrahedron
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_deformation) :: d
    real(real64) :: gradient(3, 3), before(3, 4), after(3, 4)
    integer(int32) :: rock
    call tetrahedron%create_polyhedron_hull(reshape([real(real64) :: 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 4], [3, 4]))
    call world%create(dimension=3)
    call world%add_material(density, rock)
    call world%set_elasticity(rock, halfspace_elasticity(young_modulus=2.5e6_real64))
    call world%add_block(tetrahedron, block, kind=HS_BLOCK_AFFINE)
    call world%block_vertices(block, before)
    gradient = 0
    gradient(2, 1) = 1.25_real64
    gradient(3, 2) = 1
    gradient(1, 3) = 1
    call world%set_deformation(block, gradient)
    call world%block_vertices(block, after)
    call world%block_state(block, state)
    call expect_close(pack(after - spread(state%pose%position, 2, 4), .true.), &
                      pack(matmul(gradient, before - spread(state%pose%position, 2, 4)), .true.), 4e-15_real64, &
                      'vertices are at the gradient times their places')
    call world%deformation(block, d)
    call expect(all(d%gradient == gradient), 'the gradient in space')
    call expect_close([d%stress(1, 1), d%stress(2, 2), d%stress(3, 3)], &
                      [225000.0_real64, 1054687.5_real64, 225000.0_real64], &
                      1e-9_real64, 'stress in space')
  end subroutine tensors_in_space

  subroutine all_blocks()
    type(halfspace_world) :: world
    type(halfspace_shape) :: square
    type(halfspace_block) :: block
    type(halfspace_deformation) :: d(3), one(1)
    integer :: stat
    call make_block(world, block)
    call world%set_deformation(block, stretched_and_turned)
    call square%create_polygon(corners)
    call world%add_block(square, pose=halfspace_pose(9.0_real64, 9.0_real64, 0.5_real64))
    d(3)%rate(1, 2) = 7
    call world%deformations(d)
    call expect(all(d(1)%gradient(:2, :2) == stretched_and_turned), 'the affine block')
    call expect_close(d(2)%gradient(:, 1), [cos(0.5_real64), sin(0.5_real64), 0.0_real64], 1e-15_real64, &
                      'the rigid block')
    call expect(d(3)%rate(1, 2) == 7 .and. d(3)%rate(2, 1) == 0, 'what is past the last block stays as it is')
    call world%deformations(one, stat)
    call expect(stat == HS_NOTE_TRUNCATED, 'a note that not all fit')
    call expect(all(one(1)%gradient == d(1)%gradient), 'as many as fit')
  end subroutine all_blocks

  ! 1000 N upwards on the right edge, the second one, at an arm of 1/2: 1 m/s^2, and 500 / (1000 / 12) for the gradient.
  ! The vibrations of the block have at most w^2 = 12 (2 + 2) 1e6 / 1000: in a step of 2^-20 s its stress changes the
  ! rate by at most a fraction (w h)^2 = 4.4e-8.
  subroutine load_on_a_face()
    type(halfspace_world) :: world
    type(halfspace_block) :: block
    type(halfspace_block_state) :: state
    type(halfspace_deformation) :: d
    real(real64) :: step
    call make_block(world, block)
    call world%add_surface_load(block, 1, [0.0_real64, 1e6_real64])
    call world%clear_surface_loads(block)
    call world%add_surface_load(block, 2, [0.0_real64, 1000.0_real64])
    call world%step()
    step = 2.0_real64**(-20)
    call world%block_state(block, state)
    call expect_close(state%velocity, [0.0_real64, step, 0.0_real64], 1e-15_real64 * step, 'velocity')
    call world%deformation(block, d)
    call expect_close([d%rate(2, 1), d%rate(1, 2), d%rate(1, 1), d%rate(2, 2)], step * [6, 0, 0, 0], &
                      6 * 4.4e-8_real64 * step, &
                      'rate')
    call expect(state%kind == HS_BLOCK_AFFINE, 'its kind')
  end subroutine load_on_a_face

  subroutine refusals()
    type(halfspace_world) :: world, none
    type(halfspace_shape) :: square
    type(halfspace_block) :: block, rigid
    type(halfspace_deformation) :: d
    real(real64) :: wide(2, 3)
    integer :: stat
    character(200) :: text
    call make_block(world, block)
    wide = 1
    call world%set_deformation(block, wide, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a gradient of 2 rows and 3 columns')
    call expect_text(text, 'gradient: has 2 rows and 3 columns')
    call world%set_deformation(block, stretched_and_turned, wide, stat, text)
    call expect_text(text, 'rate: has 2 rows and 3 columns')
    call world%set_stress(block, wide, stat, text)
    call expect_text(text, 'stress: has 2 rows and 3 columns')
    call world%add_surface_load(block, 1, [1.0_real64], stat, text)
    call expect_text(text, 'traction: has 1 values')
    call world%add_surface_load(block, 5, [1.0_real64, 0.0_real64], stat, text)
    call expect_text(text, 'face is 4; the block has 4')
    call world%set_elasticity(2, halfspace_elasticity(), stat, text)
    call expect(stat == HS_ERROR_STALE_ID, 'there is no second material')
    call square%create_polygon(corners)
    call world%add_block(square, rigid)
    call world%set_stress(rigid, 0 * stretched_and_turned, stat, text)
    call expect(stat == HS_ERROR_STATE, 'a rigid block has no stress')
    call expect_text(text, 'is not affine')
    call world%remove_block(rigid)
    call world%deformation(rigid, d, stat)
    call expect(stat == HS_ERROR_STALE_ID, 'a removed block')
    call none%deformation(block, d, stat)
    call expect(stat < 0, 'no world')
  end subroutine refusals

end program test_affine
