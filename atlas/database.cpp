// Reading the database: one cell, or all of them in order.
#include "snug/atlas_database.hpp"

#include <algorithm>
#include <utility>

#include "atlas/damage.hpp"
#include "checksum.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "schema.hpp"
#include "sqlite.hpp"

namespace snug {

namespace {

std::optional<Contact> contact_of(const Statement& row, int part, int obstacle) {
    if (row.is_null(part) || row.is_null(obstacle)) return std::nullopt;
    return Contact{static_cast<CarPart>(row.small(part)), static_cast<Obstacle>(row.small(obstacle))};
}

}  // namespace

struct AtlasDatabase::State {
    explicit State(const std::string& file)
        : path(file), connection(open_database(file, false)), stored(read_plan(connection, file)) {}

    /// Throws Error when it is not what was stored.
    CellAnswer answer(std::size_t car, const Statement& row) {
        CellAnswer answer;
        if (!row.is_null(2)) answer.direction_changes = row.small(2);
        answer.lower_bound = row.small(3);
        answer.proved = row.small(4) != 0;
        answer.entry = {row.real(5), row.real(6), row.real(7)};
        const std::int64_t id = row.integer(8);
        ranges.with(id);
        while (ranges.row())
            answer.ranges.push_back({ranges.real(0), ranges.real(1), ranges.small(2), ranges.small(3)});
        moves.with(id);
        while (moves.row()) {
            const Direction direction = moves.small(0) > 0 ? Direction::forward : Direction::backward;
            answer.moves.push_back({direction, moves.real(1), moves.real(2), contact_of(moves, 3, 4)});
        }
        const Car& asked = stored.plan.cars[car];
        if (row.integer(9) !=
            checksum_of_cell(stored.plan.options, stored.made_by, asked, row.real(0), row.real(1), answer))
            throw damaged(path, "its answer for " + in_quotes(asked.name()) + " in the slot of " +
                                    spelled(row.real(1)) + " x " + spelled(row.real(0)) + " m is not what was stored");
        return answer;
    }

    std::string path;
    Connection connection;
    StoredPlan stored;
    Statement count{connection, "SELECT count(*) FROM cell"};
    Statement one{connection,
                  "SELECT width, length, direction_changes, lower_bound, proved, entry_x, entry_y, entry_heading, id, "
                  "checksum FROM cell WHERE car = ? AND width = ? AND length = ?"};
    Statement all{connection,
                  "SELECT width, length, direction_changes, lower_bound, proved, entry_x, entry_y, entry_heading, id, "
                  "checksum FROM cell WHERE car = ? ORDER BY width, length"};
    Statement ranges{connection,
                     "SELECT heading_min, heading_max, direction_changes, subrange FROM entry_range WHERE cell = ? "
                     "ORDER BY number"};
    Statement moves{connection,
                    "SELECT direction, steering_angle, length, car_part, obstacle FROM move WHERE cell = ? "
                    "ORDER BY number"};
};

AtlasDatabase::AtlasDatabase(const std::string& path) : state_(std::make_unique<State>(path)) {}
AtlasDatabase::~AtlasDatabase() = default;

const AtlasPlan& AtlasDatabase::plan() const { return state_->stored.plan; }
const std::string& AtlasDatabase::made_by() const { return state_->stored.made_by; }
std::uint64_t AtlasDatabase::cells() const { return count_cells(plan()); }

std::uint64_t AtlasDatabase::stored() const {
    state_->count.with().row();
    return static_cast<std::uint64_t>(state_->count.integer(0));
}

std::optional<CellAnswer> AtlasDatabase::cell(std::size_t car, double width, double length) const {
    Statement& row = state_->one.with(state_->stored.car_ids.at(car), width, length);
    if (!row.row()) return std::nullopt;
    return state_->answer(car, row);
}

void AtlasDatabase::each(const std::function<bool(std::size_t, double, double, const CellAnswer&)>& take) const {
    for (std::size_t car = 0; car < plan().cars.size(); ++car) {
        Statement& row = state_->all.with(state_->stored.car_ids[car]);
        while (row.row())
            if (!take(car, row.real(0), row.real(1), state_->answer(car, row))) return;
    }
}

std::string AtlasDatabase::trouble() const {
    Statement check(state_->connection, "PRAGMA integrity_check(1)");
    std::string said = check.row() ? check.text(0) : "";
    std::replace(said.begin(), said.end(), '\n', ' ');
    if (said != "ok") return said;
    Statement keys(state_->connection, "PRAGMA foreign_key_check");
    if (keys.row()) return "a row of " + keys.text(0) + " belongs to no row of " + keys.text(2);
    return stored() > cells() ? too_many_cells(stored(), cells()) : "";
}

}  // namespace snug
