// Many runs on all cores, and the margin that lets enough of them park.
#include "snug/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

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
constexpr int runs_at_first = 50, runs_then = 200;  ///< that a margin is tried with before all are driven

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

/// The runs with one margin, as many as it takes to say something of it.
class Tried {
public:
    Tried(Assistant assistant, const Street* street, const Pose& start, const DriveOptions& options)
        : assistant_(std::move(assistant)), start_(start), options_(options) {
        answer_.plannable = true;
        answer_.margin = assistant_.map().clearance();
        answer_.planned = assistant_.plan(start);
        if (options.steer == Steer::moving) {
            if (answer_.planned) answer_.standing_changes = answer_.planned->direction_changes();
            answer_.rolling = rolling_plan(assistant_.map(), start, 0.0, options, RollingOptions{}.most_work);
            if (answer_.rolling) answer_.planned = answer_.rolling->in_arcs();
        }
        answer_.planned_changes = answer_.planned ? answer_.planned->direction_changes() : 0;
        answer_.lower_bound = assistant_.map().at(start).lower_bound;
        if (street && !options.blind && (options.errors.slot_place > 0.0 || options.errors.slot_size > 0.0))
            slots_.emplace(assistant_.car(), *street,
                           assistant_options(assistant_.car(), start, answer_.margin, options));
    }

    [[nodiscard]] const DriveAnswer& answer() const { return answer_; }
    [[nodiscard]] DriveAnswer taken() { return std::move(answer_); }

    /// Drives until there are so many runs; those done stay. Each is what its number makes it.
    void drive(int runs) {
        const std::size_t first = answer_.runs.size(), count = static_cast<std::size_t>(runs) - first;
        answer_.runs.resize(first + count);
        SweepOptions sweep;
        sweep.threads = options_.threads;
        if (options_.progress)
            sweep.progress = [&](double part) {
                const double done = static_cast<double>(first) + part * static_cast<double>(count);
                return options_.progress(answer_.margin, static_cast<int>(std::lround(done)));
            };
        Progress progress(sweep, count);
        std::vector<char> done(count, 0);
        on_all_cores(count, sweep, progress, [&](std::size_t i) {
            answer_.runs[first + i] = drive_run(assistant_, slots_ ? &*slots_ : nullptr, start_, options_, first + i,
                                                answer_.rolling ? &*answer_.rolling : nullptr);
            done[i] = 1;
            (void)progress.finished(1);
        });
        answer_.cancelled = progress.given_up();
        if (!answer_.cancelled) return;
        std::size_t kept = first;
        for (std::size_t i = 0; i < count; ++i)
            if (done[i] != 0) std::swap(answer_.runs[kept++], answer_.runs[first + i]);
        answer_.runs.resize(kept);
    }

    /// Whether all of the runs asked for have enough that park. Few are driven at first, and no more once too many have failed:
    /// what the others do would change nothing.
    [[nodiscard]] bool does(int most) {
        if (most > static_cast<int>(answer_.runs.size()) && !answer_.cancelled && !has_failed()) drive(most);
        return most == options_.runs && !answer_.cancelled && !has_failed();
    }
    [[nodiscard]] bool has_failed() const {
        const double may_fail = (1.0 - options_.rate) * options_.runs + 1e-9;
        return static_cast<double>(answer_.runs.size()) - answer_.parked() > may_fail;
    }
    /// On average over the first of its runs.
    [[nodiscard]] double mean_changes(std::size_t of) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < of; ++i) sum += answer_.runs[i].direction_changes;
        return sum / static_cast<double>(of);
    }
    [[nodiscard]] double share() const {
        return static_cast<double>(answer_.parked()) / static_cast<double>(answer_.runs.size());
    }

private:
    Assistant assistant_;
    const Pose start_;
    const DriveOptions& options_;
    std::optional<Slots> slots_;
    DriveAnswer answer_;
};

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
    const auto trying = [&](double margin) {
        std::optional<Assistant> assistant = assistant_with(car, place, start, margin, options);
        return assistant ? std::make_unique<Tried>(std::move(*assistant), street, start, options) : nullptr;
    };
    if (options.margin) {
        const std::unique_ptr<Tried> tried = trying(*options.margin);
        if (tried) {
            tried->drive(options.runs);
            return tried->taken();
        }
        DriveAnswer none;
        none.margin = *options.margin;
        return none;
    }
    std::unique_ptr<Tried> best;
    bool done = false;
    for (const double margin : margins) {
        std::unique_ptr<Tried> tried = trying(margin);
        if (!tried) continue;
        bool does = false;
        // The least that does, or a larger one while that takes fewer changes: over its first runs, and over all.
        bool worth_it = true;
        for (const int runs : {runs_at_first, runs_then, options.runs}) {
            does = tried->does(std::min(runs, options.runs));
            if (tried->answer().cancelled || tried->has_failed()) break;
            const std::size_t count = tried->answer().runs.size();
            worth_it = !done || tried->mean_changes(count) < best->mean_changes(count);
            if (!worth_it) break;
        }
        if (tried->answer().cancelled) return done ? best->taken() : tried->taken();
        if (done && !(does && worth_it)) break;
        if (does || !best || tried->share() > best->share()) best = std::move(tried);
        done = does;
    }
    if (!best) return {};
    // None does: all runs of the one that failed least.
    if (static_cast<int>(best->answer().runs.size()) < options.runs) best->drive(options.runs);
    return best->taken();
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
