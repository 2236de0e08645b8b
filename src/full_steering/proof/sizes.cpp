#include "full_steering/proof/sizes.hpp"

#include <algorithm>
#include <cmath>

#include "contact/sized_slot.hpp"
#include "full_steering/proof/proof.hpp"
#include "snug/error.hpp"

namespace snug::detail {

namespace {

constexpr double coarsest = 0.05;                ///< strips, at first [m]
constexpr double finest = 2e-7;                  ///< strips are not halved further [m]
constexpr std::size_t moves_a_strip = 3'000;     ///< wider strips are given up sooner than they are proved
constexpr std::size_t moves_in_all = 3'000'000;  ///< 1 to 2 s

/// In none of the slots from one size to another?
bool none_between(const Car& car, double given, const MinSlotOptions& options, double from, double to,
                  std::size_t& moves_left) {
    const double middle = 0.5 * (from + to);
    const double error = std::max(middle - from, to - middle) + 1e-15 * to;
    ProofProblem problem = proof_problem(car, slot_of(options, given, middle), options.driving, options.parked);
    (options.sought == Sought::length ? problem.length_error : problem.width_error) = error;
    std::size_t left = std::min(moves_a_strip, moves_left);
    const std::size_t before = left;
    const bool none = none_parks(problem, options.max_changes, left);
    moves_left -= before - left;
    return none;
}

}  // namespace

void prove_smaller(const Car& car, double given, const MinSlotOptions& options, MinSlot& slot) {
    const SizeRange sizes = sizes_to_search(car, given, options);
    const double end = slot.size(options.sought).value_or(sizes.most);
    std::size_t moves_left = moves_in_all;
    double from = sizes.least;
    double step = coarsest;
    const auto leave_open = [&](double to) {
        if (!slot.open.empty() && slot.open.back().max == from) {
            slot.open.back().max = to;
        } else {
            slot.open.push_back({from, to});
        }
        from = to;
    };
    while (from < end) {
        if (options.progress && !options.progress((from - sizes.least) / (end - sizes.least))) slot.cancelled = true;
        if (slot.cancelled || moves_left == 0) {
            leave_open(end);
            break;
        }
        const double to = end - from < step + finest ? end : from + step;
        if (none_between(car, given, options, from, to, moves_left)) {
            from = to;
            step = std::min(2.0 * step, coarsest);
        } else if (step > finest) {
            step /= 2.0;
        } else {  // what is open may be wide: leave more out, the more there has been
            const double open = !slot.open.empty() && slot.open.back().max == from ? from - slot.open.back().min : 0.0;
            leave_open(std::min(end, from + std::max(finest, 0.1 * open)));
        }
    }
    slot.lower = slot.open.empty() ? end : slot.open.front().min;
}

}  // namespace snug::detail
