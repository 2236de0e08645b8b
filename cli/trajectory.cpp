// A maneuver over time as a file.
#include "cli/trajectory.hpp"

#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr double usual_period = 0.05;

}  // namespace

TrajectoryOptions::TrajectoryOptions(Options& options)
    : file(options.text("--trajectory", "FILE",
                        "The maneuver over time: FILE ends with .csv, .json or\n.xosc (OpenSCENARIO).")),
      period(options.number("--period", "S", "A point every so often [s] (0.05).", {" s", 1e-6, 1e6})),
      speed(options.number("--speed", "V", "Greatest speed [m/s] (1).", {" m/s", 1e-3, 1e3})),
      acceleration(options.number("--acceleration", "A", "Gaining speed [m/s2] (0.5).", {" m/s2", 1e-3, 1e3})),
      deceleration(options.number("--deceleration", "A", "Losing speed [m/s2] (0.5).", {" m/s2", 1e-3, 1e3})),
      steering_rate(
          options.number("--steering-rate", "R", "Of the steering angle [rad/s] (0.5).", {" rad/s", 1e-3, 1e3})) {}

std::optional<TrajectoryFile> trajectory_file(const TrajectoryOptions& options, const Option<std::string>& waypoints,
                                              const Option<std::string>& draw, const Option<std::string>& output) {
    for (const Option<double>* of_it :
         {&options.period, &options.speed, &options.acceleration, &options.deceleration, &options.steering_rate})
        refuse_without(options.file, *of_it);
    if (!options.file) return std::nullopt;
    TrajectoryFile file;
    file.path = *options.file;
    if (ends_with(file.path, ".json"))
        file.format = TrajectoryFile::Format::json;
    else if (ends_with(file.path, ".xosc"))
        file.format = TrajectoryFile::Format::openscenario;
    else if (!ends_with(file.path, ".csv"))
        throw Error(options.file.name() + ": " + in_quotes(file.path) +
                    " has no known extension; end it with .csv, .json or .xosc");
    file.period = options.period.value_or(usual_period);
    file.limits.speed = options.speed.value_or(file.limits.speed);
    file.limits.acceleration = options.acceleration.value_or(file.limits.acceleration);
    file.limits.deceleration = options.deceleration.value_or(file.limits.deceleration);
    file.limits.steering_rate = options.steering_rate.value_or(file.limits.steering_rate);
    refuse_same_file(options.file, waypoints);
    refuse_same_file(options.file, draw);
    refuse_same_file(options.file, output);
    check_writable(options.file.name(), file.path);
    return file;
}

std::string written(const TrajectoryFile& file, const Car& car, const std::optional<Maneuver>& maneuver) {
    return written(file, trajectory(maneuver ? *maneuver : Maneuver{car, {}}, file.limits));
}

std::string written(const TrajectoryFile& file, const Trajectory& whole) {
    try {
        switch (file.format) {
            case TrajectoryFile::Format::json: return trajectory_json(whole, file.period);
            case TrajectoryFile::Format::openscenario: return as_openscenario(whole, file.period);
            case TrajectoryFile::Format::csv: break;
        }
        return as_csv(whole, file.period);
    } catch (const Error& error) {
        throw Error(std::string("--period: ") + error.what());
    }
}

}  // namespace snug::cli
