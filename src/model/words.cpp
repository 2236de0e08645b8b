// The words for what can be chosen.
#include <string_view>

#include "snug/driving.hpp"
#include "snug/slot.hpp"
#include "snug/strategy.hpp"

namespace snug {

std::string_view to_string(Side side) { return side == Side::right ? "right" : "left"; }

std::string_view to_string(Curb curb) { return curb == Curb::high ? "high" : "low"; }

std::string_view to_string(Enter enter) { return enter == Enter::backward ? "backward" : "forward"; }

std::string_view to_string(Strategy strategy) { return strategy == Strategy::max_steer ? "max-steer" : "fewest"; }

}  // namespace snug
