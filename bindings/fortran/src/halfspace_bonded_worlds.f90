!> Bonds, dynamic relaxation and strength reduction of a world.
module halfspace_bonded_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c, halfspace_strength_report => hs_strength_report
  use halfspace_block_worlds, only: block_world, takes_world
  use halfspace_bonds, only: halfspace_bond_event, halfspace_bond_report, halfspace_bond_state
  use halfspace_contacts, only: halfspace_block
  use halfspace_properties, only: halfspace_bond
  use halfspace_records, only: halfspace_balance
  implicit none
  private
  public :: bonded_world, halfspace_balance, halfspace_strength_report

  !> A world with bonds and dynamic relaxation; bolted_world extends it, and halfspace_world extends that.
  type, extends(block_world) :: bonded_world
  contains
    procedure :: bond_blocks
    procedure :: bond_materials
    procedure :: hold_bonds => keep_bonds
    procedure :: bonds
    procedure :: bond_events
    procedure :: bond_report
    procedure :: relax
    procedure :: balance => find_balance
    procedure :: set_gravity
    procedure :: set_damping
    procedure :: set_time_step
    procedure :: set_strength_factor
    procedure :: find_strength_factor
  end type bonded_world

  ! Bonds: halfspace_worlds_bonds.f90.
  interface

    !> Bonds two blocks of any kind along their common faces in their current positions: every pair of faces that is
    !! coplanar to rounding. HS_ERROR_STATE if they have no common face, are bonded already, or neither moves.
    module subroutine bond_blocks(self, block_a, block_b, bond, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block_a, block_b
      type(halfspace_bond), intent(in) :: bond
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_blocks

    !> Bonds all pairs of blocks of two materials along their common faces. Existing bonds do not change.
    module subroutine bond_materials(self, material_a, material_b, bond, count, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material_a, material_b  !< may be the same
      type(halfspace_bond), intent(in) :: bond
      integer(c_int64_t), intent(out), target, optional :: count  !< number of bonds made
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_materials

    !> Suspends (.true.) or resumes (.false.) the failure of all bonds, e.g. while a world settles.
    module subroutine keep_bonds(self, are_held, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      logical, intent(in) :: are_held
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine keep_bonds

    !> All bonds made so far, in their order of creation. `list` is reallocated only if their number has changed.
    module subroutine bonds(self, list, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_state), intent(inout), allocatable, target :: list(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bonds

    !> Failures of bond points so far, in order of time.
    module subroutine bond_events(self, list, first, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_event), intent(inout), allocatable, target :: list(:)
      integer(c_int64_t), intent(in), optional :: first  !< index of the first event, from 1; default 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_events

    !> Returns a summary of all bonds, as of the last step.
    module subroutine bond_report(self, values, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_report), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_report

  end interface

  ! Relaxation, changes of settings, and strength: halfspace_worlds_rest.f90.
  interface

    !> Steps the world under strong damping until static equilibrium, then sets all velocities to 0. Damping and the
    !! state of hold_bonds() are restored afterwards. The time of the relaxation has no physical meaning.
    module subroutine relax(self, at_rest, balance, ratio, measure, max_steps, local_damping, adaptive, hold_bonds, &
                            stat, errmsg)
      class(bonded_world), intent(inout) :: self
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
    end subroutine relax

    !> Returns the current balance of forces. It costs as much as a step.
    module subroutine find_balance(self, values, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      type(halfspace_balance), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine find_balance

    !> Sets gravity. The change of potential energy counts as external work.
    module subroutine set_gravity(self, gravity, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in) :: gravity(:)  !< m/s2, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_gravity

    !> Sets local and mass damping, see create().
    module subroutine set_damping(self, local_damping, mass_damping, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in), optional :: local_damping  !< [0, 1); default 0
      real(c_double), intent(in), optional :: mass_damping  !< 1/s, >= 0; default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_damping

    !> Sets the time step.
    module subroutine set_time_step(self, time_step, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in), optional :: time_step  !< s, > 0; default: safety times the stable time step
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_time_step

    !> Divides the given friction (tangent of its angle), cohesion and tensile strength of all laws and bonds by a
    !! factor. Calls do not accumulate.
    module subroutine set_strength_factor(self, factor, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in) :: factor  !< from 1e-75 to 1e75; 1 restores the given values, to rounding
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_strength_factor

    !> Computes the factor of safety by bisection. Each trial relaxes a copy of the world, with reduced strength, in
    !! which bonds can fail. The world, which should be in equilibrium, does not change.
    module subroutine find_strength_factor(self, report, low, high, resolution, ratio, max_displacement, max_steps, &
                                           fallen, stat, errmsg)
      class(bonded_world), intent(in) :: self
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
      class(bonded_world), intent(inout), optional :: fallen
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine find_strength_factor

  end interface

end module halfspace_bonded_worlds
