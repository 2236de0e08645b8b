// The paper's pictures of cars and positions, and its table of cars.
#pragma once

#include <vector>

#include "paper/work.hpp"

namespace snug::paper {

/// The table; frames and paths forward at full steering; possible entry positions; entry and goal positions.
std::vector<File> scenes();

}  // namespace snug::paper
