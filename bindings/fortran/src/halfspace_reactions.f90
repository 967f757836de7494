!> Contacts by a law without a spring: the points that are kept apart, and by which force (Li et al. 2015, sections 3
!! and 4).
module halfspace_reactions
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  use halfspace_c, only: halfspace_reaction_report => hs_reaction_report
  use halfspace_contacts, only: halfspace_block
  implicit none
  private
  public :: halfspace_reaction, halfspace_reaction_report, count_features_from_1

  !> hs_reaction byte for byte, with the names of its blocks, and features counted from 1.
  type, bind(c) :: halfspace_reaction
    type(halfspace_block) :: block_a  !< the one whose corner it is; of two edges the first
    type(halfspace_block) :: block_b  !< the one whose face it is (in 2D its edge); of two edges the second
    integer(c_int32_t) :: pair_kind = 0  !< HS_PAIR_VERTEX_FACE or, in 3D, HS_PAIR_EDGE_EDGE
    integer(c_int32_t) :: feature_a = 0  !< index of block_a's vertex or edge
    integer(c_int32_t) :: feature_b = 0  !< index of block_b's face (in 2D its edge) or edge
    integer(c_int32_t), private :: reserved = 0
    real(c_double) :: point(3) = 0  !< m
    real(c_double) :: normal(3) = 0  !< unit, outwards from block_b
    real(c_double) :: force(3) = 0  !< on block_a at the end of the last step; in the step of the touch that of the blow
    real(c_double) :: gap = 0  !< > 0 apart: the rest that rounding and turning have left
    real(c_double) :: touched_at = 0  !< time of the touch, inside of a step
  end type halfspace_reaction

contains

  elemental subroutine count_features_from_1(reaction)
    type(halfspace_reaction), intent(inout) :: reaction
    reaction%feature_a = reaction%feature_a + 1
    reaction%feature_b = reaction%feature_b + 1
  end subroutine count_features_from_1

end module halfspace_reactions
