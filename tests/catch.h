#pragma once

// Catch2 as it is found: version 3 has no single header any more, and Approx moved into its namespace.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
