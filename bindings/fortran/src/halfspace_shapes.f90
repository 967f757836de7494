!> Convex shapes: creation, cutting, mass properties, half-spaces.
!!
!! A shape may be used by any number of blocks; only set_vertices() changes it. The origin of its frame is its centroid;
!! halfspace_shape_properties%centroid is the centroid in the coordinates that the shape was made from.
!!
!! Points are columns, x(2,n) or x(3,n); with rows = .true. they are rows, x(n,2) or x(n,3). Array sections are accessed
!! without a copy. In the plane, vertices may also be separate arrays x(:) and y(:). Without a given context a shape
!! makes its own.
module halfspace_shapes
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c, halfspace_fit_report => hs_fit_report, &
    halfspace_shape_properties => hs_shape_properties
  use halfspace_contexts, only: halfspace_context, own_or_given
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_handles, only: shared_handle
  use halfspace_records, only: count_from_1
  use halfspace_views, only: address_of, are_of_one_size, are_points, components, is_vector, mutable_components, &
    mutable_view, three_of, view
  implicit none
  private
  public :: halfspace_fit_report, halfspace_shape, halfspace_shape_properties
  public :: context_of, handle_of, list_from_0

  !> Assignment adds a reference: all copies are the same shape, which the last one destroys.
  type :: halfspace_shape
    private
    type(shared_handle) :: handle
  contains
    procedure, private :: create_polygon_of_points
    procedure, private :: create_polygon_of_components
    generic :: create_polygon => create_polygon_of_points, create_polygon_of_components
    procedure :: create_polygon_hull
    procedure :: create_boundary
    procedure :: create_polyhedron
    procedure :: create_polyhedron_hull
    procedure :: create_fitted
    procedure :: create_from_halfspaces
    procedure :: cut
    procedure :: destroy
    procedure :: exists
    procedure :: properties
    procedure, private :: set_vertices_to_points
    procedure, private :: set_vertices_to_components
    generic :: set_vertices => set_vertices_to_points, set_vertices_to_components
    procedure, private :: vertices_as_points
    procedure, private :: vertices_as_components
    generic :: vertices => vertices_as_points, vertices_as_components
    procedure :: faces
    procedure :: edges
    procedure :: halfspaces
    procedure :: c_handle
    procedure, private :: share
    generic :: assignment(=) => share
  end type halfspace_shape

  abstract interface
    function shape_of_points(context, points, shape) bind(c)
      import :: c_int32_t, c_ptr, hs_view
      type(c_ptr), value :: context
      type(hs_view), value :: points
      type(c_ptr), intent(out) :: shape
      integer(c_int32_t) :: shape_of_points
    end function shape_of_points
  end interface

contains

  !> Creates a convex polygon. Faulty input is refused, not repaired.
  subroutine create_polygon_of_points(self, vertices, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: vertices(:,:)  !< 3 or more, clockwise or counter-clockwise
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    call create(self, hs_polygon_create, view(vertices, rows), context, stat, errmsg)
  end subroutine create_polygon_of_points

  !> The same from a separate array for each component.
  subroutine create_polygon_of_components(self, x, y, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target, contiguous :: x(:), y(:)
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_of_one_size(x, y, names='x and y', stat=stat, errmsg=errmsg)) return
    call create(self, hs_polygon_create, components(x, y), context, stat, errmsg)
  end subroutine create_polygon_of_components

  !> Creates the convex hull of points as a polygon.
  subroutine create_polygon_hull(self, points, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: points(:,:)  !< any order, inner and repeated points allowed
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call create(self, hs_polygon_create_hull, view(points, rows), context, stat, errmsg)
  end subroutine create_polygon_hull

  !> Creates a boundary segment for a fixed or prescribed block: a virtual polygon with the segment as one edge. Its
  !! inside is on the left of the direction from first to second: a floor runs towards -x. In a chain, `before` and
  !! `after` put the flanks of the polygon under the neighbours.
  subroutine create_boundary(self, first, second, depth, before, after, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in) :: first(:), second(:)  !< ends of the segment, m, 3 values or 2
    real(c_double), intent(in) :: depth  !< of the polygon, m: more than twice the max overlap
    real(c_double), intent(in), optional :: before(:), after(:)  !< other ends of the neighbour segments
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object, end_before, end_after
    real(c_double), target :: three_before(3), three_after(3)
    integer(c_int32_t) :: status
    if (.not. is_vector(first, 'first', 2, stat, errmsg)) return
    if (.not. is_vector(second, 'second', 2, stat, errmsg)) return
    end_before = c_null_ptr
    if (present(before)) then
      if (.not. is_vector(before, 'before', 2, stat, errmsg)) return
      three_before = three_of(before)
      end_before = c_loc(three_before)
    end if
    end_after = c_null_ptr
    if (present(after)) then
      if (.not. is_vector(after, 'after', 2, stat, errmsg)) return
      three_after = three_of(after)
      end_after = c_loc(three_after)
    end if
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polygon_create_boundary(owner%object(), end_before, three_of(first), three_of(second), end_after, &
                                        depth, object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_shape_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create_boundary

  !> Creates the convex hull of points as a polyhedron. Facets that are coplanar to rounding are one face.
  subroutine create_polyhedron_hull(self, points, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: points(:,:)  !< any order, inner and repeated points allowed
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call create(self, hs_polyhedron_create_hull, view(points, rows), context, stat, errmsg)
  end subroutine create_polyhedron_hull

  subroutine create(self, from_points, points, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    procedure(shape_of_points) :: from_points
    type(hs_view), intent(in) :: points
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = from_points(owner%object(), points, object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_shape_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create

  !> Creates a convex polyhedron. Faulty input is refused, not repaired; vertices and faces in the error text are
  !! counted from 0.
  subroutine create_polyhedron(self, vertices, face_sizes, face_vertices, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: vertices(:,:)
    integer(c_int32_t), intent(in), target, contiguous :: face_sizes(:)  !< number of vertices of each face
    !> Vertex indices of the faces from 1, face after face, in outline order; all faces counter-clockwise seen from
    !! outside, or all clockwise.
    integer(c_int32_t), intent(in) :: face_vertices(:)
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    integer(c_int32_t), allocatable, target :: from_0(:)
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    if (.not. list_from_0(face_sizes, face_vertices, from_0, stat, errmsg)) return
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polyhedron_create(owner%object(), view(vertices, rows), c_loc(face_sizes), &
                                  size(face_sizes, kind=c_int64_t), c_loc(from_0), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_shape_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create_polyhedron

  !> Creates a polyhedron from facets that are plane and convex within a tolerance, e.g. from a file with rounded
  !! coordinates. Facets within the tolerance of a common plane form one face with a fitted plane. Without facets, those
  !! of the convex hull are used.
  subroutine create_fitted(self, vertices, tolerance, face_sizes, face_vertices, report, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: vertices(:,:)
    real(c_double), intent(in) :: tolerance  !< distance, m, >= 0; 0 allows rounding only
    integer(c_int32_t), intent(in), target, contiguous, optional :: face_sizes(:)
    integer(c_int32_t), intent(in), optional :: face_vertices(:)  !< both as for create_polyhedron(), or neither
    !> Receives the changes, or the fault of an error; indices are from 1.
    type(halfspace_fit_report), intent(out), optional :: report
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object, sizes, corners
    integer(c_int32_t) :: status
    integer(c_int64_t) :: count
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(halfspace_fit_report), target :: changes
    if (.not. are_points(vertices, 'vertices', rows, stat, errmsg)) return
    sizes = c_null_ptr
    corners = c_null_ptr
    count = 0
    if (present(face_sizes) .neqv. present(face_vertices)) then
      call refuse('face_sizes, face_vertices: give both or neither', stat, errmsg)
      return
    end if
    if (present(face_sizes)) then
      if (.not. list_from_0(face_sizes, face_vertices, from_0, stat, errmsg)) return
      sizes = c_loc(face_sizes)
      corners = c_loc(from_0)
      count = size(face_sizes, kind=c_int64_t)
    end if
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polyhedron_create_fitted(owner%object(), view(vertices, rows), sizes, count, corners, tolerance, &
                                         object, c_loc(changes))
    call count_from_1(changes%fault)
    if (present(report)) report = changes
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_shape_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create_fitted

  !> Converts the vertex indices of faces to those of C, from 0. Refuses a list whose length is not the sum of the
  !! sizes, as C cannot check it.
  logical function list_from_0(face_sizes, face_vertices, from_0, stat, errmsg)
    integer(c_int32_t), intent(in) :: face_sizes(:), face_vertices(:)
    integer(c_int32_t), allocatable, intent(out) :: from_0(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer :: failure
    character(100) :: text
    list_from_0 = size(face_vertices, kind=c_int64_t) == sum(int(max(face_sizes, 0), c_int64_t))
    if (list_from_0) then
      allocate (from_0(size(face_vertices)), stat=failure)
      list_from_0 = had_memory(failure, stat, errmsg)
      if (list_from_0) from_0 = face_vertices - 1
    else
      write (text, '("face_vertices: has ", i0, " values; it must have the sum of face_sizes, ", i0)') &
        size(face_vertices), sum(int(max(face_sizes, 0), c_int64_t))
      call refuse(trim(text), stat, errmsg)
    end if
  end function list_from_0

  !> Creates the intersection of half-spaces as a polyhedron. A half-space that is redundant to rounding makes no face.
  subroutine create_from_halfspaces(self, normals, offsets, rows, context, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    !> Outer normals, of any length except 0: p is inside if dot_product(normal, p) <= offset.
    real(c_double), intent(in), target :: normals(:,:)
    real(c_double), intent(in), target, contiguous :: offsets(:)  !< one per normal
    logical, intent(in), optional :: rows
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    type(hs_view) :: directions
    character(80) :: text
    if (.not. are_points(normals, 'normals', rows, stat, errmsg)) return
    directions = view(normals, rows)
    if (directions%count /= size(offsets)) then
      write (text, '("offsets: has ", i0, " values; there are ", i0, " normals")') size(offsets), directions%count
      call refuse(trim(text), stat, errmsg)
      return
    end if
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    status = hs_polyhedron_create_from_halfspaces(owner%object(), directions, c_loc(offsets), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_shape_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create_from_halfspaces

  !> Cuts a shape by a plane, in 2D by a line. Coordinates are those that the shape was made from. exists() is .false.
  !! for an empty part.
  subroutine cut(self, point, normal, behind, ahead, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    real(c_double), intent(in) :: point(:)  !< a point of the plane, m, 3 values (2D: or 2)
    real(c_double), intent(in) :: normal(:)  !< of any length except 0
    type(halfspace_shape), intent(inout) :: behind  !< the part on the negative side of the normal
    type(halfspace_shape), intent(inout) :: ahead  !< the part on the positive side
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: whole, part_behind, part_ahead
    type(c_ptr) :: object_behind, object_ahead
    integer(c_int32_t) :: status
    if (.not. is_vector(point, 'point', 2, stat, errmsg)) return
    if (.not. is_vector(normal, 'normal', 2, stat, errmsg)) return
    whole = self%handle  ! keeps the shape during the call, also if a part replaces it
    status = hs_shape_cut(whole%object(), three_of(point), three_of(normal), object_behind, object_ahead)
    if (status == HS_OK) then
      if (.not. part_behind%takes(object_behind, hs_shape_destroy, whole, stat=stat, errmsg=errmsg)) then
        call hs_shape_destroy(object_ahead)
        return
      end if
      if (.not. part_ahead%takes(object_ahead, hs_shape_destroy, whole, stat=stat, errmsg=errmsg)) return
      behind%handle = part_behind
      ahead%handle = part_ahead
    end if
    call conclude(status, whole%context(), stat, errmsg)
  end subroutine cut

  !> Drops this reference before the end of its scope.
  impure elemental subroutine destroy(self)
    class(halfspace_shape), intent(inout) :: self
    call self%handle%drop()
  end subroutine destroy

  !> Is there a shape?
  elemental logical function exists(self)
    class(halfspace_shape), intent(in) :: self
    exists = self%handle%owns()
  end function exists

  !> Returns geometry and mass properties per unit density.
  subroutine properties(self, values, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    type(halfspace_shape_properties), intent(out) :: values
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_shape_get_properties(self%handle%object(), values, c_sizeof(values)), self%handle%context(), &
                  stat, errmsg)
  end subroutine properties

  !> Returns the vertices, in the coordinates that the shape was made from; in 2D counter-clockwise.
  subroutine vertices_as_points(self, points, rows, count, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    real(c_double), intent(inout), target :: points(:,:)
    logical, intent(in), optional :: rows
    integer(c_int64_t), intent(out), target, optional :: count  !< number of vertices, also when they do not fit
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call conclude(hs_shape_get_vertices(self%handle%object(), mutable_view(points, rows), address_of(count)), &
                  self%handle%context(), stat, errmsg)
  end subroutine vertices_as_points

  !> The same in a separate array for each component, in the plane.
  subroutine vertices_as_components(self, x, y, count, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    real(c_double), intent(inout), target, contiguous :: x(:), y(:)
    integer(c_int64_t), intent(out), target, optional :: count  !< number of vertices, also when they do not fit
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_of_one_size(x, y, names='x and y', stat=stat, errmsg=errmsg)) return
    call conclude(hs_shape_get_vertices(self%handle%object(), mutable_components(x, y), address_of(count)), &
                  self%handle%context(), stat, errmsg)
  end subroutine vertices_as_components

  !> Moves the vertices in place, for hosts whose bodies deform: as many as vertices() returns, in that order, in 2D
  !! also in the reverse order. In 3D faces must stay plane to rounding, and convex. Pair caches remain valid; worlds
  !! keep the copies that they have. After an error the shape has not changed.
  subroutine set_vertices_to_points(self, points, rows, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target :: points(:,:)
    logical, intent(in), optional :: rows
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call conclude(hs_shape_set_vertices(self%handle%object(), view(points, rows)), self%handle%context(), stat, errmsg)
  end subroutine set_vertices_to_points

  !> The same from a separate array for each component, in the plane.
  subroutine set_vertices_to_components(self, x, y, stat, errmsg)
    class(halfspace_shape), intent(inout) :: self
    real(c_double), intent(in), target, contiguous :: x(:), y(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_of_one_size(x, y, names='x and y', stat=stat, errmsg=errmsg)) return
    call conclude(hs_shape_set_vertices(self%handle%object(), components(x, y)), self%handle%context(), stat, errmsg)
  end subroutine set_vertices_to_components

  !> Returns the half-spaces: p is inside if dot_product(normal, p) <= offset. Half-space i belongs to face i; in 2D to
  !! the edge from vertex i to i + 1. The origin of the frame is the centroid.
  subroutine halfspaces(self, normals, offsets, rows, count, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    real(c_double), intent(inout), target :: normals(:,:)  !< outer unit normals
    real(c_double), intent(inout), target, contiguous :: offsets(:)  !< room for one value per normal
    logical, intent(in), optional :: rows
    integer(c_int64_t), intent(out), target, optional :: count  !< number of half-spaces, also when they do not fit
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_mutable_view) :: room
    if (.not. are_points(normals, 'normals', rows, stat, errmsg)) return
    room = mutable_view(normals, rows)
    room%count = min(room%count, size(offsets, kind=c_int64_t))
    call conclude(hs_shape_get_halfspaces(self%handle%object(), room, c_loc(offsets), address_of(count)), &
                  self%handle%context(), stat, errmsg)
  end subroutine halfspaces

  !> Returns the faces as lists of vertex indices from 1, counter-clockwise seen from outside; in 2D the two ends of
  !! each edge. Face f has the vertices face_vertices(first_of_face(f) : first_of_face(f + 1) - 1).
  subroutine faces(self, first_of_face, face_vertices, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    integer(c_int32_t), intent(inout), allocatable, target :: first_of_face(:), face_vertices(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: face_count, vertex_count
    integer(c_int32_t), allocatable, target :: first(:), listed(:)
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_shape_get_faces(self%handle%object(), c_null_ptr, 0_c_int64_t, c_null_ptr, 0_c_int64_t, &
                                c_loc(face_count), c_loc(vertex_count))
    if (status >= HS_OK) then
      allocate (first(face_count + 1), listed(vertex_count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_shape_get_faces(self%handle%object(), c_loc(first), face_count + 1, c_loc(listed), vertex_count, &
                                  c_null_ptr, c_null_ptr)
      first = first + 1
      listed = listed + 1
      call move_alloc(first, first_of_face)
      call move_alloc(listed, face_vertices)
    end if
    call conclude(status, self%handle%context(), stat, errmsg)
  end subroutine faces

  !> Returns the edges: column e has the vertex indices of the ends of edge e. HS_PAIR_EDGE_EDGE uses these indices.
  subroutine edges(self, edge_vertices, stat, errmsg)
    class(halfspace_shape), intent(in) :: self
    integer(c_int32_t), intent(inout), allocatable :: edge_vertices(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t), allocatable, target :: ends(:,:)
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_shape_get_edges(self%handle%object(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (ends(2, count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_shape_get_edges(self%handle%object(), c_loc(ends), count, c_null_ptr)
      ends = ends + 1
      call move_alloc(ends, edge_vertices)
    end if
    call conclude(status, self%handle%context(), stat, errmsg)
  end subroutine edges

  !> For calls of halfspace_c; the object stays the owner.
  type(c_ptr) function c_handle(self)
    class(halfspace_shape), intent(in) :: self
    c_handle = self%handle%object()
  end function c_handle

  !> The C handle of a shape, also of an element of an array constructor; valid for one call.
  impure elemental type(c_ptr) function handle_of(shape)
    type(halfspace_shape), intent(in) :: shape
    handle_of = shape%handle%lent_object()
  end function handle_of

  !> The C context of a shape.
  type(c_ptr) function context_of(shape)
    type(halfspace_shape), intent(in) :: shape
    context_of = shape%handle%lent_context()
  end function context_of

  impure elemental subroutine share(self, other)
    class(halfspace_shape), intent(inout) :: self
    class(halfspace_shape), intent(in) :: other
    self%handle = other%handle
  end subroutine share

end module halfspace_shapes
