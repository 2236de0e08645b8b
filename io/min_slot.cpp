// Minimum slots and streets as JSON objects.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/conditions.hpp"
#include "io/csv.hpp"
#include "snug/io.hpp"

namespace snug {

Json as_json(const MinSlot& slot, const MinSlotOptions& options) {
    const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
    Json json = {{"max_changes", slot.max_changes}, {"width", or_null(slot.width)}, {"length", or_null(slot.length)}};
    if (options.strategy == Strategy::fewest) {
        json[std::string(to_string(options.sought)) + "_lower"] = slot.lower;
    } else {
        json["entry_heading"] = or_null(slot.entry_heading);
    }
    if (options.prove && options.strategy == Strategy::max_steer) {
        const std::string sought(to_string(options.sought));
        json[sought + "_lower"] = slot.lower;
        Json open = Json::array();
        for (const Sizes& sizes : slot.open)
            open.push_back({{sought + "_min", sizes.min}, {sought + "_max", sizes.max}});
        json["open"] = open;
    }
    return json;
}

Json min_streets_as_json(const Car& car, const std::vector<Street>& streets, const MinStreetOptions& options,
                         const std::vector<MinStreet>& rows) {
    // What all of them have in common.
    Json slot = as_json(streets.front());
    for (const char* varies : {"length", "width", "road", "side", "corner", "heading"}) slot.erase(varies);
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"strategy", to_string(Strategy::fewest)}, {"slot", slot}};
    Driving driving;
    driving.clearance = options.clearance;
    driving.curb_clearance = streets.front().curb_clearance;
    driving.enter = streets.front().enter;
    add_conditions(json, driving, streets.front().parked);
    json["rows"] = Json::array();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Street& street = streets[i * streets.size() / rows.size()];
        Json& row = json["rows"].emplace_back(Json{{"max_changes", rows[i].max_changes}});
        for (const StreetSize which : {StreetSize::length, StreetSize::width, StreetSize::road}) {
            const std::string name(to_string(which));
            const bool sought = which == options.sought;
            const std::optional<double> size = sought ? rows[i].size : size_of(street, which);
            row[name] = size ? Json(*size) : Json(nullptr);
            if (sought) row[name + "_lower"] = rows[i].lower;
        }
    }
    return json;
}

std::string min_streets_as_csv(const std::vector<Street>& streets, StreetSize sought,
                               const std::vector<MinStreet>& rows) {
    Csv csv({"max_changes", "length", "width", "road", std::string(to_string(sought)) + "_lower"});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Street street = streets[i * streets.size() / rows.size()];
        const auto size = [&](StreetSize which) { return which == sought ? rows[i].size : size_of(street, which); };
        csv.row(rows[i].max_changes, size(StreetSize::length), size(StreetSize::width), size(StreetSize::road),
                rows[i].lower);
    }
    return csv.text();
}

}  // namespace snug
