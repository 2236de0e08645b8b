// Many cars from a CSV file, a line each. Nothing that is said of a car can hold a line break, so lines are taken one by one,
// quoted fields or not, and a quote left open spoils one line and not the rest of the file.
#include <algorithm>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>

#include "car_file.hpp"
#include "io/csv.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

constexpr std::size_t largest_fleet = 100'000'000;  // [bytes]
constexpr std::size_t longest_line = 20'000;        // [bytes]: room for the finest outline

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

/// The first line of a text, without its end; the text goes on after it.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') {
        line.remove_suffix(1);
    }
    return line;
}

/// The columns and the line that is being read. Whatever is wrong is an Error that begins with its place.
class Fleet {
public:
    /// Reads the next line that is not empty; false when there is none.
    bool next_line(std::string_view& text) {
        while (!text.empty()) {
            ++line_;
            if (const std::string_view line = take_line(text); !line.empty()) {
                split(line);
                return true;
            }
        }
        return false;
    }

    /// Takes the line for the names of the columns.
    void name_columns() {
        std::vector<std::string> known = {"name"};
        known.insert(known.end(), car_lengths.begin(), car_lengths.end());
        known.insert(known.end(), steerings.begin(), steerings.end());
        known.insert(known.end(), {"corner_radius", "outline"});
        for (const std::string& field : fields_) {
            if (std::find(known.begin(), known.end(), field) == known.end()) {
                throw wrong(columns_.size(),
                            in_quotes(field) + " is no column; " +
                                (field.find_first_of(";\t") != field.npos
                                     ? "separate the columns by commas"
                                     : did_you_mean(nearest_word(field, known), "write " + either(known))));
            }
            if (find(field)) {
                throw wrong(columns_.size(), in_quotes(field) + " is there twice; name each column once");
            }
            columns_.push_back(field);
        }
        need({"name"});
        need({"wheelbase"});
        need({"width", "outline"});
        need({"front", "front_overhang", "length", "outline"});
        need({"rear", "rear_overhang", "length", "outline"});
        if (std::none_of(steerings.begin(), steerings.end(), [&](const std::string& key) { return find(key); })) {
            throw wrong_line("names no column for the steering; add one of " + either(steerings));
        }
    }

    /// Takes the line for a car.
    Car car() {
        if (fields_.size() != columns_.size()) {
            throw wrong_line("has " + counted(fields_.size(), "field") + ", but the header names " +
                             counted(columns_.size(), "column") + "; write a field for each");
        }
        CarDescription car;
        car.name = unique_name();
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const std::string& key = columns_[column];
            if (key == "name" || fields_[column].empty()) continue;
            if (key == "outline") {
                car.outline = points(column);
            } else if (key == "corner_radius") {
                const double radius = number(column, fields_[column]);
                car.corner_radius = CornerRadius{radius, radius};
            } else {
                car.numbers[key] = number(column, fields_[column]);
            }
        }
        return described(car, [this](const std::string& key, const std::string& what) {
            const std::optional<std::size_t> column = find(key);
            if (key.empty()) return wrong_line(what);
            if (!column) return wrong_line(key + ' ' + what);
            return wrong(*column, fields_[*column].empty() ? "is empty; write a decimal number in " + unit_of(key)
                                                           : key + ' ' + what);
        });
    }

private:
    [[nodiscard]] Error wrong_line(const std::string& what) const {
        return Error("line " + std::to_string(line_) + ": " + what);
    }
    [[nodiscard]] Error wrong(std::size_t column, const std::string& what) const {
        const std::string name = column < columns_.size() ? " (" + columns_[column] + ')' : "";
        return Error("line " + std::to_string(line_) + ", column " + std::to_string(column + 1) + name + ": " + what);
    }

    /// What is wrong in there is wrong in that column.
    template <typename Check>
    void in(std::size_t column, Check check) const {
        try {
            check();
        } catch (const Error& error) {
            throw wrong(column, error.what());
        }
    }

    void split(std::string_view line) {
        if (line.size() > longest_line) {
            throw wrong_line("is longer than 20 kB; write one car a line");
        }
        fields_.clear();
        while (true) {
            fields_.emplace_back();
            const bool quoted = !line.empty() && line[0] == '"';
            line.remove_prefix(quoted ? take_quoted(line) : take_plain(line));
            if (line.empty()) {
                return;
            }
            line.remove_prefix(1);  // the comma
        }
    }

    // Both fill the last field from the start of the text, and return how many bytes it took.
    std::size_t take_plain(std::string_view text) {
        fields_.back() = text.substr(0, text.find(','));
        if (fields_.back().find('"') != std::string::npos) {
            throw wrong(fields_.size() - 1,
                        in_quotes(fields_.back()) + " holds a quote; put the field in quotes and double those inside");
        }
        return fields_.back().size();
    }
    std::size_t take_quoted(std::string_view text) {
        for (std::size_t begin = 1;;) {
            const std::size_t quote = text.find('"', begin);
            if (quote == text.npos) {
                throw wrong(fields_.size() - 1, "the quote is not closed on its line; close it");
            }
            fields_.back() += text.substr(begin, quote - begin);
            const std::string_view after = text.substr(quote + 1);
            if (after.empty() || after[0] == ',') {
                return quote + 1;
            }
            if (after[0] != '"') {
                throw wrong(fields_.size() - 1,
                            in_quotes(after) + " follows the closing quote; double a quote that belongs to the field");
            }
            fields_.back() += '"';
            begin = quote + 2;
        }
    }

    [[nodiscard]] std::optional<std::size_t> find(const std::string& column) const {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        return found == columns_.end() ? std::nullopt : std::optional<std::size_t>(found - columns_.begin());
    }

    std::string unique_name() {
        const std::size_t column = *find("name");
        const std::string& name = fields_[column];
        if (name.empty()) {
            throw wrong(column, "is empty; give every car a name");
        }
        in(column, [&] { check_name("the name", name); });
        const auto [first, is_new] = lines_.emplace(name, line_);
        if (!is_new) {
            throw wrong(column, in_quotes(name) + " is the name of the car in line " + std::to_string(first->second) +
                                    " too; give each car a name of its own");
        }
        return name;
    }

    /// Throws Error unless one of the columns is there; a car may do with any of them.
    void need(const std::vector<std::string>& columns) const {
        if (std::any_of(columns.begin(), columns.end(), [&](const std::string& column) { return find(column); }))
            return;
        throw wrong_line("names no column " + in_quotes(columns.front()) + "; add it, for every car needs one");
    }

    [[nodiscard]] double number(std::size_t column, const std::string& field) const {
        const std::string unit = unit_of(columns_[column]);
        double value = 0.0;
        std::istringstream digits(field);
        digits.imbue(std::locale::classic());
        const bool read = static_cast<bool>(digits >> value);
        const bool plain =
            !field.empty() && field.front() != '+' && field.find_first_not_of("0123456789.eE+-") == field.npos;
        if (!plain || !digits.eof() || (!read && value == 0.0)) {
            throw wrong(column, in_quotes(field) + " is no number; write a decimal number in " + unit);
        }
        if (!read) {
            throw wrong(column, in_quotes(field) + " is too large for a number; write one in " + unit);
        }
        return value;
    }

    /// An outline, "x y; x y; x y".
    [[nodiscard]] std::vector<Point> points(std::size_t column) const {
        std::vector<Point> all;
        std::istringstream corners(fields_[column]);
        for (std::string corner; std::getline(corners, corner, ';');) {
            std::istringstream words(corner);
            std::vector<std::string> numbers;
            for (std::string word; words >> word;) numbers.push_back(word);
            if (numbers.size() != 2)
                throw wrong(column, in_quotes(corner) + " is no point; write x y; x y; ... in metres");
            all.push_back({number(column, numbers[0]), number(column, numbers[1])});
        }
        return all;
    }

    std::vector<std::string> columns_;
    std::vector<std::string> fields_;
    std::size_t line_ = 0;
    std::map<std::string, std::size_t> lines_;  // of the cars, by their names
};

std::vector<Car> cars(std::string_view text) {
    if (text.size() > largest_fleet) {
        throw Error("is larger than 100 MB; split the fleet");
    }
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) {
        text.remove_prefix(byte_order_mark.size());
    }
    Fleet fleet;
    if (!fleet.next_line(text)) {
        throw Error("is empty; write a line that names the columns, then a line for each car");
    }
    fleet.name_columns();
    std::vector<Car> cars;
    while (fleet.next_line(text)) {
        cars.push_back(fleet.car());
    }
    if (cars.empty()) {
        throw Error("names columns and no cars; write a line for each car");
    }
    return cars;
}

std::string points_text(const Outline& outline) {
    std::string text;
    for (const Point& corner : outline.corners())
        text += (text.empty() ? "" : "; ") + write(corner.x) + ' ' + write(corner.y);
    return text;
}

}  // namespace

std::vector<Car> cars_from_csv(std::string_view text, const std::string& source) {
    try {
        return cars(text);
    } catch (const Error& error) {
        throw Error(source + ": " + error.what());
    }
}

std::string as_csv(const std::vector<Car>& cars) {
    const bool outlines = std::any_of(cars.begin(), cars.end(), [](const Car& car) { return !car.is_rectangle(); });
    Csv csv;
    for (const char* column : {"name", "width", "front", "rear", "wheelbase", "max_steer", "max_steer_deg",
                               "turning_radius", "curb_to_curb", "length"})
        csv.add_field(column);
    if (outlines) csv.add_field("outline");
    csv.end_row();
    for (const Car& car : cars) {
        csv.add_field(car.name());
        for (const double value : {car.width(), car.front(), car.rear(), car.wheelbase(), car.max_steer(),
                                   car.max_steer() / degree, car.turning_radius(), car.curb_to_curb(), car.length()})
            csv.add_field(value);
        if (outlines) csv.add_field(car.is_rectangle() ? std::string() : points_text(car.outline()));
        csv.end_row();
    }
    return csv.text();
}

std::vector<Car> read_cars(const std::string& path) {
    return cars_from_csv(read_text(path, largest_fleet, "give a CSV file of cars"), path);
}

}  // namespace snug
