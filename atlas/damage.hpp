// What to say of a database that is not what was stored, and what to do about it.
#pragma once

#include <cstdint>
#include <string>

#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug {

inline const std::string after_damage = "restore a copy, or build it again";

inline Error damaged(const std::string& path, const std::string& why) {
    return Error(in_quotes(path) + " is damaged: " + why + "; " + after_damage);
}

/// More cells than there are slots for every car.
inline std::string too_many_cells(std::uint64_t stored, std::uint64_t cells) {
    return "it has " + std::to_string(stored) + " cells for " + std::to_string(cells) + " slots";
}

}  // namespace snug
