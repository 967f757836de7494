!> Bonds: breakable connections of blocks along their common faces (Wang et al. 2021, section 3). Properties, states and
!! failures.
module halfspace_bonds
  use, intrinsic :: iso_c_binding, only: c_double, c_sizeof
  use halfspace_c, only: hs_bond_def_init, HS_OK, halfspace_bond => hs_bond_def, &
    halfspace_bond_event => hs_bond_event, halfspace_bond_report => hs_bond_report
  use halfspace_records, only: halfspace_bond_state
  implicit none
  private
  public :: halfspace_bond, halfspace_bond_event, halfspace_bond_report, halfspace_bond_state, count_from_1

  !> halfspace_bond(tensile_strength=2e5_c_double, cohesion=...): missing arguments have the defaults of the library.
  !! Each point of a bond fails on its own, by the Mohr-Coulomb criterion with a tension cut-off.
  interface halfspace_bond
    module procedure bond
  end interface

contains

  function bond(normal_stiffness, shear_stiffness, tensile_strength, cohesion, friction_angle, residual_cohesion, &
                residual_friction_angle, tensile_fracture_energy, shear_fracture_energy)
    real(c_double), intent(in), optional :: normal_stiffness  !< Pa/m, > 0; default 1e11
    real(c_double), intent(in), optional :: shear_stiffness  !< Pa/m, > 0; default 0: normal_stiffness
    real(c_double), intent(in), optional :: tensile_strength  !< Pa, >= 0
    real(c_double), intent(in), optional :: cohesion  !< Pa, >= 0
    real(c_double), intent(in), optional :: friction_angle  !< rad, [0, pi/2), of intact points; default 0
    !> Pa, from 0 to cohesion, of failed points under compression; default 0
    real(c_double), intent(in), optional :: residual_cohesion
    real(c_double), intent(in), optional :: residual_friction_angle  !< rad, [0, pi/2), of failed points
    !> J/m2, >= 0, dissipated as tension decreases linearly with opening after the peak; default 0: sudden failure
    real(c_double), intent(in), optional :: tensile_fracture_energy
    !> J/m2, >= 0, dissipated as shear strength decreases linearly with slip after the peak; default 0: sudden failure
    real(c_double), intent(in), optional :: shear_fracture_energy
    type(halfspace_bond) :: bond
    ! A bond whose initialisation fails keeps size 0, and is refused on use.
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
