// How often this program has allocated memory with new.
#pragma once

#include <cstddef>

namespace snug::test {

std::size_t allocations();

}  // namespace snug::test
