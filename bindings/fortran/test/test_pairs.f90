! Pairs: one and many, with and without a cache, features and bodies counted from 1; and the layout of contacts.
program test_pairs
  use checking
  use halfspace
  use halfspace_c, only: hs_contact, hs_pair_cache
  use, intrinsic :: iso_c_binding, only: c_loc, c_intptr_t, c_ptr
  use, intrinsic :: iso_fortran_env, only: int32, int64, real64
  implicit none

  real(real64), parameter :: corners(2, 4) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1], [2, 4])

  call one_pair()
  call options()
  call many_pairs()
  call wrong_numbers_are_refused()
  call missing_shapes_are_refused()
  call layout()
  call finish()

contains

  ! All numbers are exact in binary, so the gaps are too.
  subroutine one_pair()
    type(halfspace_shape) :: square
    type(halfspace_contact) :: contact
    type(halfspace_pair_cache) :: cache
    type(halfspace_pose) :: below, touching, apart, corner_down
    real(real64), parameter :: half_diagonal = sqrt(0.5_real64), quarter_turn = acos(-1.0_real64) / 4
    integer :: i
    call square%create_polygon(corners)
    below = halfspace_pose(0.0_real64, 0.0_real64)
    touching = halfspace_pose(0.25_real64, 0.875_real64)
    apart = halfspace_pose(0.25_real64, 1.5_real64)
    do i = 1, 3
      call halfspace_detect_pair(square, below, square, touching, contact, cache)
      call expect(contact%type == HS_CONTACT_EDGE_EDGE, 'edge on edge')
      call expect(contact%gap == -0.125_real64 .and. contact%area == 0.75_real64, 'gap and area')
      call expect(contact%normal(2) == 1, 'normal from a to b')
      call halfspace_detect_pair(square, below, square, apart, contact, cache)
      call expect(contact%type == HS_CONTACT_NONE .and. contact%gap > 0, 'apart')
    end do
    ! Standing on its corner, the first, 1/16 deep in the upper edge, the third.
    corner_down = halfspace_pose(0.125_real64, 0.4375_real64 + half_diagonal, quarter_turn)
    call halfspace_detect_pair(square, below, square, corner_down, contact)
    call expect(contact%pair_kind == HS_PAIR_FACE_VERTEX, 'an edge of a, a vertex of b')
    call expect(contact%feature_a == 3 .and. contact%feature_b == 1, 'features are counted from 1')
    call expect_close([contact%gap], [-0.0625_real64], 1e-15_real64, 'depth of the corner')
  end subroutine one_pair

  ! A rotation by 0.02 is above the default parallel angle of 0.01, and below 0.03.
  subroutine options()
    type(halfspace_shape) :: square
    type(halfspace_contact) :: contact
    type(halfspace_pose) :: below, turned
    integer :: stat
    character(200) :: text
    call square%create_polygon(corners)
    below = halfspace_pose(0.0_real64, 0.0_real64)
    turned = halfspace_pose(0.0_real64, 1.0_real64, 0.02_real64)
    call halfspace_detect_pair(square, below, square, turned, contact)
    call expect(contact%type == HS_CONTACT_VERTEX_EDGE, 'not parallel by the default')
    call halfspace_detect_pair(square, below, square, turned, contact, parallel_angle=0.03_real64)
    call expect(contact%type == HS_CONTACT_EDGE_EDGE, 'parallel within the angle')
    call halfspace_detect_pair(square, below, square, turned, contact, parallel_angle=2.0_real64, stat=stat, &
                               errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'the angle is out of range')
    call expect_text(text, 'parallel_angle is 2')
    turned = halfspace_pose(0.0_real64, 1.25_real64)
    call halfspace_detect_pair(square, below, square, turned, contact)
    call expect(contact%type == HS_CONTACT_NONE, 'apart')
    call halfspace_detect_pair(square, below, square, turned, contact, margin=0.5_real64)
    call expect(contact%type == HS_CONTACT_EDGE_EDGE .and. contact%gap == 0.25_real64, 'within the margin')
    call halfspace_detect_pair(square, below, square, turned, contact, margin=0.5_real64, without_region=.true.)
    call expect(contact%type == HS_CONTACT_VERTEX_EDGE .and. contact%point_count == 0, 'no region')
  end subroutine options

  subroutine many_pairs()
    integer, parameter :: bodies = 5
    type(halfspace_shape) :: square, triangle, shapes(bodies)
    type(halfspace_pose) :: poses(bodies)
    type(halfspace_contact) :: contacts(bodies - 1), one
    type(halfspace_pair_cache) :: caches(bodies - 1)
    integer(int32) :: pairs(2, bodies - 1)
    integer(int64) :: touching
    integer :: i
    call square%create_polygon(corners)
    call triangle%create_polygon(corners(:, 1:3))
    ! A row of squares, each 1/8 into the next, but for the last, which is 1/2 away.
    do i = 1, bodies
      shapes(i) = square
      poses(i) = halfspace_pose(0.875_real64 * i, 0.0_real64)
    end do
    poses(bodies)%position(1) = poses(bodies)%position(1) + 0.625_real64
    pairs = reshape([1, 2, 2, 3, 4, 3, 4, 5], [2, 4])
    do i = 1, 2
      call halfspace_detect_pairs(shapes, poses, pairs, contacts, caches, touching)
      call expect(touching == 3, 'three of four touch')
      call expect_close(contacts(1:3)%gap, [real(real64) :: -0.125, -0.125, -0.125], 0.0_real64, 'gaps')
      call expect(contacts(3)%normal(1) == -1, 'the third pair the other way round')
    end do
    call expect(contacts(4)%type == HS_CONTACT_NONE, 'the last is apart')
    call halfspace_detect_pair(square, poses(1), square, poses(2), one)
    call expect(one%feature_a == contacts(1)%feature_a .and. one%feature_b == contacts(1)%feature_b, &
                'features as of one pair')
    call halfspace_detect_pairs([square, triangle], poses(1:3:2), reshape([1, 2], [2, 1]), contacts(:1))
    call expect(contacts(1)%type == HS_CONTACT_NONE, 'shapes of an array constructor')
    call halfspace_detect_pairs(shapes(:0), poses(:0), pairs(:, :0), contacts(:0), touching=touching)
    call expect(touching == 0, 'no bodies, no contacts')
  end subroutine many_pairs

  subroutine wrong_numbers_are_refused()
    type(halfspace_shape) :: square
    type(halfspace_pose) :: poses(2)
    type(halfspace_contact) :: contacts(2)
    type(halfspace_pair_cache) :: caches(1)
    integer(int32) :: pairs(2, 2)
    integer :: stat
    character(200) :: text
    call square%create_polygon(corners)
    poses = halfspace_pose(0.0_real64, 0.0_real64)
    pairs = reshape([1, 2, 1, 3], [2, 2])
    call halfspace_detect_pairs([square, square], poses, pairs, contacts, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a pair names a body that is not there')
    call expect_text(text, 'hs_pairs_detect: ')
    call halfspace_detect_pairs([square], poses, pairs, contacts, stat=stat, errmsg=text)
    call expect_text(text, 'there are 1 shapes and 2 poses')
    call halfspace_detect_pairs([square, square], poses, pairs, contacts, caches, stat=stat, errmsg=text)
    call expect_text(text, 'caches: the size must be the number of pairs')
    contacts%feature_a = 7
    call halfspace_detect_pairs([halfspace_shape ::], poses(:0), pairs, contacts, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT .and. all(contacts%feature_a == 7), 'pairs of no bodies')
    call expect_text(text, 'there are 0 shapes and 0 poses, 2 x 2 pairs')
  end subroutine wrong_numbers_are_refused

  ! The error text is in the context of shape a, which must not be read after the shape is destroyed.
  subroutine missing_shapes_are_refused()
    type(halfspace_shape) :: square, nothing
    type(halfspace_shape), allocatable :: copy
    type(halfspace_pose) :: poses(2)
    type(halfspace_contact) :: contact
    integer :: stat
    character(200) :: text
    poses = halfspace_pose(0.0_real64, 0.0_real64)
    call square%create_polygon(corners)
    call halfspace_detect_pair(square, poses(1), nothing, poses(2), contact, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a shape that was not created')
    call expect_text(text, 'hs_pair_detect: shape_b is NULL')
    call halfspace_detect_pair(nothing, poses(1), square, poses(2), contact, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'the first was not created')
    call expect_text(text, 'was not created')
    allocate (copy, source=square)
    call square%destroy()
    call square%create_polygon(corners)
    call halfspace_detect_pair(copy, poses(1), square, poses(2), contact, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a copy by source= after the end of its original')
    call expect_text(text, 'bitwise copy without assignment')
  end subroutine missing_shapes_are_refused

  !> The offset of every component is that of C.
  subroutine layout()
    type(hs_contact), target :: c
    type(halfspace_contact), target :: f
    call expect(storage_size(c) == storage_size(f), 'size of a contact')
    call expect(storage_size(hs_pair_cache()) == storage_size(halfspace_pair_cache()), 'size of a cache')
    call expect(between(c_loc(c), c_loc(c%block_a)) == between(c_loc(f), c_loc(f%block_a)), 'block_a')
    call expect(between(c_loc(c), c_loc(c%block_b)) == between(c_loc(f), c_loc(f%block_b)), 'block_b')
    call expect(between(c_loc(c), c_loc(c%type)) == between(c_loc(f), c_loc(f%type)), 'type')
    call expect(between(c_loc(c), c_loc(c%point_count)) == between(c_loc(f), c_loc(f%point_count)), 'point_count')
    call expect(between(c_loc(c), c_loc(c%pair_kind)) == between(c_loc(f), c_loc(f%pair_kind)), 'pair_kind')
    call expect(between(c_loc(c), c_loc(c%feature_a)) == between(c_loc(f), c_loc(f%feature_a)), 'feature_a')
    call expect(between(c_loc(c), c_loc(c%feature_b)) == between(c_loc(f), c_loc(f%feature_b)), 'feature_b')
    call expect(between(c_loc(c), c_loc(c%normal)) == between(c_loc(f), c_loc(f%normal)), 'normal')
    call expect(between(c_loc(c), c_loc(c%gap)) == between(c_loc(f), c_loc(f%gap)), 'gap')
    call expect(between(c_loc(c), c_loc(c%area)) == between(c_loc(f), c_loc(f%area)), 'area')
    call expect(between(c_loc(c), c_loc(c%length)) == between(c_loc(f), c_loc(f%length)), 'length')
    call expect(between(c_loc(c), c_loc(c%center)) == between(c_loc(f), c_loc(f%center)), 'center')
    call expect(between(c_loc(c), c_loc(c%center_gap)) == between(c_loc(f), c_loc(f%center_gap)), 'center_gap')
    call expect(between(c_loc(c), c_loc(c%points)) == between(c_loc(f), c_loc(f%points)), 'points')
    call expect(between(c_loc(c), c_loc(c%gaps)) == between(c_loc(f), c_loc(f%gaps)), 'gaps')
    call expect(between(c_loc(c), c_loc(c%force)) == between(c_loc(f), c_loc(f%force)), 'force')
    call expect(between(c_loc(c), c_loc(c%torque)) == between(c_loc(f), c_loc(f%torque)), 'torque')
    call expect(between(c_loc(c), c_loc(c%force_point)) == between(c_loc(f), c_loc(f%force_point)), 'force_point')
    call expect(between(c_loc(c), c_loc(c%normal_force)) == between(c_loc(f), c_loc(f%normal_force)), 'normal_force')
    call expect(between(c_loc(c), c_loc(c%shear_force)) == between(c_loc(f), c_loc(f%shear_force)), 'shear_force')
    call expect(between(c_loc(c), c_loc(c%twist)) == between(c_loc(f), c_loc(f%twist)), 'twist')
  end subroutine layout

  integer(c_intptr_t) function between(first, second)
    type(c_ptr), intent(in) :: first, second
    between = transfer(second, between) - transfer(first, between)
  end function between

end program test_pairs
