! Ownership: all memory is released with the last owner, in any order; assignment adds a reference; bitwise copies are
! refused and release nothing.
program test_ownership
  use checking
  use counting
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
  real(real64), parameter :: tetrahedron_corners(3, 4) = reshape([real(real64) :: 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, &
                                                                  1], [3, 4])
  integer(int32), parameter :: tetrahedron_faces(12) = [1, 3, 2, 1, 2, 4, 1, 4, 3, 2, 3, 4]

  integer(int32), parameter :: quad(4, 1) = reshape([1, 2, 3, 4], [4, 1])

  type :: model
    type(halfspace_shape) :: shape
    integer :: number = 0
  end type model

  type(counting_allocator), target :: memory

  call end_of_scope()
  call expect_nothing_left('end of scope')
  call assignment_shares()
  call expect_nothing_left('assignment')
  call assigned_to_itself()
  call expect_nothing_left('assigned to itself')
  call arrays_share()
  call expect_nothing_left('arrays')
  call created_again()
  call expect_nothing_left('created again')
  call parts_of_a_cut()
  call expect_nothing_left('parts of a cut')
  call allocatables()
  call expect_nothing_left('allocatables')
  call foreign_copies()
  call expect_nothing_left('foreign copies')
  call nested_copies()
  call expect_nothing_left('nested copies')
  call failed_allocations()
  call failed_statements()
  call finish()

contains

  subroutine expect_nothing_left(after)
    character(*), intent(in) :: after
    call expect(memory%requests > 0, 'the allocator was asked: '//after)
    call expect(memory%living == 0 .and. memory%bytes == 0, 'all memory is released: '//after)
    memory = counting_allocator()
  end subroutine expect_nothing_left

  subroutine make_square(shape, context)
    type(halfspace_shape), intent(inout) :: shape
    type(halfspace_context), intent(in) :: context
    call shape%create_polygon(corners, context=context)
  end subroutine make_square

  ! The context is first and last: the order of finalization depends on the compiler.
  subroutine end_of_scope()
    type(halfspace_context) :: context
    type(halfspace_world) :: world
    type(halfspace_shape) :: shape
    type(halfspace_mesh) :: mesh
    type(halfspace_context) :: again
    integer :: material
    call context%create(memory)
    again = context
    call make_square(shape, context)
    call mesh%create(corners, HS_CELL_QUAD, quad, context=again)
    call world%create(context=again)
    call world%add_material(1.0_real64, material)
    call world%add_block(shape)
    call context%destroy()
    call expect(world%block_count() == 1, 'the world lives on without the context')
    call world%step(3)
  end subroutine end_of_scope

  subroutine assignment_shares()
    type(halfspace_context) :: context
    type(halfspace_shape) :: a, b
    type(halfspace_world) :: world, same
    type(halfspace_shape_properties) :: properties
    integer :: material
    call context%create(memory)
    call make_square(a, context)
    b = a
    call a%destroy()
    call expect(.not. a%exists() .and. b%exists(), 'a copy outlives the original')
    b = b
    call b%properties(properties)
    call expect(properties%vertex_count == 4, 'the copy has the shape')
    a = b
    call world%create(context=context)
    same = world
    call same%add_material(1.0_real64, material)
    call same%add_block(b)
    call expect(world%block_count() == 1, 'both names are the same world')
    call make_square(a, context)
  end subroutine assignment_shares

  subroutine assigned_to_itself()
    type(halfspace_context) :: context
    type(halfspace_shape), target :: list(2)
    type(halfspace_shape), pointer :: one, same
    type(model), target :: whole
    type(model), pointer :: part
    integer :: i
    call context%create(memory)
    do i = 1, 2
      call make_square(list(i), context)
    end do
    one => list(1)
    same => list(1)
    one = same
    call expect(list(1)%exists(), 'through two pointers')
    list = list
    call expect(all(list%exists()), 'elements of an array')
    call make_square(whole%shape, context)
    part => whole
    part%shape = whole%shape
    call expect(whole%shape%exists(), 'a component')
  end subroutine assigned_to_itself

  subroutine arrays_share()
    type(halfspace_context) :: context
    type(halfspace_shape) :: a(3), b(2), square
    integer :: i
    call context%create(memory)
    do i = 1, 3
      call make_square(a(i), context)
    end do
    b = a(2:3)
    call a(2)%destroy()
    call expect(b(1)%exists(), 'an element of a copy outlives the original')
    call make_square(square, context)
    a(1:2) = [square, b(1)]
    call b%destroy()
    call expect(all(a%exists()), 'elements of an array constructor are shared')
  end subroutine arrays_share

  subroutine created_again()
    type(halfspace_context) :: context
    type(halfspace_shape) :: shape
    integer :: i, living
    call context%create(memory)
    call make_square(shape, context)
    living = memory%living
    do i = 1, 5
      call make_square(shape, context)
    end do
    call expect(memory%living == living, 'creating again ends what was there')
    call context%create(memory)
    call expect(shape%exists(), 'the shape keeps the context it was made from')
  end subroutine created_again

  subroutine parts_of_a_cut()
    type(halfspace_context) :: context
    type(halfspace_shape) :: whole, left, right
    call context%create(memory)
    call make_square(whole, context)
    call context%destroy()
    call whole%cut([0.25_real64, 0.0_real64], [1.0_real64, 0.0_real64], left, right)
    call whole%destroy()
    call expect(left%exists() .and. right%exists(), 'both parts live without the whole')
    whole = right
    call whole%cut([2.0_real64, 0.0_real64], [1.0_real64, 0.0_real64], left, right)
    call expect(left%exists() .and. .not. right%exists(), 'there is no part beyond the shape')
  end subroutine parts_of_a_cut

  subroutine allocatables()
    type(halfspace_context) :: context
    type(halfspace_shape), allocatable :: list(:), longer(:)
    type(halfspace_shape), pointer :: one
    call context%create(memory)
    allocate (list(1), longer(2), one)
    call make_square(list(1), context)
    call make_square(one, context)
    longer(:1) = list
    longer(2) = one
    deallocate (one)
    call move_alloc(longer, list)
    call expect(all(list%exists()), 'elements survive a move')
  end subroutine allocatables

  ! allocate(source=) copies bit by bit.
  subroutine foreign_copies()
    type(halfspace_context) :: context
    type(halfspace_shape) :: square
    type(halfspace_shape), allocatable :: copy
    type(halfspace_shape_properties) :: properties
    integer :: stat
    character(100) :: text
    call context%create(memory)
    call make_square(square, context)
    allocate (copy, source=square)
    call copy%properties(properties, stat, text)
    call expect(.not. copy%exists() .and. stat == HS_ERROR_ARGUMENT, 'a copy by source= is refused')
    call expect_text(text, 'bitwise copy without assignment')
    deallocate (copy)
    call expect(square%exists(), 'the original stays')
  end subroutine foreign_copies

  ! gfortran 12 copies the components of other types bit by bit, too; other compilers assign them. Both are safe.
  subroutine nested_copies()
    type(halfspace_context) :: context
    type(model) :: a, b, c
    call context%create(memory)
    call make_square(a%shape, context)
    b = a
    call expect(a%shape%exists(), 'the original stays')
    c%shape = a%shape
    call expect(c%shape%exists(), 'a component is shared')
  end subroutine nested_copies

  ! The allocator fails at the n-th request, for every n.
  subroutine failed_allocations()
    integer :: n, stat
    character(200) :: text
    logical :: done
    done = .false.
    do n = 0, 1000
      memory = counting_allocator(most_requests=n)
      call build(stat, text)
      call expect(memory%living == 0, 'nothing is left after a failed allocation')
      done = stat == HS_OK
      if (done) exit
      call expect(stat == HS_ERROR_OUT_OF_MEMORY, 'out of memory: '//trim(text))
    end do
    call expect(done .and. n > 3, 'it works in the end')
  end subroutine failed_allocations

  ! Likewise for allocate statements of the modules, which do not use the allocator.
  subroutine failed_statements()
    integer :: n, stat
    character(200) :: text
    do n = 1, 1000
      memory = counting_allocator()
      statements = 0
      refused_statement = n
      call build(stat, text)
      refused_statement = 0
      call expect(memory%living == 0, 'nothing is left after a failed statement')
      if (stat == HS_OK) exit
      call expect(stat == HS_ERROR_OUT_OF_MEMORY .and. text == 'there is no memory for the result', &
                  'out of memory: '//trim(text))
    end do
    call expect(stat == HS_OK .and. n > 15, 'it works in the end')
  end subroutine failed_statements

  subroutine build(stat, text)
    integer, intent(out) :: stat
    character(*), intent(inout) :: text
    type(halfspace_context) :: context
    type(halfspace_shape) :: shape, left, right
    type(halfspace_world) :: world, restored, fallen
    type(halfspace_bond_state), allocatable :: bonds(:)
    type(halfspace_bond_event), allocatable :: events(:)
    type(halfspace_strength_report) :: report
    type(halfspace_contact), allocatable :: contacts(:)
    type(halfspace_contact) :: found(3)
    type(halfspace_block), allocatable :: blocks(:)
    type(halfspace_pose) :: poses(3)
    type(halfspace_shape) :: shapes(3), tetrahedron
    type(halfspace_mesh) :: mesh
    type(halfspace_body) :: body
    type(halfspace_block) :: pulled
    integer(int32), parameter :: pairs(2, 3) = reshape([1, 2, 2, 3, 3, 1], [2, 3])
    integer(int32), allocatable :: first_of_face(:), face_vertices(:), edges(:,:)
    integer(int8), allocatable :: bytes(:)
    real(real64), allocatable :: cleaned(:,:)
    integer :: material, i
    do i = 1, 3  ! each half a square wide, with a small overlap
      poses(i) = halfspace_pose(0.4375_real64 * i, 0.0_real64)
    end do
    call context%create(memory, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call shape%create_polygon(corners, context=context, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call shape%cut([0.5_real64, 0.0_real64], [1.0_real64, 0.0_real64], left, right, stat, text)
    if (stat /= HS_OK) return
    call world%create(context=context, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%add_material(1.0_real64, material, stat, text)
    if (stat /= HS_OK) return
    do i = 1, 3
      call world%add_block(left, pose=poses(i), stat=stat, errmsg=text)
      if (stat /= HS_OK) return
    end do
    call world%step(1, stat, text)
    if (stat /= HS_OK) return
    call world%contacts(contacts, stat, text)
    if (stat /= HS_OK) return
    call world%blocks(blocks, stat, text)
    if (stat /= HS_OK) return
    call mesh%create(corners, HS_CELL_QUAD, quad, context=context, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%set_elasticity(material, halfspace_elasticity(), stat, text)
    if (stat /= HS_OK) return
    call world%add_mesh(mesh, body, pose=poses(1), cell_materials=[material], stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%hold_nodes(body, [1, 2], HS_AXIS_X, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%set_node_force(body, [3, 4], [1.0_real64, 0.0_real64], stat, text)
    if (stat /= HS_OK) return
    do i = 1, 2  ! side by side; a force acts on the second one
      call world%add_block(left, pulled, pose=halfspace_pose(4 + 0.5_real64 * i, 0.0_real64), stat=stat, errmsg=text)
      if (stat /= HS_OK) return
    end do
    call world%set_applied_force(pulled, [1.0_real64, 0.0_real64], stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%bond_materials(material, material, halfspace_bond(), stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%bonds(bonds, stat, text)
    if (stat /= HS_OK) return
    call world%step(10, stat, text)
    if (stat /= HS_OK) return
    call world%bond_events(events, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call expect(size(bonds) == 1 .and. size(events) == 3, 'a bond has failed')
    call world%find_strength_factor(report, max_steps=10, fallen=fallen, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call world%find_strength_factor(report, max_steps=10, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call expect(fallen%exists(), 'a world has fallen')
    call world%save(bytes, stat, text)
    if (stat /= HS_OK) return
    call restored%restore(bytes, context, stat, text)
    if (stat /= HS_OK) return
    call shape%faces(first_of_face, face_vertices, stat, text)
    if (stat /= HS_OK) return
    call shape%edges(edges, stat, text)
    if (stat /= HS_OK) return
    call halfspace_clean_polygon(corners, 0.0_real64, cleaned, context=context, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    shapes = left
    call halfspace_detect_pairs(shapes, poses, pairs, found, stat=stat, errmsg=text)
    if (stat /= HS_OK) return
    call tetrahedron%create_polyhedron(tetrahedron_corners, [3, 3, 3, 3], tetrahedron_faces, context=context, &
                                       stat=stat, errmsg=text)
  end subroutine build

end program test_ownership
