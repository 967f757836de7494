!> Dynamic relaxation and strength reduction of a world.
module halfspace_relaxed_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_loc, c_ptr, c_sizeof
  use halfspace_block_worlds, only: takes_world
  use halfspace_c, halfspace_strength_report => hs_strength_report
  use halfspace_errors, only: conclude
  use halfspace_forwarding_worlds, only: forwarding_world
  use halfspace_records, only: halfspace_balance
  implicit none
  private
  public :: halfspace_strength_report, relaxed_world

  !> A world that comes to rest; halfspace_world extends it.
  type, extends(forwarding_world) :: relaxed_world
  contains
    procedure :: relax
    procedure :: find_strength_factor
  end type relaxed_world

contains

  !> Steps the world under strong damping until static equilibrium, then sets all velocities to 0. Damping and the
  !! state of hold_bonds() are restored afterwards. The time of the relaxation has no physical meaning.
  subroutine relax(self, at_rest, balance, ratio, measure, max_steps, local_damping, adaptive, hold_bonds, &
                   stat, errmsg)
    class(relaxed_world), intent(inout) :: self
    !> .true. in equilibrium; without this argument, stat is HS_NOTE_NOT_AT_REST if it is not in equilibrium after
    !! max_steps
    logical, intent(out), optional :: at_rest
    type(halfspace_balance), intent(out), optional :: balance  !< final balance
    real(c_double), intent(in), optional :: ratio  !< unbalanced ratio of equilibrium, > 0; default 1e-5
    !> HS_UNBALANCED_MEAN (default) or HS_UNBALANCED_LARGEST
    integer(c_int32_t), intent(in), optional :: measure
    integer, intent(in), optional :: max_steps  !< >= 1; default 1000000
    !> [0, 1); default 0.1, for adaptive damping; use 0.8 without it
    real(c_double), intent(in), optional :: local_damping
    !> default .true.: critical mass damping of the slowest mode; .false.: the world's mass damping
    logical, intent(in), optional :: adaptive
    logical, intent(in), optional :: hold_bonds  !< default .true.: bonds cannot fail during the relaxation
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
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
  end subroutine relax

  !> Computes the factor of safety by bisection. Each trial relaxes a copy of the world, with reduced strength, in
  !! which bonds can fail. The world, which should be in equilibrium, does not change.
  subroutine find_strength_factor(self, report, low, high, resolution, ratio, max_displacement, max_steps, &
                                         fallen, stat, errmsg)
    class(relaxed_world), intent(in) :: self
    type(halfspace_strength_report), intent(out) :: report  !< factor of safety, final bracket, number of trials
    real(c_double), intent(in), optional :: low  !< lower bound of the bracket, >= 1e-75; default 0.5
    real(c_double), intent(in), optional :: high  !< upper bound of the bracket, > low; default 5
    real(c_double), intent(in), optional :: resolution  !< width of the final bracket, > 0; default 0.005
    real(c_double), intent(in), optional :: ratio  !< unbalanced ratio of a stable world, > 0; default 1e-5
    !> displacement of a block, divided by its size, that is failure, > 0; default 0.1
    real(c_double), intent(in), optional :: max_displacement
    !> a world not in equilibrium after these steps has failed, >= 1; default 100000
    integer, intent(in), optional :: max_steps
    !> receives the last failed copy in its final state, or no world if no trial failed
    class(relaxed_world), intent(inout), optional :: fallen
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
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
  end subroutine find_strength_factor

end module halfspace_relaxed_worlds
