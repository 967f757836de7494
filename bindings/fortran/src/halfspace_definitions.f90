!> Poses, motions, contact laws and elasticities: the structs of the C interface, with constructors.
module halfspace_definitions
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_sizeof
  use halfspace_c, only: hs_elasticity_def_init, hs_law_def_init, hs_motion_def_init, HS_OK, &
    halfspace_elasticity => hs_elasticity_def, halfspace_motion => hs_motion_def, &
    halfspace_law => hs_law_def, halfspace_pose => hs_pose
  use halfspace_deformations, only: nine_of
  implicit none
  private
  public :: halfspace_elasticity, halfspace_law, halfspace_motion, halfspace_pose, halfspace_angle

  !> In the plane, halfspace_pose(x, y) or halfspace_pose(x, y, angle), the latter also of arrays; in space,
  !! halfspace_pose(position, rotation) with a unit quaternion x, y, z, w.
  interface halfspace_pose
    module procedure pose_in_plane, pose_in_space
  end interface

  !> halfspace_law(normal_stiffness=1e8_c_double, friction_angle=...): what is not given is the library's default.
  interface halfspace_law
    module procedure law
  end interface

  !> halfspace_elasticity(young_modulus=1e10_c_double, poisson_ratio=...): likewise.
  interface halfspace_elasticity
    module procedure elasticity
  end interface

  !> halfspace_motion(start=..., velocity=...): what is not given is at the origin, not turned, at rest.
  interface halfspace_motion
    module procedure motion
  end interface

contains

  elemental function pose_in_plane(x, y, angle) result(pose)
    real(c_double), intent(in) :: x, y  !< of the centroid
    real(c_double), intent(in), optional :: angle  !< turned about z, rad
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

  !> How far a pose in the plane is turned, rad, from -pi to pi.
  elemental real(c_double) function halfspace_angle(pose) result(angle)
    type(halfspace_pose), intent(in) :: pose
    real(c_double) :: z, w
    z = pose%rotation(3)
    w = pose%rotation(4)
    angle = 2 * atan2(sign(1.0_c_double, w) * z, abs(w))
  end function halfspace_angle

  function law(normal_stiffness, shear_stiffness, friction_angle, cohesion, tensile_strength, normal_damping, &
               shear_damping, stiffness_kind)
    real(c_double), intent(in), optional :: normal_stiffness  !< > 0; N/m, Pa/m or Pa
    real(c_double), intent(in), optional :: shear_stiffness  !< >= 0; N/m or Pa/m, of potentials N/m; 0: the normal one
    real(c_double), intent(in), optional :: friction_angle  !< rad, [0, pi/2)
    real(c_double), intent(in), optional :: cohesion  !< Pa, >= 0
    real(c_double), intent(in), optional :: tensile_strength  !< Pa, >= 0
    real(c_double), intent(in), optional :: normal_damping  !< share of critical viscous damping, >= 0
    real(c_double), intent(in), optional :: shear_damping  !< share of critical viscous damping, >= 0
    !> HS_STIFFNESS_PER_CONTACT, _PER_AREA, _POTENTIAL or _NONE
    integer(c_int32_t), intent(in), optional :: stiffness_kind
    type(halfspace_law) :: law
    ! A law that could not be filled keeps size 0, and is refused where it is used.
    if (hs_law_def_init(law, c_sizeof(law)) /= HS_OK) return
    if (present(normal_stiffness)) law%normal_stiffness = normal_stiffness
    if (present(shear_stiffness)) law%shear_stiffness = shear_stiffness
    if (present(friction_angle)) law%friction_angle = friction_angle
    if (present(cohesion)) law%cohesion = cohesion
    if (present(tensile_strength)) law%tensile_strength = tensile_strength
    if (present(normal_damping)) law%normal_damping = normal_damping
    if (present(shear_damping)) law%shear_damping = shear_damping
    if (present(stiffness_kind)) law%stiffness_kind = stiffness_kind
  end function law

  function elasticity(young_modulus, poisson_ratio, damping_time, plane)
    real(c_double), intent(in), optional :: young_modulus  !< Pa, > 0
    real(c_double), intent(in), optional :: poisson_ratio  !< (-1, 0.5)
    !> s, >= 0: of viscous stress to that by strain (Rayleigh's beta)
    real(c_double), intent(in), optional :: damping_time
    integer(c_int32_t), intent(in), optional :: plane  !< HS_PLANE_STRAIN or, in 2D, HS_PLANE_STRESS
    type(halfspace_elasticity) :: elasticity
    ! As for a law.
    if (hs_elasticity_def_init(elasticity, c_sizeof(elasticity)) /= HS_OK) return
    if (present(young_modulus)) elasticity%young_modulus = young_modulus
    if (present(poisson_ratio)) elasticity%poisson_ratio = poisson_ratio
    if (present(damping_time)) elasticity%damping_time = damping_time
    if (present(plane)) elasticity%plane = plane
  end function elasticity

  !> At time t the point at X in the shape's frame is at position + t velocity + R(t angular_velocity) Q (gradient +
  !! t gradient_rate) X, with position and Q those of the start.
  function motion(start, velocity, angular_velocity, gradient, gradient_rate)
    type(halfspace_pose), intent(in), optional :: start  !< where it is at first
    real(c_double), intent(in), optional :: velocity(3)  !< of the centroid, m/s
    real(c_double), intent(in), optional :: angular_velocity(3)  !< rad/s; up to 1e6 rad in the duration
    real(c_double), intent(in), optional :: gradient(3, 3)  !< how it is strained at first, before the start turns it
    real(c_double), intent(in), optional :: gradient_rate(3, 3)  !< 1/s
    type(halfspace_motion) :: motion
    ! As for a law.
    if (hs_motion_def_init(motion, c_sizeof(motion)) /= HS_OK) return
    if (present(start)) motion%start = start
    if (present(velocity)) motion%velocity = velocity
    if (present(angular_velocity)) motion%angular_velocity = angular_velocity
    if (present(gradient)) motion%gradient = nine_of(gradient)
    if (present(gradient_rate)) motion%gradient_rate = nine_of(gradient_rate)
  end function motion

end module halfspace_definitions
