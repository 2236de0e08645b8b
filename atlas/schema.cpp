#include "schema.hpp"

#include "atlas/damage.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/limits.hpp"
#include "snug/version.hpp"

namespace snug {

namespace {

constexpr int application = 0x736e7567;  // "snug"
constexpr int schema_version = 2;        // 1 knew rectangles only

constexpr const char* tables = R"sql(
CREATE TABLE provenance (key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE car (
    id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
    width REAL NOT NULL, front REAL NOT NULL, rear REAL NOT NULL, wheelbase REAL NOT NULL, max_steer REAL NOT NULL);
CREATE TABLE outline_corner (
    car INTEGER NOT NULL REFERENCES car, number INTEGER NOT NULL, x REAL NOT NULL, y REAL NOT NULL,
    PRIMARY KEY (car, number)) WITHOUT ROWID;
CREATE TABLE slot_width (width REAL PRIMARY KEY) WITHOUT ROWID;
CREATE TABLE slot_length (length REAL PRIMARY KEY) WITHOUT ROWID;
CREATE TABLE cell (
    id INTEGER PRIMARY KEY,
    car INTEGER NOT NULL REFERENCES car, width REAL NOT NULL REFERENCES slot_width,
    length REAL NOT NULL REFERENCES slot_length,
    direction_changes INTEGER, lower_bound INTEGER NOT NULL, proved INTEGER NOT NULL,
    entry_x REAL, entry_y REAL, entry_heading REAL, checksum INTEGER NOT NULL,
    UNIQUE (car, width, length));
CREATE TABLE entry_range (
    cell INTEGER NOT NULL REFERENCES cell, number INTEGER NOT NULL,
    heading_min REAL NOT NULL, heading_max REAL NOT NULL, direction_changes INTEGER NOT NULL, subrange INTEGER NOT NULL,
    PRIMARY KEY (cell, number)) WITHOUT ROWID;
CREATE TABLE move (
    cell INTEGER NOT NULL REFERENCES cell, number INTEGER NOT NULL,
    direction INTEGER NOT NULL, steering_angle REAL NOT NULL, length REAL NOT NULL,
    car_part INTEGER REFERENCES car_part, obstacle INTEGER REFERENCES obstacle,
    PRIMARY KEY (cell, number)) WITHOUT ROWID;
CREATE TABLE car_part (id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE obstacle (id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE VIEW answer AS
    SELECT cell.id AS cell, car.name AS car, cell.width, cell.length, direction_changes, lower_bound, proved,
           entry_x, entry_y, entry_heading
    FROM cell JOIN car ON car.id = cell.car;
CREATE VIEW maneuver AS
    SELECT cell, number, CASE direction WHEN 1 THEN 'forward' ELSE 'backward' END AS direction, steering_angle, length,
           car_part.name AS car_part, obstacle.name AS obstacle
    FROM move LEFT JOIN car_part ON car_part.id = move.car_part LEFT JOIN obstacle ON obstacle.id = move.obstacle;
)sql";

int pragma(const Connection& connection, const char* question) {
    Statement statement(connection, question);
    return statement.row() ? statement.small(0) : 0;
}

std::vector<double> read_sizes(const Connection& connection, const char* question) {
    std::vector<double> sizes;
    Statement statement(connection, question);
    while (statement.row()) {
        sizes.push_back(statement.real(0));
        check_between("size of a slot", sizes.back(), limits::shortest, limits::longest, " m");
    }
    return sizes;
}

}  // namespace

void create_tables(Connection& connection, const AtlasOptions& options) {
    connection.run("PRAGMA application_id = " + std::to_string(application) +
                   "; PRAGMA user_version = " + std::to_string(schema_version) + ';');
    connection.run(tables);
    Statement provenance(connection, "INSERT INTO provenance VALUES (?, ?)");
    provenance.run("snug", SNUG_VERSION);
    provenance.run("strategy", to_string(options.strategy));
    provenance.run("max_changes", options.max_changes);
    provenance.run("min_range", options.min_range);
    provenance.run("resolution", options.resolution);
    provenance.run("clearance", options.driving.clearance);
    provenance.run("enter", to_string(options.driving.enter));
    Statement part(connection, "INSERT INTO car_part VALUES (?, ?)");
    for (int i = 0; i <= static_cast<int>(CarPart::front_right_wheel); ++i)
        part.run(i, to_string(static_cast<CarPart>(i)));
    Statement obstacle(connection, "INSERT INTO obstacle VALUES (?, ?)");
    for (int i = 0; i <= static_cast<int>(Obstacle::rear_corner); ++i)
        obstacle.run(i, to_string(static_cast<Obstacle>(i)));
}

bool is_empty(const Connection& connection) { return pragma(connection, "PRAGMA page_count") == 0; }

Connection open_database(const std::string& path, bool may_be_empty) {
    const std::string file = in_quotes(path);
    try {
        Connection connection(path);
        if (is_empty(connection)) {
            if (may_be_empty) return connection;
            throw Error(file + " is empty; give a database that snug atlas build has made");
        }
        if (pragma(connection, "PRAGMA application_id") != application)
            throw Error(file + " is a database of another program; give one that snug atlas build has made");
        const int found = pragma(connection, "PRAGMA user_version");
        if (found != schema_version)
            throw Error(file + " has version " + std::to_string(found) + " of the atlas's tables, and snug " +
                        SNUG_VERSION + " knows version " + std::to_string(schema_version) +
                        "; take the snug that made it, or build it again");
        return connection;
    } catch (const SqliteError& error) {
        if (error.code() != SQLITE_NOTADB) throw;
        throw Error(file + " is no database; give one that snug atlas build has made");
    }
}

StoredPlan read_plan(const Connection& connection, const std::string& path) try {
    StoredPlan stored;
    AtlasOptions& options = stored.plan.options;
    Statement provenance(connection, "SELECT key, value FROM provenance");
    while (provenance.row()) {
        const std::string key = provenance.text(0);
        if (key == "snug") stored.made_by = provenance.text(1);
        if (key == "strategy" && provenance.text(1) == to_string(Strategy::fewest)) options.strategy = Strategy::fewest;
        if (key == "max_changes" && !provenance.is_null(1)) options.max_changes = provenance.small(1);
        if (key == "min_range") options.min_range = provenance.real(1);
        if (key == "resolution") options.resolution = provenance.real(1);
        if (key == "clearance") options.driving.clearance = provenance.real(1);
        if (key == "enter" && provenance.text(1) == to_string(Enter::forward)) options.driving.enter = Enter::forward;
    }
    // SQLite's own order of texts is that of std::string: byte by byte.
    Statement cars(connection, "SELECT id, name, width, front, rear, wheelbase, max_steer FROM car ORDER BY name");
    Statement outline(connection, "SELECT x, y FROM outline_corner WHERE car = ? ORDER BY number");
    while (cars.row()) {
        stored.car_ids.push_back(cars.integer(0));
        std::vector<Point> corners;
        outline.with(cars.integer(0));
        while (outline.row()) corners.push_back({outline.real(0), outline.real(1)});
        const CarDimensions dimensions = {cars.real(2), cars.real(3), cars.real(4), cars.real(5), cars.real(6)};
        const std::string name = cars.text(1);
        if (corners.empty()) {
            stored.plan.cars.emplace_back(dimensions, name);
            continue;
        }
        stored.plan.cars.emplace_back(Outline(corners), dimensions.wheelbase, dimensions.max_steer, name);
        if (stored.plan.cars.back().dimensions() != dimensions)
            throw Error("the outline of " + in_quotes(name) + " does not go with its width, front and rear");
    }
    stored.plan.widths = read_sizes(connection, "SELECT width FROM slot_width ORDER BY width");
    stored.plan.lengths = read_sizes(connection, "SELECT length FROM slot_length ORDER BY length");
    return stored;
} catch (const SqliteError&) {
    throw;
} catch (const Error& error) {
    throw damaged(path, error.what());
}

std::uint64_t count_cells(const AtlasPlan& plan) {
    return static_cast<std::uint64_t>(plan.cars.size()) * plan.widths.size() * plan.lengths.size();
}

}  // namespace snug
