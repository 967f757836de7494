!> A world: blocks, materials, laws and time. Use step(), or detect() and forces() with an integrator of the host.
!!
!! Bulk arrays have one entry per block, in the order of blocks(). Points and vectors are columns, x(2,n) or x(3,n);
!! with rows = .true. they are rows, x(n,2) or x(n,3). Array sections are accessed without a copy. Angular velocities
!! and torques have three components; in 2D only z is used.
module halfspace_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_blocks, only: halfspace_block, id_of, names_block
  use halfspace_bodies, only: halfspace_body, id_of_body
  use halfspace_c, halfspace_energy => hs_energy
  use halfspace_definitions, only: halfspace_pose
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_meshes, only: are_from_0, halfspace_mesh, halfspace_mesh_properties
  use halfspace_properties, only: halfspace_bolt
  use halfspace_shapes, only: halfspace_shape
  use halfspace_spread_worlds, only: spread_world
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of, view
  implicit none
  private
  public :: halfspace_energy, halfspace_world

  !> Assignment adds a reference: all copies are the same world, which the last one destroys. save() and restore() make
  !! a copy. Here are procedures that add to a world. Its creation is declared in halfspace_block_worlds, all that C
  !! does by one call in halfspace_forwarding_worlds, relaxation in halfspace_relaxed_worlds, separate arrays of
  !! components in the plane in halfspace_plane_worlds, shares in halfspace_spread_worlds.
  type, extends(spread_world) :: halfspace_world
  contains
    procedure :: add_mesh
    procedure :: add_compound
    procedure :: add_table
    procedure :: table
    procedure :: add_action
    procedure :: add_node_action
    procedure :: prescribe_velocities
    procedure :: add_bolt
    procedure :: set_water
  end type halfspace_world

contains

  !> Adds a copy of a mesh to the world. Its surface cells become blocks of the kind HS_BLOCK_MESH.
  subroutine add_mesh(self, mesh, body, material, pose, velocity, cell_materials, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    type(halfspace_mesh), intent(in) :: mesh  !< of the world's dimension
    type(halfspace_body), intent(out), optional :: body  !< its id
    integer(c_int32_t), intent(in), optional :: material  !< index of a material with elasticity; default 1
    type(halfspace_pose), intent(in), optional :: pose  !< pose of the frame of the mesh; default: identity
    real(c_double), intent(in), optional :: velocity(:)  !< of all nodes, m/s, 3 values (2D: or 2); default 0
    integer(c_int32_t), intent(in), optional :: cell_materials(:)  !< one index per cell, instead of `material`
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_body_def) :: def
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(c_ptr) :: materials
    integer(c_int32_t) :: status
    integer(c_int64_t) :: id
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    end if
    materials = c_null_ptr
    if (present(cell_materials)) then
      if (.not. are_one_for_each(cell_materials, mesh, stat, errmsg)) return
      if (.not. are_from_0(cell_materials, from_0, stat, errmsg)) return
      materials = c_loc(from_0)
    end if
    status = hs_body_def_init(def, c_sizeof(def))
    if (present(material)) def%material = material - 1
    if (present(pose)) def%pose = pose
    if (present(velocity)) def%velocity = three_of(velocity)
    status = hs_world_add_mesh(self%c_handle(), mesh%c_handle(), def, materials, id)
    if (status == HS_OK .and. present(body)) body = transfer(id, body)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine add_mesh

  !> Is there one material per cell? C cannot check this. C refuses a missing mesh.
  logical function are_one_for_each(cell_materials, mesh, stat, errmsg)
    integer(c_int32_t), intent(in) :: cell_materials(:)
    type(halfspace_mesh), intent(in) :: mesh
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_mesh_properties) :: properties
    character(100) :: text
    are_one_for_each = .not. mesh%exists()
    if (are_one_for_each) return
    call mesh%properties(properties, stat, errmsg)
    if (present(stat)) then
      if (stat /= HS_OK) return
    end if
    are_one_for_each = size(cell_materials, kind=c_int64_t) == properties%cell_count
    if (are_one_for_each) return
    write (text, '("cell_materials: has ", i0, " values; the mesh has ", i0, " cells")') &
      size(cell_materials), properties%cell_count
    call refuse(trim(text), stat, errmsg)
  end function are_one_for_each

  !> Adds a compound of convex parts, which touch or are apart. The world copies the shapes.
  subroutine add_compound(self, shapes, block, poses, kind, material, pose, velocity, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    type(halfspace_shape), intent(in) :: shapes(:)  !< of the parts
    type(halfspace_block), intent(out), optional :: block  !< its id
    type(halfspace_pose), intent(in), optional :: poses(:)  !< of the parts in one frame; default: as their vertices
    integer(c_int32_t), intent(in), optional :: kind  !< HS_BLOCK_RIGID (default), _FIXED or _PRESCRIBED
    integer(c_int32_t), intent(in), optional :: material  !< index from add_material(); default 1
    type(halfspace_pose), intent(in), optional :: pose  !< of the centroid of all parts; default: as the parts
    real(c_double), intent(in), optional :: velocity(:)  !< of that centroid, 3 values (2D: or 2); default 0
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_block_def) :: def
    type(c_ptr), target :: handles(size(shapes))
    type(hs_pose), target :: places(size(shapes))
    type(c_ptr) :: given
    integer(c_int64_t) :: id
    integer(c_int32_t) :: status
    integer :: i
    given = c_null_ptr
    if (present(poses)) then
      if (size(poses) /= size(shapes)) then
        call refuse('poses: must be as many as shapes', stat, errmsg)
        return
      end if
      do i = 1, size(shapes)
        places(i) = poses(i)
      end do
      given = c_loc(places)
    end if
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    end if
    do i = 1, size(shapes)
      handles(i) = shapes(i)%c_handle()
    end do
    status = hs_compound_def_init(def, c_sizeof(def), c_loc(handles), given, size(shapes, kind=c_int64_t))
    if (present(kind)) def%kind = kind
    if (present(material)) def%material = material - 1
    if (present(pose)) def%pose = pose
    if (present(velocity)) def%velocity = three_of(velocity)
    status = hs_world_add_compound(self%c_handle(), c_loc(handles), given, size(shapes, kind=c_int64_t), def, id)
    if (status == HS_OK .and. present(block)) block = transfer(id, block)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine add_compound

  !> Adds a table: values at times, linear between them, before the first and after the last time constant. Within a
  !! step a load is constant, the mean of its table, and a prescribed block moves by the integral of its velocity, so
  !! both are exact for any time step.
  subroutine add_table(self, times, values, table, rows, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    real(c_double), intent(in), target, contiguous :: times(:)  !< s, in ascending order; two equal ones are a jump
    real(c_double), intent(in), target :: values(:,:)  !< one vector per time; without z, z is 0
    integer(c_int32_t), intent(out) :: table  !< its index, from 1
    logical, intent(in), optional :: rows  !< layout of `values`
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_view) :: all
    integer(c_int32_t) :: status
    table = 0
    if (.not. are_points(values, 'values', rows, stat, errmsg)) return
    all = view(values, rows)
    if (.not. are_as_many(size(times, kind=c_int64_t), 'times', all%count, 'values', stat, errmsg)) return
    status = hs_world_add_table(self%c_handle(), c_loc(times), all, table)
    table = merge(table + 1, 0, status == HS_OK)
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine add_table

  !> Adds an action on a block, or without `block` on all blocks that move freely. Loads of one block add up; a motion
  !! ends the earlier ones along its axes.
  subroutine add_action(self, kind, table, block, scale, at, place, start, max_speed, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    !> an HS_ACTION_ value: a motion of a prescribed block or along held axes, a load on a rigid or affine block, or
    !! HS_ACTION_SERVO; without `block` only HS_ACTION_ACCELERATION
    integer(c_int32_t), intent(in) :: kind
    integer(c_int32_t), intent(in) :: table  !< index from add_table()
    type(halfspace_block), intent(in), optional :: block
    !> factor of each component, 3 values (2D: or 2, z is 0 then); default 1. A motion does not change components of
    !! scale 0; a servo presses along the scale as a vector
    real(c_double), intent(in), optional :: scale(:)
    real(c_double), intent(in), optional :: at(:)  !< place of a force, m, 3 values (2D: or 2); default: the centroid
    !> HS_PLACE_CARRIED (default): the place moves with the block; or HS_PLACE_FIXED
    integer(c_int32_t), intent(in), optional :: place
    real(c_double), intent(in), optional :: start  !< time of the world at time 0 of the table, s; default 0
    real(c_double), intent(in), optional :: max_speed  !< of a servo, m/s, > 0
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_action_def) :: def
    integer(c_int64_t) :: id
    if (.not. names_block(block, id, stat, errmsg)) return
    def = definition(kind, table, start)
    if (present(scale)) then
      if (.not. is_vector(scale, 'scale', 2, stat, errmsg)) return
      def%scale = three_of(scale)
    end if
    if (present(at)) then
      if (.not. is_vector(at, 'at', 2, stat, errmsg)) return
      def%point = three_of(at)
      def%place = HS_PLACE_CARRIED
      if (present(place)) def%place = place
    end if
    if (present(max_speed)) def%max_speed = max_speed
    call conclude(hs_world_add_action(self%c_handle(), id, def), self%c_context(), stat, errmsg)
  end subroutine add_action

  !> Adds an action on nodes of a body, e.g. a traction: each node with a share of the area as scale.
  subroutine add_node_action(self, body, nodes, kind, table, scales, rows, start, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    type(halfspace_body), intent(in) :: body
    integer(c_int32_t), intent(in) :: nodes(:)  !< of the mesh
    !> HS_ACTION_FORCE, or along axes held by hold_nodes() HS_ACTION_VELOCITY or HS_ACTION_ACCELERATION
    integer(c_int32_t), intent(in) :: kind
    integer(c_int32_t), intent(in) :: table  !< index from add_table()
    real(c_double), intent(in), target :: scales(:,:)  !< factor of each component, one vector per node
    logical, intent(in), optional :: rows  !< layout of `scales`
    real(c_double), intent(in), optional :: start  !< as above
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(hs_view) :: factors
    if (.not. are_points(scales, 'scales', rows, stat, errmsg)) return
    factors = view(scales, rows)
    if (.not. are_as_many(size(nodes, kind=c_int64_t), 'nodes', factors%count, 'scales', stat, errmsg)) return
    if (.not. are_from_0(nodes, from_0, stat, errmsg)) return
    call conclude(hs_world_add_node_action(self%c_handle(), id_of_body(body), c_loc(from_0), factors, &
                                           definition(kind, table, start)), self%c_context(), stat, errmsg)
  end subroutine add_node_action

  !> Sets the velocities of prescribed blocks between steps. Contacts and forces are kept, so it may be called at each
  !! step. Without `angular`, angular velocities stay.
  subroutine prescribe_velocities(self, blocks, linear, angular, rows, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    type(halfspace_block), intent(in), target, contiguous :: blocks(:)
    real(c_double), intent(in), target :: linear(:,:)  !< of the centroids, m/s, one vector per block
    real(c_double), intent(in), target, optional :: angular(:,:)  !< rad/s
    logical, intent(in), optional :: rows  !< layout of both
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_view) :: velocities, spins
    if (.not. are_points(linear, 'linear', rows, stat, errmsg)) return
    velocities = view(linear, rows)
    if (.not. are_as_many(size(blocks, kind=c_int64_t), 'blocks', velocities%count, 'linear', stat, errmsg)) return
    if (present(angular)) then
      if (.not. are_points(angular, 'angular', rows, stat, errmsg)) return
      spins = view(angular, rows)
    end if
    call conclude(hs_world_prescribe_velocities(self%c_handle(), c_loc(blocks), velocities, spins), &
                  self%c_context(), stat, errmsg)
  end subroutine prescribe_velocities

  !> Adds a bolt between the current positions of two places, each carried by a block, or by the ground where the block
  !! is missing. The removal of a block removes its bolts. HS_ERROR_STATE if neither block moves.
  subroutine add_bolt(self, bolt, place_a, place_b, block_a, block_b, number, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    type(halfspace_bolt), intent(in) :: bolt
    real(c_double), intent(in) :: place_a(:)  !< m, 3 values (2D: or 2)
    real(c_double), intent(in) :: place_b(:)  !< m, 3 values (2D: or 2)
    type(halfspace_block), intent(in), optional :: block_a
    type(halfspace_block), intent(in), optional :: block_b
    integer(c_int64_t), intent(out), target, optional :: number  !< >= 0, which no later bolt gets
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_bolt) :: def
    if (present(number)) number = -1
    if (.not. is_vector(place_a, 'place_a', 2, stat, errmsg)) return
    if (.not. is_vector(place_b, 'place_b', 2, stat, errmsg)) return
    def = bolt
    def%place_a = three_of(place_a)
    def%place_b = three_of(place_b)
    if (present(block_a)) def%block_a = id_of(block_a)
    if (present(block_b)) def%block_b = id_of(block_b)
    call conclude(hs_world_add_bolt(self%c_handle(), def, address_of(number)), self%c_context(), stat, errmsg)
  end subroutine add_bolt

  !> Sets the water, in place of the water before. Without points there is no water.
  subroutine set_water(self, table, density, factor, rows, columns, stat, errmsg)
    class(halfspace_world), intent(inout) :: self
    !> in 2D the corners of a polyline, in ascending order of x, level beyond its ends; in 3D one point of a level
    !! plane, three points of a plane, or the points of a height map row by row
    real(c_double), intent(in), target :: table(:,:)
    real(c_double), intent(in), optional :: density  !< kg/m3; default 1000
    real(c_double), intent(in), optional :: factor  !< multiplies the pressure; default 1
    logical, intent(in), optional :: rows  !< layout of the table
    integer, intent(in), optional :: columns  !< 3D: points in each row of a height map; default 0: a plane
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_water_def) :: def
    integer(c_int32_t) :: status
    if (.not. are_points(table, 'table', rows, stat, errmsg)) return
    status = hs_water_def_init(def, c_sizeof(def))
    if (present(density)) def%density = density
    if (present(factor)) def%factor = factor
    if (present(columns)) def%columns = int(columns, c_int32_t)
    status = hs_world_set_water(self%c_handle(), def, view(table, rows))
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine set_water

  !> The rows of a table.
  subroutine table(self, index, times, values, stat, errmsg)
    class(halfspace_world), intent(in) :: self
    integer(c_int32_t), intent(in) :: index  !< from add_table()
    real(c_double), intent(inout), allocatable, target :: times(:)  !< s
    real(c_double), intent(inout), allocatable, target :: values(:,:)  !< columns of three components
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    integer :: failure
    type(hs_mutable_view) :: none
    status = hs_world_get_table(self%c_handle(), index - 1, c_null_ptr, none, c_loc(count))
    if (status >= HS_OK) then
      if (allocated(times)) deallocate (times)
      if (allocated(values)) deallocate (values)
      allocate (times(count), values(3, count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_table(self%c_handle(), index - 1, c_loc(times), mutable_view(values), c_null_ptr)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine table

  !> Missing arguments have the defaults of the library.
  type(hs_action_def) function definition(kind, table, start) result(def)
    integer(c_int32_t), intent(in) :: kind, table
    real(c_double), intent(in), optional :: start
    ! A definition whose initialisation fails keeps size 0, and is refused on use.
    if (hs_action_def_init(def, c_sizeof(def)) /= HS_OK) return
    def%kind = kind
    def%table = table - 1
    if (present(start)) def%start = start
  end function definition

  !> C reads as many entries as the view has vectors.
  logical function are_as_many(count, name, expected, of_view, stat, errmsg)
    integer(c_int64_t), intent(in) :: count, expected
    character(*), intent(in) :: name, of_view
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(len(name) + len(of_view) + 80) :: text
    are_as_many = count == expected
    if (are_as_many) return
    write (text, '(a, ": has ", i0, " values; ", a, " has ", i0, " vectors")') name, count, of_view, expected
    call refuse(trim(text), stat, errmsg)
  end function are_as_many

end module halfspace_worlds
