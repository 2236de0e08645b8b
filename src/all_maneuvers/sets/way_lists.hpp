// What finding a way in a map writes on; its memory is used again.
#pragma once

#include <vector>

#include "contact/place_contact.hpp"

namespace snug::detail {

struct WayLists {
    std::vector<Path> steps;  ///< from node to node
    std::vector<Path> few;    ///< the same with few pieces
};

}  // namespace snug::detail
