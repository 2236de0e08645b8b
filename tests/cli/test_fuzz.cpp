// Whatever bytes come in, the answer is a car or an action, or an Error of one line: no crash, no hang.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "cli/command.hpp"
#include "cli/numbers.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

class Bytes {
public:
    explicit Bytes(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
    const std::string& any(const std::vector<std::string>& of) { return of[below(of.size())]; }

    /// The text with a few bytes, or pieces that matter to the reader, put in, left out, doubled or swapped.
    std::string mutated(std::string text, const std::vector<std::string>& pieces) {
        for (std::size_t edits = below(6); edits > 0; --edits) {
            const std::size_t at = below(text.size() + 1);
            const std::size_t length = below(1 + std::min<std::size_t>(12, text.size() - at));
            switch (below(5)) {
                case 0: text.insert(at, 1, static_cast<char>(below(256))); break;
                case 1: text.insert(at, any(pieces)); break;
                case 2: text.erase(at, length); break;
                case 3: text.insert(below(text.size() + 1), text.substr(at, length)); break;
                default: text.replace(at, length, any(pieces)); break;
            }
        }
        return text;
    }

private:
    std::mt19937 random_;
};

template <typename Attempt>
void expect_value_or_error(const std::string& input, Attempt attempt) {
    try {
        attempt();
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_FALSE(what.empty());
        EXPECT_LT(what.size(), 1000U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    } catch (const std::exception& error) {
        ADD_FAILURE() << "not an Error: " << error.what() << " for " << input;
    }
}

TEST(Fuzz, CarFiles) {
    const std::vector<std::string> pieces = {"{",
                                             "}",
                                             "[",
                                             "]",
                                             ":",
                                             ",",
                                             "\"",
                                             "\\",
                                             "\\u0000",
                                             "\\ud800",
                                             "null",
                                             "true",
                                             "-",
                                             "1e308",
                                             "1e999",
                                             "-0",
                                             "0.0",
                                             "1e-320",
                                             "NaN",
                                             "\n",
                                             "\"width\": 2",
                                             "\"max_steer_deg\": 30",
                                             "\"turning_radius\": 4",
                                             "\"curb_to_curb\": 9",
                                             "\xef\xbb\xbf",
                                             "\xff",
                                             "/**/",
                                             "[[[[[[",
                                             "\"name\": \"x\""};
    Bytes bytes(1);
    int cars = 0;
    for (int i = 0; i < sample(20'000, 2'000'000); ++i) {
        const std::vector<Car> known = catalogue();
        const std::string text = bytes.mutated(write(as_json(known[bytes.below(known.size())])), pieces);
        expect_value_or_error(text, [&] {
            const Car car = car_from_json(text, "fuzz");
            EXPECT_TRUE(car.turning_radius() > 0.0 && car.length() > 0.0);
            EXPECT_EQ(write(as_json(car_from_json(write(as_json(car)), "again"))), write(as_json(car)));
            ++cars;
        });
    }
    EXPECT_GT(cars, 0);
}

TEST(Fuzz, Fleets) {
    const std::string fleet =
        "name,width,front,rear,wheelbase,max_steer,max_steer_deg,turning_radius,curb_to_curb,length\n"
        "one,1.8,3.7,1,2.7,,45,2.7,,4.7\r\n"
        "\"two, or \"\"2\"\"\",1.771,3.427,0.657,2.588,0.5,,,,\n";
    const std::vector<std::string> pieces = {",",     "\"",           "\"\"",   "\n",  "\r\n",  "\r",
                                             "name",  "width",        "length", ";",   "-",     "1e308",
                                             "1e999", "1e-320",       "nan",    "inf", "0x1",   std::string(1, '\0'),
                                             "\xff",  "\xef\xbb\xbf", "ü",      "1.8", ",,,,,", "max_steer_deg"};
    Bytes bytes(4);
    int fleets = 0;
    for (int i = 0; i < sample(20'000, 2'000'000); ++i) {
        std::string text = bytes.mutated(fleet, pieces);
        if (bytes.below(4) == 0) {
            text.resize(bytes.below(200));
            for (char& byte : text) {
                byte = static_cast<char>(bytes.below(256));
            }
        }
        expect_value_or_error(text, [&] {
            for (const Car& car : cars_from_csv(text, "fuzz")) {
                EXPECT_FALSE(car.name().empty());
                EXPECT_TRUE(car.turning_radius() > 0.0 && car.length() > 0.0);
            }
            ++fleets;
        });
    }
    EXPECT_GT(fleets, 0);
}

TEST(Fuzz, ArgumentLists) {
    const std::vector<std::string> options = {"--car",
                                              "--length",
                                              "--width",
                                              "--extra-length",
                                              "--extra-width",
                                              "--side",
                                              "--corner",
                                              "--heading",
                                              "--clearance",
                                              "--enter",
                                              "--max-changes",
                                              "--min-range",
                                              "--strategy",
                                              "--step",
                                              "--heading-step",
                                              "--stop",
                                              "--format",
                                              "--view",
                                              "--threads",
                                              "--help",
                                              "-h",
                                              "--",
                                              "-",
                                              "-x",
                                              "--no",
                                              "cars",
                                              "entry",
                                              "--version"};
    const std::vector<std::string> values = {
        "renault-zoe", "mid-size", "5",       "2",    "4.5",        "0",         "-1",          "1e999",     "nan",
        "0x1p3",       "",         " ",       "left", "right",      "forward",   "stepping",    "max-steer", "inside",
        "json",        "csv",      "entries", "1,2",  "1,2,3",      "1:2:1",     "99999999999", "[1,2]",     "{}",
        "%s%n",        "\xff",     "a=b",     "=",    "--length=5", "--width=2", "-o",          "/",         "."};
    Bytes bytes(2);
    int understood = 0;
    for (int i = 0; i < sample(5'000, 500'000); ++i) {
        cli::Arguments arguments;
        if (bytes.below(2) == 0) {
            arguments = {"entry", "--car", "renault-zoe", "--length", "5", "--width", "2"};
        } else {
            arguments.push_back(bytes.any({"entry", "cars", "entry", ""}));
        }
        for (std::size_t count = bytes.below(6); count > 0; --count) {
            arguments.push_back(bytes.any(options));
            if (bytes.below(6) != 0) {
                arguments.push_back(bytes.mutated(bytes.any(values), options));
            }
        }
        std::string shown;
        for (const std::string& argument : arguments) {
            shown += argument + '|';
        }
        expect_value_or_error(shown, [&] {
            static_cast<void>(cli::parse(arguments));
            ++understood;
        });
    }
    EXPECT_GT(understood, 0);
}

TEST(Fuzz, NumbersAndRanges) {
    const std::vector<std::string> pieces = {"1", "0",   "9",   ".",     ",",      ":", "-", "+",  "e",     "E",
                                             "x", "nan", "inf", "1e308", "1e-308", "m", " ", "\n", "0.001", "1e999"};
    Bytes bytes(3);
    for (int i = 0; i < sample(20'000, 2'000'000); ++i) {
        const std::string text = bytes.mutated(bytes.any({"1.5", "1,2,3", "1:2:0.1", "-3", "1e3", ""}), pieces);
        expect_value_or_error(text, [&] {
            const std::vector<double> all = cli::numbers("--width", text, {" m", -1e6, 1e6});
            EXPECT_FALSE(all.empty());
            for (const double value : all) {
                EXPECT_TRUE(value >= -1e6 && value <= 1e6) << text;
            }
        });
    }
}

}  // namespace
}  // namespace snug::test
