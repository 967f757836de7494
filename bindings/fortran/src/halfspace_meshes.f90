!> Meshes: nodes, and cells that share them. Put into a world, a mesh is a body of finite elements.
!!
!! A mesh is immutable and may be put into any number of worlds. One that is given no context makes one of its own.
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

  !> Assignment shares: all copies are the same mesh, which ends with the last of them.
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

  !> Makes a mesh. Nothing is repaired: faulty input is refused with its reason, which counts nodes and cells from 0.
  !! A cell may be neither inside out nor flat, a node must belong to a cell, and a face to no more than two.
  subroutine create_of_kinds(self, nodes, cell_kinds, cell_nodes, rows, context, stat, errmsg)
    class(halfspace_mesh), intent(inout) :: self
    real(c_double), intent(in), target :: nodes(:,:)  !< their places, m; the number of components is the dimension
    integer(c_int32_t), intent(in), target, contiguous :: cell_kinds(:)  !< an HS_CELL_ value for each cell
    !> The nodes of all cells, those of one cell after those of the other, counted from 1, in the order of Gmsh and VTK:
    !! those of triangles and quads counter-clockwise; of a tetrahedron the first three run counter-clockwise seen from
    !! the side away from the fourth; of prisms and hexahedra those at the bottom come first, counter-clockwise seen
    !! from above, then those above them.
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

  !> Makes a mesh whose cells are all of one kind: column c of their nodes is cell c.
  subroutine create_of_one_kind(self, nodes, cell_kind, cell_nodes, rows, context, stat, errmsg)
    class(halfspace_mesh), intent(inout) :: self
    real(c_double), intent(in), target :: nodes(:,:)  !< as above
    integer(c_int32_t), intent(in) :: cell_kind  !< an HS_CELL_ value
    integer(c_int32_t), intent(in), target, contiguous :: cell_nodes(:,:)  !< counted from 1, in the order told above
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

  !> Numbers of nodes or materials as C counts them; without memory for them the call ends here.
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

  !> Gives up this reference now instead of at the end of the scope.
  impure elemental subroutine destroy(self)
    class(halfspace_mesh), intent(inout) :: self
    call self%handle%drop()
  end subroutine destroy

  !> Is there a mesh?
  elemental logical function exists(self)
    class(halfspace_mesh), intent(in) :: self
    exists = self%handle%owns()
  end function exists

  !> Numbers of nodes, cells and faces at the surface, and the volume.
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
