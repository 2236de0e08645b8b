// The stops of a maneuver: what is numbered in the picture and in the table.
#include "legs.hpp"

namespace snug::drawing {

std::vector<Leg> legs_of(const Maneuver& maneuver) {
    std::vector<Leg> legs;
    const auto& moves = maneuver.moves;
    char piece = 'a';
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const bool begins = i == 0 || moves[i].direction != moves[i - 1].direction;
        const bool ends = i + 1 == moves.size() || moves[i].direction != moves[i + 1].direction;
        piece = begins ? 'a' : static_cast<char>(piece < 'z' ? piece + 1 : 'z');
        const int number = legs.empty() ? 1 : legs.back().number + (begins ? 1 : 0);
        const bool whole = begins && ends;
        legs.push_back({&moves[i], number, std::to_string(number) + (whole ? "" : std::string(1, piece)),
                        ends && i + 1 < moves.size()});
    }
    return legs;
}

}  // namespace snug::drawing
