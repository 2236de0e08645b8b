// One question about one slot at a time.
#include <pybind11/stl.h>

#include "module.hpp"
#include "progress.hpp"
#include "value.hpp"

namespace snug::python {

namespace {

MaxSteerOptions max_steer_options(const Arguments& given) {
    MaxSteerOptions options;
    given.read("max_changes", options.max_changes);
    given.read_conditions(options);
    return options;
}

/// As max_steer_options() reads them.
const std::string run_parameters = "*, max_changes: int = 200, " + conditions + ")";

AskedRun asked_run(const Slot& slot, MaxSteerRun run) { return {run.outcome, std::move(run.maneuver), slot}; }

void define_strategies(py::module_& module) {
    const Signature max_steer_signature("MaxSteer()");
    Value<MaxSteer>(module, "MaxSteer", max_steer_signature.docstring("Full steering until contact, exactly."))
        .constructor(max_steer_signature, [](const Arguments&) { return MaxSteer{}; })
        .finish();

    const Signature stepping_signature("Stepping(*, step: float = 0.001, heading_step: float = 0.0001, stop: " +
                                       literal<StopRule>() + " = 'contact')");
    Value<Stepping>(module, "Stepping",
                    stepping_signature.docstring(
                        "Algorithm 1 of the paper as printed: Euler steps of equation 1, the reference.\n\n"
                        "`step` is the path of one Euler step [m], 1e-7 to 1, and `heading_step` lies between\n"
                        "neighbouring entry headings [rad], 1e-6 to pi/2. It looks whether the car is parked after\n"
                        "every step (`stop` 'inside') or only when a move ends in contact ('contact', as printed)."))
        .field("step", &Stepping::step, "Path of one Euler step [m]")
        .field("heading_step", &Stepping::heading_step, "Between entry headings [rad]")
        .field("stop", &Stepping::stop, "'contact' or 'inside'")
        .constructor(stepping_signature,
                     [](const Arguments& given) {
                         Stepping made;
                         given.read("step", made.step);
                         given.read("heading_step", made.heading_step);
                         given.read("stop", made.stop);
                         return made;
                     })
        .finish();

    const Signature reversed_signature("ReversedTrials(*, goal: " + pose_type +
                                       " | None = None, first: " + literal<Direction>() + " = 'forward')");
    Value<ReversedTrials>(module, "ReversedTrials",
                          reversed_signature.docstring(
                              "Several reversed trials (Vorobieva et al. 2015): driven out of the slot from a goal,\n"
                              "with full steering until contact, and then the same the other way round.\n\n"
                              "`goal` is a Pose in the world, or None for the one the paper deduces; `first` is the\n"
                              "direction of the first move out."))
        .field("goal", &ReversedTrials::goal, "A Pose, or None for the deduced one.")
        .field("first", &ReversedTrials::first, "Direction of the first move out.")
        .constructor(reversed_signature,
                     [](const Arguments& given) {
                         ReversedTrials made;
                         given.read("goal", made.goal);
                         given.read("first", made.first);
                         return made;
                     })
        .finish();

    const Signature parallel_signature("ParallelTrials(*, goal: " + pose_type + " | None = None)");
    Value<ParallelTrials>(
        module, "ParallelTrials",
        parallel_signature.docstring(
            "Several parallel trials (Vorobieva et al. 2015): parallel to the slot at every direction\n"
            "change. `goal` is a Pose in the world, or None for any parallel one inside."))
        .field("goal", &ParallelTrials::goal, "A Pose, or None for any parallel one inside.")
        .constructor(parallel_signature,
                     [](const Arguments& given) {
                         ParallelTrials made;
                         given.read("goal", made.goal);
                         return made;
                     })
        .finish();
}

void define_baselines(py::module_& module) {
    Value<AskedRun>(module, "MaxSteerRun", "How a run of the strategy went.")
        .field("outcome", &AskedRun::outcome,
               "'parked'; 'no_entry': no possible entry position; 'stuck': in contact both ways; 'never_touches':\n"
               "turned away, nose to the curb, before it was inside; 'too_many_changes'.")
        .field("maneuver", &AskedRun::maneuver, "The moves driven, however the run ended; none for 'no_entry'.",
               "Maneuver")
        .field("slot", &AskedRun::slot, "The slot asked about.", "Slot")
        .said([](const AskedRun& r) {
            return "MaxSteerRun: " + std::string(word(r.outcome)) + ", " +
                   counted(r.maneuver->direction_changes(), "direction change");
        })
        .picture([](const AskedRun& r) { return picture(r); })
        .finish();
    define(module, "max_steer(car: Car, slot: Slot, heading: float, " + run_parameters + " -> MaxSteerRun",
           "Drives the paper's strategy, full steering until contact, from the entry position with that heading.\n\n"
           "`heading` [rad] in [0, pi/2] is measured from the parallel heading, positive with the nose (entering\n"
           "'forward': the tail) away from the slot. Returns a MaxSteerRun.\n\n" +
               conditions_meaning,
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               const auto heading = given.get<double>("heading");
               const MaxSteerOptions options = max_steer_options(given);
               return asked_run(slot, released([&] { return max_steer(car, slot, heading, options); }));
           });
    define(module,
           "stepping(car: Car, slot: Slot, heading: float, steps: Stepping | None = None, " + run_parameters +
               " -> MaxSteerRun",
           "Algorithm 1 of the paper from one entry heading [rad]; `steps` is a Stepping, None the default one.\n"
           "Returns a MaxSteerRun.",
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               const auto heading = given.get<double>("heading");
               std::optional<Stepping> steps;
               given.read("steps", steps);
               const MaxSteerOptions options = max_steer_options(given);
               return asked_run(
                   slot, released([&] { return stepping(car, slot, heading, steps.value_or(Stepping{}), options); }));
           });
    define(module,
           "reversed_trials(car: Car, slot: Slot, trials: ReversedTrials | None = None, " + run_parameters +
               " -> Maneuver | None",
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
    define(module,
           "parallel_trials(car: Car, slot: Slot, trials: ParallelTrials | None = None, " + run_parameters +
               " -> Maneuver | None",
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
        .field("deduced", &ReversedTrialsByGoal::deduced, "From the goal the paper deduces.")
        .field("found", &ReversedTrialsByGoal::found, "From the goal of the best maneuver.")
        .table()
        .finish();
    define(module, "reversed_trials_by_goal(car: Car, slot: Slot, max_changes: int = 200) -> ReversedTrialsByGoal",
           "What the paper's choice of a goal costs in one slot (its section 4.1).", [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               const auto slot = given.get<Slot>("slot");
               int max_changes = 200;
               given.read("max_changes", max_changes);
               return released([&] { return reversed_trials_by_goal(car, slot, max_changes); });
           });
    define(module, "blackburn_extra_length(car: Car, neighbour_width: float) -> float",
           "Length that a slot must have beyond the car's for the car to back into it in one go, after Blackburn's\n"
           "formula of 2009, with the width of the car parked in front. [m]",
           [](const Arguments& given) {
               return blackburn_extra_length(given.get<Car>("car"), given.get<double>("neighbour_width"));
           });
}

/// With what was asked about.
AskedAnswer asked_answer(const Arguments& given, Answer answer) {
    AskedAnswer asked;
    static_cast<Answer&>(asked) = std::move(answer);
    asked.car = given.get<Car>("car");
    asked.slot = given.get<Slot>("slot");
    given.read("max_changes", asked.max_changes);
    given.read_driving(asked.driving);
    given.read("parked_heading", asked.parked_heading);
    given.read("parked_curb", asked.parked_curb);
    return asked;
}

/// A range of numbers by its ends, which are also its two elements.
template <class Range>
void define_range(py::module_& module, const char* name, const char* documentation, const char* unit) {
    const auto both = [](const Range& range) { return py::make_tuple(range.min, range.max); };
    Value<Range>(module, name, documentation)
        .field("min", &Range::min, unit)
        .field("max", &Range::max, unit)
        .finish()
        .def("__iter__", [both](const Range& range) { return py::iter(both(range)); })
        .def("__len__", [](const Range&) { return 2; })
        .def("__getitem__",
             [both](const Range& range, const py::object& i) { return both(range).attr("__getitem__")(i); });
}

void define_entry(py::module_& module) {
    define_range<Headings>(module, "Headings", "Headings from `min` to `max`, both included: its two elements.",
                           "[rad]");
    Value<HeadingRange>(module, "HeadingRange",
                        "A maximal range of entry headings that park with the same number of direction changes. Both\n"
                        "ends belong to it.")
        .field("min", &HeadingRange::min, "[rad]")
        .field("max", &HeadingRange::max, "[rad]")
        .field("direction_changes", &HeadingRange::direction_changes, "What every heading of the range needs.")
        .field("subrange", &HeadingRange::subrange, "Ranges that touch share it: the paper's subranges.")
        .finish();
    Value<StartTolerance>(
        module, "StartTolerance",
        "How far off the entry position the car may stand when full steering begins, its heading as it\n"
        "should be: along the slot towards the other neighbour, and out into the road. Every start up to\n"
        "there parks with no more direction changes: proved.")
        .field("heading", &StartTolerance::heading, "Of the entry position, off parallel [rad].")
        .field("direction_changes", &StartTolerance::direction_changes, "From the entry position.")
        .field("along", &StartTolerance::along, "Farther along by at most this, no farther out [m].")
        .field("out", &StartTolerance::out, "Farther out by at most this, no farther along [m].")
        .field("both_along", &StartTolerance::both_along, "Farther along by at most this [m],")
        .field("both_out", &StartTolerance::both_out, "and at once farther out by at most this [m].")
        .finish();
    Value<AskedAnswer>(module, "Answer", "What entry(), fewest(), leave() or an Atlas found, and what is proved.")
        .property("parkable", &AskedAnswer::parkable, "Whether a maneuver was found.")
        .field("cancelled", &AskedAnswer::cancelled,
               "The progress callback gave up; of an Atlas: it does not know whether the car parks.")
        .field("direction_changes", &AskedAnswer::direction_changes,
               "The fewest that a maneuver was found for; None where none was.")
        .field("lower_bound", &AskedAnswer::lower_bound,
               "Nothing that was asked about has fewer; more than max_changes: the car cannot park with as many.")
        .field("proved", &AskedAnswer::proved, "The two meet, or the lower bound exceeds what is allowed.")
        .field("ranges", &AskedAnswer::ranges, "Of entry(): in rising order.")
        .field("undecided", &AskedAnswer::undecided,
               "Of entry(): Headings of which nothing is claimed; nearly always none.")
        .field(
            "maneuver", &AskedAnswer::maneuver,
            "One best maneuver: of entry() from the middle of the widest best range, of the others the roomiest found.")
        .property("any_maneuver", &AskedAnswer::any_maneuver,
                  "Where the strategy of entry() cannot park: what any maneuver can, as fewest() answers within two "
                  "seconds;\n"
                  "None where it parks, and where that is beyond the search. Looked for when first asked.")
        .property(
            "start_tolerance", &AskedAnswer::start_tolerance,
            "Of entry() by full steering: how far the start of the maneuver may be off; None of any other. Looked "
            "for when\nfirst asked.")
        .field("spacing", &AskedAnswer::spacing,
               "Of fewest() and leave(): of the finest lattice that was needed [m]; 0 if none was.")
        .field("cell", &AskedAnswer::cell, "Of an Atlas: length and width of the stored slot [m].")
        .field("car", &AskedAnswer::car, "The car asked about.", "Car")
        .field("slot", &AskedAnswer::slot, "The slot asked about.", "Slot")
        .field("strategy", &AskedAnswer::strategy, "As the command calls it: 'max-steer', 'fewest', ...")
        .field("leaving", &AskedAnswer::leaving, "Of leave(): out of the slot.")
        .field("max_changes", &AskedAnswer::max_changes, "As asked.")
        .field(
            "clearance", [](auto& a) -> auto& { return a.driving.clearance; }, "As asked [m].")
        .field(
            "curb_clearance", [](auto& a) -> auto& { return a.driving.curb_clearance; }, "As asked [m].")
        .field(
            "enter", [](auto& a) -> auto& { return a.driving.enter; }, "As asked.")
        .field("parked_heading", &AskedAnswer::parked_heading, "As asked [rad].")
        .field("parked_curb", &AskedAnswer::parked_curb, "As asked [m].")
        .field("prove", &AskedAnswer::prove, "Of entry(): as asked.")
        .said([](const AskedAnswer& a) {
            std::string text = "Answer: " + (a.car->name().empty() ? "a car" : a.car->name()) +
                               (a.leaving ? " out of " : " in ") + few_digits(a.slot->length()) + " x " +
                               few_digits(a.slot->width()) + " m, ";
            text += a.direction_changes ? counted(*a.direction_changes, "direction change")
                    : a.cancelled       ? "undecided"
                    : a.leaving         ? "cannot leave"
                                        : "cannot park";
            return text + (a.proved ? ", proved" : "");
        })
        .picture([](const AskedAnswer& a) { return picture(a); })
        .finish();
    define(module,
           "entry(car: Car, slot: Slot, *, max_changes: int | None = None, min_range: float = 0.0, " + conditions +
               ", " + baseline_parameter + ", prove: bool = True, " + progress_parameter + ") -> Answer",
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
               AskedAnswer asked =
                   asked_answer(given, interruptible(progress, [&] {
                                    return baseline ? entry(car, slot, options, *baseline) : entry(car, slot, options);
                                }));
               asked.strategy = baseline ? to_string(*baseline) : to_string(Strategy::max_steer);
               asked.prove = options.prove && !baseline;
               return asked;
           });

    Value<Shortfall>(module, "Shortfall", "How much a slot lacks to hold the car at all. [m]")
        .field("length", &Shortfall::length, "[m], 0 if nothing")
        .field("width", &Shortfall::width, "[m], 0 if nothing")
        .table()
        .finish();
    define(module, "shortfall(car: Car, slot: Slot, " + driving_parameters + ") -> Shortfall",
           "How much the slot lacks to hold the car at all, with the clearance it keeps from front, rear and curb.",
           [](const Arguments& given) {
               Driving driving;
               given.read_driving(driving);
               return shortfall(given.get<Car>("car"), given.get<Slot>("slot"), driving);
           });
}

void define_min_slot(py::module_& module) {
    define_range<Sizes>(module, "Sizes", "Sizes from `min` to `max`, both included: its two elements.", "[m]");
    Value<AskedMinSlot>(module, "MinSlot", "A slot that is just large enough, as far as it is known.")
        .field("max_changes", &AskedMinSlot::max_changes, "Direction changes allowed.")
        .field("length", &AskedMinSlot::length,
               "[m]; what was asked for is None where nothing within the limits is found to do.")
        .field("width", &AskedMinSlot::width, "[m], likewise.")
        .field("lower", &AskedMinSlot::lower,
               "Of what was asked for: nothing smaller will do, where that is proved ('fewest', `prove`) [m].")
        .field("open", &AskedMinSlot::open,
               "With `prove`: the Sizes above `lower` that park as well, or of which nothing is known.")
        .field("entry_heading", &AskedMinSlot::entry_heading,
               "From which the car parks in it with full steering [rad], or None.")
        .field("cancelled", &AskedMinSlot::cancelled, "The progress callback gave up.")
        .field("car", &AskedMinSlot::car, "The car asked about.", "Car")
        .field("strategy", &AskedMinSlot::strategy, "As asked.")
        .field("prove", &AskedMinSlot::prove, "As asked.")
        .field("sought", &AskedMinSlot::sought, "What was asked for.")
        .field(
            "clearance", [](auto& s) -> auto& { return s.driving.clearance; }, "As asked [m].")
        .field(
            "curb_clearance", [](auto& s) -> auto& { return s.driving.curb_clearance; }, "As asked [m].")
        .field(
            "enter", [](auto& s) -> auto& { return s.driving.enter; }, "As asked.")
        .field("parked_heading", &AskedMinSlot::parked_heading, "As asked [rad].")
        .field("parked_curb", &AskedMinSlot::parked_curb, "As asked [m].")
        .field("front_setback", &AskedMinSlot::front_setback, "As asked [m].")
        .field("rear_setback", &AskedMinSlot::rear_setback, "As asked [m].")
        .field("curb", &AskedMinSlot::curb, "As asked.")
        .said([](const AskedMinSlot& s) {
            const auto size = [](const std::optional<double>& metres) { return metres ? few_digits(*metres) : "-"; };
            return "MinSlot: " + (s.car->name().empty() ? "a car" : s.car->name()) + " with " +
                   counted(s.max_changes, "direction change") + ", " + size(s.length) + " x " + size(s.width) + " m";
        })
        .picture([](const AskedMinSlot& s) { return picture(s); })
        .finish();
    define(module,
           "min_slot(car: Car, *, width: float | None = None, length: float | None = None, max_changes: int = 0, "
           "strategy: " +
               literal<Strategy>() + " = 'max-steer', " + min_slot_parameters + " -> MinSlot",
           "The shortest slot of the given `width`, or the narrowest of the given `length` [m], in which the car parks "
           "with\n"
           "at most `max_changes` direction changes, as a MinSlot.\n\n" +
               min_slot_meaning +
               "`progress` is told the part done; returning False ends with what is known so far.\n\n" +
               conditions_meaning + neighbours_meaning,
           [](const Arguments& given) {
               const auto car = given.get<Car>("car");
               std::optional<double> width, length;
               given.read("width", width);
               given.read("length", length);
               if (width.has_value() == length.has_value())
                   throw Error("give either the width or the length of the slot");
               MinSlotOptions options = min_slot_options(given);
               given.read("max_changes", options.max_changes);
               given.read("strategy", options.strategy);
               options.sought = width ? Sought::length : Sought::width;
               Progress progress(given.callback("progress"));
               options.progress = [&](double part) { return progress.tell(part); };
               AskedMinSlot asked;
               static_cast<MinSlot&>(asked) =
                   interruptible(progress, [&] { return min_slot(car, width ? *width : *length, options); });
               asked.car = car;
               asked.strategy = options.strategy;
               asked.prove = options.prove;
               asked.sought = options.sought;
               asked.driving = options.driving;
               given.read("parked_heading", asked.parked_heading);
               given.read("parked_curb", asked.parked_curb);
               given.read_neighbours(asked);
               return asked;
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
        .field("lower_bound", &FewestProgress::lower_bound, "Proved so far.")
        .field("direction_changes", &FewestProgress::direction_changes, "Demonstrated so far, or None.")
        .field("spacing", &FewestProgress::spacing, "Of the finest lattice finished [m]; 0 if none is.")
        .field("part", &FewestProgress::part, "Of the time limit gone, 0 to 1.")
        .finish();
    const std::string parameters =
        "*, max_changes: int = 200, " + conditions +
        ", resolution: float = 0.0, time_limit: float | None = None, roomiest: bool = True, " +
        search_progress_parameter + ") -> Answer";
    const std::string meaning =
        "`resolution` is the spacing of the finest lattice [m], 0 a ten-thousandth of the car's length; `time_limit` "
        "[s]\n"
        "ends with the bounds found so far; `roomiest=False` takes any maneuver with that many changes. `progress` is\n"
        "told a FewestProgress; returning False ends with the bounds found so far. Returns an Answer.\n\n" +
        conditions_meaning;
    define(
        module, "fewest(car: Car, slot: Slot, " + parameters,
        "The smallest number of direction changes with which the car can enter the slot, whatever way it is steered\n"
        "within its limit, with proof.\n\n" +
            meaning,
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const auto slot = given.get<Slot>("slot");
            FewestOptions options = fewest_options(given);
            Progress progress(given.callback("progress"));
            options.progress = [&](const FewestProgress& state) { return progress.tell(state); };
            AskedAnswer asked =
                asked_answer(given, interruptible(progress, [&] { return fewest(car, slot, options); }));
            asked.strategy = to_string(Strategy::fewest);
            return asked;
        });
    define(
        module, "leave(car: Car, slot: Slot, pose: " + pose_type + ", " + parameters,
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
            AskedAnswer asked =
                asked_answer(given, interruptible(progress, [&] { return leave(car, slot, pose, options); }));
            asked.strategy = to_string(Strategy::fewest);
            asked.leaving = true;
            return asked;
        });
    define(
        module,
        "parked_pose(car: Car, slot: Slot, *, front: float = 0.0, curb: float = 0.0, heading: float = 0.0) -> Pose",
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
        .field("start", &Stretch::from, "[m] (C++: from, which Python keeps for itself)")
        .field("end", &Stretch::to, "[m] (C++: to)")
        .finish();
    Value<FirstContact>(module, "FirstContact", "What happens on one move with constant steering.")
        .field(
            "distance", &FirstContact::distance,
            "Path of the rear axle centre until contact [m]; 0 when the car touches and would move in, infinity when\n"
            "it never touches anything.")
        .field("contact", &FirstContact::contact, "A Contact, or None.")
        .field(
            "inside", &FirstContact::inside,
            "The first Stretch of the move, up to the contact, over which the whole frame is inside the slot, or None.")
        .table()
        .finish();
    define(
        module,
        "first_contact(car: Car, slot: Slot, pose: " + pose_type + ", direction: " + literal<Direction>() +
            ", steering_angle: float, *, " + clearance_parameters + ") -> FirstContact",
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
