! Shapes: indices from 1 in arguments and results, parts of a cut, validation and cleaning.
program test_shapes
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int32, int64, real64
  implicit none

  !> A cuboid of 2 x 3 x 4 and its faces, counter-clockwise seen from outside.
  real(real64), parameter :: cuboid(3, 8) = reshape([real(real64) :: &
    0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0, 0, 0, 4, 2, 0, 4, 2, 3, 4, 0, 3, 4], [3, 8])
  integer(int32), parameter :: sizes(6) = 4
  integer(int32), parameter :: outlines(24) = [1, 4, 3, 2, 5, 6, 7, 8, 1, 2, 6, 5, 2, 3, 7, 6, 3, 4, 8, 7, 4, 1, 5, 8]

  call faces_come_back()
  call half_spaces_make_it_again()
  call edges_of_a_triangle()
  call cut_of_a_cuboid()
  call faults_are_counted_from_1()
  call facets_are_fitted_within_a_tolerance()
  call lists_of_wrong_length_are_refused()
  call clean_up()
  call finish()

contains

  subroutine faces_come_back()
    type(halfspace_shape) :: shape
    type(halfspace_shape_properties) :: properties
    integer(int32), allocatable :: first(:), listed(:), edges(:,:)
    integer :: i
    call shape%create_polyhedron(cuboid, sizes, outlines)
    call shape%properties(properties)
    call expect_close([properties%volume], [24.0_real64], 1e-14_real64, 'volume')
    call shape%faces(first, listed)
    call expect(all(first == [(1 + 4 * i, i = 0, 6)]), 'first vertex of each face')
    call expect(size(listed) == 24, 'all outlines')
    call expect(all(listed == outlines), 'outlines as they were given')
    call shape%edges(edges)
    call expect(all(shape_of(edges) == [2, 12]), '12 edges')
    call expect(minval(edges) == 1 .and. maxval(edges) == 8, 'edges count vertices from 1')
  end subroutine faces_come_back

  function shape_of(array) result(extents)
    integer(int32), intent(in) :: array(:,:)
    integer :: extents(2)
    extents = shape(array)
  end function shape_of

  ! Half-spaces are relative to the centroid.
  subroutine half_spaces_make_it_again()
    type(halfspace_shape) :: shape, again
    type(halfspace_shape_properties) :: properties
    real(real64) :: normals(3, 6), offsets(6)
    integer(int64) :: count
    call shape%create_polyhedron_hull(cuboid)
    call shape%halfspaces(normals, offsets, count=count)
    call expect(count == 6, '6 half-spaces')
    call again%create_from_halfspaces(normals, offsets)
    call again%properties(properties)
    call expect_close([properties%volume], [24.0_real64], 1e-13_real64, 'volume between the half-spaces')
    call expect_close(properties%centroid, [real(real64) :: 0, 0, 0], 1e-15_real64, 'centroid')
  end subroutine half_spaces_make_it_again

  subroutine edges_of_a_triangle()
    type(halfspace_shape) :: shape
    integer(int32), allocatable :: first(:), listed(:), edges(:,:)
    real(real64) :: outline(2, 3), few(2, 2)
    integer(int64) :: count
    integer :: stat
    character(100) :: text
    outline = reshape([real(real64) :: 0, 0, 0, 1, 1, 0], [2, 3])  ! clockwise
    call shape%create_polygon(outline)
    call shape%faces(first, listed)
    call expect(all(first == [1, 3, 5, 7]), 'two ends to an edge')
    call expect(all(listed == [1, 2, 2, 3, 3, 1]), 'edges as faces')
    call shape%edges(edges)
    call expect(all(edges == reshape([1, 2, 2, 3, 3, 1], [2, 3])), 'edges')
    text = ''
    call shape%vertices(few, count=count, stat=stat, errmsg=text)
    call expect(stat == HS_NOTE_TRUNCATED .and. count == 3, 'two of three vertices fit')
    call expect_text(text, 'is truncated')
  end subroutine edges_of_a_triangle

  subroutine cut_of_a_cuboid()
    type(halfspace_shape) :: shape, lower, upper
    type(halfspace_shape_properties) :: properties
    call shape%create_polyhedron_hull(cuboid)
    call shape%cut([real(real64) :: 0, 0, 1], [real(real64) :: 0, 0, 1], lower, upper)
    call lower%properties(properties)
    call expect_close([properties%volume], [6.0_real64], 1e-14_real64, 'volume below')
    call upper%properties(properties)
    call expect_close([properties%volume], [18.0_real64], 1e-14_real64, 'volume above')
  end subroutine cut_of_a_cuboid

  subroutine faults_are_counted_from_1()
    type(halfspace_fault) :: fault
    real(real64) :: dented(2, 5), moved(3, 8)
    dented = reshape([real(real64) :: 0, 0, 2, 0, 1, 0.5, 2, 2, 0, 2], [2, 5])
    call halfspace_check_polygon(dented, fault)
    call expect(fault%kind /= HS_FAULT_NONE .and. fault%vertex == 3, 'the dent is at vertex 3')
    call expect(fault%face == 0, 'and at no face')
    call halfspace_check_polygon(dented(:, [1, 2, 4, 5]), fault)
    call expect(fault%kind == HS_FAULT_NONE .and. fault%vertex == 0, 'no fault without it')
    moved = cuboid
    moved(3, 7) = 4.5  ! lifted out of the planes of two faces
    call halfspace_check_polyhedron(moved, sizes, outlines, fault)
    call expect(fault%kind /= HS_FAULT_NONE .and. fault%face >= 1 .and. fault%face <= 6, 'a face is not plane')
    call halfspace_check_polyhedron(cuboid, sizes, outlines, fault)
    call expect(fault%kind == HS_FAULT_NONE, 'a cuboid has no fault')
  end subroutine faults_are_counted_from_1

  subroutine facets_are_fitted_within_a_tolerance()
    type(halfspace_shape) :: shape
    type(halfspace_shape_properties) :: properties
    type(halfspace_fit_report) :: report
    real(real64) :: rounded(3, 8)
    integer :: stat
    character(300) :: text
    rounded = cuboid
    rounded(3, 7) = rounded(3, 7) + 1e-3_real64
    call shape%create_fitted(rounded, 2e-3_real64, sizes, outlines, report)
    call shape%properties(properties)
    call expect(properties%face_count == 6 .and. report%fault%kind == HS_FAULT_NONE, 'six plane faces')
    call expect(report%moved > 1e-4 .and. report%moved < 2e-3, 'the corners have moved')
    call shape%create_fitted(cuboid, 0.0_real64, report=report)
    call expect(report%merged == 0 .and. .not. report%moved > 0, 'the hull of exact corners')
    rounded(3, 7) = cuboid(3, 7) - 0.5  ! folds both faces at it inwards
    call shape%create_fitted(rounded, 1e-3_real64, sizes, outlines, report, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_GEOMETRY .and. report%fault%kind == HS_FAULT_BEYOND_TOLERANCE, 'a dent')
    call expect(report%fault%vertex >= 1 .and. report%fault%vertex <= 8, 'the dent has a vertex')
    call expect(report%sufficient_tolerance > 1e-3, 'and a tolerance that would do')
    call shape%create_fitted(rounded, 1e-3_real64, sizes, stat=stat, errmsg=text)
    call expect_text(text, 'face_sizes, face_vertices: give both or neither')
  end subroutine facets_are_fitted_within_a_tolerance

  subroutine lists_of_wrong_length_are_refused()
    type(halfspace_shape) :: shape
    integer :: stat
    character(100) :: text
    real(real64) :: offsets(5)
    call shape%create_polyhedron(cuboid, sizes, outlines(:23), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'an outline is too short')
    call expect_text(text, 'face_vertices: has 23 values; it must have the sum of face_sizes, 24')
    offsets = 1
    call shape%create_from_halfspaces(cuboid, offsets, stat=stat, errmsg=text)
    call expect_text(text, 'offsets: has 5 values; there are 8 normals')
  end subroutine lists_of_wrong_length_are_refused

  subroutine clean_up()
    real(real64) :: found(2, 6)
    real(real64), allocatable :: cleaned(:,:)
    type(halfspace_clean_report) :: report
    ! A unit square, clockwise, with a repeated vertex and one in the middle of an edge.
    found = reshape([real(real64) :: 0, 0, 0, 1, 0, 1, 1, 1, 1, 0.5, 1, 0], [2, 6])
    call halfspace_clean_polygon(found, 0.0_real64, cleaned, report)
    call expect(all(shape(cleaned) == [2, 4]), 'four vertices remain')
    call expect(report%welded == 1 .and. report%straightened == 1 .and. report%reversed == 1, 'what was changed')
  end subroutine clean_up

end program test_shapes
