!> Contact detection of one pair or many pairs, for hosts with their own bodies. It is stateless; the caller may keep a
!! cache per pair.
module halfspace_pairs
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c
  use halfspace_definitions, only: halfspace_pose
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_records, only: count_from_1, halfspace_contact
  use halfspace_shapes, only: context_of, halfspace_shape, handle_of
  use halfspace_views, only: address_of
  implicit none
  private
  public :: halfspace_pair_cache, halfspace_detect_pair, halfspace_detect_pairs

  !> Cached state of a pair between calls; empty by default. It may be copied, also to another process.
  type, bind(c) :: halfspace_pair_cache
    private
    type(hs_pair_cache) :: memory
  end type halfspace_pair_cache

  interface
    !> hs_pair_detect() with halfspace_contact, which has the layout of hs_contact.
    function pair_detect(shape_a, pose_a, shape_b, pose_b, options, cache, contact) bind(c, name='hs_pair_detect')
      import :: c_int32_t, c_ptr, halfspace_contact, halfspace_pose
      type(c_ptr), value :: shape_a, shape_b, options, cache
      type(halfspace_pose), intent(in) :: pose_a, pose_b
      type(halfspace_contact), intent(inout) :: contact
      integer(c_int32_t) :: pair_detect
    end function pair_detect
  end interface

contains

  !> Detects the contact of two shapes. contact%type is HS_CONTACT_NONE if they are separated.
  subroutine halfspace_detect_pair(shape_a, pose_a, shape_b, pose_b, contact, cache, parallel_angle, vertex_zone, &
                                   margin, without_region, stat, errmsg)
    type(halfspace_shape), intent(in) :: shape_a, shape_b  !< of the same dimension; may be the same shape
    type(halfspace_pose), intent(in) :: pose_a, pose_b  !< their poses
    type(halfspace_contact), intent(inout) :: contact  !< receives type, pair, normal, gap, and the region of a contact
    type(halfspace_pair_cache), intent(inout), target, optional :: cache  !< cache of this pair from the last call
    real(c_double), intent(in), optional :: parallel_angle  !< max angle of parallel edges or faces, rad, [0, 0.5]
    real(c_double), intent(in), optional :: vertex_zone  !< relative distance from a vertex, [0, 0.5]; default 1e-6
    !> polygons are in contact up to this gap, m, [0, 1e75], in 3D 0; default 0
    real(c_double), intent(in), optional :: margin
    !> report only the pair of largest gap, without region
    logical, intent(in), optional :: without_region
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: context, memory
    type(hs_pair_options), target :: options
    integer(c_int32_t) :: status
    memory = c_null_ptr
    if (present(cache)) memory = c_loc(cache)
    status = pair_detect(shape_a%c_handle(), pose_a, shape_b%c_handle(), pose_b, &
                         options_of(options, parallel_angle, vertex_zone, margin, without_region), memory, contact)
    if (status == HS_OK) then  ! the usual case, without a look-up of the context
      call count_from_1(contact)
      if (present(stat)) stat = status
    else
      context = c_null_ptr
      if (shape_a%exists()) context = context_of(shape_a)
      call conclude(status, context, stat, errmsg)
    end if
  end subroutine halfspace_detect_pair

  !> Detects many pairs. After an error the contacts are undefined.
  subroutine halfspace_detect_pairs(shapes, poses, pairs, contacts, caches, touching, parallel_angle, vertex_zone, &
                                    margin, without_region, stat, errmsg)
    type(halfspace_shape), intent(in) :: shapes(:)  !< of the bodies; those of a pair have the same dimension
    type(halfspace_pose), intent(in), target, contiguous :: poses(:)  !< of the bodies
    integer(c_int32_t), intent(in) :: pairs(:,:)  !< pairs(1,i) and pairs(2,i): bodies of pair i, from 1
    !> one per pair, in the order of the pairs
    type(halfspace_contact), intent(inout), target, contiguous :: contacts(:)
    type(halfspace_pair_cache), intent(inout), target, contiguous, optional :: caches(:)  !< one per pair
    integer(c_int64_t), intent(out), target, optional :: touching  !< number of pairs in contact
    real(c_double), intent(in), optional :: parallel_angle, vertex_zone, margin  !< as for one pair
    logical, intent(in), optional :: without_region  !< as for one pair
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr), allocatable, target :: handles(:)
    integer(c_int32_t), allocatable, target :: from_0(:,:)
    type(hs_pair_options), target :: options
    type(c_ptr) :: context, memory
    integer(c_int32_t) :: status
    integer :: failure
    if (.not. fit(size(shapes), size(poses), pairs, size(contacts), stat, errmsg)) return
    memory = c_null_ptr
    if (present(caches)) then
      if (size(caches) /= size(contacts)) then
        call refuse('caches: the size must be the number of pairs', stat, errmsg)
        return
      end if
      memory = c_loc(caches)
    end if
    if (present(touching)) touching = 0
    context = c_null_ptr
    status = HS_OK
    if (size(shapes) > 0) then
      context = context_of(shapes(1))
      allocate (handles(size(shapes)), from_0(2, size(contacts)), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      handles = handle_of(shapes)
      from_0 = pairs - 1
      status = hs_pairs_detect(context, c_loc(handles), c_loc(poses), size(shapes, kind=c_int64_t), c_loc(from_0), &
                               size(contacts, kind=c_int64_t), &
                               options_of(options, parallel_angle, vertex_zone, margin, without_region), memory, &
                               c_loc(contacts), address_of(touching))
    end if
    if (status == HS_OK) call count_from_1(contacts)
    call conclude(status, context, stat, errmsg)
  end subroutine halfspace_detect_pairs

  !> Do the sizes of the arrays match?
  logical function fit(shape_count, pose_count, pairs, contact_count, stat, errmsg)
    integer, intent(in) :: shape_count, pose_count, contact_count
    integer(c_int32_t), intent(in) :: pairs(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(120) :: text
    fit = pose_count == shape_count .and. size(pairs, 1) == 2 .and. size(pairs, 2) == contact_count &
      .and. (shape_count > 0 .or. contact_count == 0)
    if (fit) return
    write (text, '("there are ", i0, " shapes and ", i0, " poses, ", i0, " x ", i0, " pairs and ", i0, " contacts")') &
      shape_count, pose_count, shape(pairs), contact_count
    call refuse(trim(text), stat, errmsg)
  end function fit

  !> The address of the given options, or NULL for the defaults.
  type(c_ptr) function options_of(options, parallel_angle, vertex_zone, margin, without_region) result(address)
    type(hs_pair_options), intent(inout), target :: options
    real(c_double), intent(in), optional :: parallel_angle, vertex_zone, margin
    logical, intent(in), optional :: without_region
    address = c_null_ptr
    if (.not. (present(parallel_angle) .or. present(vertex_zone) .or. present(margin) .or. &
        present(without_region))) return
    if (hs_pair_options_init(options, c_sizeof(options)) /= HS_OK) return
    if (present(parallel_angle)) options%parallel_angle = parallel_angle
    if (present(vertex_zone)) options%vertex_zone = vertex_zone
    if (present(margin)) options%margin = margin
    if (present(without_region)) options%without_region = merge(1, 0, without_region)
    address = c_loc(options)
  end function options_of

end module halfspace_pairs
