// Independent runs of the paper's strategy with one car: where each begins, and what came out.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "full_steering/full_steering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// Direction changes after which the strategy parks, -1 if it does not; the heading must be possible.
int direction_changes_alone(const FullSteering& steering, double heading, int max_changes);

/// Hands out cases one after the other and takes their answers.
class Cases {
public:
    /// A case at its entry position.
    struct Start {
        std::size_t index = 0;
        double x = 0.0, y = 0.0;                         ///< of the first turning centre [m]
        double c = 1.0, s = 0.0;                         ///< of the heading
        double length = 0.0;                             ///< of its slot [m]
        double width = 0.0;                              ///< of its slot [m]
        double front_setback = 0.0, rear_setback = 0.0;  ///< of its slot [m]
    };

    /// With `slots`, case i is headings[i] into slots[i]; otherwise all enter the slot of `steering`.
    Cases(FullSteering& steering, Enter enter, const std::vector<double>& headings, const std::vector<Slot>* slots,
          int max_changes);

    [[nodiscard]] const FullSteering& steering() const { return steering_; }
    [[nodiscard]] int max_changes() const { return max_changes_; }
    /// Can vectors drive the cases? They know rectangles, which have four sectors, and look at nothing but the height.
    [[nodiscard]] bool in_vectors() const;

    /// The next case at a possible entry position, if there is one; those before it that are not are answered.
    const Start* next() {
        if (taken_ == prepared_) prepare();
        return taken_ == prepared_ ? nullptr : &starts_[taken_++];
    }

    void answer(std::size_t index, int changes) { changes_[index] = changes; }
    /// Drives a case by itself.
    void answer_alone(std::size_t index);

    [[nodiscard]] std::vector<int>& answers() { return changes_; }

private:
    void prepare();
    void enter_slot(std::size_t index);
    [[nodiscard]] bool is_entry(double heading, const QuarterHeading& direction) const;

    FullSteering& steering_;
    Enter enter_;
    const std::vector<double>& headings_;
    const std::vector<Slot>* slots_;
    int max_changes_;
    std::vector<Headings> possible_;  ///< for the one slot
    std::size_t next_ = 0;
    std::array<Start, 64> starts_;
    std::size_t taken_ = 0;
    std::size_t prepared_ = 0;
    std::vector<int> changes_;
};

/// Drives all cases, in vectors.
void drive_all(Cases& cases);

}  // namespace snug::detail
