! read_cases FILE: carries out a file of cases, tests/cases/*.case, and compares with what it expects.
program read_cases
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
    select case (words(2))
    case ('shape'); values = of_shape(field)
    case ('contact'); values = of_contact(s%contact, field)
    case ('impact'); values = of_impact(s%impact, field)
    case ('block'); values = of_block(field)
    case ('deformation'); values = of_deformation(field)
    case ('report', 'energy'); values = of_report(field)
    case default; error stop 'a case looks at something that this reader does not know'
    end select
  end function values_of

  function of_shape(field) result(values)
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    type(halfspace_shape_properties) :: p
    call s%shapes(shape_named(words(3), s))%shape%properties(p)
    select case (field)
    case ('dimension'); values = [real(p%dimension, real64)]
    case ('vertex_count'); values = [real(p%vertex_count, real64)]
    case ('edge_count'); values = [real(p%edge_count, real64)]
    case ('face_count'); values = [real(p%face_count, real64)]
    case ('volume'); values = [p%volume]
    case ('centroid'); values = p%centroid
    case ('second_moment'); values = p%second_moment
    case ('bounding_radius'); values = [p%bounding_radius]
    case ('shortest_edge'); values = [p%shortest_edge]
    case default; error stop 'unknown field of a shape'
    end select
  end function of_shape

  function of_contact(c, field) result(values)
    type(halfspace_contact), intent(in) :: c
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    select case (field)
    case ('type'); values = [real(c%type, real64)]
    case ('pair_kind'); values = [real(c%pair_kind, real64)]
    case ('feature_a'); values = [real(c%feature_a - 1, real64)]
    case ('feature_b'); values = [real(c%feature_b - 1, real64)]
    case ('point_count'); values = [real(c%point_count, real64)]
    case ('normal'); values = c%normal
    case ('gap'); values = [c%gap]
    case ('area'); values = [c%area]
    case ('length'); values = [c%length]
    case ('center'); values = c%center
    case ('force'); values = c%force
    case ('normal_force'); values = [c%normal_force]
    case ('shear_force'); values = c%shear_force
    case default; error stop 'unknown field of a contact'
    end select
  end function of_contact

  function of_impact(i, field) result(values)
    type(halfspace_impact), intent(in) :: i
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    select case (field)
    case ('state'); values = [real(i%state, real64)]
    case ('pair_kind'); values = [real(i%pair_kind, real64)]
    case ('feature_a'); values = [real(i%feature_a - 1, real64)]
    case ('feature_b'); values = [real(i%feature_b - 1, real64)]
    case ('time'); values = [i%time]
    case ('gap'); values = [i%gap]
    case ('normal'); values = i%normal
    case ('point'); values = i%point
    case default; error stop 'unknown field of an impact'
    end select
  end function of_impact

  function of_block(field) result(values)
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    type(halfspace_block_state) :: b
    call s%world%block_state(block_named(words(3), s), b)
    select case (field)
    case ('position'); values = b%pose%position
    case ('rotation'); values = b%pose%rotation
    case ('velocity'); values = b%velocity
    case ('angular_velocity'); values = b%angular_velocity
    case ('force'); values = b%force
    case ('torque'); values = b%torque
    case ('mass'); values = [b%mass]
    case default; error stop 'unknown field of a block'
    end select
  end function of_block

  function of_deformation(field) result(values)
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    type(halfspace_deformation) :: d
    call s%world%deformation(block_named(words(3), s), d)
    select case (field)
    case ('gradient'); values = row_by_row(d%gradient)
    case ('rate'); values = row_by_row(d%rate)
    case ('strain'); values = row_by_row(d%strain)
    case ('stress'); values = row_by_row(d%stress)
    case ('strain_energy'); values = [d%strain_energy]
    case default; error stop 'unknown field of a deformation'
    end select
  end function of_deformation

  function row_by_row(tensor) result(values)
    real(real64), intent(in) :: tensor(3, 3)
    real(real64) :: values(9)
    values = [tensor(1, :), tensor(2, :), tensor(3, :)]
  end function row_by_row

  function of_report(field) result(values)
    character(*), intent(in) :: field
    real(real64), allocatable :: values(:)
    type(halfspace_world_report) :: r
    call s%world%report(r)
    select case (field)
    case ('dimension'); values = [real(r%dimension, real64)]
    case ('steps'); values = [real(r%steps, real64)]
    case ('time'); values = [r%time]
    case ('contact_count'); values = [real(r%contact_count, real64)]
    case ('largest_overlap'); values = [r%largest_overlap]
    case ('potential_length'); values = [r%potential_length]
    case ('block_strain_energy'); values = [r%block_strain_energy]
    case ('block_damping_loss'); values = [r%block_damping_loss]
    case ('divided_steps'); values = [real(r%divided_steps, real64)]
    case ('max_penetration_ratio'); values = [r%max_penetration_ratio]
    case ('peak_overlap'); values = [r%peak_overlap]
    case ('peak_speed'); values = [r%peak_speed]
    case ('sleeping_count'); values = [real(r%sleeping_count, real64)]
    case ('max_sleep_error'); values = [r%max_sleep_error]
    case ('kinetic'); values = [r%energy%kinetic]
    case ('gravity'); values = [r%energy%gravity]
    case ('strain'); values = [r%energy%strain]
    case ('friction_loss'); values = [r%energy%friction_loss]
    case ('contact_damping_loss'); values = [r%energy%contact_damping_loss]
    case ('residual'); values = [r%energy%residual]
    case default; error stop 'unknown field of a report'
    end select
  end function of_report

end program read_cases
