!> Usual values of settings.
module halfspace_settings
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  use halfspace_c, only: hs_setting_get_usual, hs_setting_usual_text, HS_OK
  use halfspace_errors, only: text_at
  implicit none
  private
  public :: halfspace_usual_range, halfspace_usual_text

contains

  !> The smallest usual value of a setting but 0, which is usual, too, and the largest one; both 0 for a number that is
  !! no HS_SETTING_ value.
  subroutine halfspace_usual_range(setting, low, high)
    integer(c_int32_t), intent(in) :: setting
    real(c_double), intent(out) :: low, high
    if (hs_setting_get_usual(setting, low, high) == HS_OK) return
    low = 0
    high = 0
  end subroutine halfspace_usual_range

  !> The usual range of a setting in words.
  function halfspace_usual_text(setting) result(text)
    integer(c_int32_t), intent(in) :: setting
    character(:), allocatable :: text
    text = text_at(hs_setting_usual_text(setting))
  end function halfspace_usual_text

end module halfspace_settings
