// A larger slot holds the smaller one's maneuvers, so a size is the smallest when it parks and none smaller by the
// precision does. Either is shown on the lattices; where neither is, both sizes are moved apart.
#include "all_maneuvers/smallest_slot.hpp"

#include <algorithm>
#include <cmath>

#include "all_maneuvers/room.hpp"
#include "contact/sized_slot.hpp"

namespace snug::detail {

namespace {

constexpr double usual_resolution = 5e-4;  ///< of the car's length

enum class Verdict { parks, impossible, undecided };

class Sizes {
public:
    Sizes(const Car& car, double given, const MinSlotOptions& options)
        : car_(car),
          given_(given),
          options_(options),
          largest_(sizes_to_search(car, given, options).most),
          ground_(car, slot_of(options, given, largest_), options.driving, options.parked),
          smallest_(sought_length() ? shorter_than_any(ground_, given) : narrower_than_any(ground_)),
          lower_(smallest_),
          open_(largest_) {}

    void narrow(std::optional<double> known) {
        if (!holds(largest_)) {
            lower_ = std::max(smallest_, largest_);
            return;
        }
        try {
            size_ = known;
            search();
        } catch (const GivenUp&) {  // as far as it got
            cancelled_ = true;
        }
    }

    [[nodiscard]] MinSlot answer() const {
        MinSlot slot;
        slot.max_changes = options_.max_changes;
        slot.length = sought_length() ? size_ : given_;
        slot.width = sought_length() ? given_ : size_;
        slot.lower = lower_;
        slot.cancelled = cancelled_;
        return slot;
    }

private:
    [[nodiscard]] bool sought_length() const { return options_.sought == Sought::length; }

    [[nodiscard]] bool holds(double size) const {
        return has_room(ground_, sought_length() ? size : given_, sought_length() ? given_ : size);
    }

    [[nodiscard]] double halvings(double from) const { return std::log2(std::max(1.0, from / options_.precision)); }

    [[nodiscard]] Verdict verdict(double size) const {
        if (!sought_length() && !holds(size)) return Verdict::impossible;
        LeavingQuestion question =
            entering_question(car_, slot_of(options_, given_, size), options_.driving, options_.parked);
        question.max_changes = options_.max_changes;
        question.resolution = options_.resolution > 0.0 ? options_.resolution : usual_resolution * car_.length();
        question.any_upper_will_do = true;
        LeavingBounds bounds;
        bounds.upper = options_.max_changes + 1;
        const Watch watch = [&] {
            const double left = halvings(open_ - lower_) / std::max(1.0, halvings(largest_ - smallest_));
            if (options_.progress && !options_.progress(1.0 - left)) throw GivenUp{};
        };
        detail::narrow(question, options_.max_changes, bounds, watch);
        if (!bounds.moves.empty()) return Verdict::parks;
        return bounds.lower > options_.max_changes ? Verdict::impossible : Verdict::undecided;
    }

    void search() {
        open_ = size_.value_or(largest_);
        if (!size_) {
            switch (verdict(largest_)) {
                case Verdict::parks: size_ = largest_; break;
                case Verdict::impossible: lower_ = largest_; return;
                case Verdict::undecided: break;
            }
        }
        // First where it is surely impossible, then, above what stays undecided, where it is sure to work.
        double undecided = smallest_;
        // What the paper's strategy needs is often all there is: look just below first, then farther and farther.
        for (double below = 4.0 * options_.precision; open_ - below > smallest_; below *= 4.0) {
            const double size = open_ - below;
            const Verdict found = verdict(size);
            if (found == Verdict::impossible) {
                lower_ = size;
                break;
            }
            if (found == Verdict::parks) size_ = size;
            if (found == Verdict::undecided) undecided = std::max(undecided, size);
            open_ = size;
        }
        while (open_ - lower_ > options_.precision) {
            const double middle = (lower_ + open_) / 2.0;
            switch (verdict(middle)) {
                case Verdict::parks: size_ = open_ = middle; break;
                case Verdict::impossible: lower_ = middle; break;
                case Verdict::undecided:
                    undecided = std::max(undecided, middle);
                    open_ = middle;
                    break;
            }
        }
        while (size_ && *size_ - std::max(undecided, lower_) > options_.precision) {
            const double middle = (*size_ + std::max(undecided, lower_)) / 2.0;
            if (verdict(middle) == Verdict::parks) {
                size_ = middle;
            } else {
                undecided = middle;
            }
        }
    }

    const Car& car_;
    double given_;
    const MinSlotOptions& options_;
    double largest_;              ///< looked at [m]
    Ground ground_;               ///< there
    double smallest_;             ///< that can be [m]
    std::optional<double> size_;  ///< it parks there [m]
    double lower_;                ///< and nowhere below [m]
    double open_;                 ///< below which it is not known to be impossible [m]
    bool cancelled_ = false;
};

}  // namespace

MinSlot smallest_slot(const Car& car, double given, const MinSlotOptions& options, std::optional<double> known) {
    Sizes sizes(car, given, options);
    sizes.narrow(known);
    return sizes.answer();
}

bool is_plain(const Car& car, double given, const MinSlotOptions& options) {
    const Slot slot = slot_of(options, given, sizes_to_search(car, given, options).most);
    return is_plain(Ground(car, slot, options.driving, options.parked));
}

}  // namespace snug::detail
