#pragma once

#include <atomic>

namespace halfspace_test {

/// Of the whole process, what it is linked with included.
extern std::atomic<long> calls_of_new;

}  // namespace halfspace_test
