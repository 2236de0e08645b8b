// The version of the library, the command and the packages; the build reads it from here.
#pragma once

/// Semantic version, "major.minor.patch".
#define SNUG_VERSION "0.1.0"
