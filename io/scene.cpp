// Scenes from JSON and from the cases of the TPCAP benchmark.
#include "snug/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "car_file.hpp"
#include "sentences/check.hpp"
#include "sentences/decimals.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

constexpr std::size_t largest_scene = 1'000'000;  // [bytes]
constexpr double around = 10.0;                   ///< the region reaches so far beyond everything named [m]

void check_keys(const Json& object, const std::string& what, std::initializer_list<const char*> known) {
    if (!object.is_object()) throw Error(what + " must be a JSON object");
    for (const auto& [key, value] : object.items()) {
        const auto same = [&name = key](const char* word) { return name == word; };
        if (std::none_of(known.begin(), known.end(), same)) {
            const std::vector<std::string> words(known.begin(), known.end());
            throw Error(what + " has an unknown key " + in_quotes(key) + "; write " + either(words));
        }
    }
}

const Json& member(const Json& object, const char* key, const std::string& what) {
    if (!object.contains(key)) throw Error(what + " has no key \"" + key + "\"");
    return object[key];
}

double number(const Json& value, const std::string& what) {
    if (!value.is_number()) throw Error(what + " must be a number");
    return value.get<double>();
}

std::vector<double> numbers(const Json& value, std::size_t count, const std::string& what) {
    if (!value.is_array() || value.size() != count)
        throw Error(what + " must be a list of " + std::to_string(count) + " numbers");
    std::vector<double> list;
    for (const Json& entry : value) list.push_back(number(entry, what + ": an entry"));
    return list;
}

Pose pose(const Json& value, const std::string& what) {
    const std::vector<double> of = numbers(value, 3, what);
    return {of[0], of[1], of[2]};
}

std::vector<Point> polygon(const Json& value, const std::string& what) {
    if (!value.is_array()) throw Error(what + " must be a list of corners [x, y]");
    std::vector<Point> corners;
    for (const Json& corner : value) {
        const std::vector<double> of = numbers(corner, 2, what + ": a corner");
        corners.push_back({of[0], of[1]});
    }
    return corners;
}

/// Around everything named.
std::vector<Point> usual_region(const PlaceDescription& place, const Pose& start) {
    double x_min = start.x, x_max = start.x, y_min = start.y, y_max = start.y;
    const auto include = [&](const Point& p) {
        x_min = std::min(x_min, p.x), x_max = std::max(x_max, p.x);
        y_min = std::min(y_min, p.y), y_max = std::max(y_max, p.y);
    };
    for (const PlaceObstacle& obstacle : place.obstacles)
        for (const Point& p : obstacle.corners) include(p);
    if (const auto* inside = std::get_if<ParkedInside>(&place.parked)) {
        for (const Point& p : inside->corners) include(p);
    } else {
        const Pose& at = std::get<ParkedAt>(place.parked).pose;
        include({at.x, at.y});
    }
    return {{x_min - around, y_min - around},
            {x_max + around, y_min - around},
            {x_max + around, y_max + around},
            {x_min - around, y_max + around}};
}

Scene scene(const Json& file) {
    check_keys(file, "the scene", {"obstacles", "parked", "start", "region"});
    PlaceDescription place;
    const Json& obstacles = member(file, "obstacles", "the scene");
    if (!obstacles.is_array()) throw Error("key \"obstacles\" must be a list of polygons");
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const std::string what = "obstacle [" + std::to_string(i) + "]";
        const Json& given = obstacles[i];
        PlaceObstacle obstacle;
        if (given.is_object()) {
            check_keys(given, what, {"polygon", "low", "name"});
            obstacle.corners = polygon(member(given, "polygon", what), what);
            if (given.contains("low")) {
                if (!given["low"].is_boolean()) throw Error(what + ": key \"low\" must be true or false");
                obstacle.low = given["low"].get<bool>();
            }
            if (given.contains("name")) {
                if (!given["name"].is_string()) throw Error(what + ": key \"name\" must be a string");
                obstacle.name = given["name"].get<std::string>();
            }
        } else {
            obstacle.corners = polygon(given, what);
        }
        place.obstacles.push_back(std::move(obstacle));
    }
    const Json& parked = member(file, "parked", "the scene");
    if (parked.is_object() && parked.contains("pose")) {
        check_keys(parked, "key \"parked\"", {"pose", "tolerance"});
        const std::vector<double> within =
            numbers(member(parked, "tolerance", "key \"parked\""), 3, "key \"tolerance\"");
        place.parked = ParkedAt{pose(parked["pose"], "key \"pose\""), within[0], within[1], within[2]};
    } else {
        check_keys(parked, "key \"parked\"", {"inside", "heading", "heading_tolerance"});
        ParkedInside inside;
        inside.corners = polygon(member(parked, "inside", "key \"parked\""), "key \"inside\"");
        inside.heading = number(member(parked, "heading", "key \"parked\""), "key \"heading\"");
        if (parked.contains("heading_tolerance"))
            inside.heading_tolerance = number(parked["heading_tolerance"], "key \"heading_tolerance\"");
        place.parked = std::move(inside);
    }
    const Pose start = pose(member(file, "start", "the scene"), "key \"start\"");
    if (file.contains("region")) {
        const Json& region = file["region"];
        check_keys(region, "key \"region\"", {"x_min", "x_max", "y_min", "y_max"});
        const auto edge = [&](const char* key) {
            return number(member(region, key, "key \"region\""), "key \"" + std::string(key) + "\"");
        };
        const double x_min = edge("x_min"), x_max = edge("x_max"), y_min = edge("y_min"), y_max = edge("y_max");
        if (!(x_min < x_max && y_min < y_max))
            throw Error("key \"region\" is empty; its minima must lie below its maxima");
        place.region = {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
    } else {
        place.region = usual_region(place, start);
    }
    if (place.obstacles.empty()) throw Error("the scene is empty; name what is to be kept clear of in \"obstacles\"");
    return {Place(std::move(place)), start};
}

}  // namespace

Scene scene_from_json(std::string_view text, const std::string& source) {
    try {
        if (text.size() > largest_scene) throw Error("is larger than 1 MB");
        if (text.empty()) throw Error("is empty; give a scene as JSON");
        const Json file = Json::parse(text, nullptr, false);
        if (file.is_discarded()) throw Error("is no valid JSON");
        return scene(file);
    } catch (const Error& error) {
        throw Error(source + ": " + error.what());
    }
}

Scene scene_from_csv(std::string_view text, const std::string& source) {
    try {
        text = text.substr(0, largest_scene + 1);
        std::size_t read = 0;
        const auto next = [&](const char* what) {
            constexpr const char* between = ", \t\n\v\f\r";
            text.remove_prefix(std::min(text.find_first_not_of(between), text.size()));
            const std::string_view word = text.substr(0, text.find_first_of(between));
            const std::optional<double> value = decimal(word);
            if (!value) throw Error("value " + std::to_string(read + 1) + " must be " + what);
            text.remove_prefix(word.size());
            ++read;
            return *value;
        };
        const auto count = [&](const char* what, double most) {
            const double value = next(what);
            if (!(value >= 0.0 && value <= most && value == std::floor(value)))
                throw Error("value " + std::to_string(read) + " is " + spelled(value) + ", but must be " + what);
            return static_cast<std::size_t>(value);
        };
        Pose start, goal;
        for (Pose* pose : {&start, &goal}) *pose = {next("an x"), next("a y"), next("a heading")};
        std::vector<std::size_t> corners(count("the number of obstacles", 10000));
        for (std::size_t& number : corners) number = count("the number of an obstacle's corners", 10000);
        PlaceDescription place;
        for (const std::size_t number : corners) {
            PlaceObstacle obstacle;
            for (std::size_t i = 0; i < number; ++i) {
                const double x = next("an x"), y = next("a y");
                obstacle.corners.push_back({x, y});
            }
            // Some close the polygon by naming its first corner again.
            if (number > 3 && obstacle.corners.front().x == obstacle.corners.back().x &&
                obstacle.corners.front().y == obstacle.corners.back().y)
                obstacle.corners.pop_back();
            place.obstacles.push_back(std::move(obstacle));
        }
        place.parked = ParkedAt{goal, 0.1, 0.1, 0.05};
        place.region = usual_region(place, start);
        if (place.obstacles.empty()) throw Error("the case has no obstacles; name what is to be kept clear of");
        return {Place(std::move(place)), start};
    } catch (const Error& error) {
        throw Error(source + ": " + error.what());
    }
}

Scene read_scene(const std::string& path) {
    const std::string text = read_text(path, largest_scene, "give a scene as JSON, or a case of TPCAP as .csv");
    const bool csv = path.size() >= 4 && path.compare(path.size() - 4, 4, ".csv") == 0;
    return csv ? scene_from_csv(text, path) : scene_from_json(text, path);
}

}  // namespace snug
