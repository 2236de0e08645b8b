#include "paper/scenes.hpp"

#include <numbers>

#include "io/csv.hpp"
#include "paper/headings.hpp"
#include "snug/entry.hpp"

namespace snug::paper {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2.0;

// The paper shows its positions in a slot it does not name. In this one the entry headings fall into two subranges.
constexpr double extra_length = 1.1;  // [m]
constexpr double slot_width = 2.0;    // [m]
constexpr int max_changes = 2;

File table_of_cars() {
    Csv csv({"car", "width", "front", "rear", "wheelbase", "max_steer_deg", "turning_radius", "curb_to_curb"});
    for (const Car& car : catalogue())
        csv.row(car.name(), car.width(), car.front(), car.rear(), car.wheelbase(),
                car.max_steer() * 180.0 / std::numbers::pi, car.turning_radius(), car.curb_to_curb());
    return {"cars.csv", csv.text()};
}

/// Each line is a polygon or a path, its points in order.
File frames_and_paths() {
    Csv csv({"car", "line", "x", "y"});
    for (const Car& car : catalogue()) {
        for (const Point& corner : frame(car, {})) csv.row(car.name(), "frame", corner.x, corner.y);
        for (int degrees = 0; degrees <= 90; ++degrees) {
            const double distance = car.turning_radius() * degrees * std::numbers::pi / 180.0;
            const Pose pose = drive(car, {}, Direction::forward, car.max_steer(), distance);
            csv.row(car.name(), "rear axle", pose.x, pose.y);
        }
        for (int degrees = 0; degrees <= 90; ++degrees) {
            const double distance = car.turning_radius() * degrees * std::numbers::pi / 180.0;
            const Point corner = frame(car, drive(car, {}, Direction::forward, car.max_steer(), distance))[3];
            csv.row(car.name(), "front-right corner", corner.x, corner.y);
        }
    }
    return {"car_paths.csv", csv.text()};
}

Csv position_table() {
    return Csv({"position", "x", "y", "heading", "front_left_x", "front_left_y", "rear_left_x", "rear_left_y",
                "rear_right_x", "rear_right_y", "front_right_x", "front_right_y"});
}

void add_position(Csv& csv, const char* kind, const Car& car, const Pose& pose) {
    const auto corners = frame(car, pose);
    csv.row(kind, pose.x, pose.y, pose.heading, corners[0].x, corners[0].y, corners[1].x, corners[1].y, corners[2].x,
            corners[2].y, corners[3].x, corners[3].y);
}

/// The slot as one more position: its corners, in the frame's order.
void add_slot(Csv& csv, const Slot& slot) {
    csv.row("slot", 0.0, 0.0, 0.0, 0.0, 0.0, -slot.length(), 0.0, -slot.length(), -slot.width(), 0.0, -slot.width());
}

File possible_entries(const Car& car, const Slot& slot) {
    Csv csv = position_table();
    add_slot(csv, slot);
    constexpr int positions = 90;
    for (int i = 0; i <= positions; ++i) {
        const MaxSteerRun run = max_steer(car, slot, quarter_turn * i / positions, {.max_changes = 0});
        if (run.outcome != Outcome::no_entry) add_position(csv, "possible entry", car, run.maneuver.entry());
    }
    return {"possible_entries.csv", csv.text()};
}

File entries_and_goals(const Car& car, const Slot& slot) {
    Csv csv = position_table();
    add_slot(csv, slot);
    EntryOptions options;
    options.prove = false;
    options.max_changes = max_changes;
    constexpr int positions = 3;  // per subrange
    for (const Subrange& range : subranges(entry(car, slot, options).ranges)) {
        for (int i = 0; i <= positions; ++i) {
            const double heading = range.min + (range.max - range.min) * i / positions;
            const MaxSteerRun run = max_steer(car, slot, heading, {.max_changes = max_changes});
            if (run.outcome != Outcome::parked) continue;
            add_position(csv, "entry", car, run.maneuver.entry());
            add_position(csv, "goal", car, run.maneuver.goal());
        }
    }
    return {"entries_and_goals.csv", csv.text()};
}

}  // namespace

std::vector<File> scenes() {
    const Car zoe = find_car("renault-zoe").value();
    const Slot slot({.length = zoe.length() + extra_length, .width = slot_width});
    return {table_of_cars(), frames_and_paths(), possible_entries(zoe, slot), entries_and_goals(zoe, slot)};
}

}  // namespace snug::paper
