// Problem 3 of the paper: how small may the slot be.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/slot.hpp"
#include "snug/strategy.hpp"

namespace snug {

/// Which of a slot's dimensions is sought; the other is given.
enum class Sought { length, width };

struct MinSlotOptions {
    int max_changes = 0;  ///< direction changes allowed: 0 to 100000, with fewest to 1000
    Strategy strategy = Strategy::max_steer;
    Sought sought = Sought::length;
    double min_range = 0.0;  ///< max_steer: headings must park over a stretch at least this wide [rad], 0 to pi/2
    Driving driving = {};
    Parked parked = {};          ///< what counts as parked
    double front_setback = 0.0;  ///< of the neighbours, and the curb, as in SlotDimensions
    double rear_setback = 0.0;
    Curb curb = Curb::high;
    double longest = 4.0;     ///< give up where even this much more than what holds the car is too short [m]
    double widest = 4.0;      ///< likewise for the width [m]
    double precision = 1e-3;  ///< fewest: to which both sizes are found [m], as far as the resolution lets them
    double resolution = 0.0;  ///< fewest: spacing of the finest lattice [m]; 0: a two-thousandth of the car's length
    /// max_steer: show that no smaller slot will do. Takes from milliseconds to 2 s; without a smallest range.
    bool prove = false;
    /// Told the part done (0 to 1) from time to time; returning false ends with what is known so far.
    std::function<bool(double)> progress = {};
};

/// A closed range of sizes. [m]
struct Sizes {
    double min = 0.0;
    double max = 0.0;

    friend bool operator==(const Sizes&, const Sizes&) = default;
};

/// A slot that is just large enough, as far as it is known.
struct MinSlot {
    int max_changes = 0;           ///< as asked for
    std::optional<double> length;  ///< [m]; what is sought is empty where nothing within the limits is found to do
    std::optional<double> width;   ///< [m]
    double lower = 0.0;  ///< of what is sought: nothing smaller will do, where that is proved (fewest, `prove`) [m]
    /// With `prove`, between `lower` and what is sought: sizes that park as well, or of which nothing is known. No other
    /// size there parks, but from slivers of headings of 1e-9 rad in all.
    std::vector<Sizes> open;
    std::optional<double> entry_heading;  ///< max_steer: from which the car parks in it [rad]
    /// Given up, by the progress callback or at the bound on work: as far as it had come.
    bool cancelled = false;

    [[nodiscard]] const std::optional<double>& size(Sought sought) const {
        return sought == Sought::length ? length : width;
    }

    friend bool operator==(const MinSlot&, const MinSlot&) = default;
};

/// The shortest slot of the given width [m], or the narrowest of the given length, in which the car parks with at most
/// `max_changes` direction changes. A neighbour is there as deep as it is set back, so no slot is narrower than that.
///
/// With full steering the car parks in that size, and in no smaller one, to 1e-7 m, with dozens of changes to 1e-6 m. A
/// larger slot can be harder for some cars (docs/min-slot.md): then sizes that park may have gaps, and the smallest is
/// found if they park over a hundredth of a metre or so. With fewest, over all maneuvers, the answer lies between two
/// sizes, both proved; there a distance from the curb that counts as parked can only be asked for lengths.
/// Throws Error when an option is impossible.
MinSlot min_slot(const Car& car, double given, const MinSlotOptions& options = {});

/// "length", "width"
std::string_view to_string(Sought sought);

}  // namespace snug
