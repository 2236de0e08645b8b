// What a car file may say, and that an answer's car is one.
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/numbers.hpp"
#include "process.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

using model::degree;

const std::string lengths = R"("width": 1.8, "front": 3.6, "rear": 0.8, "wheelbase": 2.6)";

Car car_saying(const std::string& more) { return car_from_json("{" + lengths + more + "}", "my.json"); }

void expect_no_car(const std::string& text, const std::vector<std::string>& named) {
    try {
        static_cast<void>(car_from_json(text, "my.json"));
        ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.rfind("my.json: ", 0), 0U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        for (const std::string& word : named) {
            EXPECT_NE(what.find(word), std::string::npos) << '"' << word << "\" is not in: " << what;
        }
    }
}

TEST(CarFile, SteeringMayBeGivenInFourWays) {
    const Car car = car_saying(R"(, "max_steer": 0.6)");
    EXPECT_EQ(car.max_steer(), 0.6);
    EXPECT_EQ(car.name(), "");
    EXPECT_DOUBLE_EQ(car_saying(R"(, "max_steer_deg": 36)").max_steer(), 36 * degree);
    EXPECT_NEAR(car_saying(R"(, "turning_radius": )" + write(car.turning_radius())).max_steer(), 0.6, 1e-15);
    EXPECT_NEAR(car_saying(R"(, "curb_to_curb": )" + write(car.curb_to_curb())).max_steer(), 0.6, 1e-14);
}

TEST(CarFile, DataSheetsDescribeACar) {
    const auto car = [](const std::string& keys) {
        return car_from_json("{" + keys + R"(, "width": 1.8, "wheelbase": 2.6, "max_steer": 0.6})", "my.json");
    };
    for (const char* keys :
         {R"("front_overhang": 1.0, "rear_overhang": 0.75)", R"("length": 4.35, "front_overhang": 1.0)",
          R"("length": 4.35, "rear_overhang": 0.75)", R"("length": 4.35, "front": 3.6)",
          R"("front": 3.6, "rear": 0.75, "length": 4.35, "front_overhang": 1.0)"}) {
        EXPECT_NEAR(car(keys).front(), 3.6, 1e-14) << keys;
        EXPECT_NEAR(car(keys).rear(), 0.75, 1e-14) << keys;
    }
    const Car zoe = *find_car("renault-zoe");
    Json json = as_json(zoe);
    json.erase("max_steer");
    json["wall_to_wall"] = zoe.wall_to_wall();
    EXPECT_NEAR(car_from_json(json.dump(), "").max_steer(), zoe.max_steer(), 1e-14);
    EXPECT_NEAR(zoe.wall_to_wall(), 2.0 * std::hypot(zoe.turning_radius() + zoe.width() / 2.0, zoe.front()), 1e-14);
}

TEST(CarFile, AnOutlineIsACarsShape) {
    const std::string rest = R"(, "wheelbase": 2.6, "max_steer": 0.6, "name": "wedge"})";
    const Car car = car_from_json(R"({"outline": [[3.6, 0.5], [-0.8, 0.9], [-0.8, -0.9], [3.6, -0.5]])" + rest, "");
    EXPECT_EQ(car.width(), 1.8);
    EXPECT_EQ(car.front(), 3.6);
    EXPECT_EQ(car.rear(), 0.8);
    const Json echoed = as_json(car);
    EXPECT_EQ(echoed["outline"].size(), 4U);
    EXPECT_FALSE(echoed.contains("corner_radius"));
    EXPECT_EQ(car_from_json(write(echoed), ""), car) << "the answer's car is a car file";
    const Car box = car_from_json(R"({"outline": [[3.6, 0.9], [-0.8, 0.9], [-0.8, -0.9], [3.6, -0.9]])" + rest, "");
    EXPECT_FALSE(as_json(box).contains("outline"));
    EXPECT_EQ(box, Car({1.8, 3.6, 0.8, 2.6, 0.6}, "wedge"));
}

TEST(CarFile, CornersMayBeRound) {
    EXPECT_EQ(car_saying(R"(, "max_steer": 0.6, "corner_radius": 0.3)").outline(),
              Outline::rounded(3.6, 0.8, 0.9, 0.3, 0.3));
    EXPECT_EQ(car_saying(R"(, "max_steer": 0.6, "corner_radius": {"rear": 0.2, "front": 0.4})").outline(),
              Outline::rounded(3.6, 0.8, 0.9, 0.4, 0.2));
    EXPECT_TRUE(car_saying(R"(, "max_steer": 0.6, "corner_radius": 0)").is_rectangle());
    const Car round = car_saying(R"(, "max_steer": 0.6, "corner_radius": 0.3)");
    EXPECT_EQ(car_from_json(write(as_json(round)), ""), round);
}

TEST(CarFile, OutlinesThatAreWrongAreTold) {
    const std::string rest = R"(, "wheelbase": 2.6, "max_steer": 0.6})";
    const auto expect = [&](const std::string& outline, const std::vector<std::string>& named) {
        expect_no_car(R"({"outline": )" + outline + rest, named);
    };
    expect("[]", {"\"outline\""});
    expect("[[3.6, 0.9], [-0.8, 0.9]]", {"\"outline\""});
    expect("[[3.6, 0.9], [1, 0.1], [-0.8, 0.9], [-0.8, -0.9], [3.6, -0.9]]", {"\"outline\"", "convex"});
    expect("[[3.6, 0.9], [-0.8], [3.6, -0.9]]", {"\"outline\"", "[x, y]", "1 number"});
    expect("[[3.6, 0.9, 0], [-0.8, 1], [3.6, -0.9]]", {"\"outline\"", "3 numbers"});
    expect("[[3.6, [0.9]], [-0.8, 1], [3.6, -0.9]]", {"\"outline\"", "a list"});
    expect("[3.6, 0.9]", {"\"outline\"", "a number", "[x, y]"});
    expect("[[3.6, null]]", {"\"outline\"", "null"});
    expect("7", {"\"outline\"", "a number", "[x, y]"});
    expect("[[3.6, NaN]]", {"line 1"});
    expect("[[2.5, 0.9], [-0.8, 0.9], [-0.8, -0.9], [2.5, -0.9]]", {"\"outline\"", "wheelbase", "rear axle"});
    expect("[[3.6, 0.9], [0.5, 0.9], [0.5, -0.9], [3.6, -0.9]]", {"\"outline\"", "rear axle"});
    expect("[[3427, 885], [-657, 885], [-657, -885], [3427, -885]]", {"\"outline\"", "millimetres"});
    expect("[[3.6, 0.9], [-0.8, 0.9], [-0.8, -0.9], [3.6, -0.9]], \"corner_radius\": 0.3",
           {"corner_radius", "outline"});
    expect("[[3.6, 0.9], [-0.8, 0.9], [-0.8, -0.9], [3.6, -0.9]], \"width\": 1.7", {"\"width\"", "agree", "1.8"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6, "corner_radius": 1.5})", {"\"corner_radius\""});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6, "corner_radius": {"front": 0.3}})",
                  {"\"corner_radius\"", "rear"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6, "corner_radius": {"left": 0.3}})",
                  {"\"left\"", "front and rear"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6, "corner_radius": "round"})",
                  {"\"corner_radius\"", "a string"});
}

TEST(CarFile, SlipsAreToldForWhatTheyAre) {
    const auto expect = [](const std::string& keys, const std::vector<std::string>& named) {
        expect_no_car("{" + keys + "}", named);
    };
    const std::string mm = R"("width": 1771, "front": 3427, "rear": 657, "wheelbase": 2588, "max_steer": 0.6)";
    expect(mm, {"\"width\" is 1771 m", "looks like millimetres", "1.771 m"});
    const std::string inches = R"("width": 69.7, "front": 134.9, "rear": 25.9, "wheelbase": 101.9, "max_steer": 0.6)";
    expect(inches, {"\"width\" is 69.7 m", "looks like inches", "1.7704 m"});
    expect(R"("width": 177.1, "front": 342.7, "rear": 65.7, "wheelbase": 258.8, "max_steer": 0.6)",
           {"\"width\" is 177.1 m", "looks like centimetres", "1.771 m"});
    expect(R"("width": 1.8, "front": 1.0, "rear": 0.8, "wheelbase": 2.6, "max_steer": 0.6)",
           {"\"front\"", "front is measured from the rear axle: wheelbase + front overhang"});
    expect(R"("width": 1.8, "length": 0.7, "rear": 0.8, "wheelbase": 2.6, "max_steer": 0.6)", {"\"length\""});
    expect(lengths + R"(, "max_steer": 33)", {"\"max_steer\" is 33 rad", "33 degrees are 0.575959 rad"});
    expect(lengths + R"(, "max_steer_deg": 0.6)", {"\"max_steer_deg\" is 0.6 degrees", "0.6 rad are 34.3775 degrees"});
    expect(lengths + R"(, "max_steer_deg": 2)", {"\"max_steer_deg\" is 2 degrees", "circle of 74.454 m radius"});
    expect(lengths + R"(, "curb_to_curb": 10900)", {"\"curb_to_curb\" is 10900 m", "looks like millimetres", "10.9 m"});
    expect(lengths + R"(, "max_steer": 0.6, "length": 4.5)", {"\"length\"", "agree", "4.4"});
}

/// The paper's cars and those of data sheets, as `snug cars` prints them.
std::vector<Car> known_cars() {
    std::vector<Car> cars = catalogue();
    for (const SheetCar& known : sheet_cars()) cars.push_back(known.car);
    return cars;
}

TEST(CarFile, EveryKnownCarReadsBackTheSame) {
    for (const Car& car : known_cars()) {
        const std::string text = write(as_json(car));
        const Car back = car_from_json(text, "");
        EXPECT_EQ(write(as_json(back)), text);
        EXPECT_EQ(back.name(), car.name());
        EXPECT_EQ(back.max_steer(), car.max_steer());
        EXPECT_EQ(back.width(), car.width());
    }
}

TEST(CarFile, KeysThatAreWrongAreNamed) {
    const std::string steer = R"(, "max_steer": 0.6)";
    expect_no_car("{" + lengths + "}", {"max_steer", "curb_to_curb"});
    expect_no_car("{" + lengths + steer + R"(, "turning_radius": 4})", {"max_steer", "turning_radius", "exclude"});
    expect_no_car("{" + lengths + steer + R"(, "wheelbse": 4})", {"\"wheelbse\"", "\"wheelbase\""});
    expect_no_car("{" + lengths + steer + R"(, "width": 1.9})", {"\"width\"", "twice"});
    expect_no_car(R"({"width": 1.8, "front": 3.6, "rear": 0.8, "max_steer": 0.6})", {"\"wheelbase\"", "missing"});
    expect_no_car("{}", {"\"width\"", "missing"});
}

TEST(CarFile, TypesThatAreWrongAreNamed) {
    expect_no_car(R"({"width": "1.8"})", {"\"width\"", "a string", "a number"});
    expect_no_car(R"({"width": null})", {"\"width\"", "null"});
    expect_no_car(R"({"width": true})", {"\"width\"", "true or false"});
    expect_no_car(R"({"width": [1.8]})", {"\"width\"", "a list"});
    expect_no_car(R"({"width": {"m": 1.8}})", {"\"width\"", "an object"});
    expect_no_car(R"({"name": 7})", {"\"name\"", "a number", "a string"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6, "name": "a\nb"})", {"\"name\"", "control"});
    expect_no_car("7", {"a number", "object"});
    expect_no_car("\"zoe\"", {"a string", "object"});
    expect_no_car("[]", {"a list", "object"});
    expect_no_car("null", {"null", "object"});
}

TEST(CarFile, ValuesThatAreImpossibleAreNamed) {
    const std::string rest = R"("front": 3.6, "rear": 0.8, "wheelbase": 2.6, "max_steer": 0.6})";
    expect_no_car(R"({"width": -1.8, )" + rest, {"width", "-1.8"});
    expect_no_car(R"({"width": 0, )" + rest, {"width"});
    expect_no_car(R"({"width": 1e999, )" + rest, {"line 1", "1e999", "too large"});
    expect_no_car(R"({"width": NaN, )" + rest, {"line 1"});
    for (const char* steering :
         {R"("max_steer": 0)", R"("max_steer": 1.5707963267948966)", R"("max_steer": -0.5)", R"("max_steer_deg": 90)",
          R"("max_steer_deg": 0)", R"("max_steer_deg": 1e300)", R"("turning_radius": 0)", R"("turning_radius": -4)",
          R"("turning_radius": 1e300)", R"("curb_to_curb": 0)", R"("curb_to_curb": 5.2)", R"("curb_to_curb": 1e300)"}) {
        const std::string key = std::string(steering).substr(0, std::string(steering).find(':'));
        expect_no_car("{" + lengths + ", " + steering + "}", {key, "must lie between"});
    }
}

TEST(CarFile, BrokenJsonIsLocated) {
    expect_no_car("", {"line 1, column 1", "too early"});
    expect_no_car("{\n  \"width\": 1.8,\n  \"front\" 3\n}", {"line 3, column 11"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6} trailing)", {"line 1", "ailing"});
    expect_no_car("{" + lengths + R"(, "max_steer": 0.6)", {"too early"});
    expect_no_car("{'width': 1}", {"line 1, column 2"});
    expect_no_car("{\"width\xff\": 1}", {"line 1"});
    expect_no_car("{\"a\x01\": 1}", {"line 1"});
}

TEST(Cars, TheCatalogueComesAsTextJsonAndCsv) {
    const Result text = run("cars");
    const Result json = run("cars --format json");
    const Result csv = run("cars --format csv");
    EXPECT_EQ(text.exit_code + json.exit_code + csv.exit_code, 0);
    const Json cars = Json::parse(json.out);
    ASSERT_EQ(cars.size(), known_cars().size());
    for (const Json& car : cars) {
        EXPECT_EQ(write(as_json(car_from_json(car.dump(), "car"))), write(car));
        EXPECT_NE(text.out.find(car.at("name").get<std::string>()), std::string::npos);
        EXPECT_NE(csv.out.find(car.at("name").get<std::string>() + ","), std::string::npos);
    }
    EXPECT_EQ(csv.out.rfind("name,width,front,rear,wheelbase,max_steer,", 0), 0U);
}

TEST(Cars, ThePapersComeFirstAndTheOthersWithTheirSheets) {
    const std::string text = run("cars").out;
    const std::size_t paper = text.find("\nof the paper:\n");
    const std::size_t others = text.find("\nof data sheets:\n");
    const std::size_t sheets = text.find("\nSheets, and the circles");
    ASSERT_TRUE(paper < others && others < sheets && sheets != text.npos) << text;
    for (const Car& car : catalogue()) {
        const std::size_t at = text.find("\n" + car.name() + " ");
        EXPECT_TRUE(paper < at && at < others) << car.name();
        EXPECT_EQ(run("cars " + car.name()).out.find("sheet"), std::string::npos) << car.name();
    }
    for (const SheetCar& known : sheet_cars()) {
        const std::size_t at = text.find("\n" + known.car.name() + " ");
        EXPECT_TRUE(others < at && at < sheets) << known.car.name();
        const std::string line = text.substr(text.find("\n" + known.car.name() + " ", sheets) + 1);
        EXPECT_EQ(line.substr(0, line.find('\n')).find(known.sheet) + known.sheet.size(), line.find('\n'));
        const std::string detail = run("cars " + known.car.name()).out;
        EXPECT_NE(detail.find(known.sheet), std::string::npos) << detail;
        EXPECT_NE(detail.find(known.circle), std::string::npos) << detail;
        EXPECT_NE(detail.find(known.source.substr(known.source.rfind('\n') + 1) + "\n"), std::string::npos) << detail;
    }
}

TEST(Cars, AFilesTextShowsWhatWasUnderstood) {
    const Folder folder;
    const std::string file = folder.with(
        "sheet.json",
        R"({"name": "sheet", "width": 1.8, "length": 4.4, "front_overhang": 1.0, "wheelbase": 2.6, "curb_to_curb": 10.9,
            "corner_radius": 0.3})");
    const Result result = run("cars " + file);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const char* shown : {"4.400 m", "1.000 m", "and 0.800 m behind", "10.900 m", "wall to wall", "outline"})
        EXPECT_NE(result.out.find(shown), std::string::npos) << shown << " is not in\n" << result.out;
    const Json car = Json::parse(run("cars --format json " + file).out);
    EXPECT_NEAR(car["front"].get<double>(), 3.6, 1e-12);
}

TEST(Cars, OneCarIsACarFile) {
    const Folder folder;
    for (const Car& car : known_cars()) {
        const std::string file = folder.file(car.name() + ".json");
        ASSERT_EQ(run("cars --format json -o " + file + " " + car.name()).exit_code, 0);
        // A file does not know which sheet it is from.
        EXPECT_EQ(run("cars " + car.name()).out.rfind(run("cars " + file).out, 0), 0U);
        EXPECT_EQ(run("cars --format json " + file).out, contents(file));
        EXPECT_EQ(write(as_json(read_car(file))), write(as_json(car)));
    }
}

}  // namespace
}  // namespace snug::test
