! Arrays of all layouts, and their sections, are passed without a copy. In CTest this program fails if the run-time
! library reports an array temporary.
program test_arrays
  use checking
  use halfspace
  use halfspace_c, only: hs_view
  use halfspace_views, only: view
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc
  use, intrinsic :: iso_fortran_env, only: int64, real64
  implicit none

  !> A trapezium with four distinguishable vertices. Area 3/2, centroid (7/9, 4/9).
  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 2, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: unset = -77

  call views_point_into_the_array()
  call sections_are_read()
  call sections_are_written()
  call motions_of_all_layouts()
  call wrong_extents_are_refused()
  call finish()

contains

  subroutine views_point_into_the_array()
    real(real64), target :: columns(5, 40), rows(40, 5)
    type(hs_view) :: seen
    columns = 0
    rows = 0
    seen = view(columns(2:4, 3:40:7))
    call expect(c_associated(seen%x, c_loc(columns(2, 3))), 'x of columns')
    call expect(c_associated(seen%y, c_loc(columns(3, 3))), 'y of columns')
    call expect(c_associated(seen%z, c_loc(columns(4, 3))), 'z of columns')
    call expect(seen%stride == 7 * 5 * 8 .and. seen%count == 6, 'stride and count of columns')
    seen = view(columns(1:5:4, 40:1:-2))
    call expect(c_associated(seen%x, c_loc(columns(1, 40))), 'x of reversed columns')
    call expect(c_associated(seen%y, c_loc(columns(5, 40))), 'y of reversed columns')
    call expect(.not. c_associated(seen%z), 'no z of two components')
    call expect(seen%stride == -2 * 5 * 8 .and. seen%count == 20, 'stride and count of reversed columns')
    seen = view(rows(2:40:3, 2:4), rows=.true.)
    call expect(c_associated(seen%x, c_loc(rows(2, 2))), 'x of rows')
    call expect(c_associated(seen%y, c_loc(rows(2, 3))), 'y of rows')
    call expect(c_associated(seen%z, c_loc(rows(2, 4))), 'z of rows')
    call expect(seen%stride == 3 * 8 .and. seen%count == 13, 'stride and count of rows')
    seen = view(columns(1:2, 3:2))
    call expect(seen%count == 0 .and. .not. c_associated(seen%x), 'no points')
  end subroutine views_point_into_the_array

  subroutine sections_are_read()
    real(real64) :: spread_out(3, 9), reversed(2, 4), rows(4, 3), sparse_rows(8, 5)
    spread_out = unset
    spread_out(2:3, 1:8:2) = corners
    call expect_trapezium(spread_out(2:3, 1:8:2), 'every second column')
    spread_out(1:2, 3:6) = corners
    spread_out(3, 3:6) = 0
    call expect_trapezium(spread_out(:, 3:6), 'three components')
    reversed = corners(:, 4:1:-1)
    call expect_trapezium(reversed(:, 4:1:-1), 'columns from last to first')
    rows = unset
    rows(:, 1:2) = transpose(corners)
    call expect_trapezium(rows(:, 1:2), 'rows', rows=.true.)
    sparse_rows = unset
    sparse_rows(1:8:2, 2:5:3) = transpose(corners)
    call expect_trapezium(sparse_rows(1:8:2, 2:5:3), 'every second row', rows=.true.)
  end subroutine sections_are_read

  subroutine expect_trapezium(points, what, rows)
    real(real64), intent(in) :: points(:,:)
    character(*), intent(in) :: what
    logical, intent(in), optional :: rows
    type(halfspace_shape) :: shape
    type(halfspace_shape_properties) :: properties
    call shape%create_polygon(points, rows=rows)
    call shape%properties(properties)
    call expect_close([properties%volume], [1.5_real64], 1e-15_real64, what//': area')
    call expect_close(properties%centroid(1:2), [real(real64) :: 7, 4] / 9, 1e-15_real64, what//': centroid')
  end subroutine expect_trapezium

  subroutine sections_are_written()
    type(halfspace_shape) :: shape
    real(real64) :: columns(2, 4), rows(9, 4), normals(3, 8), offsets(4)
    integer(int64) :: count
    call shape%create_polygon(corners)
    call shape%vertices(columns)
    call expect_close(reshape(columns, [8]), reshape(corners, [8]), 1e-15_real64, 'vertices as columns')
    rows = unset
    call shape%vertices(rows(9:2:-2, 2:3), rows=.true., count=count)
    call expect(count == 4, 'number of vertices')
    call expect_close(reshape(transpose(rows(9:2:-2, 2:3)), [8]), reshape(corners, [8]), 1e-15_real64, &
                      'vertices as rows')
    call expect(all(rows(:, [1, 4]) == unset) .and. all(rows(1:8:2, 1) == unset), 'what lies between is left alone')
    normals = unset
    call shape%halfspaces(normals(:, 1:8:2), offsets)
    call expect_close(normals(:, 1), [real(real64) :: 0, -1, 0], 1e-15_real64, 'normal of the lower edge')
    call expect_close(normals(:, 3), [real(real64) :: 1, 1, 0] / sqrt(2.0_real64), 1e-15_real64, 'normal of the slope')
    call expect(all(normals(:, 2:8:2) == unset), 'what lies between is left alone')
    call expect_close(offsets(1:1), [4 / 9.0_real64], 1e-15_real64, 'the lower edge is 4/9 below the centroid')
  end subroutine sections_are_written

  ! A free and a fixed block: velocities set by one layout are returned in another.
  subroutine motions_of_all_layouts()
    type(halfspace_world) :: world
    type(halfspace_shape) :: shape
    type(halfspace_pose) :: places(6)
    type(halfspace_block_state) :: states(2)
    integer :: material, stat
    real(real64) :: linear(2, 2), turning(3, 2), rows(2, 6), force(5, 4), torque(3, 4)
    call shape%create_polygon(corners)
    call world%create(time_step=1e-3_real64)
    call world%add_material(1000.0_real64, material)
    call world%add_block(shape, kind=HS_BLOCK_FIXED)
    call world%add_block(shape)
    linear = reshape([real(real64) :: 0, 0, 3, 4], [2, 2])
    turning = reshape([real(real64) :: 0, 0, 0, 0, 0, 5], [3, 2])
    call world%set_velocities(linear, turning)
    call world%velocities(rows(:, 1:5:2), rows(:, 2:6:2), rows=.true.)
    call expect_close(rows(2, :), [real(real64) :: 3, 0, 4, 0, 0, 5], 0.0_real64, 'velocities as rows, side by side')
    call world%set_velocities(rows(:, 5:1:-2), rows=.true.)
    call world%velocities(linear)
    call expect_close(linear(:, 2), [real(real64) :: 0, 4], 0.0_real64, 'velocities from rows from last to first')
    call world%poses(places(3:4))
    call expect_close(places(4)%position, [real(real64) :: 7, 4, 0] / 9, 1e-15_real64, 'poses of a section')
    places(4) = halfspace_pose(0.75_real64, 2.0_real64, 0.5_real64)
    call world%set_poses(places(3:4))
    call world%poses(places(5:6))
    call expect_close(halfspace_angle(places(5:6)), [0.0_real64, 0.5_real64], 1e-15_real64, 'angles of poses')
    call world%detect()
    force = unset
    torque = unset
    call world%forces(0.0_real64, force(2:5:3, 1:3:2), torque(:, 2:4:2))
    call expect(all(force(2:5:3, 1:3:2) == 0) .and. all(torque(:, 2:4:2) == 0), 'no contact, no force')
    call expect(all(force(:, 2:4:2) == unset) .and. all(torque(:, 1:3:2) == unset), 'what lies between is left alone')
    call world%set_velocities(reshape([real(real64) :: 0, 0, 0, 0], [2, 2]))
    call world%set_applied_forces(reshape([real(real64) :: 1, 2, 3e3, 1500 * 9.81_real64], [2, 2]))
    call world%step(10)
    call world%block_states(states)
    call expect(all(states%kind == [HS_BLOCK_FIXED, HS_BLOCK_RIGID]) .and. all(states%material == material), 'states')
    call expect_close(states(2)%velocity, [0.02_real64, 0.0_real64, 0.0_real64], 1e-12_real64, 'the weight is held')
    call world%set_applied_forces(force(1:2, 1:1), stat=stat)
    call expect(stat == HS_ERROR_ARGUMENT, 'a force for one of two blocks')
  end subroutine motions_of_all_layouts

  subroutine wrong_extents_are_refused()
    type(halfspace_shape) :: shape
    real(real64) :: points(4, 2)
    integer :: stat
    character(100) :: text
    points = transpose(corners)
    call shape%create_polygon(points, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. .not. shape%exists(), 'rows taken for columns')
    call expect_text(text, 'vertices: extent 1 is 4; it must be 2 or 3')
    call shape%create_polygon(points(:, 1:1), rows=.true., stat=stat, errmsg=text)
    call expect_text(text, 'vertices: extent 2 is 1')
    call shape%create_polyhedron_hull(points, rows=.true., stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a polyhedron of points in the plane')
    call expect_text(text, 'hs_polyhedron_create_hull')
  end subroutine wrong_extents_are_refused

end program test_arrays
