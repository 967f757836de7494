!> Queries without contact: rays, closest points, pairs of overlapping boxes, and an order of points.
module halfspace_queries
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr
  use halfspace_block_worlds, only: block_world
  use halfspace_c, only: hs_boxes_find_pairs, hs_points_order_along_curve, HS_OK
  use halfspace_contexts, only: halfspace_context, own_or_given
  use halfspace_definitions, only: halfspace_pose
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_handles, only: shared_handle
  use halfspace_records, only: count_from_1, halfspace_closest_points, halfspace_ray_hit
  use halfspace_shapes, only: context_of, halfspace_shape
  use halfspace_views, only: are_points, is_vector, three_of, view
  implicit none
  private
  public :: halfspace_cast_ray, halfspace_find_box_pairs, halfspace_find_closest_points, halfspace_order_along_curve

  real(c_double), parameter :: longest = 1e75_c_double

  !> Casts a ray at a shape at a pose, or into a world, and returns the first point that it meets. hit%is_hit is 0 if
  !! there is none; faces are counted from 1, 0 where the ray starts inside.
  interface halfspace_cast_ray
    module procedure cast_ray_at_shape
    module procedure cast_ray_into_world
  end interface

  interface
    !> hs_shape_cast_ray() with halfspace_ray_hit, which has the layout of hs_ray_hit.
    function shape_cast_ray(shape, pose, origin, direction, max_distance, hit) bind(c, name='hs_shape_cast_ray')
      import :: c_double, c_int32_t, c_ptr, halfspace_pose, halfspace_ray_hit
      type(c_ptr), value :: shape
      type(halfspace_pose), intent(in) :: pose
      real(c_double), intent(in) :: origin(3), direction(3)
      real(c_double), value :: max_distance
      type(halfspace_ray_hit), intent(inout) :: hit
      integer(c_int32_t) :: shape_cast_ray
    end function shape_cast_ray

    function world_cast_ray(world, origin, direction, max_distance, hit) bind(c, name='hs_world_cast_ray')
      import :: c_double, c_int32_t, c_ptr, halfspace_ray_hit
      type(c_ptr), value :: world
      real(c_double), intent(in) :: origin(3), direction(3)
      real(c_double), value :: max_distance
      type(halfspace_ray_hit), intent(inout) :: hit
      integer(c_int32_t) :: world_cast_ray
    end function world_cast_ray

    !> hs_pair_distance() with halfspace_closest_points, likewise.
    function pair_distance(shape_a, pose_a, shape_b, pose_b, points) bind(c, name='hs_pair_distance')
      import :: c_int32_t, c_ptr, halfspace_closest_points, halfspace_pose
      type(c_ptr), value :: shape_a, shape_b
      type(halfspace_pose), intent(in) :: pose_a, pose_b
      type(halfspace_closest_points), intent(inout) :: points
      integer(c_int32_t) :: pair_distance
    end function pair_distance
  end interface

contains

  subroutine cast_ray_at_shape(shape, pose, origin, direction, hit, max_distance, stat, errmsg)
    type(halfspace_shape), intent(in) :: shape
    type(halfspace_pose), intent(in) :: pose
    real(c_double), intent(in) :: origin(:)  !< m, 3 values (2D: or 2)
    real(c_double), intent(in) :: direction(:)  !< of any length except 0, 3 values (2D: or 2)
    type(halfspace_ray_hit), intent(inout) :: hit
    real(c_double), intent(in), optional :: max_distance  !< length of the ray, m; default 1e75
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (.not. is_vector(origin, 'origin', 2, stat, errmsg)) return
    if (.not. is_vector(direction, 'direction', 2, stat, errmsg)) return
    status = shape_cast_ray(shape%c_handle(), pose, three_of(origin), three_of(direction), given(max_distance), hit)
    if (status == HS_OK) call count_from_1(hit)
    call conclude(status, context_or_null(shape), stat, errmsg)
  end subroutine cast_ray_at_shape

  !> All blocks are tested: fixed ones, parts of compounds, and cells at the surfaces of meshes.
  subroutine cast_ray_into_world(world, origin, direction, hit, max_distance, stat, errmsg)
    class(block_world), intent(in) :: world
    real(c_double), intent(in) :: origin(:)  !< m, 3 values (2D: or 2)
    real(c_double), intent(in) :: direction(:)  !< of any length except 0, 3 values (2D: or 2)
    type(halfspace_ray_hit), intent(inout) :: hit
    real(c_double), intent(in), optional :: max_distance  !< length of the ray, m; default 1e75
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (.not. is_vector(origin, 'origin', 2, stat, errmsg)) return
    if (.not. is_vector(direction, 'direction', 2, stat, errmsg)) return
    status = world_cast_ray(world%c_handle(), three_of(origin), three_of(direction), given(max_distance), hit)
    if (status == HS_OK) call count_from_1(hit)
    call conclude(status, world%c_context(), stat, errmsg)
  end subroutine cast_ray_into_world

  !> Finds the closest points of two shapes, by GJK. Shapes with parallel faces may have many; one pair is returned. The
  !! depth of an overlap is the gap of halfspace_detect_pair().
  subroutine halfspace_find_closest_points(shape_a, pose_a, shape_b, pose_b, points, stat, errmsg)
    type(halfspace_shape), intent(in) :: shape_a, shape_b  !< of the same dimension; may be the same shape
    type(halfspace_pose), intent(in) :: pose_a, pose_b  !< their poses
    type(halfspace_closest_points), intent(inout) :: points  !< receives distance, points and normal
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(pair_distance(shape_a%c_handle(), pose_a, shape_b%c_handle(), pose_b, points), &
                  context_or_null(shape_a), stat, errmsg)
  end subroutine halfspace_find_closest_points

  !> Broad phase alone: finds all pairs of overlapping boxes, at any ratio of sizes, in time linear in boxes and pairs.
  subroutine halfspace_find_box_pairs(lower, upper, pairs, rows, context, stat, errmsg)
    real(c_double), intent(in), target :: lower(:,:)  !< lower corners, m; the number of components is the dimension
    real(c_double), intent(in), target :: upper(:,:)  !< upper corners, as many
    !> pairs(1,i) < pairs(2,i): boxes of pair i, from 1; the order of the pairs depends on the boxes only
    integer(c_int32_t), intent(inout), allocatable, target :: pairs(:,:)
    logical, intent(in), optional :: rows  !< layout of the corners
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    integer(c_int32_t), allocatable, target :: found(:,:)
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: dimension, status
    integer :: components, failure
    if (.not. are_points(lower, 'lower', rows, stat, errmsg)) return
    if (.not. are_points(upper, 'upper', rows, stat, errmsg)) return
    components = 1
    if (present(rows)) components = merge(2, 1, rows)
    dimension = size(lower, components)
    if (size(upper, components) /= dimension) then
      call refuse('upper: the number of components must be that of lower', stat, errmsg)
      return
    end if
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_boxes_find_pairs(owner%object(), dimension, view(lower, rows), view(upper, rows), c_null_ptr, &
                                 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (found(2, count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_boxes_find_pairs(owner%object(), dimension, view(lower, rows), view(upper, rows), c_loc(found), &
                                   count, c_null_ptr)
      found = found + 1
      call move_alloc(found, pairs)
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine halfspace_find_box_pairs

  !> Orders points along a Hilbert curve through their box. Blocks that are added in this order have their neighbours
  !> close in memory, so that steps of large worlds take less time.
  subroutine halfspace_order_along_curve(points, order, rows, context, stat, errmsg)
    real(c_double), intent(in), target :: points(:,:)  !< m; the number of components is the dimension
    !> order(1): the first point along the curve, from 1. Points in one place keep their order
    integer(c_int32_t), intent(inout), allocatable, target :: order(:)
    logical, intent(in), optional :: rows  !< layout of the points
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    integer(c_int32_t), allocatable, target :: found(:)
    integer :: components, failure
    integer(c_int32_t) :: dimension, status
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    components = 1
    if (present(rows)) components = merge(2, 1, rows)
    dimension = size(points, components)
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    allocate (found(size(points) / max(dimension, 1)), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    status = hs_points_order_along_curve(owner%object(), dimension, view(points, rows), c_loc(found))
    if (status >= HS_OK) then
      found = found + 1
      call move_alloc(found, order)
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine halfspace_order_along_curve

  pure real(c_double) function given(max_distance)
    real(c_double), intent(in), optional :: max_distance
    given = longest
    if (present(max_distance)) given = max_distance
  end function given

  type(c_ptr) function context_or_null(shape) result(context)
    type(halfspace_shape), intent(in) :: shape
    context = c_null_ptr
    if (shape%exists()) context = context_of(shape)
  end function context_or_null

end module halfspace_queries
