!> Poses and motions: the structs of the C interface, with constructors.
module halfspace_definitions
  use, intrinsic :: iso_c_binding, only: c_double, c_sizeof
  use halfspace_c, only: hs_motion_def_init, HS_OK, halfspace_motion => hs_motion_def, halfspace_pose => hs_pose
  use halfspace_deformations, only: nine_of
  implicit none
  private
  public :: halfspace_motion, halfspace_pose, halfspace_angle

  !> In 2D halfspace_pose(x, y) or halfspace_pose(x, y, angle), elemental; in 3D halfspace_pose(position, rotation) with
  !! a unit quaternion x, y, z, w.
  interface halfspace_pose
    module procedure pose_in_plane, pose_in_space
  end interface

  !> halfspace_motion(start=..., velocity=...): the default is at rest at the origin, without rotation.
  interface halfspace_motion
    module procedure motion
  end interface

contains

  elemental function pose_in_plane(x, y, angle) result(pose)
    real(c_double), intent(in) :: x, y  !< of the centroid
    real(c_double), intent(in), optional :: angle  !< rotation about z, rad
    type(halfspace_pose) :: pose
    pose%position = [x, y, 0.0_c_double]
    pose%rotation = [0.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double]
    if (present(angle)) pose%rotation(3:4) = [sin(angle / 2), cos(angle / 2)]
  end function pose_in_plane

  pure function pose_in_space(position, rotation) result(pose)
    real(c_double), intent(in) :: position(3)  !< of the centroid
    real(c_double), intent(in) :: rotation(4)  !< unit quaternion x, y, z, w
    type(halfspace_pose) :: pose
    pose%position = position
    pose%rotation = rotation
  end function pose_in_space

  !> Rotation angle of a pose in 2D, rad, from -pi to pi.
  elemental real(c_double) function halfspace_angle(pose) result(angle)
    type(halfspace_pose), intent(in) :: pose
    real(c_double) :: z, w
    z = pose%rotation(3)
    w = pose%rotation(4)
    angle = 2 * atan2(sign(1.0_c_double, w) * z, abs(w))
  end function halfspace_angle

  !> At time t the material point X (in the shape's frame) is at position + t velocity + R(t angular_velocity) Q
  !! (gradient + t gradient_rate) X, with position and rotation Q of `start`.
  function motion(start, velocity, angular_velocity, gradient, gradient_rate)
    type(halfspace_pose), intent(in), optional :: start  !< pose at time 0
    real(c_double), intent(in), optional :: velocity(3)  !< of the centroid, m/s
    real(c_double), intent(in), optional :: angular_velocity(3)  !< rad/s; times the duration at most 1e6 rad
    real(c_double), intent(in), optional :: gradient(3, 3)  !< deformation gradient at time 0; default identity
    real(c_double), intent(in), optional :: gradient_rate(3, 3)  !< 1/s
    type(halfspace_motion) :: motion
    ! If its initialisation fails it keeps size 0, and is refused on use.
    if (hs_motion_def_init(motion, c_sizeof(motion)) /= HS_OK) return
    if (present(start)) motion%start = start
    if (present(velocity)) motion%velocity = velocity
    if (present(angular_velocity)) motion%angular_velocity = angular_velocity
    if (present(gradient)) motion%gradient = nine_of(gradient)
    if (present(gradient_rate)) motion%gradient_rate = nine_of(gradient_rate)
  end function motion

end module halfspace_definitions
