// What the library says to a value that cannot exist.
#pragma once

#include <string>

#include "snug/error.hpp"

namespace model {

/// The sentence of the Error that `build` throws; empty when it throws none.
template <class Build>
std::string refusal(Build build) {
    try {
        build();
    } catch (const snug::Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace model
