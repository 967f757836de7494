// halfspace/status.h

#include <cstring>
#include <set>
#include <string>

#include "capi/handles.h"
#include "catch.h"

TEST_CASE("every status has a text of its own, and unknown ones have one too") {
  std::set<std::string> texts;
  int count = 0;
#define CHECK_STATUS(name, value, text)               \
  CHECK(name == value);                               \
  CHECK(std::string(hs_status_string(name)) == text); \
  texts.insert(hs_status_string(name));               \
  ++count;
  HS_STATUS_LIST(CHECK_STATUS)
#undef CHECK_STATUS
  CHECK(int(texts.size()) == count);
  for (hs_status unknown : {3, -99, 2147483647, -2147483647 - 1}) {
    REQUIRE(hs_status_string(unknown) != nullptr);
    CHECK(std::strlen(hs_status_string(unknown)) > 0);
  }
}

TEST_CASE("the version is three numbers, those of the headers") {
  int major = -1, minor = -1, patch = -1, end = 0;
  CHECK(std::sscanf(hs_version(), "%d.%d.%d%n", &major, &minor, &patch, &end) == 3);
  CHECK(std::size_t(end) == std::strlen(hs_version()));
  CHECK(major == HS_VERSION_MAJOR);
  CHECK(minor == HS_VERSION_MINOR);
  CHECK(patch == HS_VERSION_PATCH);
  CHECK(HS_VERSION == 10000 * major + 100 * minor + patch);
}
