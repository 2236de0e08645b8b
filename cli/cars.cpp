// snug cars: the cars known by name and where their numbers are from, or one car in detail.
#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr const char* examples =
    "A car file is a JSON object with lengths in metres and one of max_steer\n"
    "(radians), max_steer_deg, turning_radius (of the rear axle centre), curb_to_curb\n"
    "or wall_to_wall (diameters, as data sheets give them); front and rear are\n"
    "measured from the rear axle, or front_overhang and rear_overhang (or length and\n"
    "one of them) are given; name is optional:\n"
    "  {\"name\": \"my-car\", \"width\": 1.8, \"front\": 3.6, \"rear\": 0.8, \"wheelbase\": 2.6,\n"
    "   \"curb_to_curb\": 10.8}\n"
    "corner_radius (a number, or {\"front\": M, \"rear\": M}) rounds the corners;\n"
    "outline, a list of [x, y] about the middle of the rear axle, any convex shape.\n\n"
    "Examples:\n"
    "  snug cars\n"
    "  snug cars tesla-model-3\n"
    "  snug cars renault-zoe --format json > my-car.json\n"
    "  snug cars my-car.json\n\n"
    "Exit codes: 0 done; 2 bad input.";

std::string shown_name(const Car& car) { return car.name().empty() ? "(no name)" : car.name(); }

/// Cars as the rows of a table.
struct Listed {
    std::vector<std::vector<std::string>> rows = {
        {"", "width", "front", "rear", "wheelbase", "max steer", "turning", "curb to", "length"},
        {"", "w", "d_f", "d_r", "b", "phi_max", "radius", "curb", ""},
        {"car", "[m]", "[m]", "[m]", "[m]", "[deg]", "[m]", "[m]", "[m]"}};

    void add(const Car& car) {
        rows.push_back({car.name(), fixed(car.width(), 3), fixed(car.front(), 3), fixed(car.rear(), 3),
                        fixed(car.wheelbase(), 3), fixed(car.max_steer() / degree, 1), fixed(car.turning_radius(), 3),
                        fixed(car.curb_to_curb(), 3), fixed(car.length(), 3)});
    }
    [[nodiscard]] std::string text() const { return table(rows, "lrrrrrrrr", 0); }
};

std::string fleet_text(const std::vector<Car>& cars) {
    Listed listed;
    for (const Car& car : cars) listed.add(car);
    return listed.text();
}

/// The paper's cars and those of data sheets, in one table with the same columns.
std::string known_text() {
    Listed listed;
    listed.rows.push_back({"of the paper:"});
    for (const Car& car : catalogue()) listed.add(car);
    listed.rows.push_back({"of data sheets:"});
    std::vector<std::vector<std::string>> sheets;
    for (const SheetCar& known : sheet_cars()) {
        listed.add(known.car);
        sheets.push_back({known.car.name(), known.circle, known.sheet});
    }
    return listed.text() + "\nSheets, and the circles from which max steer is derived:\n" + table(sheets, "lll", 0);
}

std::string car_text(const Car& car) {
    const auto metres = [](double length) { return fixed(length, 3) + " m"; };
    return shown_name(car) + "\n\n" +
           table({{"length", metres(car.length()), "bumper to bumper"},
                  {"width", metres(car.width()), "w, without mirrors"},
                  {"front", metres(car.front()), "d_f, from the rear axle to the front"},
                  {"rear", metres(car.rear()), "d_r, from the rear axle to the back"},
                  {"wheelbase", metres(car.wheelbase()), "b, between the axles"},
                  {"overhangs", metres(car.front() - car.wheelbase()),
                   "in front, and " + metres(car.rear()) + " behind the rear axle"},
                  {"max steer", fixed(car.max_steer() / degree, 3) + " deg", "phi_max, largest steering angle"},
                  {"turning radius", metres(car.turning_radius()), "r, of the rear axle centre"},
                  {"curb to curb", metres(car.curb_to_curb()), "d, diameter of the outer front wheel's circle"},
                  {"wall to wall", metres(car.wall_to_wall()), "diameter of the body's circle"}},
                 "lrl") +
           (car.is_rectangle() ? ""
                               : "  an outline of " + std::to_string(car.outline().corners().size()) + " corners\n");
}

/// Which sheet a known car is from; nothing for the paper's cars and for files.
std::string sheet_text(const std::string& name) {
    for (const SheetCar& known : sheet_cars()) {
        if (known.car.name() != name) continue;
        std::string text = "\n  circle " + known.circle +
                           "; max steer is derived from it, read as curb to curb\n  sheet  " + known.sheet +
                           "\n         ";
        for (const char c : known.source) text += c == '\n' ? "\n         " : std::string(1, c);
        return text + "\n";
    }
    return "";
}

std::vector<Car> known_cars() {
    std::vector<Car> cars = catalogue();
    for (const SheetCar& known : sheet_cars()) cars.push_back(known.car);
    return cars;
}

}  // namespace

Action parse_cars(const Arguments& arguments) {
    Options options("snug cars", "The cars snug knows, or what a car file or a fleet says.", examples);
    const Option<std::string> name =
        options.argument("NAME", "A car's name, a JSON file, or a fleet's .csv;\nwithout it, all cars.");
    const OutputOptions output(options);
    if (!options.read(arguments)) return say(options.help());
    const bool fleet = name && ends_with(*name, ".csv");
    const bool one = name && !fleet;
    const std::vector<Car> cars = one     ? std::vector<Car>{find_or_read_car(*name)}
                                  : fleet ? read_cars(*name)
                                          : known_cars();
    std::string text;
    switch (output.format()) {
        case Format::text:
            text = one ? car_text(cars.front()) + sheet_text(*name) : fleet ? fleet_text(cars) : known_text();
            break;
        case Format::json: text = one ? car_json(cars.front()) : cars_json(cars); break;
        case Format::csv: text = as_csv(cars); break;
    }
    return [text, path = output.path()] {
        put_out(path, text);
        return solved;
    };
}

}  // namespace snug::cli
