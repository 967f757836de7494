!> Views of arrays of points for the C interface, without copies.
module halfspace_views
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t, c_intptr_t, c_loc, c_null_ptr, c_ptr
  use halfspace_c, only: hs_mutable_view, hs_view
  use halfspace_errors, only: refuse
  implicit none
  private
  public :: address_of, are_of_one_size, are_points, components, is_vector, mutable_components, mutable_view, &
    three_of, view

contains

  !> Are these points? They are columns x(2,n) or x(3,n), or with rows = .true. rows x(n,2) or x(n,3). Refuses other
  !! arrays.
  logical function are_points(points, name, rows, stat, errmsg)
    real(c_double), intent(in) :: points(:,:)
    character(*), intent(in) :: name
    logical, intent(in), optional :: rows
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer :: components
    character(len(name) + 80) :: text
    components = size(points, components_index(rows))
    are_points = components == 2 .or. components == 3
    if (are_points) return
    write (text, '(a, ": extent ", i0, " is ", i0, "; it must be 2 or 3")') &
      name, components_index(rows), components
    call refuse(trim(text), stat, errmsg)
  end function are_points

  type(hs_view) function view(points, rows)
    real(c_double), intent(in), target :: points(:,:)
    logical, intent(in), optional :: rows
    call find(points, rows, view%x, view%y, view%z, view%stride, view%count)
  end function view

  type(hs_mutable_view) function mutable_view(points, rows) result(view)
    real(c_double), intent(in), target :: points(:,:)
    logical, intent(in), optional :: rows
    call find(points, rows, view%x, view%y, view%z, view%stride, view%count)
  end function mutable_view

  !> Points in the plane with an array per component.
  type(hs_view) function components(x, y)
    real(c_double), intent(in), target, contiguous :: x(:), y(:)
    if (size(x) == 0) return
    components%x = c_loc(x)
    components%y = c_loc(y)
    components%stride = storage_size(x) / 8
    components%count = size(x, kind=c_int64_t)
  end function components

  type(hs_mutable_view) function mutable_components(x, y) result(view)
    real(c_double), intent(in), target, contiguous :: x(:), y(:)
    type(hs_view) :: read_only
    read_only = components(x, y)
    view%x = read_only%x
    view%y = read_only%y
    view%stride = read_only%stride
    view%count = read_only%count
  end function mutable_components

  !> Have the components one size? Refuses others.
  logical function are_of_one_size(x, y, z, names, stat, errmsg)
    real(c_double), intent(in) :: x(:), y(:)
    real(c_double), intent(in), optional :: z(:)
    character(*), intent(in) :: names
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    are_of_one_size = size(y) == size(x)
    if (present(z)) are_of_one_size = are_of_one_size .and. size(z) == size(x)
    if (.not. are_of_one_size) call refuse(names // ': the sizes must be equal', stat, errmsg)
  end function are_of_one_size

  !> The stride is the difference of addresses, so array sections need no copy.
  subroutine find(points, rows, x, y, z, stride, count)
    real(c_double), intent(in), target :: points(:,:)
    logical, intent(in), optional :: rows
    type(c_ptr), intent(inout) :: x, y, z
    integer(c_int64_t), intent(inout) :: stride, count
    integer :: components, across
    components = components_index(rows)
    across = 3 - components
    count = size(points, across, c_int64_t)
    if (count == 0) return
    x = c_loc(points(1, 1))
    if (components == 1) then
      y = c_loc(points(2, 1))
      if (size(points, 1) == 3) z = c_loc(points(3, 1))
      if (count > 1) stride = place(c_loc(points(1, 2))) - place(x)
    else
      y = c_loc(points(1, 2))
      if (size(points, 2) == 3) z = c_loc(points(1, 3))
      if (count > 1) stride = place(c_loc(points(2, 1))) - place(x)
    end if
  end subroutine find

  integer function components_index(rows)
    logical, intent(in), optional :: rows
    components_index = 1
    if (present(rows)) components_index = merge(2, 1, rows)
  end function components_index

  pure integer(c_int64_t) function place(address)
    type(c_ptr), intent(in) :: address
    place = int(transfer(address, 0_c_intptr_t), c_int64_t)
  end function place

  !> Has the vector 3 values, or `in_plane` values? Refuses others.
  logical function is_vector(values, name, in_plane, stat, errmsg)
    real(c_double), intent(in) :: values(:)
    character(*), intent(in) :: name
    integer, intent(in) :: in_plane
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(len(name) + 80) :: text
    is_vector = size(values) == 3 .or. size(values) == in_plane
    if (is_vector) return
    write (text, '(a, ": has ", i0, " values; it must have ", i0, " or 3")') name, size(values), in_plane
    call refuse(trim(text), stat, errmsg)
  end function is_vector

  !> x and y in 2D, or one rotation about z, or all three components.
  pure function three_of(values) result(three)
    real(c_double), intent(in) :: values(:)
    real(c_double) :: three(3)
    three = 0
    select case (size(values))
    case (1)
      three(3) = values(1)
    case default
      three(:size(values)) = values
    end select
  end function three_of

  !> The address of an optional result, or NULL.
  type(c_ptr) function address_of(count)
    integer(c_int64_t), intent(in), target, optional :: count
    address_of = c_null_ptr
    if (present(count)) address_of = c_loc(count)
  end function address_of

end module halfspace_views
