// halfspace/context.h

#include <cstring>

#include "capi/handles.h"
#include "catch.h"

namespace halfspace_test {
namespace {

void* allocate(std::size_t, std::size_t, void*) { return nullptr; }
void release(void*, std::size_t, std::size_t, void*) {}

hs_context_def default_def() {
  hs_context_def def;
  if (hs_context_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no defaults");
  return def;
}

}  // namespace

TEST_CASE("a context is refused without changing anything") {
  hs_context* const sentinel = reinterpret_cast<hs_context*>(0x10);
  hs_context* context = sentinel;
  CHECK(hs_context_create(nullptr, nullptr) == HS_ERROR_ARGUMENT);

  hs_context_def def = default_def();
  for (std::uint32_t size : {0u, 1u, 4u, 0xffffffffu}) {
    def.struct_size = size;
    CHECK(hs_context_create(&def, &context) == HS_ERROR_ARGUMENT);
  }
  def = default_def();
  def.allocate = allocate;
  CHECK(hs_context_create(&def, &context) == HS_ERROR_ARGUMENT);
  def = default_def();
  def.release = release;
  CHECK(hs_context_create(&def, &context) == HS_ERROR_ARGUMENT);
  def.allocate = allocate;  // and this one gives nothing
  CHECK(hs_context_create(&def, &context) == HS_ERROR_OUT_OF_MEMORY);
  CHECK(context == sentinel);
}

TEST_CASE("destroying nothing is legal") {
  hs_context_destroy(nullptr);
  hs_shape_destroy(nullptr);
  hs_world_destroy(nullptr);
}

TEST_CASE("the last error is empty at first, is kept by success, and exists without a context") {
  const Context context = make_context();
  CHECK(std::string(hs_context_last_error(context.get())).empty());
  CHECK(std::strlen(hs_context_last_error(nullptr)) > 0);
  CHECK(hs_polygon_check(context.get(), {}, nullptr) == HS_ERROR_ARGUMENT);
  const std::string text = hs_context_last_error(context.get());
  CHECK(text.find("hs_polygon_check") == 0);
  CHECK(text.find("fault") != std::string::npos);
  hs_fault fault;
  CHECK(hs_polygon_check(context.get(), {}, &fault) == HS_OK);
  CHECK(text == hs_context_last_error(context.get()));
}

TEST_CASE("contexts do not share their errors") {
  const Context one = make_context(), other = make_context();
  CHECK(hs_polygon_check(one.get(), {}, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(std::string(hs_context_last_error(other.get())).empty());
}

}  // namespace halfspace_test
