!> The test driver: expectations, reports of failures, and a summary.
module checking
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  private
  public :: expect, expect_close, expect_text, finish

  integer :: failures = 0, expectations = 0

contains

  subroutine expect(holds, what)
    logical, intent(in) :: holds
    character(*), intent(in) :: what
    expectations = expectations + 1
    if (holds) return
    failures = failures + 1
    print '("FAILED: ", a)', what
  end subroutine expect

  subroutine expect_close(got, expected, tolerance, what)
    real(real64), intent(in) :: got(:), expected(:), tolerance
    character(*), intent(in) :: what
    call expect(size(got) == size(expected), what//': number of values')
    if (size(got) /= size(expected)) return
    call expect(all(abs(got - expected) <= tolerance), what)
    if (any(.not. abs(got - expected) <= tolerance)) print '("  got ", *(es24.16))', got
  end subroutine expect_close

  subroutine expect_text(text, part)
    character(*), intent(in) :: text, part
    call expect(index(text, part) > 0, 'the text "'//trim(text)//'" has "'//part//'"')
  end subroutine expect_text

  subroutine finish()
    if (failures > 0) then
      print '(i0, " of ", i0, " expectations failed")', failures, expectations
      error stop 1
    end if
    print '(i0, " expectations met")', expectations
  end subroutine finish

end module checking
