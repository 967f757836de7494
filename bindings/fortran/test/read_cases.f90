! read_cases FILE: runs a file of cases, tests/cases/*.case, and compares the results with its expectations.
program read_cases
  use case_fields
  use case_scene
  use case_words
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: iostat_end, int64, real64
  implicit none

  type(scene), allocatable :: s
  character(1000) :: line, name, path
  character(longest_word), allocatable :: words(:)
  integer :: unit, iostat, line_number

  call get_command_argument(1, path)
  open (newunit=unit, file=path, status='old', action='read')
  line_number = 0
  name = ''
  call start(s)
  do
    read (unit, '(a)', iostat=iostat) line
    if (iostat == iostat_end) exit
    line_number = line_number + 1
    call split(line, words)
    if (size(words) > 0) call follow()
  end do
  call expect_success()
  deallocate (s)  ! variables of the main program are not finalized
  call finish()

contains

  subroutine follow()
    if (words(1) == 'refused') then
      call expect(s%status == constant(words(2)), here('the status'))
      call expect_text(s%text, trim(refused_text()))
      s%status = HS_OK
      return
    end if
    call expect_success()
    if (words(1) == 'case') then
      name = line(index(line, 'case') + 5:)
      call start(s)
    else if (words(1) == 'expect') then
      call compare()
    else if (.not. carry_out(words, s)) then
      call expect(.false., here('unknown statement'))
    end if
  end subroutine follow

  function refused_text() result(text)
    character(len(line)) :: text
    text = line(index(line, trim(words(2))) + len_trim(words(2)) + 1:)
  end function refused_text

  subroutine expect_success()
    if (s%status == HS_OK) return
    call expect(.false., here(trim(s%text)))
    s%status = HS_OK
  end subroutine expect_success

  function here(what)
    character(*), intent(in) :: what
    character(:), allocatable :: here
    character(12) :: digits
    write (digits, '(i0)') line_number
    here = trim(path)//':'//trim(digits)//': '//trim(name)//': '//what
  end function here

  subroutine compare()
    integer :: first, last
    real(real64), allocatable :: got(:), expected(:), tolerance(:)
    if (words(2) == 'hash') then
      call compare_hash()
      return
    end if
    first = merge(4, 3, any(words(2) == ['shape      ', 'block      ', 'deformation']))
    last = findloc_within()
    got = values_of(words(first))
    expected = numbers(words(first + 1 : last))
    allocate (tolerance(size(expected)))
    tolerance = 0
    if (size(words) == last + 2) tolerance = number(words(last + 2))
    if (size(words) > last + 2) tolerance = numbers(words(last + 2:))
    call expect(size(got) == size(expected), here('number of values'))
    if (size(got) /= size(expected)) return
    call expect(all(abs(got - expected) <= tolerance), here(trim(line)))
    if (any(.not. abs(got - expected) <= tolerance)) print '("  got ", *(es24.16))', got
  end subroutine compare

  !> The last word before `within`, or the last of all.
  integer function findloc_within() result(last)
    do last = 1, size(words) - 1
      if (words(last + 1) == 'within') return
    end do
    last = size(words)
  end function findloc_within

  subroutine compare_hash()
    integer(int64) :: hash
    character(16) :: digits
    hash = pose_hash(s%world)
    write (digits, '(z16.16)') hash
    call expect(digits == upper(words(3)), here('the hash is '//digits))
  end subroutine compare_hash

  function upper(word)
    character(*), intent(in) :: word
    character(len(word)) :: upper
    integer :: i
    upper = word
    do i = 1, len(word)
      if (word(i:i) >= 'a' .and. word(i:i) <= 'f') upper(i:i) = achar(iachar(word(i:i)) - 32)
    end do
  end function upper

  function values_of(field) result(values)
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    type(halfspace_shape_properties) :: properties
    type(halfspace_block_state) :: state
    type(halfspace_deformation) :: deformation
    type(halfspace_world_report) :: report
    select case (words(2))
    case ('shape')
      call s%shapes(shape_named(words(3), s))%shape%properties(properties)
      values = of_shape(properties, field)
    case ('contact')
      values = of_contact(s%contact, field)
    case ('impact')
      values = of_impact(s%impact, field)
    case ('block')
      call s%world%block_state(block_named(words(3), s), state)
      values = of_block(state, field)
    case ('deformation')
      call s%world%deformation(block_named(words(3), s), deformation)
      values = of_deformation(deformation, field)
    case ('report')
      call s%world%report(report)
      values = of_report(report, field)
    case ('energy')
      call s%world%report(report)
      values = of_energy(report%energy, field)
    case default
      error stop 'a case looks at something that this reader does not know'
    end select
  end function values_of

end program read_cases
