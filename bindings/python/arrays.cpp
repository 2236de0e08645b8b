// Many slots or headings at once, NumPy arrays in and out, on all cores.
#include <algorithm>
#include <cstdint>
#include <limits>

#include "arguments.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"
#include "snug/sweep.hpp"

namespace snug::python {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Rows of the structured arrays.
struct EntryFields {
    std::int64_t direction_changes = -1;
    double entry_heading = none;
    double heading_min = none;
    double heading_max = none;
};
struct MinSlotFields {
    double length = none;
    double width = none;
    double lower = none;
    double entry_heading = none;
};
struct WaypointFields {
    double x = 0.0;
    double y = 0.0;
    double heading = 0.0;
    std::int64_t direction = 0;
    double curvature = 0.0;
    double distance = 0.0;
};
struct TrajectoryFields {
    double time = 0.0;
    double x = 0.0;
    double y = 0.0;
    double heading = 0.0;
    std::int64_t direction = 0;
    double speed = 0.0;
    double acceleration = 0.0;
    double steering_angle = 0.0;
    double steering_rate = 0.0;
    double curvature = 0.0;
    double distance = 0.0;
};

using Shape = std::vector<py::ssize_t>;

Shape shape_of(const py::array& array) { return {array.shape(), array.shape() + array.ndim()}; }

Shape joined(Shape first, const Shape& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

template <class T>
std::vector<T> values_of(const py::array_t<T, py::array::c_style | py::array::forcecast>& array) {
    return {array.data(), array.data() + array.size()};
}

/// An array of that shape, or its one element.
template <class T>
py::object shaped(const std::vector<T>& values, const Shape& shape) {
    py::array_t<T> array(shape);
    std::copy(values.begin(), values.end(), array.mutable_data());
    return shape.empty() ? py::object(array[py::tuple()]) : py::object(array);
}

/// "widths[3, 1]"
std::string element(const std::string& name, const Shape& shape, std::size_t flat) {
    std::string index;
    for (std::size_t axis = shape.size(); axis-- > 0;) {
        const auto size = static_cast<std::size_t>(shape[axis]);
        index.insert(0, std::to_string(flat % size) + (index.empty() ? "" : ", "));
        flat /= size;
    }
    return index.empty() ? name : name + "[" + index + "]";
}

/// Throws Error, naming the element, unless all of them lie within the limits.
void check_all(const std::string& name, const Numbers& numbers, double low, double high, std::string_view unit) {
    for (py::ssize_t i = 0; i < numbers.size(); ++i)
        if (!(numbers.data()[i] >= low && numbers.data()[i] <= high))
            check_between(element(name, shape_of(numbers), static_cast<std::size_t>(i)), numbers.data()[i], low, high,
                          unit);
}

void check_sizes(const std::string& name, const Numbers& numbers) {
    check_all(name, numbers, limits::shortest, limits::longest, " m");
}

void check_counts(const Counts& counts, int most) {
    for (py::ssize_t i = 0; i < counts.size(); ++i)
        check_between(element("max_changes", shape_of(counts), static_cast<std::size_t>(i)), counts.data()[i], 0, most,
                      "");
}

std::string spelled_shape(const Numbers& array) { return std::string(py::str(array.attr("shape"))); }

/// Arrays of one shape, as NumPy's broadcasting goes.
std::vector<Numbers> broadcast(const std::vector<std::pair<std::string, Numbers>>& arrays) {
    py::list given;
    std::string shapes;
    for (const auto& [name, array] : arrays) {
        given.append(array);
        shapes.append(shapes.empty() ? "" : ", ").append(name).append(" ").append(spelled_shape(array));
    }
    try {
        const py::object together = py::module_::import("numpy").attr("broadcast_arrays")(*given);
        std::vector<Numbers> result;
        for (const py::handle one : together) result.emplace_back(py::reinterpret_borrow<py::object>(one));
        return result;
    } catch (const py::error_already_set& error) {
        if (!error.matches(PyExc_ValueError)) throw;
        throw Error("the shapes do not go together: " + shapes);
    }
}

std::vector<Slot> slots_of(const Numbers& lengths, const Numbers& widths, SlotDimensions slot = {}) {
    std::vector<Slot> slots;
    slots.reserve(static_cast<std::size_t>(lengths.size()));
    for (py::ssize_t i = 0; i < lengths.size(); ++i) {
        slot.length = lengths.data()[i];
        slot.width = widths.data()[i];
        slots.emplace_back(slot);
    }
    return slots;
}

SweepOptions sweep_options(const Arguments& given) {
    SweepOptions sweep;
    given.read("threads", sweep.threads);
    check_between("threads", sweep.threads, 0, 1024, "");
    return sweep;
}

py::object entries(const Arguments& given) {
    const auto car = given.get<Car>("car");
    const auto lengths = given.get<Numbers>("lengths");
    const auto widths = given.get<Numbers>("widths");
    check_sizes("lengths", lengths);
    check_sizes("widths", widths);
    const auto sizes = broadcast({{"lengths", lengths}, {"widths", widths}});
    EntryOptions options;
    given.read("max_changes", options.max_changes);
    given.read("min_range", options.min_range);
    given.read_conditions(options);
    const auto baseline = given.baseline();
    SweepOptions sweep = sweep_options(given);
    Progress progress(given.callback("progress"));
    SlotDimensions beside;
    given.read_neighbours(beside);
    const std::vector<Slot> slots = slots_of(sizes[0], sizes[1], beside);
    const auto rows =
        interruptible(progress, sweep, [&] { return snug::entries(car, slots, options, sweep, baseline); });
    if (rows.size() < slots.size()) return py::none();
    std::vector<EntryFields> all(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        all[i].direction_changes = rows[i].direction_changes.value_or(-1);
        if (rows[i].widest) {
            all[i].entry_heading = middle(*rows[i].widest);
            all[i].heading_min = rows[i].widest->min;
            all[i].heading_max = rows[i].widest->max;
        }
    }
    return shaped(all, shape_of(sizes[0]));
}

/// `sizes` are the slots' lengths and widths; none for the one slot.
py::object counts_from(const Arguments& given) {
    const auto car = given.get<Car>("car");
    auto headings = given.get<Numbers>("headings");
    check_all("headings", headings, 0.0, limits::quarter_turn, " rad");
    MaxSteerOptions options;
    given.read("max_changes", options.max_changes);
    given.read_conditions(options);
    SweepOptions sweep = sweep_options(given);
    Progress progress(given.callback("progress"));
    const auto slot = given.get<py::object>("slot");
    std::vector<int> counts;
    if (py::isinstance<Slot>(slot)) {
        const auto one = slot.cast<Slot>();
        const std::vector<double> all = values_of(headings);
        counts = interruptible(progress, sweep, [&] { return direction_changes(car, one, all, options, sweep); });
    } else {
        if (!py::isinstance<py::tuple>(slot) || py::len(slot) != 2)
            complain("slot", "a snug.Slot or a tuple of arrays (lengths, widths)", slot);
        const Numbers lengths = as_numbers(py::tuple(slot)[0], "lengths");
        const Numbers widths = as_numbers(py::tuple(slot)[1], "widths");
        check_sizes("lengths", lengths);
        check_sizes("widths", widths);
        const auto together = broadcast({{"lengths", lengths}, {"widths", widths}, {"headings", headings}});
        headings = together[2];
        const std::vector<double> all = values_of(headings);
        const std::vector<Slot> slots = slots_of(together[0], together[1]);
        counts = interruptible(progress, sweep, [&] { return direction_changes(car, slots, all, options, sweep); });
    }
    if (counts.size() < static_cast<std::size_t>(headings.size())) return py::none();
    return shaped(counts, shape_of(headings));
}

/// Which sizes are given: the name of the parameter, and its array.
std::pair<std::string, Numbers> given_sizes(const Arguments& given) {
    py::object widths = py::none();
    py::object lengths = py::none();
    given.read("widths", widths);
    given.read("lengths", lengths);
    if (widths.is_none() == lengths.is_none()) throw Error("give either the widths or the lengths of the slots");
    const std::string name = lengths.is_none() ? "widths" : "lengths";
    return {name, as_numbers(lengths.is_none() ? widths : lengths, name)};
}

/// A row for every count and size: the shape is that of the counts followed by that of the sizes.
py::object min_slots(const Arguments& given) {
    const auto car = given.get<Car>("car");
    const auto [name, sizes] = given_sizes(given);
    const auto counts = given.get<Counts>("max_changes");
    check_sizes(name, sizes);
    MinSlotOptions options = min_slot_options(given);
    options.sought = name == "widths" ? Sought::length : Sought::width;
    std::optional<Stepping> steps;
    py::object strategy = py::str(std::string(to_string(Strategy::max_steer)));
    given.read("strategy", strategy);
    if (py::isinstance<Stepping>(strategy)) {
        steps = strategy.cast<Stepping>();
    } else {
        options.strategy = as<Strategy>(strategy, "strategy");
    }
    check_counts(counts, options.strategy == Strategy::fewest ? limits::most_changes_fewest : limits::most_changes);
    double step = 0.001;
    given.read("step", step);
    SweepOptions sweep = sweep_options(given);
    Progress progress(given.callback("progress"));
    const std::vector<double> all_sizes = values_of(sizes);
    const std::vector<int> all_counts = values_of(counts);
    const auto rows = interruptible(progress, sweep, [&] {
        return steps ? min_slots_by_stepping(car, all_sizes, all_counts, *steps, step, options, sweep)
                     : snug::min_slots(car, all_sizes, all_counts, options, sweep);
    });
    if (rows.size() < all_sizes.size() * all_counts.size()) return py::none();
    std::vector<MinSlotFields> all(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        all[i] = {rows[i].length.value_or(none), rows[i].width.value_or(none), rows[i].lower,
                  rows[i].entry_heading.value_or(none)};
    return shaped(all, joined(shape_of(counts), shape_of(sizes)));
}

py::object waypoints_of(const Arguments& given) {
    const auto maneuver = given.get<Maneuver>("maneuver");
    const auto spacing = given.get<double>("spacing");
    std::vector<WaypointFields> all;
    for (const Waypoint& at : waypoints(maneuver, spacing))
        all.push_back({at.pose.x, at.pose.y, at.pose.heading, static_cast<std::int64_t>(at.direction), at.curvature,
                       at.distance});
    return shaped(all, {static_cast<py::ssize_t>(all.size())});
}

py::object trajectory_of(const Arguments& given) {
    const auto maneuver = given.get<py::object>("maneuver");
    double period = 0.05;
    double steering_angle = 0.0;
    MotionLimits limits;
    given.read("period", period);
    given.read("speed", limits.speed);
    given.read("acceleration", limits.acceleration);
    given.read("deceleration", limits.deceleration);
    given.read("steering_rate", limits.steering_rate);
    given.read("steering_angle", steering_angle);
    std::vector<TrajectoryFields> all;
    const bool rolls = py::isinstance<RollingManeuver>(maneuver);
    if (rolls && steering_angle != 0.0)
        throw Error("steering_angle is " + few_digits(steering_angle) +
                    ", but the wheels of a RollingManeuver stand straight at the start");
    const Trajectory timed = rolls ? rolling_trajectory(maneuver.cast<RollingManeuver>(), limits)
                                   : trajectory(given.get<Maneuver>("maneuver"), limits, steering_angle);
    for (const TrajectoryPoint& at : sampled(timed, period))
        all.push_back({at.time, at.pose.x, at.pose.y, at.pose.heading, static_cast<std::int64_t>(at.direction),
                       at.speed, at.acceleration, at.steering_angle, at.steering_rate, at.curvature, at.distance});
    return shaped(all, {static_cast<py::ssize_t>(all.size())});
}

}  // namespace

void define_arrays(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(EntryFields, direction_changes, entry_heading, heading_min, heading_max);
    PYBIND11_NUMPY_DTYPE(MinSlotFields, length, width, lower, entry_heading);
    PYBIND11_NUMPY_DTYPE(WaypointFields, x, y, heading, direction, curvature, distance);
    PYBIND11_NUMPY_DTYPE(TrajectoryFields, time, x, y, heading, direction, speed, acceleration, steering_angle,
                         steering_rate, curvature, distance);

    define(
        module, "waypoints(maneuver: Maneuver, spacing: float) -> NDArray[np.void]",
        "A maneuver as the poses that path followers take, at most `spacing` [m] apart: a structured array with x, y,\n"
        "heading, direction (1 forward, -1 backward), curvature [1/m], positive to the left, and distance driven [m].\n"
        "Where the direction changes there are two with one pose: the first ends a stretch, the second begins one.",
        waypoints_of);
    define(
        module,
        "trajectory(maneuver: Maneuver | RollingManeuver, *, period: float = 0.05, speed: float = 1.0, acceleration: "
        "float = 0.5, "
        "deceleration: float = 0.5, steering_rate: float = 0.5, steering_angle: float = 0.0) -> NDArray[np.void]",
        "A maneuver over time, as fast as the limits allow [m/s, m/s2, rad/s], the steering of a Maneuver turning at "
        "standstill\n"
        "only: a structured array with time [s], x, y, heading, direction (1 forward, -1 backward), speed (negative\n"
        "backward), acceleration, steering_angle, steering_rate, curvature and distance, a row every `period` [s]\n"
        "and one at the end. `steering_angle` is that of the wheels at the start.",
        trajectory_of);

    const std::string meaning =
        "Runs on all cores, or on so many `threads`. `progress` is told the part done (0 to 1); when it returns "
        "False,\n"
        "so does the question: None.";
    define(module,
           "entries(car: Car, lengths: ArrayLike, widths: ArrayLike, *, max_changes: int | None = None, min_range: "
           "float = "
           "0.0, " +
               conditions + ", " + neighbour_parameters + ", " + baseline_parameter + ", threads: int = 0, " +
               progress_parameter + ") -> Any",
           "What entry() answers for many slots, `lengths` and `widths` broadcast: a structured array with\n"
           "direction_changes (-1 where the car cannot park) and, of the widest range with so few, heading_min,\n"
           "heading_max and their middle entry_heading [rad] (NaN where there is none).\n\n" +
               meaning + "\n\n" + conditions_meaning + neighbours_meaning,
           entries);
    define(
        module,
        "direction_changes(car: Car, slot: Slot | tuple[ArrayLike, ArrayLike], headings: ArrayLike, *, max_changes: "
        "int "
        "= 200, " +
            conditions + ", threads: int = 0, " + progress_parameter + ") -> Any",
        "For each entry heading [rad] in [0, pi/2] the number of direction changes after which max_steer() parks, or\n"
        "-1 where it does not. `slot` is a Slot, or a tuple of arrays (lengths, widths) that are broadcast with the\n"
        "headings.\n\n" +
            meaning + "\n\n" + conditions_meaning,
        counts_from);

    define(
        module,
        "min_slots(car: Car, max_changes: ArrayLike, *, widths: ArrayLike | None = None, lengths: ArrayLike | None = "
        "None, "
        "strategy: " +
            literal<Strategy>() + " | Stepping = 'max-steer', step: float = 0.001, threads: int = 0, " +
            min_slot_parameters + " -> Any",
        "min_slot() for every maximum of direction changes and every one of the `widths`, or of the `lengths`: a\n"
        "structured array with length, width, lower [m] and entry_heading [rad], NaN where nothing will do; its shape\n"
        "is that of `max_changes` followed by that of the sizes.\n\n" +
            min_slot_meaning +
            "With a Stepping as `strategy` it is the paper's own loop (section 3.3): slots larger and larger by `step` "
            "[m],\nAlgorithm 1 in each, thousands of times slower.\n\n" +
            meaning + "\n\n" + conditions_meaning + neighbours_meaning,
        min_slots);
}

}  // namespace snug::python
