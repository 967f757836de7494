!> Concave blocks: compounds of convex parts with one mass and one motion.
submodule(halfspace_worlds) halfspace_worlds_compounds
  use halfspace_contacts, only: id_of
  use halfspace_errors, only: conclude, refuse
  use halfspace_views, only: is_vector, three_of
  implicit none

contains

  module procedure add_compound
    type(hs_block_def) :: def
    type(c_ptr), target :: handles(size(shapes))
    type(hs_pose), target :: places(size(shapes))
    type(c_ptr) :: given
    integer(c_int64_t) :: id
    integer(c_int32_t) :: status
    integer :: i
    given = c_null_ptr
    if (present(poses)) then
      if (size(poses) /= size(shapes)) then
        call refuse('poses: must be as many as shapes', stat, errmsg)
        return
      end if
      do i = 1, size(shapes)
        places(i) = poses(i)
      end do
      given = c_loc(places)
    end if
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    end if
    do i = 1, size(shapes)
      handles(i) = shapes(i)%c_handle()
    end do
    status = hs_compound_def_init(def, c_sizeof(def), c_loc(handles), given, size(shapes, kind=c_int64_t))
    if (present(kind)) def%kind = kind
    if (present(material)) def%material = material - 1
    if (present(pose)) def%pose = pose
    if (present(velocity)) def%velocity = three_of(velocity)
    status = hs_world_add_compound(self%c_handle(), c_loc(handles), given, size(shapes, kind=c_int64_t), def, id)
    if (status == HS_OK .and. present(block)) block = transfer(id, block)
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure add_compound

  module procedure compound_parts
    integer(c_int64_t), target :: count
    type(halfspace_block), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    count = 0
    status = hs_world_get_compound_parts(self%c_handle(), id_of(block), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (found(count))
      status = hs_world_get_compound_parts(self%c_handle(), id_of(block), c_loc(found), count, c_null_ptr)
      call move_alloc(found, parts)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure compound_parts

  module procedure compound_of_block
    integer(c_int64_t) :: id
    integer(c_int32_t), target :: index
    integer(c_int32_t) :: status
    id = 0
    index = -1
    status = hs_world_get_compound_of_block(self%c_handle(), id_of(block), id, c_loc(index))
    compound = transfer(id, compound)
    part = index + 1
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure compound_of_block

end submodule halfspace_worlds_compounds
