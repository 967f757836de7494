!> Rest, changes while a world lives, and its factor of safety.
submodule(halfspace_bonded_worlds) halfspace_worlds_rest
  use halfspace_errors, only: conclude
  use halfspace_views, only: is_vector, three_of
  implicit none

contains

  module procedure relax
    type(hs_relaxation_def) :: def
    type(halfspace_balance), target :: found
    integer(c_int32_t) :: status
    status = hs_relaxation_def_init(def, c_sizeof(def))
    if (present(ratio)) def%ratio = ratio
    if (present(measure)) def%measure = measure
    if (present(max_steps)) def%max_steps = max_steps
    if (present(local_damping)) def%local_damping = local_damping
    if (present(adaptive)) def%is_adaptive = merge(1, 0, adaptive)
    if (present(hold_bonds)) def%hold_bonds = merge(1, 0, hold_bonds)
    status = hs_world_relax(self%c_handle(), def, c_loc(found), c_sizeof(found))
    if (present(balance)) balance = found
    if (present(at_rest)) then
      at_rest = status == HS_OK
      if (status == HS_NOTE_NOT_AT_REST) status = HS_OK
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure relax

  module procedure find_balance
    type(hs_balance) :: found
    integer(c_int32_t) :: status
    status = hs_world_get_balance(self%c_handle(), found, c_sizeof(found))
    values = transfer(found, values)
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure find_balance

  module procedure set_gravity
    if (.not. is_vector(gravity, 'gravity', 2, stat, errmsg)) return
    call conclude(hs_world_set_gravity(self%c_handle(), three_of(gravity)), self%c_context(), stat, errmsg)
  end procedure set_gravity

  module procedure set_damping
    real(c_double) :: share, rate
    share = 0
    rate = 0
    if (present(local_damping)) share = local_damping
    if (present(mass_damping)) rate = mass_damping
    call conclude(hs_world_set_damping(self%c_handle(), share, rate), self%c_context(), stat, errmsg)
  end procedure set_damping

  module procedure set_time_step
    real(c_double) :: wanted
    wanted = 0
    if (present(time_step)) wanted = time_step
    call conclude(hs_world_set_time_step(self%c_handle(), wanted), self%c_context(), stat, errmsg)
  end procedure set_time_step

  module procedure set_strength_factor
    call conclude(hs_world_set_strength_factor(self%c_handle(), factor), self%c_context(), stat, errmsg)
  end procedure set_strength_factor

  module procedure find_strength_factor
    type(hs_strength_def) :: def
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    status = hs_strength_def_init(def, c_sizeof(def))
    if (present(low)) def%low = low
    if (present(high)) def%high = high
    if (present(resolution)) def%resolution = resolution
    if (present(ratio)) def%ratio = ratio
    if (present(max_displacement)) def%max_displacement = max_displacement
    if (present(max_steps)) def%max_steps = max_steps
    status = hs_world_find_strength_factor(self%c_handle(), def, report, c_sizeof(report), object)
    if (status == HS_OK) then
      if (present(fallen)) then
        if (.not. takes_world(fallen, object, self, stat, errmsg)) return
      else
        call hs_world_destroy(object)
      end if
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure find_strength_factor

end submodule halfspace_worlds_rest
