// Every reader of files, and the solver itself, fed by libFuzzer: the first byte says which. Whatever the bytes are, the answer is
// a value or an Error of one line, and what a value gives when it is written is read back.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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
    options.progress = [&](double) { return ++reports < 200; };
    const snug::Answer answer = snug::entry(car, slot, options);
    expect(answer.parkable() == answer.maneuver.has_value(), "a parkable slot has no maneuver, or another has one");
    if (answer.maneuver)
        expect(answer.maneuver->direction_changes() == *answer.direction_changes, "the maneuver has another count");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0] % 5) {
            case 0: read_car(bytes); break;
            case 1: read_fleet(bytes); break;
            case 2: static_cast<void>(snug::scene_from_json(bytes, "fuzz")); break;
            case 3: static_cast<void>(snug::scene_from_csv(bytes, "fuzz")); break;
            default: solve(bytes); break;
        }
    } catch (const snug::Error& error) {
        const std::string_view what = error.what();
        expect(!what.empty() && what.size() < 1000 && what.find('\n') == std::string_view::npos,
               "an error is no sentence of one line");
    }
    return 0;
}
