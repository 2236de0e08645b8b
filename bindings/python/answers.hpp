// Answers with what was asked: as far as their JSON and their pictures say it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "snug/scene.hpp"
#include "snug/snug.hpp"

namespace snug::python {

/// What counts as parked, of limits that may not have been given.
inline Parked parked_within(const std::optional<double>& heading, const std::optional<double>& curb) {
    Parked parked;
    if (heading) parked.heading = *heading;
    if (curb) parked.curb = *curb;
    return parked;
}

/// Of entry(), fewest(), leave() and an atlas.
struct AskedAnswer : Answer {
    std::optional<Car> car;
    std::optional<Slot> slot;
    std::string strategy;  ///< in the command's words
    bool leaving = false;
    std::optional<int> max_changes;  ///< as asked
    Driving driving;
    std::optional<double> parked_heading;
    std::optional<double> parked_curb;
    bool prove = false;
    std::optional<std::pair<double, double>> cell;  ///< of an atlas: length and width of the stored slot

    [[nodiscard]] Parked parked() const { return parked_within(parked_heading, parked_curb); }
    /// What all maneuvers can do where the strategy cannot park.
    [[nodiscard]] std::optional<AskedAnswer> any_maneuver() const;
    /// By how much the start of its maneuver may be off, of full steering.
    [[nodiscard]] std::optional<StartTolerance> start_tolerance() const;

private:
    /// Found once: copies share it.
    mutable std::shared_ptr<const std::optional<Answer>> any_;
    mutable std::shared_ptr<const std::optional<StartTolerance>> off_;
};

/// Of min_slot().
struct AskedMinSlot : MinSlot {
    std::optional<Car> car;
    Strategy strategy = Strategy::max_steer;
    bool prove = false;
    Sought sought = Sought::length;
    Driving driving;
    std::optional<double> parked_heading, parked_curb;
    double front_setback = 0.0, rear_setback = 0.0;
    Curb curb = Curb::high;
};

/// Of min_street().
struct AskedMinStreet : MinStreet {
    std::optional<Car> car;
    std::optional<Street> street;
    StreetSize sought = StreetSize::road;
    double clearance = 0.0;
};

/// Of max_steer() and stepping().
struct AskedRun {
    Outcome outcome = Outcome::no_entry;
    std::optional<Maneuver> maneuver;
    std::optional<Slot> slot;
};

using AnyPlace = std::variant<Street, Scene>;

/// Of park().
struct AskedPark : ParkAnswer {
    std::optional<Car> car;
    std::optional<AnyPlace> place;
    Pose start;
    int max_changes = 0;  ///< as asked
    double clearance = 0.0;
};

/// A map, and of what in Python's words.
struct MapOf {
    AnyPlace of;
    std::optional<double> heading;
    ParkMap map;
};

// The command's JSON, by the same functions.
std::string json_text(const Car& car);
std::string json_text(const Slot& slot);
std::string json_text(const Pose& pose);
std::string json_text(const Box& box);
std::string json_text(const Contact& contact);
std::string json_text(const Move& move);
std::string json_text(const Maneuver& maneuver);
std::string json_text(const Street& street);
std::string json_text(const Scene& scene);
std::string json_text(const HeadingRange& range);
std::string json_text(const Headings& headings);
std::string json_text(const AskedAnswer& answer);
std::string json_text(const AskedMinSlot& slot);
std::string json_text(const AskedMinStreet& street);
std::string json_text(const AskedPark& answer);

// The solver's own pictures as SVG; empty where there is nothing to see.
std::optional<std::string> picture(const Maneuver& maneuver);  ///< alone
std::optional<std::string> picture(const AskedAnswer& answer);
std::optional<std::string> picture(const AskedMinSlot& slot);      ///< the car parking in it
std::optional<std::string> picture(const AskedMinStreet& street);  ///< likewise
std::optional<std::string> picture(const AskedRun& run);
std::optional<std::string> picture(const AskedPark& answer);
std::optional<std::string> picture(const MapOf& map);

}  // namespace snug::python
