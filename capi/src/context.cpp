#include <cstdlib>
#include <system_error>

#include "arithmetic.h"
#include "context_handle.h"
#include "guard.h"
#include "require.h"
#include "sized_struct.h"
#include "threads/thread_pool.h"

using namespace halfspace::capi;

namespace halfspace::capi {
namespace {

constexpr int max_threads = 256;

}  // namespace

template <>
hs_context_def default_definition() {
  hs_context_def def{};
  def.threads = 1;
  return def;
}

std::unique_ptr<Threads> threads_of(const hs_context_def& def) {
  if (def.threads == 1) return nullptr;
  if (def.run_tasks) return std::make_unique<HostThreads>(def);
  try {
    return std::make_unique<ThreadPool>(def.threads);
  } catch (const std::system_error&) {  // no more threads
    throw std::bad_alloc();
  }
}

namespace {

// Windows frees aligned memory by a function of its own.
void* allocate_by_system(std::size_t bytes, std::size_t alignment) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes);
#ifdef _WIN32
  return _aligned_malloc(bytes, alignment);
#else
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
#endif
}
void free_by_system(void* memory, [[maybe_unused]] std::size_t alignment) {
#ifdef _WIN32
  if (alignment > alignof(std::max_align_t)) return _aligned_free(memory);
#endif
  std::free(memory);
}

}  // namespace

void* HostMemory::do_allocate(std::size_t bytes, std::size_t alignment) {
  void* memory =
      def_.allocate ? def_.allocate(bytes, alignment, def_.user) : allocate_by_system(bytes, alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}

void HostMemory::do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) {
  if (def_.release) {
    def_.release(memory, bytes, alignment, def_.user);
  } else {
    free_by_system(memory, alignment);
  }
}

}  // namespace halfspace::capi

const char* hs_status_string(hs_status status) {
  switch (status) {
#define HS_STATUS_CASE(name, value, text) \
  case name:                              \
    return text;
    HS_STATUS_LIST(HS_STATUS_CASE)
#undef HS_STATUS_CASE
    default:
      return "unknown status";
  }
}

const char* hs_version(void) { return HALFSPACE_VERSION; }

hs_status hs_context_def_init(hs_context_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_context_create(const hs_context_def* def, hs_context** context) {
  return guarded(nullptr, __func__, [&] {
    require_pointer(context, "context");
    const hs_context_def known = def ? read_definition(def, "def") : default_definition<hs_context_def>();
    if (!known.allocate != !known.release)
      refuse(HS_ERROR_ARGUMENT, "def.allocate or def.release is NULL; set both or neither");
    require(known.threads >= 1 && known.threads <= max_threads, known.threads, "threads", "from 1 to 256");
    HostMemory memory(known);
    *context = create_in<hs_context>(memory, known);
    return HS_OK;
  });
}

void hs_task_run(hs_task* task, std::int32_t index) {
  if (!task) return;
  const DefaultArithmetic here;
  task->work(task->data, index);
}

void hs_context_destroy(hs_context* context) {
  if (!context) return;
  HostMemory memory = context->memory;
  destroy_in(memory, context);
}

const char* hs_context_last_error(const hs_context* context) {
  return context ? context->last_error.read() : "no context: the context or a handle was NULL";
}
