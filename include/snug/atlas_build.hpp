// Building an atlas: every car in every slot, solved on all cores, kept in an SQLite database, exported for cars.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/atlas.hpp"

namespace snug {

/// What is to be answered: each car in a slot of each width and length.
struct AtlasPlan {
    std::vector<Car> cars;        ///< each with a name of its own
    std::vector<double> widths;   ///< [m]
    std::vector<double> lengths;  ///< [m]
    AtlasOptions options;

    friend bool operator==(const AtlasPlan&, const AtlasPlan&) = default;
};

/// The answer for one car in one slot, as it is stored. Poses are those of a slot on the right with its corner at the
/// origin and heading 0.
struct CellAnswer {
    std::optional<int> direction_changes;  ///< the fewest; empty when no maneuver was found
    int lower_bound = 0;                   ///< fewest: no maneuver has fewer
    bool proved = false;                   ///< fewest: the bounds meet, or the lower one exceeds what is allowed
    std::vector<HeadingRange> ranges;      ///< in rising order; none with fewest
    Pose entry;                            ///< where the maneuver begins
    std::vector<AtlasMove> moves;          ///< none when no maneuver was found

    friend bool operator==(const CellAnswer&, const CellAnswer&) = default;
};

/// Solves one cell: entry() or fewest(), in short. Empty when `go_on` said no. Throws Error when an option is impossible.
std::optional<CellAnswer> solve(const Car& car, double width, double length, const AtlasOptions& options,
                                const std::function<bool()>& go_on = {});

/// Writes an exported atlas to a sink, part by part and in order, in bounded memory. The same plan and answers give the same
/// bytes.
class AtlasWriter {
public:
    using Sink = std::function<void(std::string_view bytes)>;

    /// Cars must be in alphabetical order of their names, widths and lengths rising. Throws Error when they are not, or
    /// when one is missing or there are too many.
    AtlasWriter(const AtlasPlan& plan, std::string_view made_by, Sink sink);
    ~AtlasWriter();

    /// The cells one after the other: cars outside, then widths, lengths inside. One too many, or one with moves and
    /// without their count, is a mistake in the program: std::logic_error.
    void add(const CellAnswer& answer);
    /// When all have been added; std::logic_error before.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace snug
