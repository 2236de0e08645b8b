// Is there any room to drive in, and how much must there be at least, as far as that is plain to see without a search?
#pragma once

#include "all_maneuvers/search.hpp"

namespace snug::detail {

/// Parallel in a slot exactly as long as the car it cannot move, and in one exactly as wide it cannot turn
/// (docs/fewest.md); only in a much wider one a car so long as the slot fits in tilted. The lattices see to the rest.
bool has_room(const Ground& ground, double length, double width);

/// No slot shorter than this can hold the car.
double shorter_than_any(const Ground& ground, double width);
/// No slot narrower than this can.
double narrower_than_any(const Ground& ground);

/// Whether this is the paper's question: a rectangle, neighbours that begin at the entry side, a curb that stops all.
bool is_plain(const Ground& ground);

/// How to enter, asked as how to leave from wherever the car is parked.
LeavingQuestion entering_question(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked);

}  // namespace snug::detail
