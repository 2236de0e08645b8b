#include "cli/words.hpp"

#include "cli/table.hpp"

namespace snug::cli {

std::string changes(int count) {
    return count == 0 ? "no direction change" : std::to_string(count) + " direction change" + (count == 1 ? "" : "s");
}

std::string name(const Car& car) { return car.name().empty() ? "The car" : car.name(); }

std::string words(const Shortfall& lacking) {
    std::string text = lacking.length > 0.0 ? fixed(lacking.length, 3) + " m too short" : "";
    text += lacking.length > 0.0 && lacking.width > 0.0 ? " and " : "";
    return text + (lacking.width > 0.0 ? fixed(lacking.width, 3) + " m too narrow" : "");
}

}  // namespace snug::cli
