// The question that most tests of the command ask, and answers taken apart.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"
#include "snug/io.hpp"

namespace snug::test {

inline const std::string zoe = "entry --car renault-zoe --length 5 --width 2 ";

inline std::vector<std::string> lines(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
}

inline std::vector<std::string> keys(const Json& object) {
    std::vector<std::string> all;
    for (const auto& item : object.items()) all.push_back(item.key());
    return all;
}

}  // namespace snug::test
