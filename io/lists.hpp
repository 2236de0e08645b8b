// Places as lists of numbers.
#pragma once

#include "snug/io.hpp"

namespace snug {

/// [x, y, heading]
Json list_of(const Pose& pose);

}  // namespace snug
