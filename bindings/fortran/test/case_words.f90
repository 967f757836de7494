!> Lines of case files: their words and numbers.
module case_words
  use case_fields, only: constant
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  private
  public :: longest_word, number, numbers, split

  integer, parameter :: longest_word = 80

contains

  !> The words of a line without its comment.
  subroutine split(line, words)
    character(*), intent(in) :: line
    character(longest_word), allocatable, intent(out) :: words(:)
    character(longest_word) :: found(100)
    character(:), allocatable :: rest
    integer :: count, blank
    rest = line
    if (index(line, '#') > 0) rest = line(:index(line, '#') - 1)
    count = 0
    do
      rest = trim(adjustl(rest))
      if (len(rest) == 0) exit
      blank = index(rest//' ', ' ')
      count = count + 1
      found(count) = rest(:blank - 1)
      rest = rest(blank:)
    end do
    words = found(:count)
  end subroutine split

  real(real64) function number(word)
    character(*), intent(in) :: word
    if (word(:min(3, len(word))) == 'HS_') then
      number = constant(word)
    else
      read (word, *) number
    end if
  end function number

  function numbers(words)
    character(*), intent(in) :: words(:)
    real(real64) :: numbers(size(words))
    integer :: i
    do i = 1, size(words)
      numbers(i) = number(words(i))
    end do
  end function numbers

end module case_words
