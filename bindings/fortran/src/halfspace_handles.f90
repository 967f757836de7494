!> Owners of C objects. All copies of an owner name one object, which ends with the last of them; a context
!! ends after everything that was made from it, in whichever order the compiler finalizes.
module halfspace_handles
  use, intrinsic :: iso_c_binding, only: c_associated, c_intptr_t, c_loc, c_null_ptr, c_ptr
  use halfspace_c, only: hs_shape_destroy
  use halfspace_errors, only: had_memory
  implicit none
  private
  public :: shared_handle

  !> What the copies of an owner have in common.
  type :: object_record
    type(c_ptr) :: object = c_null_ptr
    integer :: references = 1
    procedure(hs_shape_destroy), pointer, nopass :: destroy => null()
    type(object_record), pointer :: context => null()  !< from which it was made; null() for a context
    class(*), pointer :: companion => null()  !< deallocated after the object
  end type object_record

  type :: shared_handle
    private
    type(object_record), pointer :: record => null()
    !> Where this handle was when it took its reference. Compilers copy some derived types bit by bit where
    !! the assignment below ought to be called (gfortran 12: handles inside of other types). Such a copy holds
    !! no reference, and knows it by its place.
    integer(c_intptr_t) :: home = 0
  contains
    procedure :: takes
    procedure :: drop
    procedure :: owns
    procedure :: object
    procedure :: lent_object
    procedure :: context
    procedure :: lent_context
    procedure, private :: share
    generic :: assignment(=) => share
    final :: finish
  end type shared_handle

contains

  !> Becomes the first owner of an object, and holds nothing if that is NULL. Without memory to keep account of it,
  !! the object and its companion are ended, and self stays what it was.
  logical function takes(self, object, destroy, origin, companion, stat, errmsg)
    class(shared_handle), intent(inout) :: self
    type(c_ptr), intent(in) :: object
    procedure(hs_shape_destroy) :: destroy
    type(shared_handle), intent(in), optional :: origin  !< the object's context, or another object made from it
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

  !> Holds nothing afterwards.
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

  !> The C object; NULL of a handle that owns none.
  type(c_ptr) function object(self)
    class(shared_handle), intent(in) :: self
    object = c_null_ptr
    if (owns(self)) object = self%record%object
  end function object

  !> Likewise, but also of copies that hold no reference, such as the elements of an array constructor: for
  !! use while the original is certain to be there.
  type(c_ptr) function lent_object(self)
    class(shared_handle), intent(in) :: self
    lent_object = c_null_ptr
    if (associated(self%record)) lent_object = self%record%object
  end function lent_object

  !> The C context from which the object was made, or which it is.
  type(c_ptr) function context(self)
    class(shared_handle), intent(in) :: self
    context = c_null_ptr
    if (owns(self)) context = self%lent_context()
  end function context

  !> Likewise, as for lent_object().
  type(c_ptr) function lent_context(self)
    class(shared_handle), intent(in) :: self
    lent_context = c_null_ptr
    if (.not. associated(self%record)) return
    lent_context = self%record%object
    if (associated(self%record%context)) lent_context = self%record%context%object
  end function lent_context

  impure elemental subroutine share(self, other)
    class(shared_handle), intent(inout) :: self
    class(shared_handle), intent(in) :: other
    type(object_record), pointer :: record
    record => other%record  ! both may be one handle, which drop() empties
    if (associated(record)) record%references = record%references + 1
    call self%drop()
    self%record => record
    if (associated(record)) self%home = place_of(self)
  end subroutine share

  impure elemental subroutine finish(self)
    type(shared_handle), intent(inout) :: self
    call self%drop()
  end subroutine finish

  !> Does it name an object?
  pure logical function owns(self)
    class(shared_handle), intent(in) :: self
    owns = associated(self%record) .and. self%home == place_of(self)
  end function owns

  pure integer(c_intptr_t) function place_of(self)
    class(shared_handle), intent(in), target :: self
    place_of = transfer(c_loc(self%home), place_of)
  end function place_of

end module halfspace_handles
