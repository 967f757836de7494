! stat= and errmsg= as in allocate; and, with an argument, calls without stat=.
program test_errors
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none

  real(real64), parameter :: dented(2, 5) = reshape([real(real64) :: 0, 0, 2, 0, 1, 0.5, 2, 2, 0, 2], [2, 5])
  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  character(20) :: what

  call get_command_argument(1, what)
  select case (what)
  case ('')
    call told_by_stat()
    call finish()
  case ('error')
    call stops_at_an_error()
  case ('errmsg')
    call stops_at_an_error_with_errmsg()
  case ('note')
    call stops_at_a_note()
  case ('nothing')
    call stops_without_an_object()
  end select

contains

  subroutine told_by_stat()
    type(halfspace_shape) :: shape
    type(halfspace_context) :: context, none
    type(halfspace_world) :: world
    integer :: stat
    character(200) :: text
    character(10) :: short
    call context%create()
    call expect(context%last_error() == '', 'nothing has failed yet')
    text = 'as it was'
    call shape%create_polygon(corners, context=context, stat=stat, errmsg=text)
    call expect(stat == HS_OK .and. text == 'as it was', 'without an error, errmsg stays')
    call shape%create_polygon(dented, context=context, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_GEOMETRY, 'a dent')
    call expect_text(text, 'hs_polygon_create: vertices[2] = (1, 0.5)')
    call expect(context%last_error() == text, 'the context keeps the text')
    call expect(shape%exists(), 'after an error nothing has changed')
    call shape%create_polygon(dented, stat=stat, errmsg=short)
    call expect(short == 'hs_polygon', 'a short errmsg takes what it holds')
    call shape%create_polygon(corners, context=none, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a context that was not created')
    call expect_text(text, 'was not created')
    call world%step(1, stat, text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a world that was not created')
    call expect_text(text, 'was not created')
    call world%create(gravity=[1.0_real64], stat=stat, errmsg=text)
    call expect_text(text, 'gravity: has 1 values; it must have 2 or 3')
    call world%create(safety=2.0_real64, stat=stat, errmsg=text)
    call expect_text(text, 'hs_world_create: def.safety is 2')
    call expect(.not. world%exists(), 'there is still none')
    call expect(world%block_count() == 0, 'it has no blocks')
    call expect(index(halfspace_version(), '.') > 0, 'a version')
  end subroutine told_by_stat

  subroutine stops_at_an_error()
    type(halfspace_shape) :: shape
    call shape%create_polygon(dented)
  end subroutine stops_at_an_error

  subroutine stops_at_an_error_with_errmsg()
    type(halfspace_shape) :: shape
    character(100) :: text
    call shape%create_polygon(dented, errmsg=text)
  end subroutine stops_at_an_error_with_errmsg

  subroutine stops_at_a_note()
    type(halfspace_shape) :: shape
    real(real64) :: points(2, 3)
    call shape%create_polygon(corners)
    call shape%vertices(points)
  end subroutine stops_at_a_note

  subroutine stops_without_an_object()
    type(halfspace_world) :: world
    call world%detect()
  end subroutine stops_without_an_object

end program test_errors
