// Cars from CSV: what may be said of them in which form, and that whatever is wrong is told with its line and column.
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "model/numbers.hpp"
#include "process.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

using model::degree;

const std::string header = "name,width,front,rear,wheelbase,max_steer_deg\n";

void expect_no_fleet(const std::string& text, const std::vector<std::string>& named) {
    try {
        static_cast<void>(cars_from_csv(text, "fleet.csv"));
        ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.rfind("fleet.csv: ", 0), 0U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        for (const std::string& word : named) {
            EXPECT_NE(what.find(word), std::string::npos) << '"' << word << "\" is not in: " << what;
        }
    }
}

TEST(Fleet, TheKnownCarsReadBackAsTheyArePrinted) {
    const Folder folder;
    ASSERT_EQ(run("cars --format csv -o " + folder.file("fleet.csv")).exit_code, 0);
    const std::vector<Car> cars = read_cars(folder.file("fleet.csv"));
    std::vector<Car> known = catalogue();
    for (const SheetCar& each : sheet_cars()) known.push_back(each.car);
    ASSERT_EQ(cars.size(), known.size());
    for (std::size_t i = 0; i < cars.size(); ++i) {
        EXPECT_EQ(write(as_json(cars[i])), write(as_json(known[i])));
        EXPECT_EQ(cars[i].max_steer(), known[i].max_steer());
    }
}

TEST(Fleet, ShowsWhatWasUnderstood) {
    const Folder folder;
    const std::string file = folder.with("two.csv",
                                         "name,length,width,wheelbase,rear_overhang,curb_to_curb\n"
                                         "van,5.413,2.05,3.45,1.015,12.5\nsmall,3.595,1.595,2.4,0.52,9.6\n");
    const Result text = run("cars " + file);
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_NE(text.out.find("\nvan    2.050  4.398  1.015      3.450       39.5    4.187   12.500   5.413\n"),
              std::string::npos)
        << text.out;
    EXPECT_EQ(Json::parse(run("cars --format json " + file).out).size(), 2U);
    const std::string again = run("cars --format csv " + file).out;
    EXPECT_EQ(run("cars --format csv " + folder.with("again.csv", again)).out, again);
    expect_refusal(run("cars " + folder.with("no.csv", "name,width\na,1.8\n")), {"no.csv", "wheelbase"});
}

TEST(Fleet, AnyCarReadsBackFromAllItsColumns) {
    const Folder folder;
    for (const char* car :
         {R"("width": 10, "front": 1e-3, "rear": 1e-3, "wheelbase": 1e-3, "max_steer_deg": 80)",
          R"("width": 1e-3, "front": 50, "rear": 1e-3, "wheelbase": 50, "max_steer_deg": 5)",
          R"("width": 1.8, "front": 3.6, "rear": 0.8, "wheelbase": 2.6, "max_steer": 0.6, "corner_radius": 0.3)"}) {
        const std::string file = folder.with("car.json", std::string(R"({"name": "a \"b\", ü", )") + car + "}");
        ASSERT_EQ(run("cars --format csv -o " + folder.file("fleet.csv") + " " + file).exit_code, 0);
        const std::vector<Car> cars = read_cars(folder.file("fleet.csv"));
        ASSERT_EQ(cars.size(), 1U);
        EXPECT_EQ(write(as_json(cars[0])), write(as_json(read_car(file))));
    }
}

TEST(Fleet, ColumnsComeInAnyOrderAndSteeringUnderAnyName) {
    const std::vector<Car> cars = cars_from_csv(
        "\xef\xbb\xbfwheelbase,curb_to_curb,max_steer,name,rear,turning_radius,front,width,length\r\n"
        "2.6,,0.6,\"one, \"\"two\"\"\",0.8,,3.6,1.8,4.4\r\n"
        "2.6,,,three,0.8,4,3.6,1.8,\r\n"
        "\r\n"
        "2.6,10.9,,four,0.8,,3.6,1.8,",
        "fleet.csv");
    ASSERT_EQ(cars.size(), 3U);
    EXPECT_EQ(cars[0].name(), "one, \"two\"");
    EXPECT_EQ(cars[0].max_steer(), 0.6);
    EXPECT_EQ(cars[0].width(), 1.8);
    EXPECT_NEAR(cars[1].turning_radius(), 4.0, 1e-14);
    EXPECT_NEAR(cars[2].curb_to_curb(), 10.9, 1e-13);
    EXPECT_DOUBLE_EQ(cars_from_csv(header + "a,1.8,3.6,0.8,2.6,36", "")[0].max_steer(), 36 * degree);
}

TEST(Fleet, HeadersThatAreWrongAreToldWithTheirColumn) {
    expect_no_fleet("", {"empty"});
    expect_no_fleet("\xef\xbb\xbf\r\n\n", {"empty"});
    expect_no_fleet(header, {"no cars"});
    expect_no_fleet("name,widht,front,rear,wheelbase,max_steer\n",
                    {"line 1, column 2", "\"widht\"", "did you mean width"});
    expect_no_fleet("name;width;front\n", {"line 1, column 1", "commas"});
    expect_no_fleet("name,width,front,width\n", {"line 1, column 4", "\"width\"", "twice"});
    expect_no_fleet("name,width,front,wheelbase,max_steer\n", {"line 1", "\"rear\""});
    expect_no_fleet("width,front,rear,wheelbase,max_steer\n", {"line 1", "\"name\""});
    expect_no_fleet("name,width,front,rear,wheelbase,length\n", {"line 1", "steering", "curb_to_curb"});
    expect_no_fleet("name,\n", {"line 1, column 2", "\"\" is no column"});
}

TEST(Fleet, FieldsThatAreWrongAreToldWithTheirLineAndColumn) {
    const auto expect = [](const std::string& line, const std::vector<std::string>& named) {
        expect_no_fleet(header + "good,1.8,3.6,0.8,2.6,36\n" + line + "\nbad\n", named);
    };
    expect("a,1.8,3.6,0.8,abc,36", {"line 3, column 5 (wheelbase)", "\"abc\" is no number", "metres"});
    expect("a,1.8,3.6,0.8,2.6,36 deg", {"line 3, column 6 (max_steer_deg)", "\"36 deg\"", "degrees"});
    for (const char* width :
         {"1,8", "nan", "inf", "-inf", "nan(1)", "0x1p3", "+1.8", " 1.8", "1.8 m", "--1", ".", "e1"}) {
        expect(std::string("a,\"") + width + "\",3.6,0.8,2.6,36", {"line 3, column 2 (width)", width, "no number"});
    }
    expect("a,1e999,3.6,0.8,2.6,36", {"line 3, column 2 (width)", "too large"});
    expect("a,,3.6,0.8,2.6,36", {"line 3, column 2 (width)", "is empty"});
    expect("a,-1.8,3.6,0.8,2.6,36", {"line 3, column 2 (width)", "-1.8", "must lie between"});
    expect("a,1.8,3.6,0,2.6,36", {"line 3, column 4 (rear)", "must lie between"});
    expect("a,1.8,3.6,0.8,2.6,90", {"line 3, column 6 (max_steer_deg)", "90", "must lie between"});
    expect("a,1.8,3.6,0.8,2.6,", {"line 3", "nothing about the steering"});
    expect("a,1.8,3.6,0.8,2.6", {"line 3", "5 fields", "6 columns"});
    expect("a,1.8,3.6,0.8,2.6,36,", {"line 3", "7 fields"});
    expect("a", {"line 3", "1 field,"});
    expect(",1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "is empty"});
    expect("good,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "\"good\"", "line 2"});
    expect(std::string(101, 'x') + ",1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "100 bytes"});
    expect("a\tb,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "control"});
    expect("a\xff,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "UTF-8"});
    expect("\"a,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "not closed"});
    expect("\"a\"b,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "\"b"});
    expect("a\"b,1.8,3.6,0.8,2.6,36", {"line 3, column 1 (name)", "holds a quote"});
    expect(std::string(20'001, ','), {"line 3", "longer than 20 kB"});
    expect("a,1771,3427,657,2588,36", {"line 3, column 2 (width)", "1771 looks like millimetres", "1.771 m"});
    expect("a,1.8,2.5,0.8,2.6,36", {"line 3, column 3 (front)", "wheelbase + front overhang"});
}

TEST(Fleet, ColumnsThatRepeatOthersMustAgree) {
    const std::string all = "name,width,front,rear,wheelbase,max_steer_deg,turning_radius,length\n";
    expect_no_fleet(all + "a,1.8,3.6,0.8,2.6,36,,4.5\n",
                    {"line 2, column 8 (length)", "length is 4.5", "front and rear", "4.4"});
    expect_no_fleet(all + "a,1.8,3.6,0.8,2.6,36,4,\n",
                    {"line 2, column 7 (turning_radius)", "turning_radius is 4", "max_steer_deg"});
    expect_no_fleet(all + "a,1.8,3.6,0.8,2.6,36,x,\n", {"line 2, column 7 (turning_radius)", "no number"});
    EXPECT_EQ(cars_from_csv(all + "a,1.8,3.6,0.8,2.6,45,2.6,4.4\n", "").size(), 1U);
}

TEST(Fleet, DataSheetsAndOutlinesDescribeCars) {
    const std::vector<Car> cars = cars_from_csv(
        "name,wheelbase,length,width,front_overhang,rear_overhang,corner_radius,outline,wall_to_wall\n"
        "sheet,2.6,4.4,1.8,1,,,,11.2\n"
        "round,2.6,,1.8,1,0.8,0.3,,11.2\n"
        "wedge,2.6,,,,,,3.6 0.5; -0.8 0.9; -0.8 -0.9; 3.6 -0.5,11.2\n",
        "fleet.csv");
    ASSERT_EQ(cars.size(), 3U);
    EXPECT_DOUBLE_EQ(cars[0].front(), 3.6);
    EXPECT_NEAR(cars[0].rear(), 0.8, 1e-15);
    EXPECT_EQ(cars[1].outline(), Outline::rounded(3.6, 0.8, 0.9, 0.3, 0.3));
    EXPECT_EQ(cars[2].outline().corners().size(), 4U);
    for (const Car& car : cars) EXPECT_NEAR(car.wall_to_wall(), 11.2, 1e-12) << car.name();
    const std::vector<Car> back = cars_from_csv(as_csv(cars), "again");
    for (std::size_t i = 0; i < cars.size(); ++i) EXPECT_EQ(back[i], cars[i]);
    const std::string head = "name,wheelbase,max_steer_deg,outline\n";
    expect_no_fleet(head + "a,2.6,36,3.6 0.9; -0.8 0.9\n", {"line 2, column 4 (outline)"});
    expect_no_fleet(head + "a,2.6,36,3.6 0.9; -0.8; 1 1\n", {"line 2, column 4 (outline)", "is no point"});
    expect_no_fleet(head + "a,2.6,36,3.6 0.9; -0.8 x; 1 1\n", {"line 2, column 4 (outline)", "\"x\" is no number"});
}

TEST(Fleet, FilesThatCannotBeReadAreTold) {
    const Folder folder;
    const auto expect = [&](const std::string& path, const std::string& reason) {
        try {
            static_cast<void>(read_cars(path));
            ADD_FAILURE() << "accepted: " << path;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(path + ": "), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    };
    expect(folder.file("none.csv"), "No such file");
    expect(folder.file("."), "directory");
    expect("/dev/zero", "larger than 100 MB");
    const std::string secret = folder.with("secret.csv", header);
    if (chmod(secret.c_str(), 0) == 0 && access(secret.c_str(), R_OK) != 0) {  // root reads everything
        expect(secret, "Permission denied");
    }
}

}  // namespace
}  // namespace snug::test
