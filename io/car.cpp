// A car from a JSON file: read as a flat list of keys and values, so nothing nested, doubled or unknown slips through.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "car_file.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

constexpr std::size_t largest_car_file = 1'000'000;  // [bytes]

/// The keys and values of a car file, taken event by event from the JSON parser.
struct CarFile {
    std::string_view text;
    CarDescription car;
    std::optional<std::string> name;
    std::optional<std::string> open_key;  // its value is still to come; empty before and after the object
    bool in_object = false;
    int list_depth = 0;              // in the outline: 1 in the list of points, 2 in a point
    std::vector<double> point;       // of the outline, as far as it is read
    bool in_radius = false;          // in the object after corner_radius
    std::optional<double> radii[2];  // in front and behind
    std::string radius_key;

    bool start_object(std::size_t) {
        if (in_object && open_key == "corner_radius" && !in_radius && list_depth == 0) {
            in_radius = true;
            return true;
        }
        if (in_object) wrong_type("an object");
        in_object = true;
        return true;
    }
    bool end_object() {
        if (!in_radius) return true;
        if (!radii[0] || !radii[1])
            throw Error(quoted_key() +
                        " needs both \"front\" and \"rear\" [m]; give them, or one number for all corners");
        car.corner_radius = CornerRadius{*radii[0], *radii[1]};
        in_radius = false;
        return true;
    }

    bool key(const std::string& word) {
        if (in_radius) return key_of_radius(word);
        std::vector<std::string> known = car_lengths;
        known.insert(known.end(), steerings.begin(), steerings.end());
        known.insert(known.end(), {"outline", "corner_radius", "name"});
        if (std::find(known.begin(), known.end(), word) == known.end()) {
            std::optional<std::string> nearest = nearest_word(word, known);
            if (nearest) nearest = in_quotes(*nearest);
            throw Error("unknown key " + in_quotes(word) + "; " + did_you_mean(nearest, "write " + either(known)));
        }
        if (car.has(word) || (word == "name" && name) || (word == "outline" && car.outline) ||
            (word == "corner_radius" && car.corner_radius))
            throw Error("key \"" + word + "\" is given twice; give it once");
        open_key = word;
        return true;
    }
    bool key_of_radius(const std::string& word) {
        if (word != "front" && word != "rear")
            throw Error("unknown key " + in_quotes(word) + " in \"corner_radius\"; write front and rear");
        if (radii[word == "rear" ? 1 : 0])
            throw Error("key \"" + word + "\" is given twice in \"corner_radius\"; give it once");
        radius_key = word;
        return true;
    }

    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(value); }
    bool number(double value) {
        if (!in_object || open_key == "name" || (open_key == "outline" && list_depth != 2)) wrong_type("a number");
        if (open_key == "outline") {
            point.push_back(value);
        } else if (in_radius) {
            radii[radius_key == "rear" ? 1 : 0] = value;
        } else if (open_key == "corner_radius") {
            car.corner_radius = CornerRadius{value, value};
        } else {
            car.numbers[*open_key] = value;
        }
        return true;
    }

    bool string(const std::string& value) {
        if (!in_object || open_key != "name") wrong_type("a string");
        check_name("key \"name\"", value);
        name = value;
        return true;
    }

    bool start_array(std::size_t) {
        if (!in_object || open_key != "outline" || list_depth == 2) wrong_type("a list");
        if (++list_depth == 1) car.outline.emplace();
        point.clear();
        return true;
    }
    bool end_array() {
        if (list_depth-- == 2) {
            if (point.size() != 2)
                throw Error(quoted_key() + " has a point of " + std::to_string(point.size()) +
                            (point.size() == 1 ? " number" : " numbers") + "; write [x, y] for each, in metres");
            car.outline->push_back({point[0], point[1]});
        }
        return true;
    }

    bool null() { return wrong_type("null"); }
    bool boolean(bool) { return wrong_type("true or false"); }
    bool binary(std::vector<std::uint8_t>&) { return true; }

    [[nodiscard]] std::string quoted_key() const { return "key \"" + open_key.value_or("") + '"'; }

    [[noreturn]] bool wrong_type(const std::string& found) const {
        if (!in_object) {
            throw Error("is " + found + ", but must be a JSON object with the keys of a car");
        }
        const std::string right = open_key == "name"      ? "a string"
                                  : open_key == "outline" ? "a list of points [x, y]"
                                  : open_key == "corner_radius"
                                      ? "a number, or an object with the numbers front and rear"
                                      : "a number";
        throw Error(quoted_key() + (list_depth > 0 || in_radius ? " holds " : " is ") + found + ", but must be " +
                    right);
    }

    [[noreturn]] bool parse_error(std::size_t position, const std::string& token,
                                  const nlohmann::detail::exception& e) {
        position = std::max<std::size_t>(position, 1);
        const std::string_view before = text.substr(0, position - 1);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
        const bool overflow = e.id / 100 == 4;  // as the library numbers what is out of range
        throw Error("line " + std::to_string(line) + ", column " + std::to_string(column) + ": " +
                    (overflow                 ? in_quotes(token) + " is too large for a number"
                     : position > text.size() ? std::string("the text ends too early to be valid JSON")
                                              : "no valid JSON from " + in_quotes(text.substr(position - 1)) + " on"));
    }
};

Car car(CarFile file) {
    file.car.name = file.name.value_or("");
    const std::string* first = nullptr;
    for (const std::string& key : steerings) {
        if (!file.car.has(key)) continue;
        if (first != nullptr)
            throw Error("keys \"" + *first + "\" and \"" + key + "\" exclude each other; give one of them");
        first = &key;
    }
    return described(file.car, [](const std::string& key, const std::string& what) {
        return Error(key.empty() ? what : "key \"" + key + "\" " + what);
    });
}

}  // namespace

Car car_from_json(std::string_view text, const std::string& source) {
    try {
        if (text.size() > largest_car_file) {
            throw Error("is larger than 1 MB, but must be a short JSON object with the keys of a car");
        }
        CarFile file;
        file.text = text;
        Json::sax_parse(text, &file);
        return car(std::move(file));
    } catch (const Error& error) {
        throw Error(source + ": " + error.what());
    }
}

Car read_car(const std::string& path) {
    return car_from_json(read_text(path, largest_car_file, "give a car file or a name that `snug cars` lists"), path);
}

}  // namespace snug
