// Building a database: what is missing is given out row by row, and answers are committed several times a second.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <system_error>
#include <utility>

#include "atlas/damage.hpp"
#include "atlas/format.hpp"
#include "checksum.hpp"
#include "schema.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/atlas_database.hpp"
#include "snug/limits.hpp"
#include "snug/version.hpp"
#include "sqlite.hpp"

namespace snug {

namespace {

using Clock = std::chrono::steady_clock;

/// Keeps a second build out: a lock on a byte far behind any database's end, which ends with the process.
class BuildLock {
public:
    explicit BuildLock(const std::string& path) {
        struct stat status = {};
        if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
            throw Error(in_quotes(path) + " is no file; give a database, or a new name for one");
        descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0)
            throw Error(in_quotes(path) + " cannot be written: " + std::generic_category().message(errno) +
                        "; give a file in a folder that exists and is writable");
        struct flock lock = {};
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        lock.l_start = off_t{1} << 61;
        lock.l_len = 1;
        if (fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
        // Left open: closing it would also drop SQLite's locks, should it be this process that builds.
        if (errno == EAGAIN || errno == EACCES)
            throw Error(in_quotes(path) +
                        " is being built by another process; wait for it, or stop it, then ask again");
        throw Error(in_quotes(path) + " cannot be locked: " + std::generic_category().message(errno) +
                    "; give a file on a file system with locks");
    }
    /// After the database is closed, for the same reason.
    ~BuildLock() { close(descriptor_); }
    /// Whether the file is still where it was.
    [[nodiscard]] bool holds(const std::string& path) const {
        struct stat here = {};
        struct stat there = {};
        return fstat(descriptor_, &here) == 0 && stat(path.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
               here.st_ino == there.st_ino;
    }
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

private:
    int descriptor_ = -1;
};

void check_plan(const AtlasPlan& plan) {
    if (plan.cars.empty()) throw Error("an atlas needs a car; name one");
    for (std::size_t i = 0; i < plan.cars.size(); ++i) {
        const std::string& name = plan.cars[i].name();
        if (name.empty())
            throw Error("car [" + std::to_string(i) + "] of the atlas has no name, by which it is found; give it one");
        const auto same = [&](const Car& car) { return car.name() == name; };
        if (std::count_if(plan.cars.begin(), plan.cars.end(), same) > 1)
            throw Error("two cars of the atlas are called " + in_quotes(name) + "; give each a name of its own");
    }
    if (plan.widths.empty() || plan.lengths.empty()) throw Error("an atlas needs widths and lengths of slots");
    for (const double width : plan.widths) check_between("slot width", width, limits::shortest, limits::longest, " m");
    for (const double length : plan.lengths)
        check_between("slot length", length, limits::shortest, limits::longest, " m");
    const double cells = static_cast<double>(plan.cars.size()) * static_cast<double>(plan.widths.size()) *
                         static_cast<double>(plan.lengths.size());
    if (cells > static_cast<double>(atlas_format::most_cells))
        throw Error("an atlas of " + spelled(cells) + " cells is too large; it has at most 2^40, so take larger steps");
}

/// "1.8 to 2.4 m"
std::string extent(const std::vector<double>& sizes) {
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    return spelled(*least) + " to " + spelled(*most) + " m";
}

/// The options of a question, one after the other, as a person would say them.
std::vector<std::pair<std::string, std::string>> in_words(const AtlasOptions& options) {
    return {{"strategy", std::string(to_string(options.strategy))},
            {"maximum of direction changes", options.max_changes ? std::to_string(*options.max_changes) : "none given"},
            {"least range of headings", spelled(options.min_range) + " rad"},
            {"resolution", options.resolution > 0.0 ? spelled(options.resolution) + " m" : "none given"},
            {"clearance", spelled(options.driving.clearance) + " m"},
            {"way in", options.driving.enter == Enter::backward ? "backward" : "forward"}};
}

/// Throws Error unless answers to the plan may join those that are stored.
void check_goes_together(const StoredPlan& stored, const AtlasPlan& plan, const std::string& path) {
    const std::string file = in_quotes(path);
    if (stored.made_by != SNUG_VERSION)
        throw Error(file + " holds answers of snug " + stored.made_by + ", and those of " + SNUG_VERSION +
                    " may differ; go on with that version, or build another file");
    const auto held = in_words(stored.plan.options);
    const auto asked = in_words(plan.options);
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i].second != asked[i].second)
            throw Error(file + " was built with another " + held[i].first + ": " + held[i].second + ", not " +
                        asked[i].second + "; ask for the same, or build another file");
    const auto check_sizes = [&](const char* what, const std::vector<double>& old, const std::vector<double>& sizes) {
        const auto kept = [&](double size) { return std::find(sizes.begin(), sizes.end(), size) != sizes.end(); };
        const auto lost = std::find_if_not(old.begin(), old.end(), kept);
        if (lost != old.end())
            throw Error(file + " has the " + what + ' ' + spelled(*lost) +
                        " m, which is not among the new ones; ask for all it has, " + extent(old) +
                        ", and more, or build another file");
    };
    check_sizes("width", stored.plan.widths, plan.widths);
    check_sizes("length", stored.plan.lengths, plan.lengths);
    for (const Car& car : plan.cars) {
        const auto same_name = [&](const Car& old) { return old.name() == car.name(); };
        const auto old = std::find_if(stored.plan.cars.begin(), stored.plan.cars.end(), same_name);
        if (old == stored.plan.cars.end()) continue;
        if (*old != car)
            throw Error(file + " has another car called " + in_quotes(car.name()) + "; give this one another name");
    }
}

void add_missing(const Connection& connection, const AtlasPlan& plan) {
    Statement car(
        connection,
        "INSERT OR IGNORE INTO car (name, width, front, rear, wheelbase, max_steer) VALUES (?, ?, ?, ?, ?, ?)");
    Statement corner(connection, "INSERT OR IGNORE INTO outline_corner SELECT id, ?, ?, ? FROM car WHERE name = ?");
    for (const Car& each : plan.cars) {
        car.run(std::string_view(each.name()), each.width(), each.front(), each.rear(), each.wheelbase(),
                each.max_steer());
        if (each.is_rectangle()) continue;
        int number = 0;
        for (const Point& point : each.outline().corners())
            corner.run(number++, point.x, point.y, std::string_view(each.name()));
    }
    Statement width(connection, "INSERT OR IGNORE INTO slot_width VALUES (?)");
    for (const double each : plan.widths) width.run(each);
    Statement length(connection, "INSERT OR IGNORE INTO slot_length VALUES (?)");
    for (const double each : plan.lengths) length.run(each);
}

/// How many cells a batch has: enough that handing it out costs nothing beside solving it.
std::size_t batch_size(const AtlasOptions& options) { return options.strategy == Strategy::fewest ? 1 : 32; }

}  // namespace

struct AtlasBuild::State {
    State(const std::string& name, const AtlasPlan& asked)
        : path(name), lock(name), connection(open_database(name, true)), stored(prepare(asked)) {
        plan = stored.plan;
        progress.cells = count_cells(plan);
        Statement count(connection, "SELECT count(*) FROM cell");
        count.row();
        progress.stored = committed = static_cast<std::uint64_t>(count.integer(0));
        if (progress.stored > progress.cells) throw damaged(path, too_many_cells(progress.stored, progress.cells));
    }

    /// Makes the tables, or checks that the plan goes with them, and adds what is new: all of it or nothing.
    StoredPlan prepare(const AtlasPlan& asked) {
        const bool is_new = is_empty(connection);
        connection.run("BEGIN IMMEDIATE");
        if (is_new) {
            create_tables(connection, asked.options);
        } else {
            check_goes_together(read_plan(connection, path), asked, path);
        }
        add_missing(connection, asked);
        connection.run("COMMIT");
        return read_plan(connection, path);
    }

    /// The lengths of one car and one width that are not stored.
    std::vector<double> missing_in_row() {
        std::vector<double> there;
        row.with(stored.car_ids[car], plan.widths[width]);
        while (row.row()) there.push_back(row.real(0));
        std::vector<double> rest;
        std::set_difference(plan.lengths.begin(), plan.lengths.end(), there.begin(), there.end(),
                            std::back_inserter(rest));
        return rest;
    }

    void insert(std::size_t of_car, double slot_width, double slot_length, const CellAnswer& answer) {
        const bool has_entry = !answer.moves.empty();
        const auto entry = [&](double part) { return has_entry ? std::optional<double>(part) : std::nullopt; };
        cell.run(stored.car_ids[of_car], slot_width, slot_length, answer.direction_changes, answer.lower_bound,
                 answer.proved, entry(answer.entry.x), entry(answer.entry.y), entry(answer.entry.heading),
                 checksum_of_cell(plan.options, stored.made_by, plan.cars[of_car], slot_width, slot_length, answer));
        const std::int64_t id = sqlite3_last_insert_rowid(connection.handle());
        int number = 0;
        for (const HeadingRange& each : answer.ranges)
            range.run(id, number++, each.min, each.max, each.direction_changes, each.subrange);
        number = 0;
        for (const AtlasMove& each : answer.moves) {
            std::optional<int> part, obstacle;
            if (each.contact) {
                part = static_cast<int>(each.contact->part);
                obstacle = static_cast<int>(each.contact->obstacle);
            }
            move.run(id, number++, static_cast<int>(each.direction), each.steering_angle, each.length, part, obstacle);
        }
    }

    void commit() {
        if (!in_transaction) return;
        const Clock::time_point begin = Clock::now();
        connection.run("COMMIT");
        in_transaction = false;
        committed = progress.stored;
        const Clock::time_point end = Clock::now();
        next_commit = end + std::max<Clock::duration>(std::chrono::milliseconds(200), 20 * (end - begin));
    }

    /// What was not committed is lost, and SQLite knows why.
    [[noreturn]] void fail(const SqliteError& error) {
        if (sqlite3_get_autocommit(connection.handle()) == 0)
            sqlite3_exec(connection.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
        in_transaction = false;
        if (!lock.holds(path))
            throw Error(in_quotes(path) + " was removed or replaced while it was being built, and what it held is " +
                        "gone; leave it there and run the same command again");
        if (error.code() == SQLITE_CORRUPT) throw error;
        const bool full = error.code() == SQLITE_FULL;
        throw Error(std::string(error.what()) + "; " + std::to_string(committed) + " of " +
                    std::to_string(progress.cells) + " cells are stored; " +
                    (full ? "make room, then run the same command again" : "the same command goes on from there"));
    }

    std::string path;
    BuildLock lock;
    Connection connection;
    StoredPlan stored;
    AtlasPlan plan;
    AtlasProgress progress;
    std::uint64_t committed = 0;
    std::mutex mutex;

    // What has been given out: all rows before this one, and of this one all but `missing`.
    std::size_t car = 0;
    std::size_t width = 0;
    bool in_row = false;
    std::vector<double> missing;

    bool in_transaction = false;
    Clock::time_point next_commit = Clock::now();

    Statement row{connection, "SELECT length FROM cell WHERE car = ? AND width = ? ORDER BY length"};
    Statement cell{connection,
                   "INSERT INTO cell (car, width, length, direction_changes, lower_bound, proved, entry_x, entry_y, "
                   "entry_heading, checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
    Statement range{connection, "INSERT INTO entry_range VALUES (?, ?, ?, ?, ?, ?)"};
    Statement move{connection, "INSERT INTO move VALUES (?, ?, ?, ?, ?, ?, ?)"};
};

AtlasBuild::AtlasBuild(const std::string& path, const AtlasPlan& plan) {
    check_plan(plan);
    state_ = std::make_unique<State>(path, plan);
}

AtlasBuild::~AtlasBuild() = default;

const AtlasPlan& AtlasBuild::plan() const { return state_->plan; }

AtlasProgress AtlasBuild::progress() const {
    const std::lock_guard lock(state_->mutex);
    return state_->progress;
}

CellBatch AtlasBuild::next() {
    State& state = *state_;
    const std::lock_guard lock(state.mutex);
    const std::size_t most = batch_size(state.plan.options);
    for (; state.car < state.plan.cars.size(); ++state.car, state.width = 0) {
        for (; state.width < state.plan.widths.size(); ++state.width, state.in_row = false) {
            if (!std::exchange(state.in_row, true)) {
                state.missing = state.missing_in_row();
                std::reverse(state.missing.begin(), state.missing.end());  // taken from the end
            }
            if (state.missing.empty()) continue;
            const auto count = static_cast<std::ptrdiff_t>(std::min(most, state.missing.size()));
            CellBatch batch = {
                state.car, state.plan.widths[state.width], {state.missing.rbegin(), state.missing.rbegin() + count}};
            state.missing.erase(state.missing.end() - count, state.missing.end());
            return batch;
        }
    }
    return {};
}

void AtlasBuild::store(const SolvedBatch& solved) {
    State& state = *state_;
    const std::lock_guard lock(state.mutex);
    try {
        if (!state.in_transaction) state.connection.run("BEGIN IMMEDIATE");
        state.in_transaction = true;
        for (std::size_t i = 0; i < solved.answers.size(); ++i)
            state.insert(solved.cells.car, solved.cells.width, solved.cells.lengths[i], solved.answers[i]);
        state.progress.stored += solved.answers.size();
        state.progress.solved += solved.answers.size();
        if (Clock::now() >= state.next_commit) state.commit();
    } catch (const SqliteError& error) {
        state.fail(error);
    }
}

void AtlasBuild::commit() {
    const std::lock_guard lock(state_->mutex);
    try {
        state_->commit();
    } catch (const SqliteError& error) {
        state_->fail(error);
    }
}

bool build_atlas(AtlasBuild& build, const AtlasBuildOptions& options) {
    const CellQueue queue = {[&] { return build.next(); },
                             [&](const SolvedBatch& solved) {
                                 build.store(solved);
                                 if (options.progress) options.progress(build.progress());
                             }};
    solve_all(build.plan(), queue, options.threads, options.go_on);
    build.commit();
    const AtlasProgress progress = build.progress();
    return progress.stored == progress.cells;
}

}  // namespace snug
