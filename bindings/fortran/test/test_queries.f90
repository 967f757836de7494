! Rays, closest points, pairs of boxes, shapes that deform, and components in separate arrays.
program test_queries
  use checking
  use halfspace
  use halfspace_c, only: hs_closest_points, hs_ray_hit
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none

  real(real64), parameter :: x(4) = [0, 1, 1, 0], y(4) = [0, 0, 1, 1]

  call rays()
  call closest()
  call boxes()
  call curve()
  call deforms()
  call separate_arrays()
  call finish()

contains

  subroutine make_world(world, near)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_block), intent(out) :: near
    type(halfspace_shape) :: square
    integer(int32) :: stone
    call square%create_polygon(x, y)
    call world%create(gravity=[0.0_real64, 0.0_real64])
    call world%add_material(2000.0_real64, stone)
    call world%add_block(square, pose=halfspace_pose(9.0_real64, 0.0_real64))
    call world%add_block(square, near, pose=halfspace_pose(4.0_real64, 0.0_real64))
  end subroutine make_world

  subroutine rays()
    type(halfspace_world) :: world
    type(halfspace_block) :: near
    type(halfspace_shape) :: square
    type(halfspace_ray_hit) :: hit
    integer :: stat
    character(200) :: text
    call expect(storage_size(hs_ray_hit()) == storage_size(halfspace_ray_hit()), 'size of a hit')
    call make_world(world, near)
    call halfspace_cast_ray(world, [0.0_real64, 0.25_real64], [2.0_real64, 0.0_real64], hit)
    call expect(hit%is_hit == 1 .and. hit%block == near, 'the nearest block')
    call expect_close([hit%distance, hit%normal(1)], [3.5_real64, -1.0_real64], 0.0_real64, 'distance')
    call expect(hit%face == 4, 'the last edge, from 1')
    call halfspace_cast_ray(world, [0.0_real64, 0.25_real64], [2.0_real64, 0.0_real64], hit, 3.4_real64)
    call expect(hit%is_hit == 0, 'too short')
    call square%create_polygon(x, y)
    call halfspace_cast_ray(square, halfspace_pose(4.0_real64, 0.0_real64), [4.0_real64, 0.0_real64], &
                            [0.0_real64, 1.0_real64], hit)
    call expect(hit%is_hit == 1 .and. hit%face == 0, 'inside')
    call halfspace_cast_ray(world, [0.0_real64, 0.0_real64], [0.0_real64, 0.0_real64], hit, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. index(text, 'direction') > 0, 'no direction')
  end subroutine rays

  subroutine closest()
    type(halfspace_shape) :: square
    type(halfspace_closest_points) :: points
    call expect(storage_size(hs_closest_points()) == storage_size(halfspace_closest_points()), 'size of points')
    call square%create_polygon(x, y)
    call halfspace_find_closest_points(square, halfspace_pose(0.0_real64, 0.0_real64), square, &
                                       halfspace_pose(4.0_real64, 5.0_real64), points)
    call expect_close([points%distance, points%point_b(:2)], [5.0_real64, 3.5_real64, 4.5_real64], 0.0_real64, &
                      'from corner to corner')
  end subroutine closest

  subroutine boxes()
    real(real64) :: lower(2, 3), upper(2, 3)
    integer(int32), allocatable :: pairs(:,:)
    lower = reshape([0.0_real64, 0.0_real64, 0.5_real64, 0.5_real64, 3.0_real64, 0.0_real64], [2, 3])
    upper = lower + 1
    call halfspace_find_box_pairs(lower, upper, pairs)
    call expect(all(shape(pairs) == [2, 1]), 'one pair')
    call expect(all(pairs(:, 1) == [1, 2]), 'the pair, from 1')
  end subroutine boxes

  subroutine curve()
    real(real64) :: corners(2, 4)
    integer(int32), allocatable :: order(:)
    corners = reshape([0.0_real64, 0.0_real64, 1.0_real64, 1.0_real64, 1.0_real64, 0.0_real64, 0.0_real64, &
                       1.0_real64], [2, 4])
    call halfspace_order_along_curve(corners, order)
    call expect(size(order) == 4, 'as many as points')
    call expect(all(order == [1, 4, 2, 3]), 'around the square, from 1')
  end subroutine curve

  subroutine deforms()
    type(halfspace_shape) :: body
    type(halfspace_shape_properties) :: properties
    real(real64) :: u(4), v(4)
    integer :: stat
    character(200) :: text
    call body%create_polygon(x, y)
    call body%set_vertices(2 * x, y)
    call body%properties(properties)
    call expect_close([properties%volume, properties%centroid(1)], [2.0_real64, 1.0_real64], 0.0_real64, 'stretched')
    call body%vertices(u, v)
    call expect_close([u, v], [2 * x, y], 0.0_real64, 'its vertices')
    call body%set_vertices(reshape([0, 0, 1, 0, 1, 1, 0, 1] * 1.0_real64, [2, 4]))
    call body%properties(properties)
    call expect_close([properties%volume], [1.0_real64], 0.0_real64, 'as before')
    call body%set_vertices(x(:3), y(:3), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. index(text, 'vertices.count is 3') > 0, 'too few')
  end subroutine deforms

  subroutine separate_arrays()
    type(halfspace_world) :: world
    type(halfspace_block) :: near
    real(real64) :: px(2), py(2), angle(2), u(2), v(2), omega(2), fx(2), fy(2), torque(2)
    real(real64) :: linear(2, 2), angular(3, 2)
    integer :: stat
    character(200) :: text
    call make_world(world, near)
    call world%poses(px, py, angle)
    call expect_close([px, py, angle], [9.0_real64, 4.0_real64, 0.0_real64, 0.0_real64, 0.0_real64, 0.0_real64], &
                      0.0_real64, 'poses')
    call world%set_poses([1.0_real64, 5.0_real64], [2.0_real64, 3.0_real64], [0.5_real64, -0.25_real64])
    call world%poses(px, py, angle)
    call expect_close([px, py, angle], [1.0_real64, 5.0_real64, 2.0_real64, 3.0_real64, 0.5_real64, -0.25_real64], &
                      1e-15_real64, 'poses that were set')
    call world%set_velocities([1.0_real64, 2.0_real64], [3.0_real64, 4.0_real64], [5.0_real64, 6.0_real64])
    call world%velocities(u, v, omega)
    call expect_close([u, v, omega], [1.0_real64, 2.0_real64, 3.0_real64, 4.0_real64, 5.0_real64, 6.0_real64], &
                      0.0_real64, 'velocities')
    call world%velocities(linear, angular)
    call expect_close([linear(:, 2), angular(:, 2)], [2.0_real64, 4.0_real64, 0.0_real64, 0.0_real64, 6.0_real64], &
                      0.0_real64, 'the same as points')
    call world%set_poses([1.0_real64, 1.75_real64], [2.0_real64, 2.0_real64])
    call world%detect()
    call world%forces(0.0_real64, fx, fy, torque)
    call world%forces(0.0_real64, linear, angular)
    call expect(fx(2) > 0, 'they push')
    call expect_close([fx(2), fy(2), torque(2)], [linear(:, 2), angular(3, 2)], 0.0_real64, 'forces')
    call world%set_velocities(u, v(:1), stat=stat, errmsg=text)
    call expect(stat /= 0 .and. index(text, 'u, v and omega') > 0, 'different sizes')
  end subroutine separate_arrays

end program test_queries
