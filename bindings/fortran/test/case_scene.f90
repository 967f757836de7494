!> What a case has made so far, and the statements that make it. The files count from 0, the modules from 1.
module case_scene
  use case_fields, only: constant, set_elasticity, set_law
  use case_words, only: longest_word, number, numbers
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, int64, real64
  implicit none
  private
  public :: block_named, carry_out, pose_hash, scene, shape_named, start

  integer, parameter :: most_names = 50

  type :: named_shape
    character(longest_word) :: name = ''
    type(halfspace_shape) :: shape
    type(halfspace_pose) :: pose
    type(halfspace_motion) :: motion  !< but for its start, which is the pose
  end type named_shape

  type :: named_block
    character(longest_word) :: name = ''
    type(halfspace_block) :: block
  end type named_block

  type :: scene
    type(named_shape), allocatable :: shapes(:)
    type(named_block), allocatable :: blocks(:)
    type(halfspace_context) :: context
    type(halfspace_world) :: world
    type(halfspace_contact) :: contact  !< the one that expectations look at
    type(halfspace_impact) :: impact  !< likewise
    integer(int32), allocatable :: face_sizes(:), face_vertices(:)
    real(real64), allocatable :: parallel_angle, vertex_zone
    integer :: status = HS_OK  !< of the last statement
    character(512) :: text = ''  !< likewise
  end type scene

contains

  !> Forgets the case before.
  subroutine start(s)
    type(scene), allocatable, intent(inout) :: s
    if (allocated(s)) deallocate (s)
    allocate (s)
    allocate (s%shapes(most_names), s%blocks(most_names))
    call s%context%create()
  end subroutine start

  !> Carries out a statement; false if it is none of those that make something.
  logical function carry_out(words, s) result(known)
    character(longest_word), intent(in) :: words(:)
    type(scene), intent(inout) :: s
    type(halfspace_world) :: restored
    type(halfspace_shape) :: behind, ahead
    integer :: a, b, material
    known = .true.
    select case (words(1))
    case ('faces')
      call keep_faces(int(numbers(words(2:))), s)
    case ('shape')
      call make_shape(words, s)
    case ('cut')
      call s%shapes(shape_named(words(2), s))%shape%cut(numbers(words(3:5)), numbers(words(6:8)), behind, ahead, &
                                                       s%status, s%text)
      if (s%status == HS_OK) then
        call keep_shape(words(9), behind, s)
        call keep_shape(words(10), ahead, s)
      end if
    case ('options')
      call keep_options(words(2:), s)
    case ('pose')
      s%shapes(shape_named(words(2), s))%pose = pose_of(numbers(words(3:9)))
    case ('pair')
      a = shape_named(words(2), s)
      b = shape_named(words(3), s)
      call halfspace_detect_pair(s%shapes(a)%shape, s%shapes(a)%pose, s%shapes(b)%shape, s%shapes(b)%pose, s%contact, &
                                 parallel_angle=s%parallel_angle, vertex_zone=s%vertex_zone, stat=s%status, &
                                 errmsg=s%text)
    case ('motion')
      s%shapes(shape_named(words(2), s))%motion = motion_of(words(3:))
    case ('impact')
      a = shape_named(words(2), s)
      b = shape_named(words(3), s)
      call find_impact(s%shapes(a), s%shapes(b), number(words(4)), s)
    case ('world')
      call make_world(words(2:), s)
    case ('material')
      call s%world%add_material(number(words(2)), material, s%status, s%text)
    case ('default_law')
      call s%world%set_law(law_of(words(2:)), s%status, s%text)
    case ('law')
      call s%world%set_law(law_of(words(4:)), index_of(words(2)), index_of(words(3)), s%status, s%text)
    case ('elasticity')
      call s%world%set_elasticity(index_of(words(2)), elasticity_of(words(3:)), s%status, s%text)
    case ('block')
      call make_block(words, s)
    case ('set_pose')
      call s%world%set_pose(block_named(words(2), s), pose_of(numbers(words(3:9))), s%status, s%text)
    case ('velocity')
      call s%world%set_velocity(block_named(words(2), s), numbers(words(3:5)), numbers(words(6:8)), s%status, s%text)
    case ('applied_force')
      call s%world%set_applied_force(block_named(words(2), s), numbers(words(3:5)), numbers(words(6:8)), s%status, &
                                     s%text)
    case ('set_deformation')
      call s%world%set_deformation(block_named(words(2), s), tensor_of(words(3:11)), tensor_of(words(12:20)), &
                                   s%status, s%text)
    case ('set_stress')
      call s%world%set_stress(block_named(words(2), s), tensor_of(words(3:11)), s%status, s%text)
    case ('surface_load')
      call s%world%add_surface_load(block_named(words(2), s), index_of(words(3)), numbers(words(4:6)), s%status, s%text)
    case ('clear_surface_loads')
      call s%world%clear_surface_loads(block_named(words(2), s), s%status, s%text)
    case ('remove')
      call s%world%remove_block(block_named(words(2), s), s%status, s%text)
    case ('detect')
      call s%world%detect(stat=s%status, errmsg=s%text)
      call look_at_contacts(s)
    case ('forces')
      call evaluate_forces(number(words(2)), s)
    case ('step')
      call s%world%step(int(number(words(2))), s%status, s%text)
      call look_at_contacts(s)
    case ('reopen')
      call reopen(s)
    case ('restore')
      call restored%restore(int(numbers(words(2:)), int8), s%context, s%status, s%text)
    case default
      known = .false.
    end select
  end function carry_out

  subroutine keep_faces(values, s)
    integer, intent(in) :: values(:)
    type(scene), intent(inout) :: s
    integer :: first
    s%face_sizes = [integer ::]
    s%face_vertices = [integer ::]
    first = 1
    do while (first <= size(values))
      s%face_sizes = [s%face_sizes, values(first)]
      s%face_vertices = [s%face_vertices, values(first + 1 : first + values(first)) + 1]
      first = first + values(first) + 1
    end do
  end subroutine keep_faces

  subroutine make_shape(words, s)
    character(longest_word), intent(in) :: words(:)
    type(scene), intent(inout) :: s
    type(halfspace_shape) :: shape
    real(real64), allocatable :: values(:)
    values = numbers(words(4:))
    select case (words(3))
    case ('polygon')
      call shape%create_polygon(columns(values, 2), context=s%context, stat=s%status, errmsg=s%text)
    case ('polygon_hull')
      call shape%create_polygon_hull(columns(values, 2), context=s%context, stat=s%status, errmsg=s%text)
    case ('boundary')
      call boundary(values(:2), values(3:4), values(5), values(6:))
    case ('polyhedron')
      call shape%create_polyhedron(columns(values, 3), s%face_sizes, s%face_vertices, context=s%context, &
                                   stat=s%status, errmsg=s%text)
    case ('polyhedron_hull')
      call shape%create_polyhedron_hull(columns(values, 3), context=s%context, stat=s%status, errmsg=s%text)
    case ('halfspaces')
      call from_halfspaces(columns(values, 4))
    case default
      error stop 'a case makes a shape in a way that this reader does not know'
    end select
    if (s%status == HS_OK) call keep_shape(words(2), shape, s)
  contains
    subroutine boundary(first, second, depth, neighbours)
      real(real64), intent(in) :: first(:), second(:), depth, neighbours(:)
      if (size(neighbours) > 0) then
        call shape%create_boundary(first, second, depth, neighbours(:2), neighbours(3:), context=s%context, &
                                   stat=s%status, errmsg=s%text)
      else
        call shape%create_boundary(first, second, depth, context=s%context, stat=s%status, errmsg=s%text)
      end if
    end subroutine boundary

    subroutine from_halfspaces(planes)
      real(real64), intent(in) :: planes(:,:)
      call shape%create_from_halfspaces(planes(:3, :), planes(4, :), context=s%context, stat=s%status, errmsg=s%text)
    end subroutine from_halfspaces
  end subroutine make_shape

  function columns(values, components)
    real(real64), intent(in) :: values(:)
    integer, intent(in) :: components
    real(real64) :: columns(components, size(values) / components)
    columns = reshape(values, shape(columns))
  end function columns

  subroutine keep_shape(name, shape, s)
    character(*), intent(in) :: name
    type(halfspace_shape), intent(in) :: shape
    type(scene), intent(inout) :: s
    integer :: i
    do i = 1, most_names
      if (s%shapes(i)%name /= name .and. s%shapes(i)%name /= '') cycle
      s%shapes(i)%name = name
      s%shapes(i)%shape = shape
      s%shapes(i)%pose = halfspace_pose(0.0_real64, 0.0_real64)
      s%shapes(i)%motion = halfspace_motion()
      return
    end do
    error stop 'more shapes than this reader keeps'
  end subroutine keep_shape

  integer function shape_named(name, s) result(place)
    character(*), intent(in) :: name
    type(scene), intent(in) :: s
    do place = 1, most_names
      if (s%shapes(place)%name == name) return
    end do
    error stop 'a case names a shape that it has not made'
  end function shape_named

  subroutine keep_options(words, s)
    character(longest_word), intent(in) :: words(:)
    type(scene), intent(inout) :: s
    integer :: i
    do i = 1, size(words), 2
      select case (words(i))
      case ('parallel_angle'); s%parallel_angle = number(words(i + 1))
      case ('vertex_zone'); s%vertex_zone = number(words(i + 1))
      case default; error stop 'unknown option'
      end select
    end do
  end subroutine keep_options

  type(halfspace_motion) function motion_of(words) result(motion)
    character(longest_word), intent(in) :: words(:)
    integer :: i
    motion = halfspace_motion()
    i = 1
    do while (i < size(words))
      select case (words(i))
      case ('velocity'); motion%velocity = numbers(words(i + 1 : i + 3)); i = i + 4
      case ('angular_velocity'); motion%angular_velocity = numbers(words(i + 1 : i + 3)); i = i + 4
      case ('gradient'); motion%gradient = numbers(words(i + 1 : i + 9)); i = i + 10
      case ('gradient_rate'); motion%gradient_rate = numbers(words(i + 1 : i + 9)); i = i + 10
      case default; error stop 'unknown field of a motion'
      end select
    end do
  end function motion_of

  subroutine find_impact(a, b, duration, s)
    type(named_shape), intent(in) :: a, b
    real(real64), intent(in) :: duration
    type(scene), intent(inout) :: s
    type(halfspace_motion) :: motion_a, motion_b
    motion_a = a%motion
    motion_a%start = a%pose
    motion_b = b%motion
    motion_b%start = b%pose
    call halfspace_time_of_impact(a%shape, motion_a, b%shape, motion_b, duration, s%impact, s%status, s%text)
  end subroutine find_impact

  subroutine make_world(words, s)
    character(longest_word), intent(in) :: words(:)
    type(scene), intent(inout) :: s
    integer, allocatable :: dimension
    integer(int32), allocatable :: fast_blocks
    real(real64), allocatable :: time_step, safety, potential_length, sleep_tolerance, gravity(:)
    integer :: i
    i = 1
    do while (i < size(words))
      select case (words(i))
      case ('dimension'); dimension = int(number(words(i + 1)))
      case ('time_step'); time_step = number(words(i + 1))
      case ('safety'); safety = number(words(i + 1))
      case ('potential_length'); potential_length = number(words(i + 1))
      case ('fast_blocks'); fast_blocks = constant(words(i + 1))
      case ('sleep_tolerance'); sleep_tolerance = number(words(i + 1))
      case ('gravity')
        gravity = numbers(words(i + 1 : i + 3))
        i = i + 2
      case default; error stop 'unknown field of a world'
      end select
      i = i + 2
    end do
    call s%world%create(dimension=dimension, gravity=gravity, time_step=time_step, safety=safety, &
                        potential_length=potential_length, fast_blocks=fast_blocks, sleep_tolerance=sleep_tolerance, &
                        context=s%context, stat=s%status, errmsg=s%text)
  end subroutine make_world

  type(halfspace_law) function law_of(words) result(law)
    character(longest_word), intent(in) :: words(:)
    integer :: i
    law = halfspace_law()
    do i = 1, size(words), 2
      call set_law(law, words(i), number(words(i + 1)))
    end do
  end function law_of

  type(halfspace_elasticity) function elasticity_of(words) result(elasticity)
    character(longest_word), intent(in) :: words(:)
    integer :: i
    elasticity = halfspace_elasticity()
    do i = 1, size(words), 2
      call set_elasticity(elasticity, words(i), number(words(i + 1)))
    end do
  end function elasticity_of

  !> The files have tensors row by row.
  function tensor_of(words) result(tensor)
    character(longest_word), intent(in) :: words(9)
    real(real64) :: tensor(3, 3)
    tensor = transpose(reshape(numbers(words), [3, 3]))
  end function tensor_of

  integer function index_of(word)
    character(*), intent(in) :: word
    index_of = int(number(word)) + 1
  end function index_of

  pure type(halfspace_pose) function pose_of(values) result(pose)
    real(real64), intent(in) :: values(7)
    pose%position = values(1:3)
    pose%rotation = values(4:7)
  end function pose_of

  subroutine make_block(words, s)
    character(longest_word), intent(in) :: words(:)
    type(scene), intent(inout) :: s
    type(halfspace_block) :: block
    integer :: i
    call s%world%add_block(s%shapes(shape_named(words(3), s))%shape, block, kind=constant(words(4)), &
                           material=index_of(words(5)), pose=pose_of(numbers(words(6:12))), stat=s%status, &
                             errmsg=s%text)
    if (s%status /= HS_OK) return
    do i = 1, most_names
      if (s%blocks(i)%name /= words(2) .and. s%blocks(i)%name /= '') cycle
      s%blocks(i) = named_block(words(2), block)
      return
    end do
    error stop 'more blocks than this reader keeps'
  end subroutine make_block

  type(halfspace_block) function block_named(name, s) result(block)
    character(*), intent(in) :: name
    type(scene), intent(in) :: s
    integer :: i
    do i = 1, most_names
      if (s%blocks(i)%name /= name) cycle
      block = s%blocks(i)%block
      return
    end do
    error stop 'a case names a block that it has not made'
  end function block_named

  subroutine look_at_contacts(s)
    type(scene), intent(inout) :: s
    type(halfspace_contact), allocatable :: list(:)
    if (s%status /= HS_OK) return
    call s%world%contacts(list)
    if (size(list) > 0) s%contact = list(1)
  end subroutine look_at_contacts

  subroutine evaluate_forces(elapsed, s)
    real(real64), intent(in) :: elapsed
    type(scene), intent(inout) :: s
    real(real64), allocatable :: force(:,:), torque(:,:)
    allocate (force(3, s%world%block_count()), torque(3, s%world%block_count()))
    call s%world%forces(elapsed, force, torque, stat=s%status, errmsg=s%text)
    call look_at_contacts(s)
  end subroutine evaluate_forces

  subroutine reopen(s)
    type(scene), intent(inout) :: s
    integer(int8), allocatable :: bytes(:)
    call s%world%save(bytes)
    call s%world%destroy()
    call s%world%restore(bytes, s%context, s%status, s%text)
  end subroutine reopen

  !> FNV-1a, 64 bits, of the bytes of all poses.
  integer(int64) function pose_hash(world) result(hash)
    type(halfspace_world), intent(in) :: world
    integer(int64), parameter :: low_half = int(z'ffffffff', int64)
    type(halfspace_pose), allocatable :: poses(:)
    integer(int8), allocatable :: bytes(:)
    integer(int64) :: low, high
    integer :: i
    allocate (poses(world%block_count()))
    allocate (bytes(size(poses) * storage_size(poses) / storage_size(bytes)))
    call world%poses(poses)
    bytes(:) = transfer(poses, bytes)
    hash = ior(ishft(int(z'cbf29ce4', int64), 32), int(z'84222325', int64))
    do i = 1, size(bytes)
      hash = ieor(hash, iand(int(bytes(i), int64), 255_int64))
      ! The prime is 2^40 + 435. The low and high halves apart, as integers must not overflow.
      low = iand(hash, low_half) * 435
      high = iand(ishft(hash, -32) * 435 + ishft(low, -32) + ishft(iand(hash, 16777215_int64), 8), low_half)
      hash = ior(ishft(high, 32), iand(low, low_half))
    end do
  end function pose_hash

end module case_scene
