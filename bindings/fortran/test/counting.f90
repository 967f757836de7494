!> An allocator that counts requests, and refuses a given one.
module counting
  use, intrinsic :: iso_c_binding, only: c_associated, c_null_ptr, c_ptr, c_size_t
  use halfspace, only: halfspace_allocator
  implicit none

  type, extends(halfspace_allocator) :: counting_allocator
    integer :: requests = 0
    integer :: living = 0
    integer(c_size_t) :: bytes = 0
    integer :: most_requests = huge(0)
  contains
    procedure :: allocate => allocate_counted
    procedure :: release => release_counted
  end type counting_allocator

  !> Requests of allocate statements, which the linker redirects here. Smaller ones are the compiler's: gfortran 12
  !! allocates up to 16 bytes to finalize, and does not check the result.
  integer(c_size_t), parameter :: least_bytes = 24
  integer :: statements = 0
  integer :: refused_statement = 0  !< the request that fails

  interface
    function real_malloc(bytes) bind(c, name='__real_malloc')
      import
      integer(c_size_t), value :: bytes
      type(c_ptr) :: real_malloc
    end function real_malloc

    function aligned_alloc(alignment, size) bind(c)
      import
      integer(c_size_t), value :: alignment, size
      type(c_ptr) :: aligned_alloc
    end function aligned_alloc

    subroutine free(memory) bind(c)
      import
      type(c_ptr), value :: memory
    end subroutine free
  end interface

contains

  function wrapped_malloc(bytes) bind(c, name='__wrap_malloc') result(memory)
    integer(c_size_t), value :: bytes
    type(c_ptr) :: memory
    if (bytes >= least_bytes) statements = statements + 1
    if (bytes >= least_bytes .and. statements == refused_statement) then
      memory = c_null_ptr
    else
      memory = real_malloc(bytes)
    end if
  end function wrapped_malloc

  type(c_ptr) function allocate_counted(self, bytes, alignment) result(memory)
    class(counting_allocator), intent(inout) :: self
    integer(c_size_t), intent(in) :: bytes, alignment
    memory = c_null_ptr
    self%requests = self%requests + 1
    if (self%requests > self%most_requests) return
    memory = aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
    if (.not. c_associated(memory)) return
    self%living = self%living + 1
    self%bytes = self%bytes + bytes
  end function allocate_counted

  subroutine release_counted(self, memory, bytes, alignment)
    class(counting_allocator), intent(inout) :: self
    type(c_ptr), intent(in) :: memory
    integer(c_size_t), intent(in) :: bytes, alignment
    if (alignment < 1) error stop 'alignment'
    call free(memory)
    self%living = self%living - 1
    self%bytes = self%bytes - bytes
  end subroutine release_counted

end module counting
