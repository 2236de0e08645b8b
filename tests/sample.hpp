// How many random cases a test runs: a seeded sample, or all of them in a soak.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace snug::test {

inline bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && std::string_view(value) == "1";
}

/// A whole number from the environment, to choose cases with.
inline std::uint64_t number(const char* variable, std::uint64_t otherwise) {
    const char* value = std::getenv(variable);
    return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

/// `full` with SNUG_SOAK=1, `small` with SNUG_SMALL=1 (sanitizers), else `usual`.
inline int sample(int usual, int full, int small) {
    if (is_set("SNUG_SOAK")) {
        return full;
    }
    return is_set("SNUG_SMALL") ? small : usual;
}
/// The same, small a tenth of the usual.
inline int sample(int usual, int full) { return sample(usual, full, std::max(1, usual / 10)); }

}  // namespace snug::test
