// Every reader of files, and the solver itself, fed by libFuzzer: the first byte says which. Whatever the bytes are, the answer is
// a value or an Error of one line, and what a value gives when it is written is read back.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../atlas/reseal.hpp"
#include "snug/atlas.hpp"
#include "snug/atlas_build.hpp"
#include "snug/io.hpp"
#include "snug/scene.hpp"
#include "snug/snug.hpp"

namespace {

[[noreturn]] void fail(const std::string& what) {
    std::cerr << what << '\n';
    std::abort();
}

void expect(bool holds, const char* what) {
    if (!holds) fail(what);
}

void read_car(std::string_view text) {
    const snug::Car car = snug::car_from_json(text, "fuzz");
    expect(snug::car_from_json(snug::as_json(car).dump(), "again") == car, "a car is not read back as it was written");
}

void read_fleet(std::string_view text) {
    const std::vector<snug::Car> cars = snug::cars_from_csv(text, "fuzz");
    if (!cars.empty())
        expect(snug::cars_from_csv(snug::as_csv(cars), "again") == cars, "a fleet is not read back as it was written");
}

/// Numbers of every size, mostly those of cars.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

    double next(double usual) {
        if (bytes_.empty()) return usual;
        const auto kind = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        if (kind < 200) return usual * kind / 100.0;
        double any = usual;
        std::memcpy(&any, bytes_.data(), std::min(sizeof any, bytes_.size()));
        bytes_.remove_prefix(std::min(sizeof any, bytes_.size()));
        return any;
    }

private:
    std::string_view bytes_;
};

void solve(std::string_view bytes) {
    Numbers numbers(bytes);
    snug::CarDimensions size;
    size.width = numbers.next(1.8);
    size.front = numbers.next(3.5);
    size.rear = numbers.next(0.8);
    size.wheelbase = numbers.next(2.6);
    size.max_steer = numbers.next(0.6);
    const snug::Car car(size, "");
    snug::SlotDimensions room;
    room.length = numbers.next(5.0);
    room.width = numbers.next(2.1);
    const snug::Slot slot(room);
    snug::EntryOptions options;
    options.max_changes = 12;
    options.driving.clearance = std::abs(numbers.next(0.0));
    int reports = 0;
    options.progress = [&](double) { return ++reports < 10; };
    const snug::Answer answer = snug::entry(car, slot, options);
    expect(answer.parkable() == answer.maneuver.has_value(), "a parkable slot has no maneuver, or another has one");
    if (answer.maneuver)
        expect(answer.maneuver->direction_changes() == *answer.direction_changes, "the maneuver has another count");
}

/// An exported atlas of two cars, one of them round, with all that can be in a cell.
std::string small_atlas() {
    using namespace snug;
    const Outline round = Outline::rounded(3.4, 0.7, 0.9, 0.3, 0.2);
    const AtlasPlan plan = {{*find_car("renault-zoe"), Car(round, 2.6, 0.6, "round")}, {2.0, 2.1}, {5.0, 5.1, 5.2}, {}};
    CellAnswer answer;
    answer.direction_changes = 1;
    answer.ranges = {{0.4, 0.5, 1, 0}};
    answer.entry = {0.5, 1.0, 0.45};
    answer.moves = {{Direction::backward, 0.5, 1.0, Contact{CarPart::rear_right_corner, Obstacle::curb}},
                    {Direction::forward, -0.3, 0.2, {}}};
    std::string bytes;
    AtlasWriter writer(plan, "fuzz", [&](std::string_view part) { bytes += part; });
    for (int i = 0; i < 12; ++i) writer.add(i % 3 == 2 ? CellAnswer{} : answer);
    writer.finish();
    std::string sealed = bytes;
    snug::test::reseal(sealed);
    expect(sealed == bytes, "a whole atlas is sealed otherwise than it was");
    return bytes;
}

/// Everything in an atlas; of one that says it is enormous the beginning and the end.
void read_all(const snug::Atlas& atlas) {
    const auto each = [](std::size_t count, const auto& look) {
        for (std::size_t i = 0; i < std::min<std::size_t>(count, 4); ++i) {
            look(i);
            look(count - 1 - i);
        }
    };
    const auto read_cell = [&](const snug::AtlasCell& cell, std::size_t car) {
        for (std::size_t i = 0; i < cell.ranges(); ++i) static_cast<void>(cell.range(i));
        try {
            for (const snug::Side side : {snug::Side::right, snug::Side::left})
                static_cast<void>(snug::maneuver(cell, atlas.car(car), snug::Slot({5.1, 2.0, side})));
        } catch (const snug::Error&) {  // no such car can exist
        }
    };
    each(atlas.cars(), [&](std::size_t car) {
        static_cast<void>(atlas.find_car(atlas.car_name(car)));
        each(atlas.widths(), [&](std::size_t width) {
            each(atlas.lengths(), [&](std::size_t length) {
                if (const auto cell = atlas.cell(car, width, length)) read_cell(*cell, car);
                read_cell(atlas.look_up(car, atlas.length(length) + 1e-3, atlas.width(width) + 1e-3).cell, car);
            });
        });
    });
    each(atlas.blocks(), [&](std::size_t block) { static_cast<void>(atlas.block_is_whole(block)); });
}

/// An atlas as the bytes are, or a whole one in which they change words, of which the checksums are made right again.
void read_atlas(std::string_view text) {
    std::string bytes(text);
    if (!text.empty() && text.front() % 8 != 0) {
        static const std::string whole = small_atlas();
        bytes = whole;
        for (text.remove_prefix(1); text.size() >= 6; text.remove_prefix(6)) {
            std::uint16_t at = 0;
            std::memcpy(&at, text.data(), sizeof at);
            std::memcpy(bytes.data() + at % (bytes.size() - 3), text.data() + sizeof at, 4);
        }
        snug::test::reseal(bytes);
    }
    const std::vector<char> exact(bytes.begin(), bytes.end());  // ends where its memory ends
    read_all(snug::Atlas(std::as_bytes(std::span(exact))));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0] % 6) {
            case 0: read_car(bytes); break;
            case 1: read_fleet(bytes); break;
            case 2: static_cast<void>(snug::scene_from_json(bytes, "fuzz")); break;
            case 3: static_cast<void>(snug::scene_from_csv(bytes, "fuzz")); break;
            case 4: read_atlas(bytes); break;
            default: solve(bytes); break;
        }
    } catch (const snug::Error& error) {
        const std::string_view what = error.what();
        expect(!what.empty() && what.size() < 1000 && what.find('\n') == std::string_view::npos,
               "an error is no sentence of one line");
    }
    return 0;
}
