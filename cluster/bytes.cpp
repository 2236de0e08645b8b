#include "cluster/bytes.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/version.hpp"

namespace snug::cluster {
namespace {

class Writer {
public:
    template <typename Number>
    void number(Number value) {
        static_assert(std::is_arithmetic_v<Number>);
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        bytes_.append(bytes, sizeof value);
    }
    template <typename Choice>
    void choice(Choice value) {
        number(static_cast<std::int32_t>(value));
    }
    void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }
    void text(std::string_view value) {
        count(value.size());
        bytes_.append(value);
    }
    void optional(const std::optional<int>& value) {
        choice(value.has_value());
        choice(value.value_or(0));
    }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Reads what a Writer wrote, and never past the end.
class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    template <typename Number>
    Number number() {
        static_assert(std::is_arithmetic_v<Number>);
        const std::string_view bytes = take(sizeof(Number));
        Number value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return value;
    }
    double real() { return number<double>(); }
    int whole() { return number<std::int32_t>(); }
    bool flag() { return choice(0, 1) == 1; }
    int choice(int first, int last) {
        const int value = whole();
        check(value >= first && value <= last);
        return value;
    }
    std::size_t index(std::size_t size) {
        const auto value = number<std::uint64_t>();
        check(value < size);
        return static_cast<std::size_t>(value);
    }
    /// Of things that have at least so many bytes each: never more than there is room for.
    std::size_t count(std::size_t least_size) {
        const auto value = number<std::uint64_t>();
        check(value <= rest_.size() / least_size);
        return static_cast<std::size_t>(value);
    }
    std::string text() { return std::string(take(count(1))); }
    std::optional<int> optional() {
        const bool there = flag();
        const int value = whole();
        return there ? std::optional<int>(value) : std::nullopt;
    }
    void end() const { check(rest_.empty()); }

private:
    static void check(bool right) {
        if (!right) throw Error("a message between processes is damaged; start the same command again");
    }
    std::string_view take(std::size_t size) {
        check(size <= rest_.size());
        const std::string_view bytes = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return bytes;
    }

    std::string_view rest_;
};

void write(Writer& to, const Car& car) {
    to.text(car.name());
    const CarDimensions& d = car.dimensions();
    for (const double value : {d.width, d.front, d.rear, d.wheelbase, d.max_steer}) to.number(value);
    const std::vector<Point> corners = car.is_rectangle() ? std::vector<Point>{} : car.outline().corners();
    to.count(corners.size());
    for (const Point& corner : corners) {
        to.number(corner.x);
        to.number(corner.y);
    }
}

Car read_car(Reader& from) {
    const std::string name = from.text();
    CarDimensions d;
    for (double* value : {&d.width, &d.front, &d.rear, &d.wheelbase, &d.max_steer}) *value = from.real();
    std::vector<Point> corners(from.count(2 * sizeof(double)));
    for (Point& corner : corners) corner = {from.real(), from.real()};
    return corners.empty() ? Car(d, name) : Car(Outline(corners), d.wheelbase, d.max_steer, name);
}

void write(Writer& to, const AtlasOptions& options) {
    to.choice(options.strategy);
    to.optional(options.max_changes);
    to.number(options.min_range);
    to.number(options.resolution);
    to.number(options.driving.clearance);
    to.choice(options.driving.enter);
}

AtlasOptions read_options(Reader& from) {
    AtlasOptions options;
    options.strategy = Strategy{from.choice(0, 1)};
    options.max_changes = from.optional();
    options.min_range = from.real();
    options.resolution = from.real();
    options.driving.clearance = from.real();
    options.driving.enter = Enter{from.choice(0, 1)};
    return options;
}

void write(Writer& to, const CellBatch& batch) {
    to.count(batch.car);
    to.number(batch.width);
    to.count(batch.lengths.size());
    for (const double length : batch.lengths) to.number(length);
}

CellBatch read_batch(Reader& from, std::size_t cars) {
    CellBatch batch;
    batch.car = from.index(cars);
    batch.width = from.real();
    batch.lengths.resize(from.count(sizeof(double)));
    for (double& length : batch.lengths) length = from.real();
    return batch;
}

void write(Writer& to, const HeadingRange& range) {
    to.number(range.min);
    to.number(range.max);
    to.number(range.direction_changes);
    to.number(range.subrange);
}

HeadingRange read_range(Reader& from) {
    HeadingRange range;
    range.min = from.real();
    range.max = from.real();
    range.direction_changes = from.whole();
    range.subrange = from.whole();
    return range;
}

void write(Writer& to, const AtlasMove& move) {
    to.choice(move.direction);
    to.number(move.steering_angle);
    to.number(move.length);
    to.choice(move.contact.has_value());
    if (move.contact) {
        to.choice(move.contact->part);
        to.choice(move.contact->obstacle);
    }
}

AtlasMove read_move(Reader& from) {
    AtlasMove move;
    move.direction = from.choice(-1, 1) < 0 ? Direction::backward : Direction::forward;
    move.steering_angle = from.real();
    move.length = from.real();
    if (from.flag()) {
        const auto part = CarPart{from.choice(0, static_cast<int>(CarPart::front_right_wheel))};
        const auto obstacle = Obstacle{from.choice(0, static_cast<int>(Obstacle::rear_corner))};
        move.contact = Contact{part, obstacle};
    }
    return move;
}

void write(Writer& to, const CellAnswer& answer) {
    to.optional(answer.direction_changes);
    to.number(answer.lower_bound);
    to.choice(answer.proved);
    for (const double value : {answer.entry.x, answer.entry.y, answer.entry.heading}) to.number(value);
    to.count(answer.ranges.size());
    for (const HeadingRange& range : answer.ranges) write(to, range);
    to.count(answer.moves.size());
    for (const AtlasMove& move : answer.moves) write(to, move);
}

CellAnswer read_answer(Reader& from) {
    CellAnswer answer;
    answer.direction_changes = from.optional();
    answer.lower_bound = from.whole();
    answer.proved = from.flag();
    for (double* value : {&answer.entry.x, &answer.entry.y, &answer.entry.heading}) *value = from.real();
    for (std::size_t count = from.count(sizeof(double)); count > 0; --count) answer.ranges.push_back(read_range(from));
    for (std::size_t count = from.count(sizeof(double)); count > 0; --count) answer.moves.push_back(read_move(from));
    return answer;
}

}  // namespace

std::string to_bytes(const Task& task) {
    Writer to;
    to.text(SNUG_VERSION);
    to.choice(task.threads);
    write(to, task.plan.options);
    to.count(task.plan.cars.size());
    for (const Car& car : task.plan.cars) write(to, car);
    return to.take();
}

Task task_from(std::string_view bytes) {
    Reader from(bytes);
    const std::string version = from.text();
    if (version != SNUG_VERSION)
        throw Error("is snug " SNUG_VERSION ", but the first process is snug " + printable(version) +
                    ", whose answers may differ; install the same on every machine");
    Task task;
    task.threads = from.whole();
    task.plan.options = read_options(from);
    for (std::size_t count = from.count(sizeof(double)); count > 0; --count) task.plan.cars.push_back(read_car(from));
    from.end();
    return task;
}

std::string to_bytes(const CellBatch& batch) {
    Writer to;
    write(to, batch);
    return to.take();
}

CellBatch batch_from(std::string_view bytes, std::size_t cars) {
    Reader from(bytes);
    CellBatch batch = read_batch(from, cars);
    from.end();
    return batch;
}

std::string to_bytes(const SolvedBatch& solved) {
    Writer to;
    write(to, solved.cells);
    to.count(solved.answers.size());
    for (const CellAnswer& answer : solved.answers) write(to, answer);
    return to.take();
}

SolvedBatch solved_from(std::string_view bytes, std::size_t cars) {
    Reader from(bytes);
    SolvedBatch solved;
    solved.cells = read_batch(from, cars);
    // As many as lengths, or fewer.
    for (std::size_t count = from.index(solved.cells.lengths.size() + 1); count > 0; --count)
        solved.answers.push_back(read_answer(from));
    from.end();
    return solved;
}

}  // namespace snug::cluster
