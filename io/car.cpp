// A car from a JSON file: read as a flat list of keys and values, so nothing nested, doubled or unknown slips through.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <system_error>
#include <vector>

#include "check.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"
#include "spelling.hpp"

namespace snug {
namespace {

constexpr std::size_t largest_file = 1'000'000;  // [bytes]
constexpr std::size_t longest_name = 100;        // [bytes]
constexpr double degree = std::numbers::pi / 180.0;
constexpr double least_steer = 0.1 * degree;  // what a Car accepts
constexpr double most_steer = 89.9 * degree;

const std::vector<std::string> lengths = {"width", "front", "rear", "wheelbase"};
const std::vector<std::string> steerings = {"max_steer", "max_steer_deg", "turning_radius", "curb_to_curb"};

/// The keys and values of a car file, taken event by event from the JSON parser.
struct CarFile {
    std::string_view text;
    std::map<std::string, double> numbers;
    std::optional<std::string> name;
    std::optional<std::string> open_key;  // its value is still to come; empty before and after the object
    bool in_object = false;

    bool start_object(std::size_t) {
        if (in_object) {
            wrong_type("an object");
        }
        in_object = true;
        return true;
    }
    bool end_object() { return true; }

    bool key(const std::string& word) {
        std::vector<std::string> known = lengths;
        known.insert(known.end(), steerings.begin(), steerings.end());
        known.emplace_back("name");
        if (std::find(known.begin(), known.end(), word) == known.end()) {
            std::optional<std::string> nearest = nearest_word(word, known);
            if (nearest) nearest = in_quotes(*nearest);
            throw Error("unknown key " + in_quotes(word) + "; " + did_you_mean(nearest, "write " + either(known)));
        }
        if (numbers.count(word) != 0 || (word == "name" && name)) {
            throw Error("key \"" + word + "\" is given twice; give it once");
        }
        open_key = word;
        return true;
    }

    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(value); }
    bool number(double value) {
        if (!in_object || open_key == "name") {
            wrong_type("a number");
        }
        numbers[*open_key] = value;
        return true;
    }

    bool string(const std::string& value) {
        if (!in_object || open_key != "name") {
            wrong_type("a string");
        }
        if (value.size() > longest_name || std::any_of(value.begin(), value.end(), is_control)) {
            throw Error("key \"name\" is " + in_quotes(value) + ", but must be at most " +
                        std::to_string(longest_name) + " bytes long and free of control characters");
        }
        name = value;
        return true;
    }

    bool null() { return wrong_type("null"); }
    bool boolean(bool) { return wrong_type("true or false"); }
    bool start_array(std::size_t) { return wrong_type("a list"); }
    bool end_array() { return true; }
    bool binary(std::vector<std::uint8_t>&) { return true; }

    [[noreturn]] bool wrong_type(const std::string& found) const {
        if (!in_object) {
            throw Error("is " + found + ", but must be a JSON object with the keys of a car");
        }
        throw Error("key \"" + *open_key + "\" is " + found + ", but must be a " +
                    (open_key == "name" ? "string" : "number"));
    }

    [[noreturn]] bool parse_error(std::size_t position, const std::string& token,
                                  const nlohmann::detail::exception& e) {
        position = std::max<std::size_t>(position, 1);
        const std::string_view before = text.substr(0, position - 1);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
        const bool overflow = dynamic_cast<const nlohmann::detail::out_of_range*>(&e) != nullptr;
        throw Error("line " + std::to_string(line) + ", column " + std::to_string(column) + ": " +
                    (overflow                 ? in_quotes(token) + " is too large for a number"
                     : position > text.size() ? std::string("the text ends too early to be valid JSON")
                                              : "no valid JSON from " + in_quotes(text.substr(position - 1)) + " on"));
    }
};

/// The largest steering angle under whichever key it was given. [rad]
double max_steer(const CarFile& file, CarDimensions dimensions) {
    const std::string* given = nullptr;
    for (const std::string& key : steerings) {
        if (file.numbers.count(key) == 0) {
            continue;
        }
        if (given != nullptr) {
            throw Error("keys \"" + *given + "\" and \"" + key + "\" exclude each other; give one of them");
        }
        given = &key;
    }
    if (given == nullptr) {
        throw Error("says nothing about the steering; give one of " + either(steerings));
    }
    const double value = file.numbers.at(*given);
    dimensions.max_steer = most_steer;
    const Car sharpest(dimensions);
    dimensions.max_steer = least_steer;
    const Car dullest(dimensions);
    const std::string what = "key \"" + *given + '"';
    if (*given == "max_steer") {
        check_between(what, value, least_steer, most_steer, " rad");
        return value;
    }
    if (*given == "max_steer_deg") {
        check_between(what, value, least_steer / degree, most_steer / degree, " degrees");
        return value * degree;
    }
    if (*given == "turning_radius") {
        check_between(what, value, sharpest.turning_radius(), dullest.turning_radius(), " m");
        return steer_for_turning_radius(dimensions.wheelbase, value);
    }
    check_between(what, value, sharpest.curb_to_curb(), dullest.curb_to_curb(), " m");
    return steer_for_curb_to_curb(dimensions.wheelbase, dimensions.width, value);
}

Car car(const CarFile& file) {
    for (const std::string& key : lengths) {
        if (file.numbers.count(key) == 0) {
            throw Error("key \"" + key + "\" is missing; give it in metres");
        }
    }
    CarDimensions dimensions = {file.numbers.at("width"), file.numbers.at("front"), file.numbers.at("rear"),
                                file.numbers.at("wheelbase"), 1.0};
    static_cast<void>(Car(dimensions));  // the lengths first: what the steering may be depends on them
    dimensions.max_steer = max_steer(file, dimensions);
    return Car(dimensions, file.name.value_or(""));
}

}  // namespace

Car car_from_json(std::string_view text, const std::string& source) {
    try {
        if (text.size() > largest_file) {
            throw Error("is larger than 1 MB, but must be a short JSON object with the keys of a car");
        }
        CarFile file;
        file.text = text;
        Json::sax_parse(text, &file);
        return car(file);
    } catch (const Error& error) {
        throw Error(source + ": " + error.what());
    }
}

Car read_car(const std::string& path) {
    const auto failed = [&](int reason) {
        return Error(path + ": cannot be read: " + std::generic_category().message(reason) +
                     "; give a car file or a name that `snug cars` lists");
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        throw failed(errno);
    }
    std::string text(largest_file + 1, '\0');
    errno = 0;
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    if (std::ferror(file.get()) != 0) {
        throw failed(errno);
    }
    return car_from_json(text, path);
}

}  // namespace snug
