// By how much a start may be off the entry position, proved.
#pragma once

#include "full_steering/proof/proof.hpp"
#include "snug/start_tolerance.hpp"

namespace snug::detail {

/// Fills in all but the counts of a tolerance, for that heading and so many changes; the car parks with them from the entry
/// position, and its other end stays clear of the other neighbour up to `room` farther along.
void prove_starts(const ProofProblem& problem, double room, StartTolerance& tolerance);

}  // namespace snug::detail
