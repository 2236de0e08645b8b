// The version of the library, the command and the packages; the build reads it from here.
#pragma once

#if __cplusplus < 202002L
#error "snug needs C++20: compile with -std=c++20"
#endif

/// Semantic version, "major.minor.patch".
#define SNUG_VERSION "0.1.0"
