// Atlases with anything in them that can be stored, written as the exported file.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/random_cases.hpp"
#include "snug/atlas.hpp"
#include "snug/atlas_build.hpp"

namespace snug::test {

using oracle::Random;

struct WrittenAtlas {
    AtlasPlan plan;
    std::vector<CellAnswer> answers;
    std::string bytes = {};

    [[nodiscard]] const CellAnswer& answer(std::size_t car, std::size_t width, std::size_t length) const {
        return answers[(car * plan.widths.size() + width) * plan.lengths.size() + length];
    }
};

inline std::string written(const AtlasPlan& plan, const std::vector<CellAnswer>& answers) {
    std::string bytes;
    AtlasWriter writer(plan, "1.2.3-test", [&](std::string_view more) { bytes += more; });
    for (const CellAnswer& answer : answers) writer.add(answer);
    writer.finish();
    return bytes;
}

inline std::span<const std::byte> as_bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

inline std::vector<double> random_axis(Random& random, int most) {
    std::set<double> values;
    const int count = 1 + random.below(most);
    const double from = random.between(1.0, 5.0);
    const bool even = random.chance(0.5);
    for (int i = 0; i < count; ++i) values.insert(even ? from + 0.01 * i : from + random.unit());
    return {values.begin(), values.end()};
}

inline std::vector<Car> random_cars(Random& random, int most) {
    std::set<std::string> names;
    const int count = 1 + random.below(most);
    while (static_cast<int>(names.size()) < count) {
        std::string name(1 + static_cast<std::size_t>(random.below(random.chance(0.1) ? 300 : 12)), ' ');
        for (char& letter : name) letter = "abcxyz-0\xc3"[random.below(9)];
        names.insert(name);
    }
    std::vector<Car> cars;
    for (const std::string& name : names) {
        oracle::Case chosen;
        oracle::choose_car(random, chosen);
        if (random.chance(0.7)) {
            cars.emplace_back(chosen.car, name);
            continue;
        }
        const CarDimensions& d = chosen.car;
        const double round = 0.2 * std::min({d.front, d.rear, d.width});
        cars.emplace_back(Outline::rounded(d.front, d.rear, d.width / 2.0, round, 0.5 * round), d.wheelbase,
                          d.max_steer, name);
    }
    return cars;
}

inline AtlasMove random_move(Random& random, const Car& car) {
    AtlasMove move;
    move.direction = random.chance(0.5) ? Direction::backward : Direction::forward;
    move.length = random.chance(0.1) ? 0.0 : random.between(0.0, 3.0);
    switch (random.below(8)) {
        case 0: move.steering_angle = 0.0; break;
        case 1: move.steering_angle = random.between(-1.0, 1.0) * car.max_steer(); break;
        default: move.steering_angle = random.chance(0.5) ? car.max_steer() : -car.max_steer();
    }
    if (random.chance(0.7))
        move.contact = Contact{static_cast<CarPart>(random.below(8)), static_cast<Obstacle>(random.below(5))};
    return move;
}

inline CellAnswer random_answer(Random& random, const Car& car, const AtlasOptions& options) {
    CellAnswer answer;
    const int allowed = options.max_changes.value_or(200);
    if (options.strategy == Strategy::fewest) {
        answer.lower_bound = random.below(4) * (allowed + 1) / 3;
        answer.proved = random.chance(0.5);
    }
    if (random.chance(0.4)) return answer;
    answer.direction_changes = random.below(allowed + 1);
    if (options.strategy == Strategy::max_steer) {
        for (int i = random.below(random.chance(0.1) ? 40 : 4); i >= 0; --i)
            answer.ranges.push_back({random.unit(), random.unit(), random.below(allowed + 1), random.below(9)});
    }
    if (random.chance(0.05)) return answer;  // known to exist, and not found again
    answer.entry = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.unit()};
    for (int i = random.below(random.chance(0.1) ? 60 : 6); i >= 0; --i)
        answer.moves.push_back(random_move(random, car));
    return answer;
}

inline WrittenAtlas random_atlas(Random& random, int most_cars = 4, int most_widths = 6, int most_lengths = 30) {
    WrittenAtlas atlas;
    atlas.plan.cars = random_cars(random, most_cars);
    atlas.plan.widths = random_axis(random, most_widths);
    atlas.plan.lengths = random_axis(random, most_lengths);
    AtlasOptions& options = atlas.plan.options;
    options.strategy = random.chance(0.5) ? Strategy::max_steer : Strategy::fewest;
    if (random.chance(0.5)) options.max_changes = random.below(30);
    if (random.chance(0.5)) options.min_range = random.unit();
    if (random.chance(0.5)) options.resolution = random.unit();
    if (random.chance(0.5)) options.driving.clearance = random.unit();
    if (random.chance(0.5)) options.driving.enter = Enter::forward;
    for (const Car& car : atlas.plan.cars)
        for (std::size_t i = 0; i < atlas.plan.widths.size() * atlas.plan.lengths.size(); ++i)
            atlas.answers.push_back(random_answer(random, car, options));
    atlas.bytes = written(atlas.plan, atlas.answers);
    return atlas;
}

/// Everything in a cell, as text.
inline std::string told(const CellAnswer& answer) {
    std::ostringstream out;
    out.precision(17);
    out << answer.direction_changes.value_or(-1) << ' ' << answer.lower_bound << ' ' << answer.proved << " entry "
        << answer.entry.x << ' ' << answer.entry.y << ' ' << answer.entry.heading;
    for (const HeadingRange& range : answer.ranges)
        out << "\nrange " << range.min << ' ' << range.max << ' ' << range.direction_changes << ' ' << range.subrange;
    for (const AtlasMove& move : answer.moves) {
        out << "\nmove " << to_string(move.direction) << ' ' << move.steering_angle << ' ' << move.length;
        if (move.contact) out << ' ' << to_string(move.contact->part) << ' ' << to_string(move.contact->obstacle);
    }
    return out.str();
}

inline CellAnswer stored_in(const AtlasCell& cell) {
    CellAnswer answer{cell.direction_changes(), cell.lower_bound(), cell.proved(), {}, cell.entry(), {}};
    for (std::size_t i = 0; i < cell.ranges(); ++i) answer.ranges.push_back(cell.range(i));
    for (std::size_t i = 0; i < cell.moves(); ++i) answer.moves.push_back(cell.move(i));
    return answer;
}

}  // namespace snug::test
