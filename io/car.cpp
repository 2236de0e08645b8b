// A car from a JSON file: read as a flat list of keys and values, so nothing nested, doubled or unknown slips through.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "car_file.hpp"
#include "model/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

constexpr std::size_t largest_file = 1'000'000;  // [bytes]

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
        std::vector<std::string> known;
        for (const NamedLength& length : car_lengths) {
            known.emplace_back(length.name);
        }
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
        check_name("key \"name\"", value);
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
double max_steer(const CarFile& file, const CarDimensions& dimensions) {
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
    return steering_angle("key \"" + *given + '"', *given, file.numbers.at(*given), dimensions);
}

Car car(const CarFile& file) {
    CarDimensions dimensions;
    for (const NamedLength& length : car_lengths) {
        const auto found = file.numbers.find(length.name);
        if (found == file.numbers.end()) {
            throw Error("key \"" + std::string(length.name) + "\" is missing; give it in metres");
        }
        dimensions.*length.value = found->second;
    }
    dimensions.max_steer = 1.0;
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
    return car_from_json(read_text(path, largest_file, "give a car file or a name that `snug cars` lists"), path);
}

}  // namespace snug
