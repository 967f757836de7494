!> Blocks of a world in the plane, with a separate array for each component: x(:), y(:), angle(:); u(:), v(:), omega(:).
module halfspace_plane_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_loc
  use halfspace_c, only: hs_mutable_view, hs_view, hs_world_forces, hs_world_get_velocities, hs_world_set_velocities
  use halfspace_definitions, only: halfspace_angle, halfspace_pose
  use halfspace_errors, only: conclude, had_memory
  use halfspace_relaxed_worlds, only: relaxed_world
  use halfspace_views, only: are_of_one_size, components, mutable_components
  implicit none
  private
  public :: plane_world

  !> Contiguous arrays are read and written in place; the compiler copies sections. Arrays have the order of blocks().
  type, extends(relaxed_world) :: plane_world
  contains
    procedure, private :: poses_in_plane
    procedure, private :: set_poses_in_plane
    procedure, private :: velocities_in_plane
    procedure, private :: set_velocities_in_plane
    procedure, private :: forces_in_plane
    generic :: poses => poses_in_plane
    generic :: set_poses => set_poses_in_plane
    generic :: velocities => velocities_in_plane
    generic :: set_velocities => set_velocities_in_plane
    generic :: forces => forces_in_plane
  end type plane_world

contains

  !> Positions of all centroids, m, and rotations, rad, from -pi to pi.
  subroutine poses_in_plane(self, x, y, angle, stat, errmsg)
    class(plane_world), intent(in) :: self
    real(c_double), intent(inout) :: x(:), y(:)
    real(c_double), intent(inout), optional :: angle(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_pose), allocatable :: values(:)
    integer :: failure
    if (.not. are_of_one_size(x, y, angle, 'x, y and angle', stat, errmsg)) return
    allocate (values(size(x)), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    call self%poses(values, stat, errmsg)
    if (present(stat)) then
      if (stat < 0) return
    end if
    x = values%position(1)
    y = values%position(2)
    if (present(angle)) angle = halfspace_angle(values)
  end subroutine poses_in_plane

  !> Sets the positions of all centroids, and rotations. Without `angle`, no block is rotated.
  subroutine set_poses_in_plane(self, x, y, angle, stat, errmsg)
    class(plane_world), intent(inout) :: self
    real(c_double), intent(in) :: x(:), y(:)
    real(c_double), intent(in), optional :: angle(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_pose), allocatable :: values(:)
    integer :: failure, i
    if (.not. are_of_one_size(x, y, angle, 'x, y and angle', stat, errmsg)) return
    allocate (values(size(x)), stat=failure)
    if (.not. had_memory(failure, stat, errmsg)) return
    do i = 1, size(x)
      if (present(angle)) then
        values(i) = halfspace_pose(x(i), y(i), angle(i))
      else
        values(i) = halfspace_pose(x(i), y(i))
      end if
    end do
    call self%set_poses(values, stat, errmsg)
  end subroutine set_poses_in_plane

  !> Velocities of all centroids, m/s, and angular velocities, rad/s.
  subroutine velocities_in_plane(self, u, v, omega, stat, errmsg)
    class(plane_world), intent(in) :: self
    real(c_double), intent(inout), target, contiguous :: u(:), v(:)
    real(c_double), intent(inout), target, contiguous, optional :: omega(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_mutable_view) :: spins
    if (.not. are_of_one_size(u, v, omega, 'u, v and omega', stat, errmsg)) return
    if (present(omega)) spins = about_z(omega)
    call conclude(hs_world_get_velocities(self%c_handle(), mutable_components(u, v), spins), self%c_context(), stat, &
                  errmsg)
  end subroutine velocities_in_plane

  !> Sets the velocities of all blocks; entries of fixed blocks are ignored. Without `omega`, angular velocities stay.
  subroutine set_velocities_in_plane(self, u, v, omega, stat, errmsg)
    class(plane_world), intent(inout) :: self
    real(c_double), intent(in), target, contiguous :: u(:), v(:)
    real(c_double), intent(in), target, contiguous, optional :: omega(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_view) :: spins
    if (.not. are_of_one_size(u, v, omega, 'u, v and omega', stat, errmsg)) return
    if (present(omega)) then  ! only z is read
      spins = components(omega, omega)
      spins%z = c_loc(omega)
    end if
    call conclude(hs_world_set_velocities(self%c_handle(), components(u, v), spins), self%c_context(), stat, errmsg)
  end subroutine set_velocities_in_plane

  !> Stage: contact forces, as forces() with force(2,n).
  subroutine forces_in_plane(self, elapsed, fx, fy, torque, stat, errmsg)
    class(plane_world), intent(inout) :: self
    real(c_double), intent(in) :: elapsed  !< time since the last call, s, >= 0
    real(c_double), intent(inout), target, contiguous :: fx(:), fy(:)  !< on each block, N
    real(c_double), intent(inout), target, contiguous, optional :: torque(:)  !< about each centroid, N m
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hs_mutable_view) :: torques
    if (.not. are_of_one_size(fx, fy, torque, 'fx, fy and torque', stat, errmsg)) return
    if (present(torque)) torques = about_z(torque)
    call conclude(hs_world_forces(self%c_handle(), elapsed, mutable_components(fx, fy), torques), self%c_context(), &
                  stat, errmsg)
  end subroutine forces_in_plane

  !> Angular vectors of which only z is kept: it is written last, over x and y.
  type(hs_mutable_view) function about_z(values)
    real(c_double), intent(in), target, contiguous :: values(:)
    about_z = mutable_components(values, values)
    if (size(values) > 0) about_z%z = c_loc(values)
  end function about_z

end module halfspace_plane_worlds
