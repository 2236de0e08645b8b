// One question about one slot at a time.
#include <pybind11/stl.h>

#include "arguments.hpp"
#include "module.hpp"
#include "progress.hpp"

namespace snug::python {

namespace {

MaxSteerOptions max_steer_options(const Arguments& given) {
    MaxSteerOptions options;
    given.read("max_changes", options.max_changes);
    given.read_conditions(options);
    return options;
}

/// As max_steer_options() reads them.
const std::string run_parameters = "*, max_changes=200, " + conditions + ")";

void define_strategies(py::module_& module) {
    const Signature max_steer_signature("MaxSteer()");
    Value<MaxSteer>(module, "MaxSteer", max_steer_signature.docstring("Full steering until contact, exactly."))
        .constructor(max_steer_signature, [](const Arguments&) { return MaxSteer{}; })
        .finish();

    const Signature stepping_signature("Stepping(*, step=0.001, heading_step=0.0001, stop='contact')");
    Value<Stepping>(module, "Stepping",
                    stepping_signature.docstring(
                        "Algorithm 1 of the paper as printed: Euler steps of equation 1, the reference.\n\n"
                        "`step` is the path of one Euler step [m], 1e-7 to 1, and `heading_step` lies between\n"
                        "neighbouring entry headings [rad], 1e-6 to pi/2. It looks whether the car is parked after\n"
                        "every step (`stop` 'inside') or only when a move ends in contact ('contact', as printed)."))
        .field(
            "step", [](const Stepping& s) { return s.step; }, "Path of one Euler step [m]")
        .field(
            "heading_step", [](const Stepping& s) { return s.heading_step; }, "Between entry headings [rad]")
        .field(
            "stop", [](const Stepping& s) { return word(s.stop); }, "'contact' or 'inside'")
        .constructor(stepping_signature,
                     [](const Arguments& given) {
                         Stepping made;
                         given.read("step", made.step);
                         given.read("heading_step", made.heading_step);
                         given.read("stop", made.stop);
                         return made;
                     })
        .finish();

    const Signature reversed_signature("ReversedTrials(*, goal=None, first='forward')");
    Value<ReversedTrials>(module, "ReversedTrials",
                          reversed_signature.docstring(
                              "Several reversed trials (Vorobieva et al. 2015): driven out of the slot from a goal,\n"
                              "with full steering until contact, and then the same the other way round.\n\n"
                              "`goal` is a Pose in the world, or None for the one the paper deduces; `first` is the\n"
                              "direction of the first move out."))
        .field(
            "goal", [](const ReversedTrials& t) { return t.goal; }, "A Pose, or None for the deduced one.")
        .field(
            "first", [](const ReversedTrials& t) { return word(t.first); }, "Direction of the first move out.")
        .constructor(reversed_signature,
                     [](const Arguments& given) {
                         ReversedTrials made;
                         given.read("goal", made.goal);
                         given.read("first", made.first);
                         return made;
                     })
        .finish();

    const Signature parallel_signature("ParallelTrials(*, goal=None)");
    Value<ParallelTrials>(
        module, "ParallelTrials",
        parallel_signature.docstring(
            "Several parallel trials (Vorobieva et al. 2015): parallel to the slot at every direction\n"
            "change. `goal` is a Pose in the world, or None for any parallel one inside."))
        .field(
            "goal", [](const ParallelTrials& t) { return t.goal; }, "A Pose, or None for any parallel one inside.")
        .constructor(parallel_signature,
                     [](const Arguments& given) {
                         ParallelTrials made;
                         given.read("goal", made.goal);
                         return made;
                     })
        .finish();
}

void define_baselines(py::module_& module) {
    Value<MaxSteerRun>(module, "MaxSteerRun", "How a run of the strategy went.")
        .field(
            "outcome", [](const MaxSteerRun& r) { return word(r.outcome); },
            "'parked'; 'no_entry': no possible entry position; 'stuck': in contact both ways; 'never_touches':\n"
            "circles freely and never gets inside; 'too_many_changes'.")
        .field(
            "maneuver", [](const MaxSteerRun& r) { return r.maneuver; },
            "The moves driven, however the run ended; none for 'no_entry'.")
        .finish();
    define(module, "max_steer(car, slot, heading, " + run_parameters,
           "Drives the paper's strategy, full steering until contact, from the entry position with that heading.\n\n"
           "`heading` [rad] in [0, pi/2] is measured from the parallel heading, positive with the nose (entering\n"
           "'forward': the tail) away from the slot. Returns a MaxSteerRun.\n\n" +
               conditions_meaning,
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               const auto heading = given.get<double>("heading");
               const MaxSteerOptions options = max_steer_options(given);
               return released([&] { return max_steer(car, slot, heading, options); });
           });
    define(module, "stepping(car, slot, heading, steps=None, " + run_parameters,
           "Algorithm 1 of the paper from one entry heading [rad]; `steps` is a Stepping, None the default one.\n"
           "Returns a MaxSteerRun.",
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               const auto heading = given.get<double>("heading");
               std::optional<Stepping> steps;
               given.read("steps", steps);
               const MaxSteerOptions options = max_steer_options(given);
               return released([&] { return stepping(car, slot, heading, steps.value_or(Stepping{}), options); });
           });
    define(module, "reversed_trials(car, slot, trials=None, " + run_parameters,
           "The parking maneuver of several reversed trials; None when the car does not get out of the slot within\n"
           "the allowed direction changes. `trials` is a ReversedTrials, None the default one.",
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               std::optional<ReversedTrials> trials;
               given.read("trials", trials);
               const MaxSteerOptions options = max_steer_options(given);
               return released([&] { return reversed_trials(car, slot, trials.value_or(ReversedTrials{}), options); });
           });
    define(module, "parallel_trials(car, slot, trials=None, " + run_parameters,
           "The parking maneuver of several parallel trials; None when the car does not get to its goal within the\n"
           "allowed direction changes. `trials` is a ParallelTrials, None the default one.",
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               std::optional<ParallelTrials> trials;
               given.read("trials", trials);
               const MaxSteerOptions options = max_steer_options(given);
               return released([&] { return parallel_trials(car, slot, trials.value_or(ParallelTrials{}), options); });
           });

    Value<ReversedTrialsByGoal>(module, "ReversedTrialsByGoal",
                                "Direction changes of several reversed trials from two goals; None where the car does\n"
                                "not get out.")
        .field(
            "deduced", [](const ReversedTrialsByGoal& r) { return r.deduced; }, "From the goal the paper deduces.")
        .field(
            "found", [](const ReversedTrialsByGoal& r) { return r.found; }, "From the goal of the best maneuver.")
        .finish();
    define(module, "reversed_trials_by_goal(car, slot, max_changes=200)",
           "What the paper's choice of a goal costs in one slot (its section 4.1).", [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               int max_changes = 200;
               given.read("max_changes", max_changes);
               return released([&] { return reversed_trials_by_goal(car, slot, max_changes); });
           });
    define(module, "blackburn_extra_length(car, neighbour_width)",
           "Length that a slot must have beyond the car's for the car to back into it in one go, after Blackburn's\n"
           "formula of 2009, with the width of the car parked in front. [m]",
           [](const Arguments& given) {
               return blackburn_extra_length(given.get<Car>("car"), given.get<double>("neighbour_width"));
           });
}

void define_entry(py::module_& module) {
    Value<HeadingRange>(module, "HeadingRange",
                        "A maximal range of entry headings that park with the same number of direction changes. Both\n"
                        "ends belong to it.")
        .field(
            "min", [](const HeadingRange& r) { return r.min; }, "[rad]")
        .field(
            "max", [](const HeadingRange& r) { return r.max; }, "[rad]")
        .field(
            "direction_changes", [](const HeadingRange& r) { return r.direction_changes; },
            "What every heading of the range needs.")
        .field(
            "subrange", [](const HeadingRange& r) { return r.subrange; },
            "Ranges that touch share it: the paper's subranges.")
        .finish();
    Value<Answer>(module, "Answer", "What entry(), fewest() or leave() found, and what is proved.")
        .property(
            "parkable", [](const Answer& a) { return a.parkable(); }, "Whether a maneuver was found.")
        .field(
            "cancelled", [](const Answer& a) { return a.cancelled; }, "The progress callback gave up.")
        .field(
            "direction_changes", [](const Answer& a) { return a.direction_changes; },
            "The fewest that a maneuver was found for; None where none was.")
        .field(
            "lower_bound", [](const Answer& a) { return a.lower_bound; },
            "Nothing that was asked about has fewer; more than max_changes: the car cannot park with as many.")
        .field(
            "proved", [](const Answer& a) { return a.proved; },
            "The two meet, or the lower bound exceeds what is allowed.")
        .field(
            "ranges", [](const Answer& a) { return py::tuple(py::cast(a.ranges)); },
            "Of entry(): a tuple of HeadingRange in rising order.")
        .field(
            "undecided",
            [](const Answer& a) {
                py::list parts;
                for (const Headings& part : a.undecided) parts.append(py::make_tuple(part.min, part.max));
                return py::tuple(parts);
            },
            "Of entry(): pairs of headings between which nothing is claimed [rad].")
        .field(
            "maneuver", [](const Answer& a) { return a.maneuver; },
            "One best maneuver: of entry() from the middle of the widest best range, of the others the roomiest found.")
        .field(
            "spacing", [](const Answer& a) { return a.spacing; },
            "Of fewest() and leave(): of the finest lattice that was needed [m]; 0 if none was.")
        .finish();
    define(module,
           "entry(car, slot, *, max_changes=None, min_range=0.0, " + conditions +
               ", strategy=None, prove=True, progress=None)",
           "All entry headings in [0, pi/2] from which the car parks with the fewest direction changes (at most 200),\n"
           "or with every count up to `max_changes`, as exact ranges, and one best maneuver. Returns an Answer.\n\n"
           "`min_range` leaves out ranges of headings narrower than this [rad]; `strategy` is a Stepping, "
           "ReversedTrials or\n"
           "ParallelTrials, None or MaxSteer for full steering until contact. With `prove` it is shown, for full "
           "steering, that no heading\n"
           "is missed; without, the answer comes sooner. `progress` is told the part done (0 to "
           "1) on\n"
           "long questions; returning False gives up. " +
               conditions_meaning,
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               EntryOptions options;
               given.read("max_changes", options.max_changes);
               given.read("min_range", options.min_range);
               given.read_conditions(options);
               given.read("prove", options.prove);
               const auto baseline = given.baseline();
               Progress progress(given.callback("progress"));
               options.progress = [&](double part) { return progress.tell(part); };
               return interruptible(progress, [&] {
                   return baseline ? entry(car, slot, options, *baseline) : entry(car, slot, options);
               });
           });

    Value<Shortfall>(module, "Shortfall", "How much a slot lacks to hold the car at all. [m]")
        .field(
            "length", [](const Shortfall& s) { return s.length; }, "[m], 0 if nothing")
        .field(
            "width", [](const Shortfall& s) { return s.width; }, "[m], 0 if nothing")
        .finish();
    define(module, "shortfall(car, slot, " + driving_parameters + ")",
           "How much the slot lacks to hold the car at all, with the clearance it keeps from front, rear and curb.",
           [](const Arguments& given) {
               Driving driving;
               given.read_driving(driving);
               return shortfall(given.get<Car>("car"), given.get<Slot>("slot"), driving);
           });
}

void define_min_slot(py::module_& module) {
    Value<MinSlot>(module, "MinSlot", "A slot that is just large enough, as far as it is known.")
        .field(
            "max_changes", [](const MinSlot& s) { return s.max_changes; }, "Direction changes allowed.")
        .field(
            "length", [](const MinSlot& s) { return s.length; },
            "[m]; what was asked for is None where nothing within the limits is found to do.")
        .field(
            "width", [](const MinSlot& s) { return s.width; }, "[m], likewise.")
        .field(
            "lower", [](const MinSlot& s) { return s.lower; },
            "Of what was asked for: nothing smaller will do, where that is proved ('fewest', `prove`) [m].")
        .field(
            "open",
            [](const MinSlot& s) {
                py::list open;
                for (const Sizes& sizes : s.open) open.append(py::make_tuple(sizes.min, sizes.max));
                return py::tuple(open);
            },
            "With `prove`: the sizes above `lower` that park as well, or of which nothing is known, as (min, max) [m].")
        .field(
            "entry_heading", [](const MinSlot& s) { return s.entry_heading; },
            "From which the car parks in it with full steering [rad], or None.")
        .field(
            "cancelled", [](const MinSlot& s) { return s.cancelled; }, "The progress callback gave up.")
        .finish();
    define(
        module, "min_slot(car, *, width=None, length=None, max_changes=0, strategy='max-steer', " + min_slot_parameters,
        "The shortest slot of the given `width`, or the narrowest of the given `length` [m], in which the car parks "
        "with\n"
        "at most `max_changes` direction changes, as a MinSlot.\n\n" +
            min_slot_meaning + "`progress` is told the part done; returning False ends with what is known so far.\n\n" +
            conditions_meaning + neighbours_meaning,
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            std::optional<double> width, length;
            given.read("width", width);
            given.read("length", length);
            if (width.has_value() == length.has_value()) throw Error("give either the width or the length of the slot");
            MinSlotOptions options = min_slot_options(given);
            given.read("max_changes", options.max_changes);
            given.read("strategy", options.strategy);
            options.sought = width ? Sought::length : Sought::width;
            Progress progress(given.callback("progress"));
            options.progress = [&](double part) { return progress.tell(part); };
            return interruptible(progress, [&] { return min_slot(car, width ? *width : *length, options); });
        });
}

FewestOptions fewest_options(const Arguments& given) {
    FewestOptions options;
    given.read("max_changes", options.max_changes);
    given.read_conditions(options);
    given.read("resolution", options.resolution);
    std::optional<double> time_limit;
    given.read("time_limit", time_limit);
    if (time_limit) options.time_limit = *time_limit;
    given.read("roomiest", options.roomiest);
    return options;
}

void define_fewest(py::module_& module) {
    Value<FewestProgress>(module, "FewestProgress", "How far a search has got.")
        .field(
            "lower_bound", [](const FewestProgress& p) { return p.lower_bound; }, "Proved so far.")
        .field(
            "direction_changes", [](const FewestProgress& p) { return p.direction_changes; },
            "Demonstrated so far, or None.")
        .field(
            "spacing", [](const FewestProgress& p) { return p.spacing; },
            "Of the finest lattice finished [m]; 0 if none is.")
        .field(
            "part", [](const FewestProgress& p) { return p.part; }, "Of the time limit gone, 0 to 1.")
        .finish();
    const std::string parameters =
        "*, max_changes=200, " + conditions + ", resolution=0.0, time_limit=None, roomiest=True, progress=None)";
    const std::string meaning =
        "`resolution` is the spacing of the finest lattice [m], 0 a ten-thousandth of the car's length; `time_limit` "
        "[s]\n"
        "ends with the bounds found so far; `roomiest=False` takes any maneuver with that many changes. `progress` is\n"
        "told a FewestProgress; returning False ends with the bounds found so far. Returns an Answer.\n\n" +
        conditions_meaning;
    define(
        module, "fewest(car, slot, " + parameters,
        "The smallest number of direction changes with which the car can enter the slot, whatever way it is steered\n"
        "within its limit, with proof.\n\n" +
            meaning,
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const auto slot = given.get<Slot>("slot");
            FewestOptions options = fewest_options(given);
            Progress progress(given.callback("progress"));
            options.progress = [&](const FewestProgress& state) { return progress.tell(state); };
            return interruptible(progress, [&] { return fewest(car, slot, options); });
        });
    define(
        module, "leave(car, slot, pose, " + parameters,
        "The smallest number of direction changes with which a car parked at `pose` (world frame) can leave the slot,\n"
        "with proof.\n\n" +
            meaning,
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const auto slot = given.get<Slot>("slot");
            const auto pose = given.get<Pose>("pose");
            FewestOptions options = fewest_options(given);
            Progress progress(given.callback("progress"));
            options.progress = [&](const FewestProgress& state) { return progress.tell(state); };
            return interruptible(progress, [&] { return leave(car, slot, pose, options); });
        });
    define(
        module, "parked_pose(car, slot, *, front=0.0, curb=0.0, heading=0.0)",
        "Pose in the world of a parked car, by what is left around it: from its foremost point to the front\n"
        "neighbour [m], from its lowest point to the curb [m], and its heading from parallel, positive with the nose\n"
        "away from the curb [rad].",
        [](const Arguments& given) {
            ParkedGaps gaps;
            given.read("front", gaps.front);
            given.read("curb", gaps.curb);
            given.read("heading", gaps.heading);
            return parked_pose(given.get<Car>("car"), given.get<Slot>("slot"), gaps);
        });
}

void define_contact(py::module_& module) {
    Value<Stretch>(module, "Stretch", "A stretch of a move, as distances from its start. [m]")
        .field(
            "start", [](const Stretch& s) { return s.from; }, "[m] (C++: from, which Python keeps for itself)")
        .field(
            "end", [](const Stretch& s) { return s.to; }, "[m] (C++: to)")
        .finish();
    Value<FirstContact>(module, "FirstContact", "What happens on one move with constant steering.")
        .field(
            "distance", [](const FirstContact& f) { return f.distance; },
            "Path of the rear axle centre until contact [m]; 0 when the car touches and would move in, infinity when\n"
            "it never touches anything.")
        .field(
            "contact", [](const FirstContact& f) { return f.contact; }, "A Contact, or None.")
        .field(
            "inside", [](const FirstContact& f) { return f.inside; },
            "The first Stretch of the move, up to the contact, over which the whole frame is inside the slot, or None.")
        .finish();
    define(
        module, "first_contact(car, slot, pose, direction, steering_angle, *, clearance=0.0, curb_clearance=None)",
        "Where a car at `pose` (world frame) that drives 'backward' or 'forward' with `steering_angle` (positive to\n"
        "the left, 0 straight) [rad] first touches the curb or a neighbour, in closed form. Returns a FirstContact.\n"
        "`clearance` [m] grows the frame on every side for contacts, not for being inside; at the curb "
        "`curb_clearance` in its\n"
        "place.",
        [](const Arguments& given) {
            Driving driving;
            given.read("clearance", driving.clearance);
            given.read("curb_clearance", driving.curb_clearance);
            return first_contact(given.get<Car>("car"), given.get<Slot>("slot"), given.get<Pose>("pose"),
                                 given.get<Direction>("direction"), given.get<double>("steering_angle"), driving);
        });
}

}  // namespace

void define_questions(py::module_& module) {
    define_strategies(module);
    define_baselines(module);
    define_entry(module);
    define_min_slot(module);
    define_fewest(module);
    define_contact(module);
}

}  // namespace snug::python
