// The groups of options that subcommands share: their names, their help and what they mean, each in one place.
#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "snug/draw.hpp"
#include "snug/entry.hpp"
#include "snug/error.hpp"
#include "snug/fewest.hpp"
#include "snug/place.hpp"
#include "snug/stepping.hpp"

namespace snug::cli {

// Each declares its options where it is made, and is then asked what they mean.

struct CarOptions {
    explicit CarOptions(Options& options);
    [[nodiscard]] Car car() const;

    Option<std::string> name;
};

/// The catalogue's car of that name, or the car in that file. Throws Error.
Car find_or_read_car(const std::string& name_or_file);

/// --front-setback, --rear-setback, --curb and --curb-clearance.
struct NeighbourOptions {
    explicit NeighbourOptions(Options& options);
    /// Adds to a slot what stands beside it. Throws Error when a neighbour begins deeper than the slot.
    void describe(SlotDimensions& slot) const;
    /// Throws Error when a neighbour begins deeper than a slot of that width.
    void check_within(double width) const;

    Option<double> front_setback;
    Option<double> rear_setback;
    Option<Curb> curb;
    Option<double> curb_clearance;
};

struct SlotOptions {
    explicit SlotOptions(Options& options);
    [[nodiscard]] SlotDimensions dimensions(const Car& car) const;

    Option<double> length;
    Option<double> width;
    Option<double> extra_length;
    Option<double> extra_width;
    Option<Side> side;
    Option<Point> corner;
    Option<double> heading;
};

/// --angle and --stretch, wherever there is a street.
Option<double> angle_option(Options& options);
Option<double> stretch_option(Options& options);

/// --angle, --road and --stretch: what makes a slot a bay at a street.
struct StreetOptions {
    explicit StreetOptions(Options& options);
    [[nodiscard]] Street street(const SlotDimensions& slot) const;

    Option<double> angle;  ///< in degrees
    Option<double> road;
    Option<double> stretch;
};

/// The car, and the bay at a street with what stands beside it.
struct BayOptions {
    explicit BayOptions(Options& options);
    [[nodiscard]] SlotDimensions dimensions(const Car& of) const;
    [[nodiscard]] Street bay(const Car& of, const Driving& driving) const;

    CarOptions car;
    SlotOptions slot;
    StreetOptions street;
    NeighbourOptions neighbours;
};

/// --parked-heading and --parked-curb.
struct ParkedOptions {
    explicit ParkedOptions(Options& options);
    [[nodiscard]] Parked parked() const;

    Option<double> heading;  ///< in degrees
    Option<double> curb;
};

/// --clearance; the others only where they are declared.
Option<double> clearance_option(Options& options);

struct DrivingOptions {
    explicit DrivingOptions(Options& options);
    [[nodiscard]] Driving driving() const;
    [[nodiscard]] Driving driving(const NeighbourOptions& neighbours) const;

    Option<Enter> enter;
    Option<double> clearance;
};

/// What --strategy may name.
enum class Planner { max_steer, stepping, reversed_trials, parallel_trials, fewest };

/// Throws Error where an option is given that belongs to strategies which are not asked for.
template <class Value>
void belongs_to(const Option<Value>& option, bool asked_for, const std::string& strategies) {
    if (option && !asked_for)
        throw Error(option.name() + " belongs to --strategy " + strategies + "; leave it out or give that strategy");
}

/// --resolution and --time-limit: what the search over all maneuvers is limited to.
Option<double> resolution_option(Options& options, const std::string& finest_by_default,
                                 const std::string& begins = "fewest: finest");
Option<double> time_limit_option(Options& options, const std::string& begins = "fewest: end");

/// How small the steps of stepping are.
struct SteppingOptions {
    explicit SteppingOptions(Options& options);
    /// Throws Error where one is given and `asked_for` is not.
    [[nodiscard]] Stepping stepping(bool asked_for) const;

    Option<double> step;
    Option<double> heading_step;
    Option<StopRule> stop;
};

/// A pose in the world, X,Y,HEADING; for Options::declared().
Point point(const std::string& option, const std::string& text);
Pose pose(const std::string& option, const std::string& text);

/// Throws Error where a baseline is asked what only the solver can answer.
void refuse_for_baselines(Planner planner, const NeighbourOptions& neighbours, const ParkedOptions& parked);

enum class Format { text, json, csv };

struct OutputOptions {
    explicit OutputOptions(Options& options, const std::string& formats = "text (default), json or csv.");
    [[nodiscard]] Format format() const { return chosen.value_or(Format::text); }
    /// The same where there is no csv: `why_no_csv` is the sentence.
    [[nodiscard]] Format format_without_csv(const std::string& why_no_csv) const;
    /// The file of `-o`, which can be written as far as one can tell before the work; empty for standard output.
    [[nodiscard]] std::string path() const;

    Option<Format> chosen;
    Option<std::string> file;
};

/// Throws Error when an option names the file of `-o`, too.
void refuse_same_file(const Option<std::string>& one, const Option<std::string>& other);

/// Throws Error when an option is given without the file it says something about.
template <class T>
void refuse_without(const Option<std::string>& file, const Option<T>& option) {
    if (option && !file)
        throw Error(option.name() + " belongs to " + file.name() + "; leave it out or give " + file.name() + " FILE");
}

/// A picture that is to be written.
struct PictureFile {
    std::string path;
    PictureFormat format = PictureFormat::svg;
};

/// --draw. Throws Error when the file has no known extension or cannot be written, as far as one can tell before the work.
Option<std::string> draw_option(Options& options);
std::optional<PictureFile> picture_file(const Option<std::string>& draw, const OutputOptions& output);

/// --threads. Without it, `otherwise`.
Option<int> threads_option(Options& options, const std::string& otherwise = "");

/// How the command ends with that answer.
int exit_code(const Answer& answer);

}  // namespace snug::cli
