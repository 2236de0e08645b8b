// The questions of the library for JavaScript. What goes in and out are the objects of the command's JSON, key by key, so
// that docs/formats.md describes both; snug.d.ts has their types.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "snug/io.hpp"
#include "snug/leave.hpp"
#include "snug/scene.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

using emscripten::val;

/// What stands under a key of an options object; empty where there is none.
std::optional<val> given(const val& object, const char* key) {
    if (object.isUndefined() || object.isNull()) return std::nullopt;
    const val value = object[key];
    return value.isUndefined() || value.isNull() ? std::nullopt : std::optional(value);
}

std::optional<double> number_given(const val& object, const char* key) {
    const std::optional<val> value = given(object, key);
    if (value && !value->isNumber()) throw Error(std::string("\"") + key + "\" must be a number");
    return value ? std::optional(value->as<double>()) : std::nullopt;
}

double number(const val& object, const char* key) {
    const std::optional<double> value = number_given(object, key);
    if (!value) throw Error(std::string("\"") + key + "\" is missing; give a number");
    return *value;
}

/// A count as the options take it; what no int can hold is an Error as from any other number out of range.
std::optional<int> count_given(const val& object, const char* key) {
    const std::optional<double> value = number_given(object, key);
    if (!value) return std::nullopt;
    if (!(*value >= -1e9 && *value <= 1e9) || static_cast<double>(static_cast<int>(*value)) != *value)
        throw Error(std::string("\"") + key + "\" must be a whole number");
    return static_cast<int>(*value);
}

std::optional<bool> flag_given(const val& object, const char* key) {
    const std::optional<val> value = given(object, key);
    if (value && !value->isTrue() && !value->isFalse())
        throw Error(std::string("\"") + key + "\" must be true or false");
    return value ? std::optional(value->isTrue()) : std::nullopt;
}

/// One of two words; the first where nothing is given.
bool second_word(const val& object, const char* key, const std::string& first, const std::string& second) {
    const std::optional<val> value = given(object, key);
    if (!value) return false;
    const std::string word = value->isString() ? value->as<std::string>() : "";
    if (word != first && word != second)
        throw Error(std::string("\"") + key + "\" must be \"" + first + "\" or \"" + second + "\"");
    return word == second;
}

Car car_from(const val& object) {
    if (object.isString()) {
        const std::string name = object.as<std::string>();
        if (const std::optional<Car> car = find_car(name)) return *car;
        const std::optional<std::string> nearest = nearest_car_name(name);
        throw Error("no car has that name" +
                    (nearest ? "; did you mean \"" + *nearest + "\"?" : "; cars() lists them"));
    }
    const val text = val::global("JSON").call<val>("stringify", object);
    return car_from_json(text.isString() ? text.as<std::string>() : "", "car");
}

Slot slot_from(const val& object) {
    SlotDimensions slot;
    slot.length = number(object, "length");
    slot.width = number(object, "width");
    slot.side = second_word(object, "side", "right", "left") ? Side::left : Side::right;
    if (const std::optional<val> corner = given(object, "corner"))
        slot.corner = {number(*corner, "0"), number(*corner, "1")};
    slot.heading = number_given(object, "heading").value_or(0.0);
    slot.front_setback = number_given(object, "front_setback").value_or(0.0);
    slot.rear_setback = number_given(object, "rear_setback").value_or(0.0);
    slot.curb = second_word(object, "curb", "high", "low") ? Curb::low : Curb::high;
    return Slot(slot);
}

/// The options that every question has.
template <class Options>
Options common(const val& object) {
    Options options;
    options.driving.clearance = number_given(object, "clearance").value_or(0.0);
    options.driving.curb_clearance = number_given(object, "curb_clearance");
    options.driving.enter = second_word(object, "enter", "backward", "forward") ? Enter::forward : Enter::backward;
    if (const std::optional<val> parked = given(object, "parked")) {
        options.parked.heading = number_given(*parked, "heading").value_or(options.parked.heading);
        options.parked.curb = number_given(*parked, "curb").value_or(options.parked.curb);
    }
    return options;
}

val as_object(const Json& json) {
    return val::global("JSON").call<val>("parse", json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// What the callback under "progress" wants: to go on, unless it returns false.
template <class Told>
bool goes_on(const val& progress, const Told& told) {
    return !progress(told).isFalse();
}

/// The answer; an Error becomes JavaScript's, with the same message.
template <class Question>
val answered(const Question& question) {
    std::string message;
    try {
        return question();
    } catch (const std::bad_alloc&) {
        message = "out of memory; ask for a coarser resolution or a smaller slot";
    } catch (const std::exception& error) {
        message = error.what();
    }
    val::global("Error").new_(message).throw_();
}

val cars() {
    return answered([] {
        Json list = Json::array();
        for (const Car& car : catalogue()) list.push_back(as_json(car));
        return as_object(list);
    });
}

/// The cars of data sheets, each with the sheet that has its lengths and the circle as printed there.
val sheet_cars_question() {
    return answered([] {
        Json list = Json::array();
        for (const SheetCar& known : sheet_cars()) {
            Json car = as_json(known.car);
            car["sheet"] = known.sheet;
            car["circle"] = known.circle;
            list.push_back(std::move(car));
        }
        return as_object(list);
    });
}

/// A car as it is understood: by its name, or from what a car file says.
val car_question(const val& given_car) {
    return answered([&] { return as_object(as_json(car_from(given_car))); });
}

val entry_question(const val& given_car, const val& given_slot, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const Slot slot = slot_from(given_slot);
        auto options = common<EntryOptions>(given_options);
        options.max_changes = count_given(given_options, "max_changes");
        options.min_range = number_given(given_options, "min_range").value_or(0.0);
        options.prove = flag_given(given_options, "prove").value_or(options.prove);
        if (const std::optional<val> progress = given(given_options, "progress"))
            options.progress = [progress](double part) { return goes_on(*progress, part); };
        return as_object(as_json(car, slot, options, entry(car, slot, options)));
    });
}

val max_steer_question(const val& given_car, const val& given_slot, const val& heading, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const Slot slot = slot_from(given_slot);
        auto options = common<MaxSteerOptions>(given_options);
        options.max_changes = count_given(given_options, "max_changes").value_or(options.max_changes);
        if (!heading.isNumber()) throw Error("the entry heading must be a number");
        const MaxSteerRun run = max_steer(car, slot, heading.as<double>(), options);
        constexpr const char* outcomes[] = {"parked", "no-entry", "stuck", "never-touches", "too-many-changes"};
        Json json = {{"outcome", outcomes[static_cast<int>(run.outcome)]}};
        if (!run.maneuver.moves.empty()) json["maneuver"] = as_json(run.maneuver);
        return as_object(json);
    });
}

FewestOptions fewest_options(const val& object) {
    auto options = common<FewestOptions>(object);
    options.max_changes = count_given(object, "max_changes").value_or(options.max_changes);
    options.resolution = number_given(object, "resolution").value_or(0.0);
    options.time_limit = number_given(object, "time_limit").value_or(options.time_limit);
    options.roomiest = flag_given(object, "roomiest").value_or(options.roomiest);
    if (const std::optional<val> progress = given(object, "progress"))
        options.progress = [progress,
                            last = FewestProgress{-1, std::nullopt, 0.0, 0.0}](const FewestProgress& so_far) mutable {
            // The search reports thousands of times a second; a call into JavaScript is dear.
            if (so_far.lower_bound == last.lower_bound && so_far.direction_changes == last.direction_changes &&
                so_far.spacing == last.spacing && so_far.part < last.part + 0.01)
                return true;
            last = so_far;
            Json json = {{"lower_bound", so_far.lower_bound}, {"spacing", so_far.spacing}, {"part", so_far.part}};
            if (so_far.direction_changes) json["direction_changes"] = *so_far.direction_changes;
            return goes_on(*progress, as_object(json));
        };
    return options;
}

val fewest_question(const val& given_car, const val& given_slot, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const Slot slot = slot_from(given_slot);
        const std::optional<int> max_changes = count_given(given_options, "max_changes");
        const FewestOptions options = fewest_options(given_options);
        return as_object(as_json(car, slot, max_changes, fewest(car, slot, options), options.driving, options.parked));
    });
}

val leave_question(const val& given_car, const val& given_slot, const val& gaps, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const Slot slot = slot_from(given_slot);
        const Pose parked = parked_pose(
            car, slot, {number(gaps, "front"), number(gaps, "curb"), number_given(gaps, "heading").value_or(0.0)});
        const FewestOptions options = fewest_options(given_options);
        return as_object(leave_as_json(car, slot, leave(car, slot, parked, options), options.driving));
    });
}

/// A row of `snug min-slot`: the shortest slot of a width, or the narrowest of a length.
val min_slot_question(const val& given_car, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const std::optional<double> width = number_given(given_options, "width");
        const std::optional<double> length = number_given(given_options, "length");
        if (width.has_value() == length.has_value()) throw Error("give either \"width\" or \"length\" of the slot");
        const int max_changes = count_given(given_options, "max_changes").value_or(0);
        auto options = common<MinSlotOptions>(given_options);
        options.max_changes = max_changes;
        options.sought = width ? Sought::length : Sought::width;
        options.strategy =
            second_word(given_options, "strategy", "max-steer", "fewest") ? Strategy::fewest : Strategy::max_steer;
        options.min_range = number_given(given_options, "min_range").value_or(0.0);
        options.front_setback = number_given(given_options, "front_setback").value_or(0.0);
        options.rear_setback = number_given(given_options, "rear_setback").value_or(0.0);
        options.curb = second_word(given_options, "curb", "high", "low") ? Curb::low : Curb::high;
        options.resolution = number_given(given_options, "resolution").value_or(0.0);
        options.precision = number_given(given_options, "precision").value_or(options.precision);
        options.prove = flag_given(given_options, "prove").value_or(options.prove);
        return as_object(as_json(min_slot(car, width ? *width : *length, options), options));
    });
}

val shortfall_question(const val& given_car, const val& given_slot, const val& given_options) {
    return answered([&] {
        const Shortfall missing =
            shortfall(car_from(given_car), slot_from(given_slot), common<EntryOptions>(given_options).driving);
        return as_object({{"length", missing.length}, {"width", missing.width}});
    });
}

/// A street as `snug park --format json` has it.
Street street_from(const val& object, const val& options) {
    Street street;
    street.length = number(object, "length");
    street.width = number(object, "width");
    street.angle = number_given(object, "angle").value_or(0.0);
    street.road = number_given(object, "road");
    street.stretch = number_given(object, "stretch").value_or(street.stretch);
    street.side = second_word(object, "side", "right", "left") ? Side::left : Side::right;
    if (const std::optional<val> corner = given(object, "corner"))
        street.corner = {number(*corner, "0"), number(*corner, "1")};
    street.heading = number_given(object, "heading").value_or(0.0);
    street.front_setback = number_given(object, "front_setback").value_or(0.0);
    street.rear_setback = number_given(object, "rear_setback").value_or(0.0);
    street.curb = second_word(object, "curb", "high", "low") ? Curb::low : Curb::high;
    const auto shared = common<FewestOptions>(options);
    street.enter = shared.driving.enter;
    street.curb_clearance = shared.driving.curb_clearance;
    street.parked = shared.parked;
    return street;
}

/// A scene says which obstacles it has, a street does not.
std::optional<Scene> scene_from(const val& object) {
    if (!given(object, "obstacles")) return std::nullopt;
    return scene_from_json(val::global("JSON").call<val>("stringify", object).as<std::string>(), "scene");
}

Pose pose_of(const val& pose) {
    return {number(pose, "x"), number(pose, "y"), number_given(pose, "heading").value_or(0.0)};
}

std::optional<Pose> pose_given(const val& object, const char* key) {
    const std::optional<val> pose = given(object, key);
    return pose ? std::optional(pose_of(*pose)) : std::nullopt;
}

/// Where the car is to stand: in the bay, or out of it on the road.
Place place_of(const Street& street, const val& options) {
    return second_word(options, "goal", "bay", "road") ? road_place(street) : street_place(street);
}

/// Any place with a start as a scene, that it may be drawn: a street's bay, or the scene given.
val scene_question(const val& given_car, const val& given_place, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        if (const std::optional<Scene> scene = scene_from(given_place)) return as_object(as_json(*scene));
        const Street street = street_from(given_place, given_options);
        return as_object(as_json(Scene{street_place(street), standard_start(street, car)}));
    });
}

/// The text of a scene file, or of a case of TPCAP where the file's name ends in .csv.
val read_scene_question(const std::string& text, const std::string& name) {
    return answered([&] {
        const bool is_case = name.size() >= 4 && name.substr(name.size() - 4) == ".csv";
        return as_object(as_json(is_case ? scene_from_csv(text, name) : scene_from_json(text, name)));
    });
}

val park_question(const val& given_car, const val& given_place, const val& given_options) {
    return answered([&] {
        const Car car = car_from(given_car);
        const FewestOptions shared = fewest_options(given_options);
        ParkOptions options;
        options.max_changes = shared.max_changes;
        options.clearance = shared.driving.clearance;
        options.resolution = shared.resolution;
        options.time_limit = shared.time_limit;
        options.roomiest = shared.roomiest;
        options.progress = shared.progress;
        const std::optional<Pose> start = pose_given(given_options, "start");
        if (std::optional<Scene> scene = scene_from(given_place)) {
            if (start) scene->start = *start;
            return as_object(park_as_json(car, *scene, options, park(car, scene->place, scene->start, options)));
        }
        const Street street = street_from(given_place, given_options);
        const Pose from = start ? *start : standard_start(street, car);
        return as_object(
            park_as_json(car, street, from, options, park(car, place_of(street, given_options), from, options)));
    });
}

/// From every pose at once. Counts go into JavaScript as whole numbers: -1 outside, -2 where the car meets something,
/// 32767 where no number will do, or none is known.
class MapForPage {
public:
    explicit MapForPage(ParkMap map) : map_(std::move(map)) {}

    [[nodiscard]] val at(const val& pose) const {
        return answered([&] {
            const MapBounds bounds = map_.at(pose_of(pose));
            constexpr const char* where[] = {"free", "blocked", "outside"};
            Json json = {{"where", where[bounds.where]},
                         {"lower_bound", bounds.lower_bound},
                         {"impossible", bounds.impossible},
                         {"proved", bounds.proved()}};
            if (bounds.direction_changes) json["direction_changes"] = *bounds.direction_changes;
            if (bounds.first) json["first"] = *bounds.first == Direction::forward ? "forward" : "backward";
            return as_object(json);
        });
    }
    [[nodiscard]] val maneuver(const val& pose) const {
        return answered([&] {
            const std::optional<Maneuver> found = map_.maneuver(pose_of(pose));
            return found ? as_object(as_json(*found)) : val::null();
        });
    }
    /// For one heading, at the middles of columns x rows fields, row by row from the least y: lower bounds and counts.
    [[nodiscard]] val slice(double heading, const val& box, int columns, int rows) const {
        return answered([&] {
            constexpr int most = 4096;
            if (columns < 1 || rows < 1 || columns > most || rows > most)
                throw Error("a slice has 1 to 4096 columns and rows");
            const double x_min = number(box, "x_min"), x_max = number(box, "x_max"), y_min = number(box, "y_min"),
                         y_max = number(box, "y_max");
            std::vector<std::int16_t> lower, upper;
            for (int row = 0; row < rows; ++row) {
                for (int column = 0; column < columns; ++column) {
                    const MapBounds bounds = map_.at({x_min + (x_max - x_min) * (column + 0.5) / columns,
                                                      y_min + (y_max - y_min) * (row + 0.5) / rows, heading});
                    constexpr std::int16_t more_than_any = 32767, outside = -1, blocked = -2;
                    const bool is_free = bounds.where == MapBounds::free;
                    const std::int16_t nothing = bounds.where == MapBounds::outside ? outside : blocked;
                    lower.push_back(!is_free            ? nothing
                                    : bounds.impossible ? more_than_any
                                                        : static_cast<std::int16_t>(bounds.lower_bound));
                    upper.push_back(!is_free                   ? nothing
                                    : bounds.direction_changes ? static_cast<std::int16_t>(*bounds.direction_changes)
                                                               : more_than_any);
                }
            }
            const val array = val::global("Int16Array");
            val result = val::object();
            result.set("lower", array.new_(emscripten::typed_memory_view(lower.size(), lower.data())));
            result.set("upper", array.new_(emscripten::typed_memory_view(upper.size(), upper.data())));
            return result;
        });
    }
    /// A copy, which can be handed over to another worker.
    [[nodiscard]] val packed() const {
        const std::vector<std::byte> bytes = map_.packed();
        return val::global("Uint8Array")
            .new_(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<const unsigned char*>(bytes.data())));
    }
    [[nodiscard]] std::string fingerprint() const { return std::to_string(map_.fingerprint()); }
    [[nodiscard]] double middle_heading() const { return map_.middle_heading(); }
    [[nodiscard]] double spacing() const { return map_.spacing(); }
    [[nodiscard]] double bytes() const { return static_cast<double>(map_.bytes()); }

private:
    ParkMap map_;
};

/// `make` has a place or a street to make the map of.
template <class Make>
val map_of(const val& given_car, const val& given_place, const val& given_options, const Make& make) {
    return answered([&] {
        const Car car = car_from(given_car);
        ParkMapOptions options;
        options.spacing = number_given(given_options, "spacing").value_or(0.0);
        options.clearance = number_given(given_options, "clearance").value_or(0.0);
        options.max_changes = count_given(given_options, "max_changes").value_or(options.max_changes);
        options.heading = number_given(given_options, "heading");
        if (const std::optional<val> first = given(given_options, "first")) {
            const val pose = (*first)["pose"], known = (*first)["known"];
            options.first = {pose_of(pose), [pose, known](const ParkMap& so_far) {
                                 const MapForPage map(so_far);
                                 known(map.at(pose), map.maneuver(pose));
                             }};
        }
        if (const std::optional<Scene> scene = scene_from(given_place)) {
            if (!options.heading) options.heading = scene->start.heading;
            return val(MapForPage(make(car, scene->place, options)));
        }
        const Street street = street_from(given_place, given_options);
        if (!options.heading) options.heading = street.heading;
        return val(MapForPage(make(car, place_of(street, given_options), options)));
    });
}

val map_question(const val& given_car, const val& given_place, const val& given_options) {
    return map_of(
        given_car, given_place, given_options,
        [](const Car& car, const Place& place, const ParkMapOptions& options) { return ParkMap(car, place, options); });
}

/// From what another worker packed, for the same car, place and options.
val unpack_question(const val& given_car, const val& given_place, const val& given_options, const val& given_bytes) {
    return map_of(given_car, given_place, given_options,
                  [&](const Car& car, const Place& place, const ParkMapOptions& options) {
                      if (!given_bytes.instanceof (val::global("Uint8Array")))
                          throw Error("the packed map must be a Uint8Array");
                      const auto size = given_bytes["length"].as<std::size_t>();
                      const std::unique_ptr<std::byte[]> bytes(new std::byte[size]);  // not zeros first: a frame waits
                      val(emscripten::typed_memory_view(size, reinterpret_cast<unsigned char*>(bytes.get())))
                          .call<void>("set", given_bytes);
                      return ParkMap::unpacked(car, place, options, {bytes.get(), size});
                  });
}

/// A question whose last argument, the options, may be left out.
template <val (*asked)(const val&, const val&, const val&)>
void with_options(const char* name) {
    emscripten::function(name, asked);
    emscripten::function(
        name, +[](const val& first, const val& second) { return asked(first, second, val::undefined()); });
}
template <val (*asked)(const val&, const val&, const val&, const val&)>
void with_options(const char* name) {
    emscripten::function(name, asked);
    emscripten::function(
        name, +[](const val& first, const val& second, const val& third) {
            return asked(first, second, third, val::undefined());
        });
}

EMSCRIPTEN_BINDINGS(snug) {
    emscripten::constant("version", std::string(SNUG_VERSION));
    emscripten::function("cars", &cars);
    emscripten::function("sheetCars", &sheet_cars_question);
    with_options<&entry_question>("entry");
    with_options<&max_steer_question>("maxSteer");
    emscripten::function("minSlot", &min_slot_question);
    with_options<&fewest_question>("fewest");
    with_options<&leave_question>("leave");
    with_options<&shortfall_question>("shortfall");
    with_options<&park_question>("park");
    with_options<&map_question>("parkMap");
    emscripten::function("unpackParkMap", &unpack_question);
    with_options<&scene_question>("scene");
    emscripten::function("readScene", &read_scene_question);
    emscripten::function("car", &car_question);
    emscripten::class_<MapForPage>("ParkMap")
        .function("at", &MapForPage::at)
        .function("maneuver", &MapForPage::maneuver)
        .function("slice", &MapForPage::slice)
        .function("packed", &MapForPage::packed)
        .property("fingerprint", &MapForPage::fingerprint)
        .property("middle_heading", &MapForPage::middle_heading)
        .property("spacing", &MapForPage::spacing)
        .property("bytes", &MapForPage::bytes);
}

}  // namespace
}  // namespace snug
