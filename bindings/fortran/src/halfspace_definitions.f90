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

  !> In 2D halfspace_pose(x, y) or halfspace_pose(x, y, angle), elemental; in 3D halfspace_pose(position, rotation) with
  !! a unit quaternion x, y, z, w.
  interface halfspace_pose
    module procedure pose_in_plane, pose_in_space
  end interface

  !> halfspace_law(normal_stiffness=1e8_c_double, friction_angle=...): missing arguments have the defaults of the
  !! library.
  interface halfspace_law
    module procedure law
  end interface

  !> halfspace_elasticity(young_modulus=1e10_c_double, poisson_ratio=...): likewise.
  interface halfspace_elasticity
    module procedure elasticity
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

  function law(normal_stiffness, shear_stiffness, friction_angle, cohesion, tensile_strength, normal_damping, &
               shear_damping, stiffness_kind, restitution)
    real(c_double), intent(in), optional :: normal_stiffness  !< N/m, Pa/m or Pa by stiffness_kind, > 0; default 1e9
    !> N/m or Pa/m (potentials: N/m), >= 0; default 0: as normal_stiffness
    real(c_double), intent(in), optional :: shear_stiffness
    real(c_double), intent(in), optional :: friction_angle  !< rad, [0, pi/2)
    real(c_double), intent(in), optional :: cohesion  !< Pa, >= 0
    real(c_double), intent(in), optional :: tensile_strength  !< Pa, >= 0
    real(c_double), intent(in), optional :: normal_damping  !< damping ratio, >= 0; default 0.1
    real(c_double), intent(in), optional :: shear_damping  !< damping ratio, >= 0; default 0.1
    !> an HS_STIFFNESS_ value; default HS_STIFFNESS_PER_CONTACT
    integer(c_int32_t), intent(in), optional :: stiffness_kind
    real(c_double), intent(in), optional :: restitution  !< of rigid blocks without springs, [0, 1]; default 0
    type(halfspace_law) :: law
    ! A law whose initialisation fails keeps size 0, and is refused on use.
    if (hs_law_def_init(law, c_sizeof(law)) /= HS_OK) return
    if (present(normal_stiffness)) law%normal_stiffness = normal_stiffness
    if (present(shear_stiffness)) law%shear_stiffness = shear_stiffness
    if (present(friction_angle)) law%friction_angle = friction_angle
    if (present(cohesion)) law%cohesion = cohesion
    if (present(tensile_strength)) law%tensile_strength = tensile_strength
    if (present(normal_damping)) law%normal_damping = normal_damping
    if (present(shear_damping)) law%shear_damping = shear_damping
    if (present(stiffness_kind)) law%stiffness_kind = stiffness_kind
    if (present(restitution)) law%restitution = restitution
  end function law

  function elasticity(young_modulus, poisson_ratio, damping_time, plane)
    real(c_double), intent(in), optional :: young_modulus  !< Pa, > 0
    real(c_double), intent(in), optional :: poisson_ratio  !< (-1, 0.5)
    !> s, >= 0; default 0: stiffness-proportional (Rayleigh) damping
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

  !> At time t the material point X (in the shape's frame) is at position + t velocity + R(t angular_velocity) Q
  !! (gradient + t gradient_rate) X, with position and rotation Q of `start`.
  function motion(start, velocity, angular_velocity, gradient, gradient_rate)
    type(halfspace_pose), intent(in), optional :: start  !< pose at time 0
    real(c_double), intent(in), optional :: velocity(3)  !< of the centroid, m/s
    real(c_double), intent(in), optional :: angular_velocity(3)  !< rad/s; times the duration at most 1e6 rad
    real(c_double), intent(in), optional :: gradient(3, 3)  !< deformation gradient at time 0; default identity
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
