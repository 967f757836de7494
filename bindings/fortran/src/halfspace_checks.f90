!> Validation of shapes without making them, and cleaning of polygons.
module halfspace_checks
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc
  use halfspace_c, halfspace_clean_report => hs_clean_report, halfspace_fault => hs_fault
  use halfspace_contexts, only: halfspace_context, own_or_given
  use halfspace_errors, only: conclude, had_memory
  use halfspace_handles, only: shared_handle
  use halfspace_records, only: count_from_1
  use halfspace_shapes, only: list_from_0
  use halfspace_views, only: are_points, mutable_view, view
  implicit none
  private
  public :: halfspace_clean_report, halfspace_fault
  public :: halfspace_check_polygon, halfspace_check_polyhedron, halfspace_clean_polygon

contains

  !> Returns the first fault of a polygon's vertices: fault%kind is HS_FAULT_NONE if there is none; fault%vertex is from
  !! 1, or 0 for the whole.
  subroutine halfspace_check_polygon(vertices, fault, rows, context, stat, errmsg)
    real(c_double), intent(in), target :: vertices(:,:)  !< clockwise or counter-clockwise
    type(halfspace_fault), intent(out) :: fault
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    integer(c_int32_t) :: status
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polygon_check(owner%object(), view(vertices, rows), fault)
    if (status == HS_OK) call count_from_1(fault)
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine halfspace_check_polygon

  !> Returns the first fault of a polyhedron; fault%vertex and fault%face are from 1.
  subroutine halfspace_check_polyhedron(vertices, face_sizes, face_vertices, fault, rows, context, stat, errmsg)
    real(c_double), intent(in), target :: vertices(:,:)
    integer(c_int32_t), intent(in), target, contiguous :: face_sizes(:)
    integer(c_int32_t), intent(in) :: face_vertices(:)  !< as for halfspace_shape's create_polyhedron()
    type(halfspace_fault), intent(out) :: fault
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    integer(c_int32_t) :: status
    integer(c_int32_t), allocatable, target :: from_0(:)
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    if (.not. list_from_0(face_sizes, face_vertices, from_0, stat, errmsg)) return
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polyhedron_check(owner%object(), view(vertices, rows), c_loc(face_sizes), &
                                 size(face_sizes, kind=c_int64_t), c_loc(from_0), fault)
    if (status == HS_OK) call count_from_1(fault)
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine halfspace_check_polyhedron

  !> Removes repeated and collinear vertices, and reverses a clockwise order. It moves no vertex.
  subroutine halfspace_clean_polygon(vertices, tolerance, cleaned, report, rows, context, stat, errmsg)
    real(c_double), intent(in), target :: vertices(:,:)  !< in outline order
    !> distance, m, >= 0; 0 removes exact repetitions and vertices collinear to rounding
    real(c_double), intent(in) :: tolerance
    real(c_double), intent(inout), allocatable :: cleaned(:,:)  !< receives the remaining vertices, (2,n)
    type(halfspace_clean_report), intent(out), target, optional :: report
    logical, intent(in), optional :: rows  !< layout of `vertices`
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    integer(c_int32_t) :: status
    integer(c_int64_t) :: count
    type(hs_view) :: found
    type(halfspace_clean_report), target :: changes
    real(c_double), allocatable, target :: remaining(:,:)
    real(c_double), allocatable :: kept(:,:)
    integer :: failure
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    found = view(vertices, rows)
    allocate (remaining(2, found%count), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    status = hs_polygon_clean(owner%object(), found, tolerance, mutable_view(remaining), count, c_loc(changes))
    if (status == HS_OK) then
      allocate (kept(2, count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      kept = remaining(:, :count)
      call move_alloc(kept, cleaned)
      if (present(report)) report = changes
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine halfspace_clean_polygon

end module halfspace_checks
