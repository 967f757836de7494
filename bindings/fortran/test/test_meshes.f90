! Meshes and bodies: nodes, cells and materials are counted from 1, tensors are (row, column).
program test_meshes
  use checking
  use halfspace
  use, intrinsic :: iso_fortran_env, only: int8, int32, int64, real64
  implicit none

  !> Two adjacent squares; the right one is divided along its diagonal.
  real(real64), parameter :: places(2, 6) = reshape([real(real64) :: 0, 0, 1, 0, 1, 1, 0, 1, 2, 0, 2, 1], [2, 6])
  integer(int32), parameter :: kinds(3) = [HS_CELL_QUAD, HS_CELL_TRIANGLE, HS_CELL_TRIANGLE]
  integer(int32), parameter :: cell_nodes(10) = [1, 2, 3, 4, 2, 5, 6, 2, 6, 3]
  real(real64), parameter :: young_modulus = 1e6, poisson_ratio = 0.25, density = 1000
  real(real64), parameter :: at_rest(2) = 0
  integer(int32), parameter :: both_axes = HS_AXIS_X + HS_AXIS_Y

  call properties_of_meshes()
  call stretched()
  call goes_on_bit_for_bit()
  call nodes_are_set_and_read()
  call materials_of_cells()
  call blocks_at_the_surface()
  call tetrahedron_in_space()
  call turned_inside_out()
  call faulty_meshes()
  call refusals()
  call finish()

contains

  subroutine make_mesh(mesh)
    type(halfspace_mesh), intent(inout) :: mesh
    call mesh%create(places, kinds, cell_nodes)
  end subroutine make_mesh

  subroutine make_body(world, body, mass_damping, pose, time_step)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_body), intent(out) :: body
    real(real64), intent(in), optional :: mass_damping, time_step
    type(halfspace_pose), intent(in), optional :: pose
    type(halfspace_mesh) :: mesh
    integer(int32) :: rubber
    call make_mesh(mesh)
    call world%create(gravity=at_rest, mass_damping=mass_damping, time_step=time_step)
    call world%add_material(density, rubber)
    call world%set_elasticity(rubber, halfspace_elasticity(young_modulus, poisson_ratio, plane=HS_PLANE_STRESS))
    call world%add_mesh(mesh, body, pose=pose)
  end subroutine make_body

  !> It is held at its left side along x, and pulled to the right.
  subroutine make_pulled_body(world, body)
    type(halfspace_world), intent(inout) :: world
    type(halfspace_body), intent(out) :: body
    call make_body(world, body, mass_damping=16.0_real64)
    call world%hold_nodes(body, [1], both_axes)
    call world%hold_nodes(body, [4], HS_AXIS_X)
    call world%set_node_force(body, [5, 6], [0.5_real64 * force(), 0.0_real64])
  end subroutine make_pulled_body

  !> A stretch by 1.25: the Green strain is 9/32, the second Piola-Kirchhoff stress the modulus times this.
  real(real64) function force()
    force = 1.25_real64 * (9.0_real64 / 32) * young_modulus
  end function force

  subroutine properties_of_meshes()
    type(halfspace_mesh) :: mesh, same, rows, quads
    type(halfspace_mesh_properties) :: p
    call expect(.not. mesh%exists(), 'there is no mesh yet')
    call make_mesh(mesh)
    same = mesh
    call mesh%destroy()
    call expect(.not. mesh%exists() .and. same%exists(), 'a copy outlives the original')
    call same%properties(p)
    call expect(p%dimension == 2 .and. p%node_count == 6 .and. p%cell_count == 3, 'nodes and cells')
    call expect(p%surface_face_count == 6 .and. p%volume == 2, 'edges at the surface, and area')
    call rows%create(transpose(places), kinds, cell_nodes, rows=.true.)
    call rows%properties(p)
    call expect(p%dimension == 2 .and. p%volume == 2, 'nodes in rows')
    call quads%create(places, HS_CELL_QUAD, reshape([1, 2, 3, 4, 2, 5, 6, 3], [4, 2]))
    call quads%properties(p)
    call expect(p%cell_count == 2 .and. abs(p%volume - 2) < 1e-14_real64, 'cells of one kind')
  end subroutine properties_of_meshes

  ! The damping is about critical for bending, the slowest mode, at about 8/s: after 4 s it has decayed.
  subroutine stretched()
    type(halfspace_world) :: world
    type(halfspace_body) :: body
    type(halfspace_body_state) :: state
    type(halfspace_cell_state) :: cells(3)
    type(halfspace_world_report) :: report
    real(real64) :: points(2, 6), forces(2, 6), thinner, energy
    call make_pulled_body(world, body)
    do
      call world%step(100)
      call world%report(report)
      if (report%time > 4) exit
    end do
    thinner = sqrt(1 - 2 * poisson_ratio * 9 / 32)
    call world%node_positions(body, points)
    call expect_close(points(1, :), places(1, :) * 1.25_real64, 1e-9_real64, 'the stretch')
    call expect_close(points(2, :), places(2, :) * thinner, 1e-9_real64, 'and how thin it becomes')
    call world%node_forces(body, forces)
    call expect_close(forces(1, :), force() * 0.5_real64 * [1, 0, 0, 1, 0, 0], 1e-3_real64, 'pull on the support')
    call expect_close(forces(2, :), spread(0.0_real64, 1, 6), 1e-3_real64, 'nothing across')

    call world%cells(body, cells)
    call expect_close(cells%strain(1, 1), spread(9.0_real64 / 32, 1, 3), 1e-9_real64, 'strain along')
    call expect_close(cells%strain(2, 2), spread(-poisson_ratio * 9 / 32, 1, 3), 1e-9_real64, 'strain across')
    call expect_close(cells%stress(1, 1), spread(force() / thinner, 1, 3), 1e-3_real64, 'stress along')
    call expect_close(cells%stress(2, 2), spread(0.0_real64, 1, 3), 1e-3_real64, 'no stress across')
    call world%body_state(body, state)
    energy = young_modulus * (9.0_real64 / 32)**2  ! over 2, times the area
    call expect_close([state%strain_energy, sum(cells%strain_energy)], [energy, energy], 1e-4_real64, 'strain energy')
    call expect_close(state%centroid, [1.25_real64, 0.5_real64 * thinner, 0.0_real64], 1e-9_real64, 'the centroid')
    call expect(state%node_count == 6 .and. state%cell_count == 3 .and. state%mass == 2 * density, 'numbers and mass')
    call expect(state%kinetic_energy < 1e-12_real64 .and. all(abs(state%momentum) < 1e-6_real64), 'it is at rest')
  end subroutine stretched

  subroutine goes_on_bit_for_bit()
    type(halfspace_world) :: world, restored
    type(halfspace_body) :: body
    integer(int8), allocatable :: bytes(:)
    real(real64) :: expected(2, 6), got(2, 6)
    call make_pulled_body(world, body)
    call world%step(20)
    call world%save(bytes)
    call restored%restore(bytes)
    call world%step(20)
    call restored%step(20)
    call world%node_positions(body, expected)
    call restored%node_positions(body, got)
    call expect(all(expected == got) .and. any(got /= places), 'a restored world goes on')
    call world%node_velocities(body, expected)
    call restored%node_velocities(body, got)
    call expect(all(expected == got) .and. any(got > 0), 'also its velocities')
  end subroutine goes_on_bit_for_bit

  ! Rotated by 90 degrees about the origin of its frame, and placed at (3, 4).
  subroutine nodes_are_set_and_read()
    type(halfspace_world) :: world
    type(halfspace_body) :: body
    type(halfspace_body_state) :: state
    real(real64) :: points(2, 6), velocities(2, 6), in_rows(6, 3), few(2, 2)
    integer(int64) :: count
    integer :: stat, i
    call make_body(world, body, pose=halfspace_pose(3.0_real64, 4.0_real64, acos(0.0_real64)), time_step=1e-3_real64)
    call world%node_positions(body, points, count=count)
    call expect_close([points(:, 6), real(count, real64)], [2.0_real64, 6.0_real64, 6.0_real64], 1e-14_real64, &
                      'the last node')
    call world%node_positions(body, few, count=count, stat=stat)
    call expect(stat == HS_NOTE_TRUNCATED .and. count == 6 .and. all(few == points(:, :2)), 'as many as fit')
    in_rows = 7
    call world%node_positions(body, in_rows, rows=.true.)
    call expect(all(in_rows(:, :2) == transpose(points)) .and. all(in_rows(:, 3) == 0), 'rows of three')

    velocities = spread([real(real64) :: 1, 2], 2, 6)
    call world%set_node_velocities(body, velocities)
    call world%hold_nodes(body, [2], HS_AXIS_Y, [7.0_real64, -3.0_real64])
    call world%node_velocities(body, points)
    velocities(2, 2) = -3
    call expect(all(points == velocities), 'what is not held keeps its velocity')
    call world%set_node_velocities(body, velocities(:, [(7 - i, i = 1, 6)]))
    call world%hold_nodes(body, [(i, i = 1, 6)], both_axes, [2.0_real64, 0.5_real64])
    call world%step(1000)
    call world%body_state(body, state)
    call expect_close(state%momentum, 2 * density * [2.0_real64, 0.5_real64, 0.0_real64], 1e-9_real64, 'all held go on')
    call expect_close(state%centroid, [4.5_real64, 5.5_real64, 0.0_real64], 1e-9_real64, 'where the centroid is then')
  end subroutine nodes_are_set_and_read

  ! The left square has the second material, and twice the mass.
  subroutine materials_of_cells()
    type(halfspace_mesh) :: mesh
    type(halfspace_world) :: world
    type(halfspace_body) :: body
    type(halfspace_body_state) :: state
    integer(int32) :: light, heavy
    call make_mesh(mesh)
    call world%create()
    call world%add_material(density, light)
    call world%add_material(2 * density, heavy)
    call world%set_elasticity(light, halfspace_elasticity())
    call world%set_elasticity(heavy, halfspace_elasticity())
    call world%add_mesh(mesh, body, cell_materials=[heavy, light, light], velocity=[1.0_real64, -2.0_real64])
    call world%body_state(body, state)
    call expect_close([state%mass, state%momentum], 3 * density * [1, 1, -2, 0], 1e-9_real64, 'mass and momentum')
    call expect_close(state%centroid(:1), [2.5_real64 / 3], 1e-14_real64, 'a centroid of masses')
    call world%add_mesh(mesh, body, heavy)
    call mesh%destroy()
    call world%body_state(body, state)
    call expect(state%mass == 4 * density, 'one material for all')
  end subroutine materials_of_cells

  ! The quad is two triangles there.
  subroutine blocks_at_the_surface()
    type(halfspace_world) :: world
    type(halfspace_shape) :: square
    type(halfspace_body) :: body, other, none
    type(halfspace_block) :: single
    type(halfspace_block), allocatable :: blocks(:)
    type(halfspace_block_state) :: state
    integer(int32) :: cell, i
    logical :: met(3)
    integer :: stat
    call make_body(world, body)
    met = .false.
    call world%blocks(blocks)
    do i = 1, size(blocks)
      call world%block_state(blocks(i), state)
      call expect(state%kind == HS_BLOCK_MESH, 'the kind of a block at the surface')
      call world%body_of_block(blocks(i), other, cell)
      call expect(other == body, 'its body')
      if (cell >= 1 .and. cell <= 3) met(cell) = .true.
    end do
    call expect(all(met), 'all cells are at the surface')

    call square%create_polygon(places(:, :4))
    call world%add_block(square, single, pose=halfspace_pose(9.0_real64, 9.0_real64))
    call world%body_of_block(single, other, cell)
    call expect(other == none .and. other /= body .and. cell == 0, 'a single block is of no body')
    call world%remove_block(blocks(1), stat)
    call expect(stat < 0, 'a block of a body is not removed by itself')
    call world%remove_body(body)
    call expect(world%block_count() == 1, 'the blocks go with their body')
    call world%body_of_block(blocks(1), other, stat=stat)
    call expect(stat == HS_ERROR_STALE_ID, 'their names are stale')
  end subroutine blocks_at_the_surface

  subroutine tetrahedron_in_space()
    type(halfspace_mesh) :: mesh
    type(halfspace_world) :: world
    type(halfspace_body) :: body
    type(halfspace_cell_state) :: cell(1)
    real(real64) :: points(3, 4)
    integer(int32) :: rubber
    call mesh%create(reshape([real(real64) :: 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [3, 4]), HS_CELL_TETRAHEDRON, &
                     reshape([1, 2, 3, 4], [4, 1]))
    call world%create(dimension=3, gravity=[real(real64) :: 0, 0, 0], time_step=2.0_real64**(-10))
    call world%add_material(density, rubber)
    call world%set_elasticity(rubber, halfspace_elasticity(young_modulus))
    call world%add_mesh(mesh, body)
    call world%hold_nodes(body, [1, 2, 3], both_axes + HS_AXIS_Z)
    call world%hold_nodes(body, [4], both_axes + HS_AXIS_Z, [128.0_real64, 0.0_real64, 0.0_real64])
    call world%step(2)  ! a simple shear: x grows by z / 4
    call world%node_positions(body, points)
    call expect_close(points(:, 4), [0.25_real64, 0.0_real64, 1.0_real64], 1e-14_real64, 'a node in space')
    call world%cells(body, cell)
    call expect_close([cell(1)%strain(1, 3), cell(1)%strain(3, 1), cell(1)%strain(3, 3), cell(1)%strain(1, 1)], &
                      [0.125_real64, 0.125_real64, 0.03125_real64, 0.0_real64], 1e-14_real64, 'strain by shear')
  end subroutine tetrahedron_in_space

  ! The right side moves through the left one in one step.
  subroutine turned_inside_out()
    type(halfspace_world) :: world
    type(halfspace_body) :: body
    integer :: stat
    real(real64) :: before(2, 6), after(2, 6)
    character(200) :: text
    call make_body(world, body, time_step=1e-3_real64)
    call world%hold_nodes(body, [1, 2, 3, 4], both_axes)
    call world%hold_nodes(body, [5, 6], both_axes, [-4000.0_real64, 0.0_real64])
    call world%node_positions(body, before)
    call world%step(1, stat, text)
    call expect(stat == HS_ERROR_INVERTED, 'a cell inside out')
    call expect_text(text, 'hs_world_step: ')
    call world%node_positions(body, after)
    call expect(all(before == after), 'the world stays at the last good step')
  end subroutine turned_inside_out

  subroutine faulty_meshes()
    type(halfspace_mesh) :: mesh
    type(halfspace_context) :: none
    real(real64) :: one_component(1, 6)
    integer :: stat
    character(200) :: text
    call mesh%create(places, kinds, cell_nodes([4, 3, 2, 1, 5, 6, 7, 8, 9, 10]), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_GEOMETRY .and. .not. mesh%exists(), 'a quad that runs clockwise')
    call expect_text(text, 'hs_mesh_create: cell 0 ')
    call mesh%create(places, kinds, [cell_nodes(:9), 7], stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'there is no seventh node')
    call expect_text(text, 'hs_mesh_create: cell 2 ')
    call mesh%create(places, kinds, cell_nodes(:9), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a node lacks')
    call mesh%create(places, HS_CELL_HEXAHEDRON, reshape([1, 2, 3, 4], [4, 1]), stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a hexahedron in the plane')
    one_component = 0
    call mesh%create(one_component, kinds, cell_nodes, stat=stat, errmsg=text)
    call expect_text(text, 'nodes: extent 1 is 1; it must be 2 or 3')
    call mesh%create(places, kinds, cell_nodes, context=none, stat=stat, errmsg=text)
    call expect_text(text, 'was not created')
  end subroutine faulty_meshes

  subroutine refusals()
    type(halfspace_world) :: world, none
    type(halfspace_mesh) :: mesh
    type(halfspace_body) :: body
    type(halfspace_body_state) :: state
    type(halfspace_cell_state) :: one(1)
    integer(int32) :: rigid
    integer(int64) :: count
    integer :: stat
    character(200) :: text
    call make_body(world, body)
    call world%add_mesh(mesh, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a mesh that was not created')
    call expect_text(text, 'hs_world_add_mesh: mesh')
    call world%add_mesh(mesh, cell_materials=[1], stat=stat, errmsg=text)
    call expect_text(text, 'hs_world_add_mesh: mesh')
    call make_mesh(mesh)
    call world%add_mesh(mesh, cell_materials=[1, 1], stat=stat, errmsg=text)
    call expect_text(text, 'cell_materials: has 2 values; the mesh has 3 cells')
    call world%add_material(density, rigid)
    call world%add_mesh(mesh, material=rigid, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_STATE, 'a material that is not elastic')
    call expect_text(text, 'has no elasticity')
    call world%add_mesh(mesh, velocity=[1.0_real64], stat=stat, errmsg=text)
    call expect_text(text, 'velocity: has 1 values')
    call world%remove_cells(body, [1, 4], stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a cell that is not there')
    call expect_text(text, 'cells[1] is 3; the body has 3')
    call world%remove_cells(body, [1, 2, 3], stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_STATE, 'all cells of a body')
    call world%set_body_stress(body, reshape([0, 1, 0, 2, 0, 0, 0, 0, 0] * 1.0_real64, [3, 3]), stat=stat, errmsg=text)
    call expect_text(text, 'the tensor must be symmetric')
    call world%hold_nodes(body, [6, 7], HS_AXIS_X, stat=stat, errmsg=text)
    call expect(stat == HS_ERROR_ARGUMENT, 'a node that is not there')
    call expect_text(text, 'nodes[1] is 6; the body has 6')
    call world%hold_nodes(body, [1], HS_AXIS_Z, stat=stat, errmsg=text)
    call expect_text(text, 'axes is 4')
    call world%set_node_force(body, [0], at_rest, stat, text)
    call expect_text(text, 'nodes[0] is -1')
    call world%set_node_velocities(body, places(:, :5), stat=stat, errmsg=text)
    call expect_text(text, 'the body has 6 nodes')
    call world%cells(body, one, count, stat)
    call expect(stat == HS_NOTE_TRUNCATED .and. count == 3, 'not all cells fit')
    call world%remove_body(body)
    call world%body_state(body, state, stat, text)
    call expect(stat == HS_ERROR_STALE_ID, 'a removed body')
    call expect_text(text, 'hs_world_get_body_state: body')
    call none%remove_body(body, stat)
    call expect(stat < 0, 'no world')
  end subroutine refusals

end program test_meshes
