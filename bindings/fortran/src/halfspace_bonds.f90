!> Bonds: the way they hold, their state, and what has failed. Blocks of any kind hold together along their common faces
!! until their strength is reached (Wang et al. 2021, section 3).
module halfspace_bonds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_sizeof
  use halfspace_c, only: halfspace_bond => hs_bond_def, halfspace_bond_report => hs_bond_report, hs_bond_def_init, HS_OK
  use halfspace_contacts, only: halfspace_block
  implicit none
  private
  public :: halfspace_bond, halfspace_bond_event, halfspace_bond_report, halfspace_bond_state, count_from_1

  !> halfspace_bond(tensile_strength=2e5_c_double, cohesion=...): a default of the library stands for all that is not
  !! given. Each of a bond's points fails by itself, by Mohr and Coulomb's criterion with a tension cut-off.
  interface halfspace_bond
    module procedure bond
  end interface

  !> hs_bond byte for byte, with the names of its blocks.
  type, bind(c) :: halfspace_bond_state
    type(halfspace_block) :: block_a  !< no block when one of both has been removed
    type(halfspace_block) :: block_b  !< likewise
    integer(c_int32_t) :: is_joint = 0  !< 1; or 0 when it has come apart and contact has taken over
    integer(c_int32_t) :: point_count = 0  !< integration points
    integer(c_int32_t) :: broken_count = 0  !< those of them that have failed
    integer(c_int32_t), private :: reserved = 0
    real(c_double) :: area = 0  !< that of the common face, in 2D its length
    real(c_double) :: damage = 0  !< mean over the area: 0 whole, 1 failed
    real(c_double) :: normal_force = 0  !< > 0 in tension
    real(c_double) :: shear_force(3) = 0  !< on block_b
  end type halfspace_bond_state

  !> hs_bond_event byte for byte, with bonds and points counted from 1: a point of a bond that has failed.
  type, bind(c) :: halfspace_bond_event
    integer(c_int64_t) :: bond = 0  !< its place in bonds()
    integer(c_int64_t) :: step = 0  !< steps done before
    integer(c_int32_t) :: failure = 0  !< HS_BOND_TENSION or HS_BOND_SHEAR
    integer(c_int32_t) :: point = 0  !< which one of the bond
    real(c_double) :: time = 0  !< s
    real(c_double) :: position(3) = 0  !< m
    real(c_double) :: normal(3) = 0  !< that of the face, from block_a to block_b
    real(c_double) :: area = 0  !< that of the point's share of the face, in 2D a length
    real(c_double) :: normal_traction = 0  !< Pa, > 0 in tension, at the end of the step before
    real(c_double) :: shear_traction = 0  !< Pa, likewise
    real(c_double) :: energy = 0  !< J, lost in this step
  end type halfspace_bond_event

contains

  function bond(normal_stiffness, shear_stiffness, tensile_strength, cohesion, friction_angle, residual_cohesion, &
                residual_friction_angle, tensile_fracture_energy, shear_fracture_energy)
    real(c_double), intent(in), optional :: normal_stiffness  !< Pa/m, > 0; default 1e11
    real(c_double), intent(in), optional :: shear_stiffness  !< Pa/m, > 0; default 0: the normal one
    real(c_double), intent(in), optional :: tensile_strength  !< Pa, >= 0
    real(c_double), intent(in), optional :: cohesion  !< Pa, >= 0
    real(c_double), intent(in), optional :: friction_angle  !< rad, [0, pi/2), of what holds
    !> Pa, from 0 to the cohesion, of what has failed and is pressed together
    real(c_double), intent(in), optional :: residual_cohesion
    real(c_double), intent(in), optional :: residual_friction_angle  !< rad, [0, pi/2), likewise
    !> J/m2, >= 0: tension fades linearly with opening and takes so much from its peak on; default 0: at once
    real(c_double), intent(in), optional :: tensile_fracture_energy
    !> J/m2, >= 0: likewise what shear strength loses with slip; default 0: at once
    real(c_double), intent(in), optional :: shear_fracture_energy
    type(halfspace_bond) :: bond
    ! A bond that could not be filled keeps size 0, and is refused where it is used.
    if (hs_bond_def_init(bond, c_sizeof(bond)) /= HS_OK) return
    if (present(normal_stiffness)) bond%normal_stiffness = normal_stiffness
    if (present(shear_stiffness)) bond%shear_stiffness = shear_stiffness
    if (present(tensile_strength)) bond%tensile_strength = tensile_strength
    if (present(cohesion)) bond%cohesion = cohesion
    if (present(friction_angle)) bond%friction_angle = friction_angle
    if (present(residual_cohesion)) bond%residual_cohesion = residual_cohesion
    if (present(residual_friction_angle)) bond%residual_friction_angle = residual_friction_angle
    if (present(tensile_fracture_energy)) bond%tensile_fracture_energy = tensile_fracture_energy
    if (present(shear_fracture_energy)) bond%shear_fracture_energy = shear_fracture_energy
  end function bond

  elemental subroutine count_from_1(event)
    type(halfspace_bond_event), intent(inout) :: event
    event%bond = event%bond + 1
    event%point = event%point + 1
  end subroutine count_from_1

end module halfspace_bonds
