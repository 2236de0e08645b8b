// A stretch of entry headings, and all cars that entered with them, between two moves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "full_steering/proof/enclosure.hpp"

namespace snug::detail::proof {

/// Conditions of an obstacle at least one of which does not hold at the start of a move, because the last one ended there.
struct Touched {
    struct At {
        std::uint32_t stage = 0;
        std::uint32_t condition = 0;  ///< within the stage
    };
    int count = 0;
    bool exact = false;  ///< the one condition is exactly zero
    std::array<At, 4> at;

    void add(std::size_t stage, std::size_t condition) {
        for (int i = 0; i < count; ++i) {
            if (at[static_cast<std::size_t>(i)].stage == stage &&
                at[static_cast<std::size_t>(i)].condition == condition)
                return;
        }
        if (count < 0 || count == 4) {
            count = -1;  // nothing is known
            return;
        }
        at[static_cast<std::size_t>(count++)] = {static_cast<std::uint32_t>(stage),
                                                 static_cast<std::uint32_t>(condition)};
    }
};

/// All cars of a box between two moves.
struct State {
    Form x, y;  ///< turning centre of the next move
    HeadingForm start;
    std::array<Touched, 3> touched;
    bool backward = true;
    bool first = true;
    double x_noise = 0.0, y_noise = 0.0;  ///< of the centre: how far it can be from a straight line in the heading
    std::array<double, 3> turned = {infinity, infinity, infinity};  ///< in the last moves, the last one first, roughly
};

/// A stretch of headings, and what is known of it when its first moves are driven.
struct Box {
    double min = 0.0, max = 0.0;
    double middle = 0.0, half = 0.0;  ///< its headings are middle + t * half with t in [-1, 1]
    bool doubtful = false;            ///< it may be no entry position
    int ends_in = -1;                 ///< a range of this move, and it is too narrow to tell more; nothing parks before
    int driven = 0;                   ///< so many moves
    State state;                      ///< after them

    Box(double least, double most)
        : min(least),
          max(most),
          middle(0.5 * (least + most)),
          half(std::max(max - middle, middle - min) * upward + 1e-300) {}
};

/// Starts at one heading that are off the entry position, away from the corner it touches: this far along the slot and out
/// into the road. [m]
struct Starts {
    double heading = 0.0;
    double along_min = 0.0, along_max = 0.0;
    double out_min = 0.0, out_max = 0.0;
};

/// Why something could not be told, and so where to cut: at the root of a quantity, or (beside a graze) nearer to it.
struct Failure {
    enum Kind : unsigned char { halve, at_root, beside_graze } kind = halve;
    Form quantity;
    bool parking = false;  ///< cars park in this move where the quantity has one sign, and only there
    /// The lowest corner grazes the curb, in this stage: it meets it in `at`, or (unless `surely`) passes.
    bool grazes = false;
    bool surely = false;
    std::size_t stage = 0;
    HeadingForm at;
};

/// Does a quantity have both signs in the box, for sure?
inline bool changes_sign(const Form& quantity) {
    return std::abs(quantity.mid) + quantity.noise() < std::abs(quantity.along);
}

inline Failure at_root_of(const Form& quantity) {
    Failure failure;
    failure.kind = Failure::at_root;
    failure.quantity = quantity;
    return failure;
}

}  // namespace snug::detail::proof
