!> The bonds of a world, its rest, and the factor by which it could be weaker.
module halfspace_bonded_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
  use halfspace_c, halfspace_strength_report => hs_strength_report
  use halfspace_block_worlds, only: block_world, takes_world
  use halfspace_bonds, only: halfspace_bond, halfspace_bond_event, halfspace_bond_report, halfspace_bond_state
  use halfspace_contacts, only: halfspace_block
  implicit none
  private
  public :: bonded_world, halfspace_balance, halfspace_strength_report

  !> hs_balance byte for byte: the distance of forces from balance.
  type, bind(c) :: halfspace_balance
    !> unbalanced over all forces, see HS_UNBALANCED_MEAN; 0 where no force acts
    real(c_double) :: mean = 0
    real(c_double) :: largest = 0  !< see HS_UNBALANCED_LARGEST
    real(c_double) :: largest_force = 0  !< that is unbalanced, N
    integer(c_int64_t) :: steps = 0  !< that relax() has taken; else 0
    !> the block that largest_force acts on, of a node a cell at the surface; default: there is none
    type(halfspace_block) :: largest_force_block
  end type halfspace_balance

  !> A world whose blocks can hold together, and that can come to rest; halfspace_world extends it.
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

    !> Bonds two blocks of any kind along their largest common face, as they are now: both faces lie in one plane but
    !! for rounding. HS_ERROR_STATE says that they have no common face, hold together already, or that neither moves.
    module subroutine bond_blocks(self, block_a, block_b, bond, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      type(halfspace_block), intent(in) :: block_a, block_b
      type(halfspace_bond), intent(in) :: bond
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_blocks

    !> Bonds all pairs of blocks of two materials along their common faces; what holds together already stays as it is.
    module subroutine bond_materials(self, material_a, material_b, bond, count, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material_a, material_b  !< may be the same
      type(halfspace_bond), intent(in) :: bond
      integer(c_int64_t), intent(out), target, optional :: count  !< number of bonds made
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_materials

    !> Holds all bonds, which then never fail, while a world comes to rest; or lets them fail again.
    module subroutine keep_bonds(self, are_held, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      logical, intent(in) :: are_held
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine keep_bonds

    !> All bonds made so far, in their order. Memory is allocated only when their number has changed.
    module subroutine bonds(self, list, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_state), intent(inout), allocatable, target :: list(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bonds

    !> The points that have failed so far, in order of time.
    module subroutine bond_events(self, list, first, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_event), intent(inout), allocatable, target :: list(:)
      integer(c_int64_t), intent(in), optional :: first  !< the first one wanted, counted from 1; default 1
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_events

    !> The bonds in numbers, as of the last step.
    module subroutine bond_report(self, values, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_bond_report), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_report

  end interface

  ! Rest, changes while a world lives, and strength: halfspace_worlds_rest.f90.
  interface

    !> Steps the world under strong damping until no force is left unbalanced. Its own damping, and whether bonds are
    !! held, come back afterwards; velocities are set to 0. Time passes, but means nothing.
    module subroutine relax(self, at_rest, balance, ratio, measure, max_steps, local_damping, adaptive, hold_bonds, &
                            stat, errmsg)
      class(bonded_world), intent(inout) :: self
      !> whether it has come to rest within max_steps; without this, it is the note HS_NOTE_NOT_AT_REST that it has not
      logical, intent(out), optional :: at_rest
      type(halfspace_balance), intent(out), optional :: balance  !< forces that are unbalanced then, and steps
      real(c_double), intent(in), optional :: ratio  !< unbalanced forces at which it is at rest, > 0; default 1e-5
      !> HS_UNBALANCED_MEAN (default): their share of all forces; or HS_UNBALANCED_LARGEST: of a single block or node
      integer(c_int32_t), intent(in), optional :: measure
      integer, intent(in), optional :: max_steps  !< >= 1; default 1000000
      !> [0, 1) meanwhile; default 0.1, beside adaptive damping; by itself 0.8 does best
      real(c_double), intent(in), optional :: local_damping
      !> default .true.: mass damping twice as fast as the slowest motion that is left swings; otherwise the world's
      logical, intent(in), optional :: adaptive
      logical, intent(in), optional :: hold_bonds  !< default .true.: bonds do not fail meanwhile
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine relax

    !> Forces that are unbalanced now. To measure them takes as long as a step.
    module subroutine find_balance(self, values, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      type(halfspace_balance), intent(out) :: values
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine find_balance

    !> Sets gravity from now on; what that changes of the energy is booked as outer work.
    module subroutine set_gravity(self, gravity, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in) :: gravity(:)  !< m/s2, 3 values (2D: or 2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_gravity

    !> Sets damping from now on, see create().
    module subroutine set_damping(self, local_damping, mass_damping, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in), optional :: local_damping  !< [0, 1); default 0
      real(c_double), intent(in), optional :: mass_damping  !< 1/s, >= 0; default 0
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_damping

    !> Sets the time step from now on.
    module subroutine set_time_step(self, time_step, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in), optional :: time_step  !< > 0, s; default: safety times the stable one
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_time_step

    !> Divides friction (its tangent), cohesion and tensile strength of all laws and bonds, as they were given, by a
    !! factor, from now on.
    module subroutine set_strength_factor(self, factor, stat, errmsg)
      class(bonded_world), intent(inout) :: self
      real(c_double), intent(in) :: factor  !< from 1e-75 to 1e75; 1 gives them back but for rounding
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_strength_factor

    !> Looks for the factor of safety by bisection: how many times weaker all materials could be until something moves.
    !! Each trial relaxes a copy of the world with bonds that may fail. The world stays as it is, and should be at rest.
    module subroutine find_strength_factor(self, report, low, high, resolution, ratio, max_displacement, max_steps, &
                                           fallen, stat, errmsg)
      class(bonded_world), intent(in) :: self
      type(halfspace_strength_report), intent(out) :: report  !< the factor, its bracket, and trials
      real(c_double), intent(in), optional :: low  !< a factor at which it should stand, >= 1e-75; default 0.5
      real(c_double), intent(in), optional :: high  !< a factor at which it should fall, > low; default 5
      real(c_double), intent(in), optional :: resolution  !< the bracket that is narrow enough, > 0; default 0.005
      real(c_double), intent(in), optional :: ratio  !< unbalanced forces at which it stands, > 0; default 1e-5
      !> share of its size by which a block that moves has fallen, > 0; default 0.1
      real(c_double), intent(in), optional :: max_displacement
      !> steps after which a world that is not at rest falls as well, >= 1; default 100000
      integer, intent(in), optional :: max_steps
      !> becomes the copy that fell last, as it was then, or no world where none did: velocities and bond events show
      !! how
      class(bonded_world), intent(inout), optional :: fallen
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine find_strength_factor

  end interface

end module halfspace_bonded_worlds
