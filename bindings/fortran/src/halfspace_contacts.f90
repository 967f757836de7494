!> Contacts between blocks, and ids of blocks.
module halfspace_contacts
  use halfspace_blocks, only: halfspace_block, id_of, operator(==), operator(/=)
  use halfspace_records, only: halfspace_contact
  implicit none
  private
  public :: halfspace_block, halfspace_contact, count_features_from_1, id_of
  public :: operator(==), operator(/=)

contains

  elemental subroutine count_features_from_1(contact)
    type(halfspace_contact), intent(inout) :: contact
    contact%feature_a = contact%feature_a + 1
    contact%feature_b = contact%feature_b + 1
  end subroutine count_features_from_1

end module halfspace_contacts
