// A minimum slot as a JSON object.
#include <nlohmann/json.hpp>
#include <string>

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

}  // namespace snug
