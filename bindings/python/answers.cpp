// How answers convert and show themselves.
#include "answers.hpp"

#include <pybind11/pybind11.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "snug/any_maneuver.hpp"
#include "snug/draw.hpp"
#include "snug/io.hpp"
#include "value.hpp"

namespace snug::python {

namespace {

Json json_of(py::handle value) {
    if (value.is_none()) return nullptr;
    if (PyBool_Check(value.ptr())) return value.ptr() == Py_True;
    if (PyLong_Check(value.ptr())) return value.cast<std::int64_t>();
    if (PyFloat_Check(value.ptr())) return value.cast<double>();
    if (PyUnicode_Check(value.ptr())) return value.cast<std::string>();
    if (py::hasattr(value, "to_json")) return Json::parse(value.attr("to_json")().cast<std::string>());
    Json all = Json::array();
    for (const py::handle one : value) all.push_back(json_of(one));
    return all;
}

}  // namespace

std::string json_of_fields(const py::object& self, const py::tuple& fields) {
    Json json = Json::object();
    for (const py::handle name : fields) json[std::string(py::str(name))] = json_of(self.attr(name));
    return write(json);
}

std::string table_of_fields(const py::object& self, const py::tuple& fields) {
    const py::object escape = py::module_::import("html").attr("escape");
    std::string table = "<table>";
    for (const py::handle name : fields)
        table.append("<tr><th>")
            .append(py::str(name))
            .append("</th><td>")
            .append(py::str(escape(py::str(self.attr(name)))))
            .append("</td></tr>");
    return table + "</table>";
}

py::object read_json(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

std::string spelled_value(const py::object& self, const py::tuple& fields, const Signature* constructor) {
    std::string text = py::str(py::type::of(self).attr("__name__"));
    const char* separator = "";
    text.append("(");
    for (const py::handle name : fields) {
        const py::object value = self.attr(name);
        const std::string spelled = py::repr(value);
        if (constructor != nullptr) {
            const std::string usual = constructor->default_of(std::string(py::str(name)));
            if (spelled == usual) continue;
            if (py::isinstance<Point>(value) && std::string(py::repr(py::tuple(value))) == usual) continue;
        }
        text.append(separator).append(py::str(name)).append("=").append(spelled);
        separator = ", ";
    }
    return text + ")";
}

std::optional<AskedAnswer> AskedAnswer::any_maneuver() const {
    if (cancelled || parkable() || leaving || cell || strategy == "fewest") return std::nullopt;
    if (!any_) {
        const auto found = [&] {
            const py::gil_scoped_release interpreter;
            return snug::any_maneuver(*car, *slot, driving, parked());
        }();
        any_ = std::make_shared<const std::optional<Answer>>(found);
    }
    if (!*any_) return std::nullopt;
    AskedAnswer other = *this;
    static_cast<Answer&>(other) = **any_;
    other.strategy = to_string(Strategy::fewest);
    other.max_changes.reset();
    other.prove = false;
    return other;
}

std::optional<StartTolerance> AskedAnswer::start_tolerance() const {
    if (!parkable() || leaving || cell || strategy != to_string(Strategy::max_steer)) return std::nullopt;
    if (!off_) {
        EntryOptions options;
        options.driving = driving;
        options.parked = parked();
        const auto found = [&] {
            const py::gil_scoped_release interpreter;
            return snug::start_tolerance(*car, *slot, *this, options);
        }();
        off_ = std::make_shared<const std::optional<StartTolerance>>(found);
    }
    return *off_;
}

std::string json_text(const Car& car) { return write(as_json(car)); }
std::string json_text(const Slot& slot) { return write(as_json(slot)); }
std::string json_text(const Pose& pose) { return write(as_json(pose)); }
std::string json_text(const Box& box) { return write(as_json(box)); }
std::string json_text(const Contact& contact) {
    return write({{"car", to_string(contact.part)}, {"obstacle", to_string(contact.obstacle)}});
}
std::string json_text(const Move& move) { return write(as_json(move)); }
std::string json_text(const Maneuver& maneuver) {
    if (maneuver.moves.empty()) return write({{"direction_changes", 0}, {"length", 0.0}, {"moves", Json::array()}});
    return write(as_json(maneuver));
}
std::string json_text(const Street& street) { return write(as_json(street)); }
std::string json_text(const Scene& scene) { return write(as_json(scene)); }
std::string json_text(const HeadingRange& range) {
    return write({{"heading_min", range.min},
                  {"heading_max", range.max},
                  {"direction_changes", range.direction_changes},
                  {"subrange", range.subrange}});
}

std::string json_text(const Headings& headings) {
    return write({{"heading_min", headings.min}, {"heading_max", headings.max}});
}

std::string json_text(const AskedAnswer& answer) {
    if (answer.leaving) return write(leave_as_json(*answer.car, *answer.slot, answer, answer.driving));
    Json json;
    if (answer.strategy == to_string(Strategy::fewest)) {
        json = as_json(*answer.car, *answer.slot, answer.max_changes, answer, answer.driving, answer.parked());
    } else {
        EntryOptions options;
        options.max_changes = answer.max_changes;
        options.driving = answer.driving;
        options.parked = answer.parked();
        options.prove = answer.prove;
        json = as_json(*answer.car, *answer.slot, options, answer, answer.strategy);
        if (const auto any = answer.any_maneuver()) json["any_maneuver"] = any_maneuver_as_json(*any);
        if (const auto tolerance = answer.start_tolerance()) json["start_tolerance"] = as_json(*tolerance);
    }
    if (answer.cell)
        json["cell"] = {{"length", answer.cell->first},
                        {"width", answer.cell->second},
                        {"shorter", answer.slot->length() - answer.cell->first},
                        {"narrower", answer.slot->width() - answer.cell->second}};
    return write(json);
}

std::string json_text(const AskedMinSlot& slot) {
    MinSlotOptions options;
    options.strategy = slot.strategy;
    options.sought = slot.sought;
    options.prove = slot.prove;
    ListInParts list;
    std::string text =
        list.begin({{"schema", 1}, {"car", as_json(*slot.car)}, {"strategy", to_string(slot.strategy)}}, "rows");
    text += list.item(as_json(slot, options));
    return text + list.end();
}

std::string json_text(const AskedMinStreet& street) {
    MinStreetOptions options;
    options.sought = street.sought;
    options.clearance = street.clearance;
    return write(min_streets_as_json(*street.car, {*street.street}, options, {street}));
}

std::string json_text(const AskedPark& answer) {
    ParkOptions options;
    options.max_changes = answer.max_changes;
    options.clearance = answer.clearance;
    if (const auto* street = std::get_if<Street>(&*answer.place))
        return write(park_as_json(*answer.car, *street, answer.start, options, answer));
    Scene scene = std::get<Scene>(*answer.place);
    scene.start = answer.start;
    return write(park_as_json(*answer.car, scene, options, answer));
}

std::optional<std::string> picture(const Maneuver& maneuver) {
    if (maneuver.moves.empty()) return std::nullopt;
    return draw_maneuver(maneuver, PictureFormat::svg);
}

std::optional<std::string> picture(const AskedAnswer& answer) {
    if (answer.cancelled || (answer.leaving && !answer.maneuver)) return std::nullopt;
    const PictureOptions options = {answer.driving};
    if (answer.leaving) return draw_maneuver(*answer.slot, *answer.maneuver, PictureFormat::svg, options);
    return draw_maneuver(*answer.car, *answer.slot, answer, PictureFormat::svg, options);
}

std::optional<std::string> picture(const AskedMinSlot& found) {
    if (!found.length || !found.width) return std::nullopt;
    const Slot slot({.length = *found.length,
                     .width = *found.width,
                     .front_setback = found.front_setback,
                     .rear_setback = found.rear_setback,
                     .curb = found.curb});
    const Parked parked = parked_within(found.parked_heading, found.parked_curb);
    const std::optional<Maneuver> maneuver = [&]() -> std::optional<Maneuver> {
        const py::gil_scoped_release interpreter;
        if (found.strategy == Strategy::fewest) {
            FewestOptions options;
            options.max_changes = found.max_changes;
            options.driving = found.driving;
            options.parked = parked;
            return fewest(*found.car, slot, options).maneuver;
        }
        const MaxSteerRun run =
            max_steer(*found.car, slot, found.entry_heading.value_or(0.0), {found.max_changes, found.driving, parked});
        if (run.outcome != Outcome::parked) return std::nullopt;
        return run.maneuver;
    }();
    if (!maneuver) return std::nullopt;
    return draw_maneuver(slot, *maneuver, PictureFormat::svg, {found.driving});
}

std::optional<std::string> picture(const AskedMinStreet& found) {
    if (!found.size) return std::nullopt;
    const Street street = with_size(*found.street, found.sought, *found.size);
    const Pose start = standard_start(street, *found.car);
    ParkOptions options;
    options.max_changes = found.max_changes;
    options.clearance = found.clearance;
    const ParkAnswer answer = [&] {
        const py::gil_scoped_release interpreter;
        return park(*found.car, street_place(street), start, options);
    }();
    if (!answer.parkable()) return std::nullopt;
    PictureOptions picture;
    picture.driving.clearance = found.clearance;
    return draw_park(*found.car, street, start, answer, PictureFormat::svg, picture);
}

std::optional<std::string> picture(const AskedRun& run) {
    return draw_maneuver(*run.slot, *run.maneuver, PictureFormat::svg);
}

std::optional<std::string> picture(const AskedPark& answer) {
    PictureOptions options;
    options.driving.clearance = answer.clearance;
    if (const auto* street = std::get_if<Street>(&*answer.place))
        return draw_park(*answer.car, *street, answer.start, answer, PictureFormat::svg, options);
    Scene scene = std::get<Scene>(*answer.place);
    scene.start = answer.start;
    return draw_park(*answer.car, scene, answer, PictureFormat::svg, options);
}

std::optional<std::string> picture(const MapOf& map) {
    if (const auto* street = std::get_if<Street>(&map.of))
        return draw_map(map.map, *street, standard_start(*street, map.map.car()), PictureFormat::svg);
    return draw_map(map.map, std::get<Scene>(map.of), PictureFormat::svg);
}

}  // namespace snug::python
