!> Lines of case files: their words, numbers, and the constants that they name.
module case_words
  use halfspace
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  private
  public :: longest_word, constant, number, numbers, split

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

  integer function constant(name)
    character(*), intent(in) :: name
    select case (name)
    case ('HS_ERROR_ARGUMENT'); constant = HS_ERROR_ARGUMENT
    case ('HS_ERROR_GEOMETRY'); constant = HS_ERROR_GEOMETRY
    case ('HS_ERROR_STALE_ID'); constant = HS_ERROR_STALE_ID
    case ('HS_ERROR_STATE'); constant = HS_ERROR_STATE
    case ('HS_ERROR_UNSTABLE'); constant = HS_ERROR_UNSTABLE
    case ('HS_ERROR_TOO_FAST'); constant = HS_ERROR_TOO_FAST
    case ('HS_ERROR_INVERTED'); constant = HS_ERROR_INVERTED
    case ('HS_FAST_DIVIDE'); constant = HS_FAST_DIVIDE
    case ('HS_FAST_REFUSE'); constant = HS_FAST_REFUSE
    case ('HS_ERROR_FORMAT'); constant = HS_ERROR_FORMAT
    case ('HS_CONTACT_NONE'); constant = HS_CONTACT_NONE
    case ('HS_CONTACT_VERTEX_VERTEX'); constant = HS_CONTACT_VERTEX_VERTEX
    case ('HS_CONTACT_VERTEX_EDGE'); constant = HS_CONTACT_VERTEX_EDGE
    case ('HS_CONTACT_EDGE_EDGE'); constant = HS_CONTACT_EDGE_EDGE
    case ('HS_CONTACT_EDGE_FACE'); constant = HS_CONTACT_EDGE_FACE
    case ('HS_CONTACT_FACE_FACE'); constant = HS_CONTACT_FACE_FACE
    case ('HS_CONTACT_VERTEX_FACE'); constant = HS_CONTACT_VERTEX_FACE
    case ('HS_PAIR_FACE_VERTEX'); constant = HS_PAIR_FACE_VERTEX
    case ('HS_PAIR_VERTEX_FACE'); constant = HS_PAIR_VERTEX_FACE
    case ('HS_PAIR_EDGE_EDGE'); constant = HS_PAIR_EDGE_EDGE
    case ('HS_PAIR_VERTEX_VERTEX'); constant = HS_PAIR_VERTEX_VERTEX
    case ('HS_STIFFNESS_PER_CONTACT'); constant = HS_STIFFNESS_PER_CONTACT
    case ('HS_STIFFNESS_PER_AREA'); constant = HS_STIFFNESS_PER_AREA
    case ('HS_STIFFNESS_POTENTIAL'); constant = HS_STIFFNESS_POTENTIAL
    case ('HS_IMPACT_NEVER'); constant = HS_IMPACT_NEVER
    case ('HS_IMPACT_AT_START'); constant = HS_IMPACT_AT_START
    case ('HS_IMPACT_TOUCH'); constant = HS_IMPACT_TOUCH
    case ('HS_PLANE_STRAIN'); constant = HS_PLANE_STRAIN
    case ('HS_PLANE_STRESS'); constant = HS_PLANE_STRESS
    case ('HS_BLOCK_FIXED'); constant = HS_BLOCK_FIXED
    case ('HS_BLOCK_PRESCRIBED'); constant = HS_BLOCK_PRESCRIBED
    case ('HS_BLOCK_RIGID'); constant = HS_BLOCK_RIGID
    case ('HS_BLOCK_AFFINE'); constant = HS_BLOCK_AFFINE
    case ('HS_BLOCK_MESH'); constant = HS_BLOCK_MESH
    case default; error stop 'a case names a constant that this reader does not know'
    end select
  end function constant

end module case_words
