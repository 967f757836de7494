#pragma once

#include <atomic>

namespace halfspace_test {

/// The calls of the whole process are counted, those of its libraries included.
extern std::atomic<long> calls_of_new;

}  // namespace halfspace_test
