// The compact file for cars, written from its begin to its end: only the block at hand and the index stay in memory.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "atlas/format.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/atlas_build.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

using namespace atlas_format;

constexpr std::size_t most_bytes = std::numeric_limits<std::uint32_t>::max();

template <class T>
void append(std::string& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void pad(std::string& bytes) { bytes.resize(padded(bytes.size())); }

std::uint64_t checksum_of(const std::string& bytes) { return checksum(std::as_bytes(std::span(bytes))); }

void check_axis(const char* what, const std::vector<double>& values) {
    if (values.empty()) throw Error(std::string("the atlas has no ") + what + "s, but must have at least one");
    for (std::size_t i = 0; i < values.size(); ++i) {
        check_between(std::string("slot ") + what, values[i], limits::shortest, limits::longest, " m");
        if (i > 0 && values[i] <= values[i - 1])
            throw Error(std::string("the atlas has the ") + what + " " + spelled(values[i]) + " m after " +
                        spelled(values[i - 1]) + " m, but " + what + "s must rise");
    }
}

void check_cars(const std::vector<Car>& cars) {
    if (cars.empty()) throw Error("the atlas has no cars, but must have at least one");
    std::size_t name_bytes = 0;
    for (std::size_t i = 0; i < cars.size(); ++i) {
        const std::string& name = cars[i].name();
        if (name.empty()) throw Error("car [" + std::to_string(i) + "] has no name, but must be found by one");
        if (i > 0 && name == cars[i - 1].name())
            throw Error("the atlas has two cars named " + in_quotes(name) + ", but each must have a name of its own");
        if (i > 0 && name < cars[i - 1].name())
            throw Error("the atlas has the car " + in_quotes(name) + " after " + in_quotes(cars[i - 1].name()) +
                        ", but cars must be in alphabetical order");
        name_bytes += name.size();
    }
    if (name_bytes > most_bytes) throw Error("the names of the cars are longer than 4 GiB, but must be shorter");
}

void check_options(const AtlasOptions& options) {
    check_between("maximum of direction changes", options.max_changes.value_or(0), 0.0, limits::most_changes, "");
    check_between("narrowest range", options.min_range, 0.0, limits::quarter_turn, " rad");
    check_between("resolution", options.resolution, 0.0, limits::longest, " m");
    check_between("clearance", options.driving.clearance, 0.0, limits::longest, " m");
}

/// How many cells there are.
std::uint64_t checked_cells(const AtlasPlan& plan) {
    check_cars(plan.cars);
    check_axis("width", plan.widths);
    check_axis("length", plan.lengths);
    check_options(plan.options);
    const std::uint64_t cars = plan.cars.size();
    const std::uint64_t widths = plan.widths.size();
    const std::uint64_t lengths = plan.lengths.size();
    if (cars > most_cells || widths > most_cells / cars || lengths > most_cells / (cars * widths))
        throw Error(std::to_string(cars) + " cars in slots of " + std::to_string(widths) + " widths and " +
                    std::to_string(lengths) + " lengths are more than 2^40 cells, the most one file may have; export " +
                    "some of the cars at a time");
    for (const std::uint64_t count : {cars, widths, lengths})
        if (count > most_bytes) throw Error("the atlas has more than 2^32 of one kind, but must have fewer");
    return cars * widths * lengths;
}

std::string front_part(const AtlasPlan& plan, std::uint64_t cells, std::string_view made_by) {
    std::string names;
    for (const Car& car : plan.cars) names += car.name();
    Head head{};
    std::copy(begin_mark.begin(), begin_mark.end(), head.mark.begin());
    head.version = version;
    head.cars = static_cast<std::uint32_t>(plan.cars.size());
    head.widths = static_cast<std::uint32_t>(plan.widths.size());
    head.lengths = static_cast<std::uint32_t>(plan.lengths.size());
    head.cells_per_block = cells_per_block(cells);
    head.strategy = plan.options.strategy == Strategy::max_steer ? 0 : 1;
    head.max_changes = plan.options.max_changes.value_or(-1);
    head.enter = plan.options.driving.enter == Enter::backward ? 0 : 1;
    head.resolution = plan.options.resolution;
    head.min_range = plan.options.min_range;
    head.clearance = plan.options.driving.clearance;
    if (made_by.size() > head.made_by.size())
        throw Error("version " + in_quotes(made_by) + " has " + std::to_string(made_by.size()) +
                    " bytes, but must have at most " + std::to_string(head.made_by.size()));
    std::copy(made_by.begin(), made_by.end(), head.made_by.begin());
    head.name_bytes = names.size();
    std::string corners;
    std::vector<std::uint32_t> corners_of;
    for (const Car& car : plan.cars) {
        const std::vector<Point> outline = car.is_rectangle() ? std::vector<Point>{} : car.outline().corners();
        corners_of.push_back(static_cast<std::uint32_t>(outline.size()));
        for (const Point& corner : outline) append(corners, Corner{corner.x, corner.y});
    }
    head.corners = corners.size() / sizeof(Corner);
    if (head.corners > most_bytes)
        throw Error("the outlines of the cars have more than 2^32 corners; export some of the cars at a time");

    std::string bytes;
    append(bytes, head);
    std::size_t name_at = 0;
    std::uint32_t corners_at = 0;
    for (std::size_t i = 0; i < plan.cars.size(); ++i) {
        const Car& car = plan.cars[i];
        append(bytes, CarEntry{car.width(), car.front(), car.rear(), car.wheelbase(), car.max_steer(),
                               static_cast<std::uint32_t>(name_at), static_cast<std::uint32_t>(car.name().size()),
                               corners_at, corners_of[i]});
        name_at += car.name().size();
        corners_at += corners_of[i];
    }
    bytes += names;
    pad(bytes);
    bytes += corners;
    for (const double width : plan.widths) append(bytes, width);
    for (const double length : plan.lengths) append(bytes, length);
    return bytes;
}

Steering steering_of(double angle, double max_steer) {
    if (angle == -max_steer) return Steering::full_right;
    if (angle == 0.0) return Steering::straight;
    return angle == max_steer ? Steering::full_left : Steering::stored;
}

std::uint8_t code_of(const AtlasMove& move, double max_steer) {
    const int contact =
        move.contact ? 1 + static_cast<int>(move.contact->part) * obstacles + static_cast<int>(move.contact->obstacle)
                     : 0;
    return static_cast<std::uint8_t>(contact | static_cast<int>(steering_of(move.steering_angle, max_steer)) << 6);
}

/// Appends the body and returns the record.
Record append_body(std::string& bodies, const CellAnswer& answer, double max_steer) {
    const bool angles = std::any_of(answer.moves.begin(), answer.moves.end(), [&](const AtlasMove& move) {
        return steering_of(move.steering_angle, max_steer) == Steering::stored;
    });
    Record record{};
    record.direction_changes = answer.direction_changes.value_or(-1);
    record.lower_bound = answer.lower_bound;
    record.ranges = static_cast<std::uint32_t>(answer.ranges.size());
    record.moves = static_cast<std::uint32_t>(answer.moves.size());
    record.flags = (answer.proved ? proved : 0U) | (angles ? angles_stored : 0U);
    record.body_at = static_cast<std::uint32_t>(bodies.size());  // among the bodies; that it fits is seen in the end

    if (!answer.moves.empty())
        for (const double value : {answer.entry.x, answer.entry.y, answer.entry.heading}) append(bodies, value);
    for (const HeadingRange& range : answer.ranges)
        append(bodies, RangeEntry{range.min, range.max, range.direction_changes, range.subrange});
    for (const AtlasMove& move : answer.moves)
        append(bodies, std::copysign(move.length, static_cast<double>(move.direction)));
    if (angles)
        for (const AtlasMove& move : answer.moves) append(bodies, move.steering_angle);
    for (const AtlasMove& move : answer.moves) append(bodies, code_of(move, max_steer));
    pad(bodies);
    return record;
}

}  // namespace

struct AtlasWriter::State {
    Sink sink;
    std::vector<double> max_steers;  ///< of each car
    std::uint64_t cells_of_a_car = 0;
    std::uint64_t cells = 0;
    std::uint32_t cells_per_block = 0;

    std::uint64_t added = 0;
    std::uint64_t written = 0;  ///< bytes
    std::uint64_t front_checksum = 0;
    std::string index;
    std::vector<Record> records;  ///< of the block at hand
    std::string bodies;           ///< of the same cells

    void write(const std::string& bytes) {
        sink(bytes);
        written += bytes.size();
    }

    void write_block() {
        const std::size_t record_bytes = records.size() * sizeof(Record);
        if (record_bytes + bodies.size() > most_bytes)
            throw Error("a block of " + std::to_string(records.size()) +
                        " cells is larger than 4 GiB; export some of the cars at a time");
        std::string block;
        block.reserve(record_bytes + bodies.size());
        for (Record& record : records) {
            record.body_at += static_cast<std::uint32_t>(record_bytes);
            append(block, record);
        }
        block += bodies;
        append(index, IndexEntry{written, checksum_of(block)});
        write(block);
        records.clear();
        bodies.clear();
    }
};

AtlasWriter::AtlasWriter(const AtlasPlan& plan, std::string_view made_by, Sink sink)
    : state_(std::make_unique<State>()) {
    state_->cells = checked_cells(plan);
    state_->cells_of_a_car = state_->cells / plan.cars.size();
    state_->cells_per_block = cells_per_block(state_->cells);
    for (const Car& car : plan.cars) state_->max_steers.push_back(car.max_steer());
    state_->sink = std::move(sink);
    const std::string front = front_part(plan, state_->cells, made_by);
    state_->front_checksum = checksum_of(front);
    state_->write(front);
}

AtlasWriter::~AtlasWriter() = default;

void AtlasWriter::add(const CellAnswer& answer) {
    State& state = *state_;
    if (state.added == state.cells) throw std::logic_error("AtlasWriter::add() after the last cell");
    if (!answer.moves.empty() && !answer.direction_changes)
        throw std::logic_error("AtlasWriter::add() of moves without their direction changes");
    state.records.push_back(append_body(state.bodies, answer, state.max_steers[state.added / state.cells_of_a_car]));
    if (++state.added % state.cells_per_block == 0 || state.added == state.cells) state.write_block();
}

void AtlasWriter::finish() {
    State& state = *state_;
    if (state.added != state.cells)
        throw std::logic_error("AtlasWriter::finish() after " + std::to_string(state.added) + " of " +
                               std::to_string(state.cells) + " cells");
    Trailer trailer{};
    trailer.index_at = state.written;
    trailer.index_checksum = checksum_of(state.index);
    state.write(state.index);
    trailer.file_bytes = state.written + sizeof(Trailer);
    trailer.front_checksum = state.front_checksum;
    std::copy(end_mark.begin(), end_mark.end(), trailer.mark.begin());
    trailer.trailer_checksum =
        checksum(std::as_bytes(std::span(&trailer, 1)).first(offsetof(Trailer, trailer_checksum)));
    std::string bytes;
    append(bytes, trailer);
    state.write(bytes);
}

}  // namespace snug
