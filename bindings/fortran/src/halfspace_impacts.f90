!> Time of impact of two moving shapes.
module halfspace_impacts
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_null_ptr, c_ptr
  use halfspace_c, only: halfspace_impact => hs_impact, hs_pair_time_of_impact, HS_IMPACT_NEVER, HS_OK
  use halfspace_definitions, only: halfspace_motion
  use halfspace_errors, only: conclude
  use halfspace_shapes, only: context_of, halfspace_shape
  implicit none
  private
  public :: halfspace_impact, halfspace_time_of_impact

contains

  !> Computes the time of impact of two moving shapes by conservative advancement. The shapes are separated at all times
  !! before the reported one, whatever their speed, thickness or number of revolutions. impact%state is HS_IMPACT_NEVER
  !! if they do not touch; features are counted from 1.
  subroutine halfspace_time_of_impact(shape_a, motion_a, shape_b, motion_b, duration, impact, stat, errmsg)
    type(halfspace_shape), intent(in) :: shape_a, shape_b  !< of the same dimension; may be the same shape
    type(halfspace_motion), intent(in) :: motion_a, motion_b  !< their motions
    real(c_double), intent(in) :: duration  !< s, >= 0
    type(halfspace_impact), intent(inout) :: impact  !< receives time, place and normal of the first touch
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_impact) :: found
    type(c_ptr) :: context
    integer(c_int32_t) :: status
    status = hs_pair_time_of_impact(shape_a%c_handle(), motion_a, shape_b%c_handle(), motion_b, duration, found)
    if (status == HS_OK) then
      if (found%state /= HS_IMPACT_NEVER) then
        found%feature_a = found%feature_a + 1
        found%feature_b = found%feature_b + 1
      end if
      impact = found
    end if
    context = c_null_ptr
    if (shape_a%exists()) context = context_of(shape_a)
    call conclude(status, context, stat, errmsg)
  end subroutine halfspace_time_of_impact

end module halfspace_impacts
