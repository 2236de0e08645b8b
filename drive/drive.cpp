// Many runs on all cores, and the margin that lets enough of them park.
#include "snug/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drive/run.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"
#include "snug/limits.hpp"
#include "sweep/tasks.hpp"

namespace snug {
namespace {

/// Margins that are tried, the smallest first: a small one leads to plans with the fewest changes, a large one to fewer that are not
/// planned. [m]
constexpr std::array margins = {0.01, 0.02, 0.025, 0.03, 0.035, 0.04, 0.045, 0.05, 0.06, 0.08, 0.10, 0.12, 0.15, 0.2};
constexpr int runs_tried = 200;

void check(const DriveOptions& options) {
    const CarErrors& errors = options.errors;
    const auto least = [](const char* what, double value, double most, const char* unit) {
        check_between(what, value, 0.0, most, unit);
    };
    least("sensing error of x", errors.sensing.x, 10.0, " m");
    least("sensing error of y", errors.sensing.y, 10.0, " m");
    least("sensing error of the heading", errors.sensing.heading, 1.0, " rad");
    check_between("bias of x", errors.bias.x, -10.0, 10.0, " m");
    check_between("bias of y", errors.bias.y, -10.0, 10.0, " m");
    check_between("bias of the heading", errors.bias.heading, -1.0, 1.0, " rad");
    least("actuation error of the distance", errors.distance, 10.0, " m");
    least("actuation error of the steering", errors.steering, 0.5, " rad");
    least("lag of the steering", errors.lag, 10.0, " s");
    least("error of the slot's place", errors.slot_place, 10.0, " m");
    least("error of the slot's size", errors.slot_size, 10.0, " m");
    if (options.margin) check_between("margin", *options.margin, 0.0, 10.0, " m");
    check_between("rate", options.rate, 0.0, 1.0, "");
    check_between("runs", options.runs, 1.0, 1e6, "");
    (void)trajectory({Car({1.0, 1.0, 0.1, 0.9, 0.5}), {}}, options.limits);
}

AssistantOptions assistant_options(const Car& car, const Pose& start, double margin, const DriveOptions& options) {
    AssistantOptions how;
    how.margin = margin;
    how.steering_reserve = options.blind ? 0.0 : std::min(options.errors.steering, car.max_steer() / 4.0);
    how.heading = start.heading;
    how.spacing = options.spacing;
    return how;
}

/// The plan with a margin; nothing where none fits.
std::optional<Assistant> assistant_with(const Car& car, const Place& place, const Pose& start, double margin,
                                        const DriveOptions& options) {
    try {
        Assistant assistant(car, place, assistant_options(car, start, margin, options));
        const Instruction first = assistant.next(start);
        if (first.what == Instruction::move || first.what == Instruction::parked) return assistant;
    } catch (const Error&) {
        // What counts as parked has no room for such a margin.
    }
    return std::nullopt;
}

bool enough(const DriveAnswer& answer, double rate) {
    return answer.parked() >= rate * static_cast<double>(answer.runs.size());
}

DriveAnswer with(const Assistant& assistant, const Street* street, const Pose& start, int runs,
                 const DriveOptions& options) {
    DriveAnswer answer;
    answer.plannable = true;
    answer.margin = assistant.map().clearance();
    answer.planned = assistant.plan(start);
    answer.planned_changes = answer.planned ? answer.planned->direction_changes() : 0;
    answer.lower_bound = assistant.map().at(start).lower_bound;
    answer.runs.resize(static_cast<std::size_t>(runs));
    SweepOptions sweep;
    sweep.threads = options.threads;
    if (options.progress)
        sweep.progress = [&](double part) {
            return options.progress(answer.margin, static_cast<int>(std::lround(part * runs)));
        };
    Progress progress(sweep, answer.runs.size());
    std::optional<Slots> slots;
    if (street && !options.blind && (options.errors.slot_place > 0.0 || options.errors.slot_size > 0.0))
        slots.emplace(assistant.car(), *street, assistant_options(assistant.car(), start, answer.margin, options));
    std::vector<char> done(answer.runs.size(), 0);
    on_all_cores(answer.runs.size(), sweep, progress, [&](std::size_t run) {
        answer.runs[run] = drive_run(assistant, slots ? &*slots : nullptr, start, options, run);
        done[run] = 1;
        (void)progress.finished(1);
    });
    answer.cancelled = progress.given_up();
    if (answer.cancelled) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < done.size(); ++i)
            if (done[i] != 0) std::swap(answer.runs[kept++], answer.runs[i]);
        answer.runs.resize(kept);
    }
    return answer;
}

DriveAnswer drive_all(const Car& car, const Place& place, const Street* street, const Pose& start,
                      const DriveOptions& options) {
    check(options);
    const std::vector<PlaceGap> room = gaps(car, place, start);
    for (std::size_t i = 0; i < room.size(); ++i)
        if (room[i].distance < -1e-9)
            throw Error("the car starts in contact with " + place.name_of(i) + ", " + spelled(-room[i].distance) +
                        " m deep; move it away");
    const std::vector<Point>& region = place.region();
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Point &a = region[i], &b = region[(i + 1) % region.size()];
        if ((b.x - a.x) * (start.y - a.y) - (b.y - a.y) * (start.x - a.x) < 0.0)
            throw Error(
                "the rear axle's middle starts outside the region; start elsewhere, or give a larger one (of a street: "
                "--stretch)");
    }
    if (options.margin) {
        const std::optional<Assistant> assistant = assistant_with(car, place, start, *options.margin, options);
        if (!assistant) {
            DriveAnswer none;
            none.margin = *options.margin;
            return none;
        }
        return with(*assistant, street, start, options.runs, options);
    }
    DriveAnswer best;
    double best_share = -1.0;
    std::optional<Assistant> best_assistant;
    bool done = false;
    for (const double margin : margins) {
        std::optional<Assistant> assistant = assistant_with(car, place, start, margin, options);
        if (!assistant) continue;
        DriveAnswer tried = with(*assistant, street, start, std::min(options.runs, runs_tried), options);
        if (!tried.cancelled && enough(tried, options.rate) && options.runs > runs_tried)
            tried = with(*assistant, street, start, options.runs, options);
        if (tried.cancelled) return done ? best : tried;
        const double share = static_cast<double>(tried.parked()) / static_cast<double>(tried.runs.size());
        // The least that does, or a larger one while that takes fewer changes.
        const bool does = enough(tried, options.rate);
        if (done && !(does && tried.totals().mean_changes < best.totals().mean_changes)) break;
        if (does || share > best_share) {
            best_share = share;
            best = std::move(tried);
            best_assistant = std::move(assistant);
        }
        done = does;
    }
    if (best_assistant && static_cast<int>(best.runs.size()) < options.runs)
        best = with(*best_assistant, street, start, options.runs, options);
    return best;
}

}  // namespace

DriveAnswer drive_runs(const Car& car, const Place& place, const Pose& start, const DriveOptions& options) {
    if (options.errors.slot_place > 0.0 || options.errors.slot_size > 0.0)
        throw Error("errors of the slot's place and size are of a street's slot; set them to 0 in any other place");
    return drive_all(car, place, nullptr, start, options);
}

DriveAnswer drive_runs(const Car& car, const Street& street, const Pose& start, const DriveOptions& options) {
    return drive_all(car, street_place(street), &street, start, options);
}

}  // namespace snug
