!> Meshes: nodes, and cells that share them. In a world a mesh is a body of finite elements.
!!
!! A mesh is immutable and may be added to any number of worlds. Without a given context it makes its own.
module halfspace_meshes
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_ptr, c_sizeof
  use halfspace_c, only: halfspace_mesh_properties => hs_mesh_properties, hs_mesh_create, hs_mesh_destroy, &
    hs_mesh_get_properties, hs_view, HS_OK
  use halfspace_contexts, only: halfspace_context, own_or_given
  use halfspace_errors, only: conclude, had_memory
  use halfspace_handles, only: shared_handle
  use halfspace_views, only: are_points, view
  implicit none
  private
  public :: halfspace_mesh, halfspace_mesh_properties, are_from_0

  !> Assignment adds a reference: all copies are the same mesh, which the last one destroys.
  type :: halfspace_mesh
    private
    type(shared_handle) :: handle
  contains
    procedure, private :: create_of_kinds
    procedure, private :: create_of_one_kind
    generic :: create => create_of_kinds, create_of_one_kind
    procedure :: destroy
    procedure :: exists
    procedure :: properties
    procedure :: c_handle
    procedure, private :: share
    generic :: assignment(=) => share
  end type halfspace_mesh

contains

  !> Creates a mesh. Faulty input is refused; nodes and cells in the error text are counted from 0. Cells must not be
  !! inverted or flat, every node must belong to a cell, and a face to at most two cells.
  subroutine create_of_kinds(self, nodes, cell_kinds, cell_nodes, rows, context, stat, errmsg)
    class(halfspace_mesh), intent(inout) :: self
    real(c_double), intent(in), target :: nodes(:,:)  !< positions, m; the number of components is the dimension
    integer(c_int32_t), intent(in), target, contiguous :: cell_kinds(:)  !< one HS_CELL_ value per cell
    !> Node indices of all cells from 1, cell after cell, in the order of Gmsh and VTK: triangles and quads
    !! counter-clockwise; the first three nodes of a tetrahedron counter-clockwise seen from the fourth; prisms and
    !! hexahedra with the bottom face first, counter-clockwise seen from above, then the top face.
    integer(c_int32_t), intent(in) :: cell_nodes(:)
    logical, intent(in), optional :: rows  !< layout of `nodes`
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle) :: owner
    type(c_ptr) :: object
    integer(c_int32_t) :: status, dimension
    integer(c_int32_t), allocatable, target :: from_0(:)
    if (.not. are_points(nodes, 'nodes', rows, stat, errmsg)) return
    if (.not. are_from_0(cell_nodes, from_0, stat, errmsg)) return
    if (.not. own_or_given(context, owner, stat, errmsg)) return
    dimension = size(nodes, 1)
    if (present(rows)) dimension = merge(size(nodes, 2), size(nodes, 1), rows)
    status = hs_mesh_create(owner%object(), dimension, view(nodes, rows), c_loc(cell_kinds), &
                            size(cell_kinds, kind=c_int64_t), c_loc(from_0), size(from_0, kind=c_int64_t), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_mesh_destroy, owner, stat=stat, errmsg=errmsg)) return
    end if
    call conclude(status, owner%context(), stat, errmsg)
  end subroutine create_of_kinds

  !> Creates a mesh of cells of one kind: column c of cell_nodes is cell c.
  subroutine create_of_one_kind(self, nodes, cell_kind, cell_nodes, rows, context, stat, errmsg)
    class(halfspace_mesh), intent(inout) :: self
    real(c_double), intent(in), target :: nodes(:,:)  !< as above
    integer(c_int32_t), intent(in) :: cell_kind  !< an HS_CELL_ value
    integer(c_int32_t), intent(in), target, contiguous :: cell_nodes(:,:)  !< node indices from 1, in the order above
    logical, intent(in), optional :: rows  !< layout of `nodes`
    type(halfspace_context), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable :: kinds(:)
    integer(c_int32_t), pointer :: in_a_row(:)
    integer :: failure
    allocate (kinds(size(cell_nodes, 2)), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    kinds = cell_kind
    in_a_row(1:size(cell_nodes)) => cell_nodes
    call self%create_of_kinds(nodes, kinds, in_a_row, rows, context, stat, errmsg)
  end subroutine create_of_one_kind

  !> Converts indices to those of C, from 0; ends the call without memory.
  logical function are_from_0(numbers, from_0, stat, errmsg)
    integer(c_int32_t), intent(in) :: numbers(:)
    integer(c_int32_t), allocatable, intent(out) :: from_0(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer :: failure
    allocate (from_0(size(numbers)), stat=failure)
    are_from_0 = had_memory(failure, stat, errmsg)
    if (are_from_0) from_0 = numbers - 1
  end function are_from_0

  !> Drops this reference before the end of its scope.
  impure elemental subroutine destroy(self)
    class(halfspace_mesh), intent(inout) :: self
    call self%handle%drop()
  end subroutine destroy

  !> Is there a mesh?
  elemental logical function exists(self)
    class(halfspace_mesh), intent(in) :: self
    exists = self%handle%owns()
  end function exists

  !> Returns the numbers of nodes, cells and surface faces, and the volume.
  subroutine properties(self, values, stat, errmsg)
    class(halfspace_mesh), intent(in) :: self
    type(halfspace_mesh_properties), intent(out) :: values
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_mesh_get_properties(self%handle%object(), values, c_sizeof(values)), self%handle%context(), &
                  stat, errmsg)
  end subroutine properties

  !> The handle for calls of halfspace_c; the object stays the owner.
  type(c_ptr) function c_handle(self)
    class(halfspace_mesh), intent(in) :: self
    c_handle = self%handle%object()
  end function c_handle

  impure elemental subroutine share(self, other)
    class(halfspace_mesh), intent(inout) :: self
    class(halfspace_mesh), intent(in) :: other
    self%handle = other%handle
  end subroutine share

end module halfspace_meshes
