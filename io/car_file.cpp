// The steering under any of its names, and how files are read.
#include "car_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <numbers>
#include <system_error>

#include "model/check.hpp"
#include "model/spelling.hpp"

namespace snug {
namespace {

constexpr std::size_t longest_name = 100;  // [bytes]
constexpr double degree = std::numbers::pi / 180.0;
constexpr double least_steer = 0.1 * degree;  // what a Car accepts
constexpr double most_steer = 89.9 * degree;

}  // namespace

double steering_angle(const std::string& what, const std::string& name, double value, CarDimensions dimensions) {
    dimensions.max_steer = most_steer;
    const Car sharpest(dimensions);
    dimensions.max_steer = least_steer;
    const Car dullest(dimensions);
    if (name == "max_steer") {
        check_between(what, value, least_steer, most_steer, " rad");
        return value;
    }
    if (name == "max_steer_deg") {
        check_between(what, value, least_steer / degree, most_steer / degree, " degrees");
        return value * degree;
    }
    if (name == "turning_radius") {
        check_between(what, value, sharpest.turning_radius(), dullest.turning_radius(), " m");
        return steer_for_turning_radius(dimensions.wheelbase, value);
    }
    check_between(what, value, sharpest.curb_to_curb(), dullest.curb_to_curb(), " m");
    return steer_for_curb_to_curb(dimensions.wheelbase, dimensions.width, value);
}

void check_name(const std::string& what, const std::string& name) {
    if (name.size() > longest_name || printable(name) != name) {
        throw Error(what + " is " + in_quotes(name) + ", but must be at most " + std::to_string(longest_name) +
                    " bytes of UTF-8, free of control characters");
    }
}

std::string read_text(const std::string& path, std::size_t largest, const std::string& instead) {
    const auto failed = [&](int reason) {
        return Error(path + ": cannot be read: " + std::generic_category().message(reason) + "; " + instead);
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        throw failed(errno);
    }
    std::string text;
    std::string part(1 << 16, '\0');
    errno = 0;
    while (text.size() <= largest) {
        const std::size_t wanted = std::min(part.size(), largest + 1 - text.size());
        const std::size_t count = std::fread(part.data(), 1, wanted, file.get());
        text.append(part, 0, count);
        if (count < wanted) {
            break;
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw failed(errno);
    }
    return text;
}

}  // namespace snug
