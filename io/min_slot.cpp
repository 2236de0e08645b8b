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
    return json;
}

}  // namespace snug
