// A way with few and short pieces in the place of one with many: what a person would drive.
#pragma once

#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "contact/place_contact.hpp"

namespace snug::detail::sets {

/// The same moves with few pieces: as far as nothing is in the way, each stretch becomes the shortest way between its ends,
/// which is an arc, a straight line and an arc.
std::vector<Path> with_few_pieces(const ChartPlace& place, const std::vector<Path>& way);
/// The same, into a list whose memory is used again.
void with_few_pieces(const ChartPlace& place, const std::vector<Path>& way, std::vector<Path>& few);

/// As many moves, to the same place, with fewer and shorter pieces as far as that can be had by changing where a move ends
/// and the next one begins. It costs what `trouble` says, and never more than the way given.
std::vector<Path> polished(const ChartPlace& place, const std::vector<Path>& way);

/// Ways of an arc, a straight line and an arc at full steering from one pose to another, driven forward (1) or backward (-1)
/// (Dubins 1957), the shortest first; no arc turns farther than 2.5 rad.
std::vector<std::vector<Path>> shortest_ways(const Pose& from, const Pose& to, double way, double radius);

/// What a driver minds, as so much length [m]: the length, every piece, and holding the wheel between straight and full.
double trouble(const std::vector<Path>& way, double radius);

/// How often the direction changes.
int changes_of(const std::vector<Path>& way);

}  // namespace snug::detail::sets
