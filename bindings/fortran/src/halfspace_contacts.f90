!> Names of blocks, and contacts between them.
module halfspace_contacts
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
  use halfspace_c, only: HS_CONTACT_POINTS
  implicit none
  private
  public :: halfspace_block, halfspace_contact, count_features_from_1, id_of
  public :: operator(==), operator(/=)

  !> Names a block of a world. One that was never set is no block; a removed block's never names another.
  type, bind(c) :: halfspace_block
    private
    integer(c_int64_t) :: id = 0
  end type halfspace_block

  !> hs_contact byte for byte, in the terms of this module: blocks by their names, features counted from 1.
  !! Points are in the frame of the poses given, directions in its orientation. Detection of single pairs
  !! leaves what has no meaning there as it was: blocks, forces, torque and twist always; `area` and all that
  !! follows it when the blocks are separated; points and gaps past `point_count`.
  type, bind(c) :: halfspace_contact
    type(halfspace_block) :: block_a  !< in a world
    type(halfspace_block) :: block_b  !< in a world
    integer(c_int32_t) :: type = 0  !< an HS_CONTACT_ value
    integer(c_int32_t) :: point_count = 0  !< points of the region, 0 when separated
    !> an HS_PAIR_ value: of the pair whose half-space is the contact plane, or violated
    integer(c_int32_t) :: pair_kind = 0
    !> block a's vertex, edge or face in it; 0: no vertex is behind the face that separates
    integer(c_int32_t) :: feature_a = 0
    integer(c_int32_t) :: feature_b = 0  !< block b's, likewise
    integer(c_int32_t), private :: reserved = 0
    real(c_double) :: normal(3) = 0  !< unit, from a to b
    real(c_double) :: gap = 0  !< < 0 is overlap; when separated, a lower bound of the distance
    !> 2D: overlap length of an edge-edge region times unit thickness; 3D: of a face-face region
    real(c_double) :: area = 0
    real(c_double) :: length = 0  !< overlap length; 2D: of an edge-edge region; 3D: of an edge-face region
    real(c_double) :: center(3) = 0  !< centroid of the region, on the contact plane
    real(c_double) :: center_gap = 0  !< gap there
    real(c_double) :: points(3, HS_CONTACT_POINTS) = 0  !< of the region, on the contact plane
    real(c_double) :: gaps(HS_CONTACT_POINTS) = 0  !< gap at each point
    real(c_double) :: force(3) = 0  !< on block b, normal and shear together; in a world
    real(c_double) :: torque(3) = 0  !< couple on block b besides the force, about force_point
    real(c_double) :: force_point(3) = 0  !< where the force acts
    real(c_double) :: normal_force = 0  !< compression > 0
    real(c_double) :: shear_force(3) = 0  !< in the contact plane, on block b
    real(c_double) :: twist = 0  !< 3D: torque about the normal, on block b
    real(c_double) :: touched_at = 0  !< s: time of the touch, inside of a step, by a law without springs; else 0
  end type halfspace_contact

  interface operator(==)
    module procedure same_block
  end interface operator(==)

  interface operator(/=)
    module procedure other_block
  end interface operator(/=)

contains

  elemental logical function same_block(a, b)
    type(halfspace_block), intent(in) :: a, b
    same_block = a%id == b%id
  end function same_block

  elemental logical function other_block(a, b)
    type(halfspace_block), intent(in) :: a, b
    other_block = a%id /= b%id
  end function other_block

  elemental integer(c_int64_t) function id_of(block)
    type(halfspace_block), intent(in) :: block
    id_of = block%id
  end function id_of

  elemental subroutine count_features_from_1(contact)
    type(halfspace_contact), intent(inout) :: contact
    contact%feature_a = contact%feature_a + 1
    contact%feature_b = contact%feature_b + 1
  end subroutine count_features_from_1

end module halfspace_contacts
