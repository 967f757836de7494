!> The context: allocator, threads and text of the last error. Shapes, meshes and worlds without a given context make
!! their own.
module halfspace_contexts
  use, intrinsic :: iso_c_binding, only: c_f_pointer, c_funloc, c_int32_t, c_loc, c_ptr, c_size_t, c_sizeof
  use halfspace_c
  use halfspace_errors, only: conclude, had_memory, refuse, text_at
  use halfspace_handles, only: shared_handle
  implicit none
  private
  public :: halfspace_allocator, halfspace_context, halfspace_version, own_or_given

  !> Allocator of a context. Extend it, and pass a target to create() of halfspace_context; it must outlive the context
  !! and everything made from it. Its procedures must not call the library.
  type, abstract :: halfspace_allocator
  contains
    procedure(allocate_memory), deferred :: allocate
    procedure(release_memory), deferred :: release
  end type halfspace_allocator

  abstract interface
    !> Returns memory aligned to `alignment` bytes, or c_null_ptr if there is none.
    type(c_ptr) function allocate_memory(self, bytes, alignment)
      import :: c_ptr, c_size_t, halfspace_allocator
      class(halfspace_allocator), intent(inout) :: self
      integer(c_size_t), intent(in) :: bytes, alignment
    end function allocate_memory

    !> Releases memory of allocate(), with the same sizes.
    subroutine release_memory(self, memory, bytes, alignment)
      import :: c_ptr, c_size_t, halfspace_allocator
      class(halfspace_allocator), intent(inout) :: self
      type(c_ptr), intent(in) :: memory
      integer(c_size_t), intent(in) :: bytes, alignment
    end subroutine release_memory
  end interface

  !> Everything made from one context must be used by one thread at a time; different contexts share nothing. Assignment
  !! adds a reference: all copies are the same context, which is destroyed with the last reference to it and to objects
  !! made from it.
  type :: halfspace_context
    private
    type(shared_handle) :: handle
  contains
    procedure :: create
    procedure :: destroy
    procedure :: last_error
    procedure :: c_handle
    procedure, private :: share
    generic :: assignment(=) => share
  end type halfspace_context

  !> The user pointer of the two procedures below.
  type :: allocator_link
    class(halfspace_allocator), pointer :: allocator => null()
  end type allocator_link

contains

  !> Creates a context; the previous reference is dropped.
  subroutine create(self, allocator, stat, errmsg, threads)
    class(halfspace_context), intent(inout) :: self
    class(halfspace_allocator), intent(inout), target, optional :: allocator  !< default: the C library's
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer, intent(in), optional :: threads  !< threads that step a world, 1 to 256; default 1
    type(allocator_link), pointer :: link
    type(hs_context_def), target :: def
    type(c_ptr) :: object
    class(*), pointer :: companion
    integer(c_int32_t) :: status
    integer :: failure
    nullify (companion)
    status = hs_context_def_init(def, c_sizeof(def))
    if (present(threads)) def%threads = int(threads, c_int32_t)
    if (present(allocator)) then
      allocate (link, stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      link%allocator => allocator
      companion => link
      def%allocate = c_funloc(allocate_through)
      def%release = c_funloc(release_through)
      def%user = c_loc(link)
    end if
    status = hs_context_create(c_loc(def), object)
    if (status == HS_OK) then
      if (.not. self%handle%takes(object, hs_context_destroy, companion=companion, stat=stat, errmsg=errmsg)) return
      call conclude(status, self%handle%context(), stat, errmsg)
    else
      if (associated(companion)) deallocate (companion)
      call refuse('hs_context_create: '//text_at(hs_status_string(status)), stat, errmsg, status)
    end if
  end subroutine create

  function allocate_through(bytes, alignment, user) bind(c, name='') result(memory)
    integer(c_size_t), value :: bytes, alignment
    type(c_ptr), value :: user
    type(c_ptr) :: memory
    type(allocator_link), pointer :: link
    call c_f_pointer(user, link)
    memory = link%allocator%allocate(bytes, alignment)
  end function allocate_through

  subroutine release_through(memory, bytes, alignment, user) bind(c, name='')
    type(c_ptr), value :: memory
    integer(c_size_t), value :: bytes, alignment
    type(c_ptr), value :: user
    type(allocator_link), pointer :: link
    call c_f_pointer(user, link)
    call link%allocator%release(memory, bytes, alignment)
  end subroutine release_through

  !> Drops this reference before the end of its scope.
  impure elemental subroutine destroy(self)
    class(halfspace_context), intent(inout) :: self
    call self%handle%drop()
  end subroutine destroy

  !> Returns the text of the last error of this context; empty if no call has failed.
  function last_error(self) result(text)
    class(halfspace_context), intent(in) :: self
    character(:), allocatable :: text
    text = text_at(hs_context_last_error(self%handle%object()))
  end function last_error

  !> For calls of halfspace_c; the object stays the owner.
  type(c_ptr) function c_handle(self)
    class(halfspace_context), intent(in) :: self
    c_handle = self%handle%object()
  end function c_handle

  impure elemental subroutine share(self, other)
    class(halfspace_context), intent(inout) :: self
    class(halfspace_context), intent(in) :: other
    self%handle = other%handle
  end subroutine share

  !> Returns the given context, or a new one; .true. on success.
  logical function own_or_given(context, handle, stat, errmsg)
    type(halfspace_context), intent(in), optional :: context
    type(shared_handle), intent(inout) :: handle
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_context) :: own
    integer :: status
    own_or_given = .true.
    if (present(context)) then
      handle = context%handle
    else if (present(stat)) then
      call own%create(stat=status, errmsg=errmsg)
      own_or_given = status == HS_OK
      if (.not. own_or_given) stat = status
      handle = own%handle
    else
      call own%create()
      handle = own%handle
    end if
  end function own_or_given

  !> Version of the library at run time, e.g. '0.1.0'.
  function halfspace_version() result(version)
    character(:), allocatable :: version
    version = text_at(hs_version())
  end function halfspace_version

end module halfspace_contexts
