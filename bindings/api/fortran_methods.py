"""Fortran: the methods of a world that only forward to a function of C, in the base type of all that are written by
hand."""
import re

from fortran_calls import Method
from fortran_records import RECORDS, name_of

# The methods as they are called, in lines by the headers of C. Before a colon stands a generic name, behind "=" that of
# C where it is another one. An array with [] is allocated as long as what is in it; one with another shape has it in C,
# too. An argument with "?" may be absent, and is the number behind it then, or 0.
METHODS = """
add_material(density, material) set_law: set_default_law(law)
set_law: set_law_between=set_law(law, material_a, material_b) remove_block(block) blocks(names=blocks[])
block_state(block, state) block_states(states) block_vertices(block, points=vertices, count?) set_pose(block, pose)
set_velocity(block, velocity, angular_velocity?) set_applied_force(block, force, torque?)
poses: poses_of_blocks=get_poses(values=poses) set_poses: set_poses_of_blocks=set_poses(values=poses)
velocities: velocities_of_blocks=get_velocities(linear=velocities, angular=angular_velocities?)
set_velocities: set_velocities_of_blocks=set_velocities(linear=velocities, angular=angular_velocities?)
set_applied_forces(force=forces, torque=torques?) detect(touching?)
forces: forces_on_blocks=forces(elapsed, force=forces, torque=torques?) step(steps?1) report(values=report)
contacts(list=contacts[]) set_shear_force(block_a, block_b, shear_force)
remove_body(body) remove_cells(body, cells, released?) set_body_stress(body, stress, gradient(3,3,3)?)
body_state(body, state) node_positions(body, points=positions, count?) node_velocities(body, velocities, count?)
node_forces(body, forces, count?) set_node_velocities(body, velocities) hold_nodes(body, nodes, axes, velocity?)
set_node_force(body, nodes, force) cells(body, values=cells, count?) body_of_block(block, body, cell?)
end_actions(block?) end_node_actions(body) set_node_viscosity(body, nodes, viscosity) hold_block(block, axes)
deformation(block, values=deformation) deformations(values=deformations) set_deformation(block, gradient, rate?)
set_stress(block, stress) add_surface_load(block, face, traction) clear_surface_loads(block)
remove_bolt(number) bolts(list=bolts[]) block_at(place, block)
bond_blocks(block_a, block_b, bond=def) bond_materials(material_a, material_b, bond=def, count?) hold_bonds(are_held)
bonds(list=bonds[]) bond_events(list=events[], first?1) bond_report(values=report)
check(notes[])
compound_parts(block, parts[]) compound_of_block(block, compound, part)
definition=get_def(def) densities(list=densities[]) elasticity(material, value=elasticity) law: default_law(value=law)
law: law_between=get_law(value=law, material_a, material_b) actions(list=actions[], block?)
plan(values=plan, steps?)
balance(values=balance) set_gravity(gravity) set_damping(local_damping?, mass_damping?) set_time_step(time_step?)
set_keys(keys) keys(list=keys[]) roles(list=roles[]) sums(values=sums(HS_SUM_COUNT))
set_sums(values=sums(HS_SUM_COUNT)) begin() end_begin() plan_motion(plan) renew_list(plan) move() end_step()
set_strength_factor(factor)
water_loads(force=forces, torque=torques?)
"""
METHOD = re.compile(r"(?:(\w+): )?(\w+)(?:=(\w+))?\(((?:[^()]|\([^)]*\))*)\)")
HEAD = """\
! Generated {generated}.

!> Methods of a world that call one function of the C interface: for blocks, bodies, bonds, bolts, actions, steps and
!! shares.
module halfspace_forwarding_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_size_t, c_sizeof
  use halfspace_block_worlds, only: block_world
  use halfspace_blocks, only: halfspace_block, id_of, names_block
  use halfspace_bodies, only: halfspace_body, id_of_body
  use halfspace_c, &
    {renamed}
  use halfspace_deformations, only: is_tensor, nine_of
  use halfspace_errors, only: conclude, had_memory
  use halfspace_meshes, only: are_from_0
  use halfspace_records
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of, view
  implicit none
  private
  public :: forwarding_world, &
    {public}

  !> A world with all that C does by one call; halfspace_world extends it. Arrays of blocks have the order of blocks(),
  !! those of nodes and cells that of the mesh. Allocatable arrays are as long as what is in them, and keep what they
  !! have after an error.
  type, extends(block_world) :: forwarding_world
  contains
"""


def write(api):
    entries = METHOD.findall(METHODS)
    names = {(c_name or name).removeprefix("get_"): generic or name for generic, name, c_name, _ in entries}
    methods = [Method(api, names, *entry[1:]) for entry in entries]
    structs = sorted(set().union(*(method.structs for method in methods)).difference(RECORDS))
    lines = HEAD.format(generated=api["generated"], public=", &\n    ".join(map(name_of, structs)),
                        renamed=", &\n    ".join(f"{name_of(name)} => {name}" for name in structs)).splitlines()
    for generic, name, *_ in entries:
        lines.append(f"    procedure{', private' if generic else ''} :: {name}")
    lines += [f"    generic :: {generic} => {name}" for generic, name, *_ in entries if generic]
    lines += ["  end type forwarding_world", "", "contains"]
    for method in methods:
        lines += ["", *method.text()]
    return "\n".join([*lines, "", "end module halfspace_forwarding_worlds", ""])
