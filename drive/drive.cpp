// Many runs on all cores, and the margin that lets enough of them park.
#include "snug/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

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

/// The runs with one margin, as many as it takes to say something of it. A margin that is looked for is chosen by other runs than
/// those that are told, which come after them: of many the one that does best has had luck, too.
class Tried {
public:
    Tried(Assistant assistant, const Street* street, const Pose& start, const DriveOptions& options)
        : assistant_(std::move(assistant)),
          start_(start),
          options_(options),
          choosing_(options.margin ? 0 : static_cast<std::size_t>(options.runs)) {
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
    [[nodiscard]] std::size_t driven() const { return answer_.runs.size(); }
    [[nodiscard]] DriveAnswer taken() {
        if (answer_.runs.size() > choosing_)
            answer_.runs.erase(answer_.runs.begin(), answer_.runs.begin() + static_cast<std::ptrdiff_t>(choosing_));
        return std::move(answer_);
    }

    /// Drives until there are so many runs, and all that are told; those done stay. Each is what its number makes it.
    void drive_all() { drive(static_cast<int>(choosing_) + options_.runs); }
    void drive(int runs) {
        const std::size_t first = answer_.runs.size(), count = static_cast<std::size_t>(runs) - first;
        answer_.runs.resize(first + count);
        SweepOptions sweep;
        sweep.threads = options_.threads;
        if (options_.progress)
            sweep.progress = [&](double part) {
                const double done = static_cast<double>(first) + part * static_cast<double>(count);
                const double all = options_.runs;
                return options_.progress(answer_.margin, static_cast<int>(std::lround(done > all ? done - all : done)));
            };
        Progress progress(sweep, count);
        std::vector<char> done(count, 0);
        on_all_cores(count, sweep, progress, [&](std::size_t i) {
            const std::size_t number = choosing_ == 0 ? first + i : (first + i + choosing_) % (2 * choosing_);
            answer_.runs[first + i] = drive_run(assistant_, slots_ ? &*slots_ : nullptr, start_, options_, number,
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

    /// Too many of those it is chosen by, or of those that are told.
    [[nodiscard]] bool has_failed() const {
        const double may_fail = (1.0 - options_.rate) * options_.runs + 1e-9;
        int failed = 0;
        for (std::size_t i = 0; i < answer_.runs.size(); ++i) {
            if (i == choosing_) failed = 0;
            failed += answer_.runs[i].parked ? 0 : 1;
            if (failed > may_fail) return true;
        }
        return false;
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
    const std::size_t choosing_;  ///< so many of its runs are for, the first
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
            tried->drive_all();
            return tried->taken();
        }
        DriveAnswer none;
        none.margin = *options.margin;
        return none;
    }
    std::vector<std::unique_ptr<Tried>> found;  // those that do, each with fewer changes than the one before
    std::unique_ptr<Tried> failed;              // least
    for (const double margin : margins) {
        std::unique_ptr<Tried> tried = trying(margin);
        if (!tried) continue;
        // Few runs are driven at first, and no more of one that has failed or takes more changes.
        bool better = true;
        for (const int runs : {runs_at_first, runs_then, options.runs}) {
            tried->drive(std::min(runs, options.runs));
            if (tried->answer().cancelled) return found.empty() ? tried->taken() : found.back()->taken();
            better = !tried->has_failed() && (found.empty() || tried->mean_changes(tried->driven()) <
                                                                   found.back()->mean_changes(tried->driven()));
            if (!better) break;
        }
        if (better)
            found.push_back(std::move(tried));
        else if (found.empty() && (!failed || tried->share() > failed->share()))
            failed = std::move(tried);
    }
    for (; !found.empty(); found.pop_back()) {
        found.back()->drive_all();
        if (!found.back()->has_failed()) return found.back()->taken();
        failed = std::move(found.back());
    }
    if (!failed) return {};
    failed->drive_all();
    return failed->taken();
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
