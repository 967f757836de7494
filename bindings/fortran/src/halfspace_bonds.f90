!> Bonds: breakable connections of blocks along their common faces (Wang et al. 2021, section 3). States and failures.
module halfspace_bonds
  use halfspace_c, only: halfspace_bond_event => hs_bond_event, halfspace_bond_report => hs_bond_report
  use halfspace_records, only: halfspace_bond_state
  implicit none
  private
  public :: halfspace_bond_event, halfspace_bond_report, halfspace_bond_state, count_from_1

contains

  elemental subroutine count_from_1(event)
    type(halfspace_bond_event), intent(inout) :: event
    event%bond = event%bond + 1
    event%point = event%point + 1
  end subroutine count_from_1

end module halfspace_bonds
