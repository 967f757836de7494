!> Reference-counted owners of C objects. The last copy of an owner destroys the object; a context is destroyed after
!! everything made from it, whatever the order of finalization.
module halfspace_handles
  use, intrinsic :: iso_c_binding, only: c_associated, c_intptr_t, c_loc, c_null_ptr, c_ptr
  use halfspace_c, only: hs_shape_destroy
  use halfspace_errors, only: had_memory
  implicit none
  private
  public :: shared_handle

  !> Common data of the copies of an owner.
  type :: object_record
    type(c_ptr) :: object = c_null_ptr
    integer :: references = 1
    procedure(hs_shape_destroy), pointer, nopass :: destroy => null()
    type(object_record), pointer :: context => null()  !< context of the object; null() for a context
    class(*), pointer :: companion => null()  !< deallocated after the object
    integer :: row_length = 0  !< of the loads of a share; 0: to be found
  end type object_record

  type :: shared_handle
    private
    type(object_record), pointer :: record => null()
    !> Address of this handle when it took its reference. Compilers make bitwise copies of some derived types instead of
    !! calling the assignment below (gfortran 12: handles inside other types). Such a copy holds no reference; its
    !! address differs.
    integer(c_intptr_t) :: home = 0
  contains
    procedure :: takes
    procedure :: drop
    procedure :: owns
    procedure :: object
    procedure :: lent_object
    procedure :: context
    procedure :: lent_context
    procedure :: row_length
    procedure :: remember_row_length
    procedure, private :: share
    generic :: assignment(=) => share
    final :: finish
  end type shared_handle

contains

  !> Becomes the first owner of an object; none if it is NULL. Without memory for the record, the object and its
  !! companion are destroyed, and self does not change.
  logical function takes(self, object, destroy, origin, companion, stat, errmsg)
    class(shared_handle), intent(inout) :: self
    type(c_ptr), intent(in) :: object
    procedure(hs_shape_destroy) :: destroy
    type(shared_handle), intent(in), optional :: origin  !< context of the object, or another object made from it
    class(*), pointer, intent(in), optional :: companion
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(object_record), pointer :: record
    class(*), pointer :: unwanted
    integer :: failure
    takes = .true.
    if (.not. c_associated(object)) then
      call self%drop()
      return
    end if
    allocate (record, stat=failure)
    if (failure /= 0) then
      call destroy(object)
      nullify (unwanted)
      if (present(companion)) unwanted => companion
      if (associated(unwanted)) deallocate (unwanted)
      takes = had_memory(failure, stat, errmsg)
      return
    end if
    record%object = object
    record%destroy => destroy
    if (present(companion)) record%companion => companion
    if (present(origin)) then
      record%context => origin%record
      if (associated(origin%record%context)) record%context => origin%record%context
      record%context%references = record%context%references + 1
    end if
    call self%drop()
    self%record => record
    self%home = place_of(self)
  end function takes

  !> Drops the reference.
  impure elemental subroutine drop(self)
    class(shared_handle), intent(inout) :: self
    if (owns(self)) call drop_record(self%record)
    nullify (self%record)
    self%home = 0
  end subroutine drop

  recursive subroutine drop_record(record)
    type(object_record), pointer, intent(in) :: record
    type(object_record), pointer :: last, context
    record%references = record%references - 1
    if (record%references > 0) return
    last => record
    context => record%context
    call last%destroy(last%object)
    if (associated(last%companion)) deallocate (last%companion)
    deallocate (last)
    if (associated(context)) call drop_record(context)
  end subroutine drop_record

  !> The C object; NULL if the handle owns none.
  type(c_ptr) function object(self)
    class(shared_handle), intent(in) :: self
    object = c_null_ptr
    if (owns(self)) object = self%record%object
  end function object

  !> Likewise, but also for copies without a reference, such as elements of an array constructor; valid only while the
  !! original exists.
  type(c_ptr) function lent_object(self)
    class(shared_handle), intent(in) :: self
    lent_object = c_null_ptr
    if (associated(self%record)) lent_object = self%record%object
  end function lent_object

  !> The C context of the object, or the object if it is a context.
  type(c_ptr) function context(self)
    class(shared_handle), intent(in) :: self
    context = c_null_ptr
    if (owns(self)) context = self%lent_context()
  end function context

  !> Likewise, also for copies without a reference.
  type(c_ptr) function lent_context(self)
    class(shared_handle), intent(in) :: self
    lent_context = c_null_ptr
    if (.not. associated(self%record)) return
    lent_context = self%record%object
    if (associated(self%record%context)) lent_context = self%record%context%object
  end function lent_context

  !> Length of a row of a share's loads, which its owner has remembered for all copies; 0: none.
  integer function row_length(self)
    class(shared_handle), intent(in) :: self
    row_length = 0
    if (owns(self)) row_length = self%record%row_length
  end function row_length

  subroutine remember_row_length(self, length)
    class(shared_handle), intent(in) :: self
    integer, intent(in) :: length
    if (owns(self)) self%record%row_length = length
  end subroutine remember_row_length

  impure elemental subroutine share(self, other)
    class(shared_handle), intent(inout) :: self
    class(shared_handle), intent(in) :: other
    type(object_record), pointer :: record
    record => other%record  ! self and other may be the same handle, which drop() empties
    if (associated(record)) record%references = record%references + 1
    call self%drop()
    self%record => record
    if (associated(record)) self%home = place_of(self)
  end subroutine share

  impure elemental subroutine finish(self)
    type(shared_handle), intent(inout) :: self
    call self%drop()
  end subroutine finish

  !> Does the handle own an object?
  pure logical function owns(self)
    class(shared_handle), intent(in) :: self
    owns = associated(self%record) .and. self%home == place_of(self)
  end function owns

  pure integer(c_intptr_t) function place_of(self)
    class(shared_handle), intent(in), target :: self
    place_of = transfer(c_loc(self%home), place_of)
  end function place_of

end module halfspace_handles
