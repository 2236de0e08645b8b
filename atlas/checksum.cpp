#include "checksum.hpp"

#include <bit>
#include <span>
#include <vector>

#include "atlas/format.hpp"

namespace snug {

namespace {

class Words {
public:
    void put(int value) { words_.push_back(static_cast<std::uint64_t>(value)); }
    void put(double value) { words_.push_back(std::bit_cast<std::uint64_t>(value + 0.0)); }  // SQLite knows no -0
    void put(std::string_view text) {
        put(static_cast<int>(text.size()));
        for (const char c : text) put(static_cast<int>(c));
    }
    template <class... Values>
    void put_all(const Values&... values) {
        (put(values), ...);
    }
    [[nodiscard]] std::int64_t checksum() const {
        return static_cast<std::int64_t>(atlas_format::checksum(std::as_bytes(std::span(words_))));
    }

private:
    std::vector<std::uint64_t> words_;
};

}  // namespace

std::int64_t checksum_of_cell(const AtlasOptions& options, std::string_view made_by, const Car& car, double width,
                              double length, const CellAnswer& answer) {
    Words words;
    words.put_all(made_by, static_cast<int>(options.strategy), options.max_changes.value_or(-1), options.min_range,
                  options.resolution, options.driving.clearance, static_cast<int>(options.driving.enter));
    words.put_all(std::string_view(car.name()), car.width(), car.front(), car.rear(), car.wheelbase(), car.max_steer(),
                  width, length);
    if (!car.is_rectangle())
        for (const Point& corner : car.outline().corners()) words.put_all(corner.x, corner.y);
    words.put_all(answer.direction_changes.value_or(-1), answer.lower_bound, answer.proved ? 1 : 0);
    words.put_all(answer.entry.x, answer.entry.y, answer.entry.heading);
    words.put(static_cast<int>(answer.ranges.size()));
    for (const HeadingRange& range : answer.ranges)
        words.put_all(range.min, range.max, range.direction_changes, range.subrange);
    for (const AtlasMove& move : answer.moves) {
        words.put_all(static_cast<int>(move.direction), move.steering_angle, move.length);
        words.put_all(move.contact ? static_cast<int>(move.contact->part) : -1,
                      move.contact ? static_cast<int>(move.contact->obstacle) : -1);
    }
    return words.checksum();
}

}  // namespace snug
