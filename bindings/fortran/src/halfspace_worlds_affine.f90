!> Deformation of blocks.
submodule(halfspace_block_worlds) halfspace_worlds_affine
  use halfspace_contacts, only: id_of
  use halfspace_deformations, only: count_rows_first, is_tensor, nine_of
  use halfspace_errors, only: conclude
  use halfspace_views, only: is_vector, three_of
  implicit none

contains

  module procedure set_elasticity
    call self%handle%remember_row_length(0)  ! virials are loads, too
    call conclude(hs_world_set_elasticity(self%handle%object(), material - 1, elasticity), self%handle%context(), &
                  stat, errmsg)
  end procedure set_elasticity

  module procedure row_length_of
    type(hs_share_info) :: info
    length = self%handle%row_length()
    if (length > 0) return
    if (hs_world_get_share_info(self%handle%object(), info, c_sizeof(info)) == HS_OK) length = info%load_length
    call self%handle%remember_row_length(length)
  end procedure row_length_of

  module procedure deformation
    type(hs_deformation) :: found
    integer(c_int32_t) :: status
    status = hs_world_get_deformation(self%handle%object(), id_of(block), found)
    if (status == HS_OK) then
      values = transfer(found, values)
      call count_rows_first(values)
    end if
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure deformation

  module procedure deformations
    integer(c_int64_t), target :: count
    integer(c_int32_t) :: status
    status = hs_world_get_deformations(self%handle%object(), c_loc(values), size(values, kind=c_int64_t), c_loc(count))
    if (status >= HS_OK) call count_rows_first(values(:min(count, size(values, kind=c_int64_t))))
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure deformations

  module procedure set_deformation
    real(c_double) :: speed(9)
    if (.not. is_tensor(gradient, 'gradient', stat, errmsg)) return
    speed = 0
    if (present(rate)) then
      if (.not. is_tensor(rate, 'rate', stat, errmsg)) return
      speed = nine_of(rate)
    end if
    call conclude(hs_world_set_deformation(self%handle%object(), id_of(block), nine_of(gradient), speed), &
                  self%handle%context(), stat, errmsg)
  end procedure set_deformation

  module procedure set_stress
    if (.not. is_tensor(stress, 'stress', stat, errmsg)) return
    call conclude(hs_world_set_stress(self%handle%object(), id_of(block), nine_of(stress)), self%handle%context(), &
                  stat, errmsg)
  end procedure set_stress

  module procedure add_surface_load
    if (.not. is_vector(traction, 'traction', 2, stat, errmsg)) return
    call conclude(hs_world_add_surface_load(self%handle%object(), id_of(block), face - 1, three_of(traction)), &
                  self%handle%context(), stat, errmsg)
  end procedure add_surface_load

  module procedure clear_surface_loads
    call conclude(hs_world_clear_surface_loads(self%handle%object(), id_of(block)), self%handle%context(), stat, errmsg)
  end procedure clear_surface_loads

end submodule halfspace_worlds_affine
