// Pictures: every one is a whole file of its format, shows its parts, and is the same each time.
#include "snug/draw.hpp"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../draw/palette.hpp"

namespace snug {
namespace {

using drawing::Color;

/// Back and forth in the slot, with made-up contacts: for pictures, not for parking.
Maneuver shuffle(const Car& car, const Slot& slot, int moves, Direction first = Direction::backward) {
    const double sign = first == Direction::backward ? 1.0 : -1.0;
    const double heading = 0.3;
    Pose pose = slot.to_world(Pose{-0.75 * slot.length(), -0.1 * slot.width(), sign * heading});
    Maneuver maneuver = {car, {}};
    double steering = slot.mirrored(sign * car.max_steer());
    Direction direction = first;
    for (int i = 0; i < moves; ++i) {
        Move move;
        move.direction = direction;
        move.steering_angle = steering;
        move.length = (0.02 + 0.01 * (i % 4)) * car.length();
        move.start = pose;
        move.end = pose = drive(car, pose, direction, steering, move.length);
        if (i + 1 < moves) {
            move.contact = i % 2 == 0 ? Contact{CarPart::rear_right_corner, Obstacle::curb}
                                      : Contact{CarPart::right_edge, Obstacle::front_corner};
        }
        maneuver.moves.push_back(move);
        direction = direction == Direction::backward ? Direction::forward : Direction::backward;
        steering = -steering;
    }
    return maneuver;
}

Answer answer_with(const Maneuver& maneuver) {
    Answer answer;
    answer.direction_changes = maneuver.direction_changes();
    answer.ranges = {{0.30, 0.31, maneuver.direction_changes(), 0},
                     {0.31, 0.31000001, maneuver.direction_changes() + 2, 0}};
    answer.maneuver = maneuver;
    return answer;
}

Slot roomy(const Car& car, Side side = Side::right) { return Slot({1.2 * car.length(), 1.2 * car.width(), side}); }

/// A PNG read back: one number 0xrrggbb per pixel.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> colors;
};

Pixels read_png(const std::string& bytes) {
    struct Source {
        const std::string& bytes;
        std::size_t at = 0;
    } source = {bytes};
    const auto read = [](void* from, unsigned char* data, unsigned int length) {
        auto& s = *static_cast<Source*>(from);
        if (s.at + length > s.bytes.size()) {
            return CAIRO_STATUS_READ_ERROR;
        }
        std::memcpy(data, s.bytes.data() + s.at, length);
        s.at += length;
        return CAIRO_STATUS_SUCCESS;
    };
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
        cairo_image_surface_create_from_png_stream(read, &source), cairo_surface_destroy);
    EXPECT_EQ(cairo_surface_status(image.get()), CAIRO_STATUS_SUCCESS);
    Pixels pixels = {cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
    const unsigned char* row = cairo_image_surface_get_data(image.get());
    for (int y = 0; y < pixels.height; ++y, row += cairo_image_surface_get_stride(image.get())) {
        for (int x = 0; x < pixels.width; ++x) {
            std::uint32_t color = 0;
            std::memcpy(&color, row + std::size_t{4} * static_cast<std::size_t>(x), 4);
            pixels.colors.push_back(color & 0xffffff);
        }
    }
    return pixels;
}

int distance(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16}) {
        const int difference = static_cast<int>((a >> shift) & 255) - static_cast<int>((b >> shift) & 255);
        most = std::max(most, std::abs(difference));
    }
    return most;
}

std::uint32_t hex(const Color& color) {
    const auto byte = [](double part) { return static_cast<std::uint32_t>(std::lround(part * 255)); };
    return byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
}

long count(const Pixels& pixels, const Color& color) {
    long found = 0;
    for (const std::uint32_t pixel : pixels.colors) {
        found += distance(pixel, hex(color)) <= 2 ? 1 : 0;
    }
    return found;
}

/// Every tag that opens also closes, in order, and every quote within a tag.
bool is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    std::size_t at = 0;
    while ((at = xml.find('<', at)) != std::string::npos) {
        std::size_t end = at + 1;
        bool quoted = false;
        while (end < xml.size() && (quoted || xml[end] != '>')) {
            quoted ^= xml[end] == '"';
            if (xml[end] == '<') {
                return false;
            }
            ++end;
        }
        if (end == xml.size()) {
            return false;
        }
        const std::string tag = xml.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
        if (tag[0] == '/') {
            if (open.empty() || "/" + open.back() != tag) {
                return false;
            }
            open.pop_back();
        } else if (tag[0] != '?' && tag.back() != '/') {
            open.push_back(name);
        }
        at = end;
    }
    return open.empty();
}

void expect_whole(const std::string& bytes, PictureFormat format) {
    switch (format) {
        case PictureFormat::svg:
            EXPECT_EQ(bytes.substr(0, 5), "<?xml");
            EXPECT_TRUE(is_well_formed(bytes));
            EXPECT_EQ(bytes.find("nan"), std::string::npos);
            break;
        case PictureFormat::pdf:
            EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
            EXPECT_NE(bytes.find("%%EOF", bytes.size() - 8), std::string::npos);
            break;
        case PictureFormat::png:
            EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
            const Pixels pixels = read_png(bytes);
            EXPECT_EQ(pixels.width, 2000);
            EXPECT_GT(count(pixels, drawing::palette::slot), 100) << "no slot to be seen";
            EXPECT_GT(count(pixels, drawing::palette::ink), 100) << "no text to be seen";
            break;
    }
}

constexpr std::array formats = {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png};

TEST(Picture, IsAWholeFileForEveryCarAndSideInBothViews) {
    for (const Car& car : catalogue()) {
        for (const Side side : {Side::right, Side::left}) {
            const Slot slot = roomy(car, side);
            const Answer answer = answer_with(shuffle(car, slot, 7));
            for (const PictureFormat format : formats) {
                expect_whole(draw_maneuver(car, slot, answer, format), format);
                expect_whole(draw_entries(car, slot, answer, format), format);
            }
        }
    }
}

TEST(Picture, ShowsSlotEntryGoalPathsAndContacts) {
    const Car car = *find_car("renault-zoe");
    const Slot slot = roomy(car);
    const Pixels pixels = read_png(draw_maneuver(slot, shuffle(car, slot, 3), PictureFormat::png));
    namespace in = drawing::palette;
    for (const Color& color :
         {in::slot, in::entry, in::goal, in::backward, in::forward, in::contact, in::neighbour, in::curb}) {
        EXPECT_GT(count(pixels, color), 30) << std::hex << hex(color);
    }
}

TEST(Picture, SaysInItsTitleWhatItShows) {
    const Car car = *find_car("renault-zoe");
    const Slot slot({4.5, 2.0});
    const std::string svg = draw_maneuver(slot, shuffle(car, slot, 19), PictureFormat::svg);
    EXPECT_NE(
        svg.find("<title>renault-zoe, slot 4.50 m \u00d7 2.00 m: 18 direction changes, entry heading 17.19\u00b0"),
        std::string::npos)
        << svg.substr(0, 400);
}

TEST(Picture, IsTheSameBytesEachTime) {
    const Car car = *find_car("opel-corsa");
    const Slot slot = roomy(car);
    const Answer answer = answer_with(shuffle(car, slot, 9));
    for (const PictureFormat format : formats) {
        EXPECT_EQ(draw_maneuver(car, slot, answer, format), draw_maneuver(car, slot, answer, format));
        EXPECT_EQ(draw_entries(car, slot, answer, format), draw_entries(car, slot, answer, format));
    }
}

TEST(Picture, IsTheSameFromManyThreads) {
    const Car car = *find_car("mid-size");
    const Slot slot = roomy(car);
    const Maneuver maneuver = shuffle(car, slot, 5);
    std::vector<std::string> pictures(4);
    std::vector<std::thread> threads;
    threads.reserve(pictures.size());
    for (std::string& picture : pictures) {
        threads.emplace_back([&] { picture = draw_maneuver(slot, maneuver, PictureFormat::svg); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const std::string& picture : pictures) {
        EXPECT_EQ(picture, pictures.front());
    }
}

TEST(Picture, LiesInTheSlotFrameWhereverTheSlotIs) {
    const Car car = *find_car("vw-transporter");
    for (const Side side : {Side::right, Side::left}) {
        const Slot here({6.2, 2.4, side});
        const Slot there({6.2, 2.4, side, {123.0, -45.0}, 2.5});
        const Pixels a = read_png(draw_maneuver(here, shuffle(car, here, 6), PictureFormat::png));
        const Pixels b = read_png(draw_maneuver(there, shuffle(car, there, 6), PictureFormat::png));
        ASSERT_EQ(a.height, b.height);
        long different = 0;
        for (std::size_t i = 160 * static_cast<std::size_t>(a.width); i < a.colors.size(); ++i) {  // below the header
            different += distance(a.colors[i], b.colors[i]) > 8 ? 1 : 0;
        }
        EXPECT_LT(different, 20);
    }
}

TEST(Picture, OfALeftSlotIsTheMirrorImageOfTheRight) {
    const Car car = *find_car("mercedes-amg-gt");
    const Slot right = roomy(car);
    const Slot left = roomy(car, Side::left);
    const Pixels a = read_png(draw_maneuver(right, shuffle(car, right, 2), PictureFormat::png));
    const Pixels b = read_png(draw_maneuver(left, shuffle(car, left, 2), PictureFormat::png));
    ASSERT_EQ(a.height, b.height);
    for (const Color& color : {drawing::palette::entry, drawing::palette::goal, drawing::palette::neighbour}) {
        EXPECT_NEAR(static_cast<double>(count(a, color)), static_cast<double>(count(b, color)),
                    0.02 * static_cast<double>(count(a, color)) + 40);
    }
}

TEST(Picture, OfACarThatEntersNoseFirst) {
    const Car car = *find_car("mid-size");
    for (const Side side : {Side::right, Side::left}) {
        const Slot slot = roomy(car, side);
        const Answer answer = answer_with(shuffle(car, slot, 6, Direction::forward));
        const PictureOptions options = {{.clearance = 0.05, .enter = Enter::forward}};
        expect_whole(draw_maneuver(car, slot, answer, PictureFormat::png, options), PictureFormat::png);
        const std::string svg = draw_entries(car, slot, answer, PictureFormat::svg, options);
        expect_whole(svg, PictureFormat::svg);
    }
}

TEST(Picture, OfAMapShowsCountsByShadeAndIsMirroredOnTheLeft) {
    const Car car = *find_car("renault-zoe");
    Street street;
    street.length = 5.2;
    street.width = 2.0;
    street.road = 3.5;
    const ParkMap map(car, street);
    for (const PictureFormat format : formats) {
        const std::string picture = draw_map(map, street, {2.0, 1.75, 0.0}, format);
        expect_whole(picture, format);
        EXPECT_EQ(picture, draw_map(map, street, {2.0, 1.75, 0.0}, format));
    }
    const auto right = read_png(draw_map(map, street, {2.0, 1.75, 0.0}, PictureFormat::png));
    street.side = Side::left;
    const auto left = read_png(draw_map(ParkMap(car, street), street, {2.0, -1.75, 0.0}, PictureFormat::png));
    for (const Color color : {drawing::rgb(0xa9dcc8), drawing::rgb(0x74c3ad)}) {
        EXPECT_GT(count(right, color), 10000);
        EXPECT_NEAR(static_cast<double>(count(right, color)), static_cast<double>(count(left, color)),
                    0.02 * static_cast<double>(count(right, color)));
    }
    // Where the car meets something or outside of the map.
    const std::string blocked = draw_map(map, street, {2.0, 0.5, 0.0}, PictureFormat::svg);
    EXPECT_NE(blocked.find("the car meets something where it stands</title>"), std::string::npos);
    const std::string outside = draw_map(map, street, {2.0, 1.75, 3.0}, PictureFormat::svg);
    EXPECT_NE(outside.find("outside of the map</title>"), std::string::npos);
}

TEST(Picture, OfACarThatCannotParkSaysSo) {
    const Car car = *find_car("renault-zoe");
    const Slot slot({3.9, 1.5});
    for (const PictureFormat format : formats) {
        expect_whole(draw_maneuver(car, slot, {}, format), format);
        expect_whole(draw_entries(car, slot, {}, format), format);
    }
    const std::string svg = draw_maneuver(car, slot, {}, PictureFormat::svg);
    EXPECT_NE(svg.find("cannot park, the slot is 0.184 m too short and 0.271 m too narrow</title>"), std::string::npos);
    EXPECT_GT(count(read_png(draw_maneuver(car, slot, {}, PictureFormat::png)), drawing::palette::entry), 1000);
    const std::string roomier = draw_maneuver(car, Slot({4.2, 1.8}), {}, PictureFormat::svg);
    EXPECT_NE(roomier.find("cannot park</title>"), std::string::npos);
}

TEST(Picture, OfAManeuverWithoutMovesOrAnAnswerGivenUp) {
    const Car car = *find_car("renault-zoe");
    const Slot slot = roomy(car);
    expect_whole(draw_maneuver(slot, Maneuver{car, {}}, PictureFormat::png), PictureFormat::png);
    Answer given_up;
    given_up.cancelled = true;
    EXPECT_NE(draw_maneuver(car, slot, given_up, PictureFormat::svg).find("given up"), std::string::npos);
    Answer moveless = answer_with(shuffle(car, slot, 1));
    moveless.maneuver->moves.clear();
    expect_whole(draw_maneuver(car, slot, moveless, PictureFormat::png), PictureFormat::png);
}

TEST(Picture, TakesAnyName) {
    const CarDimensions dimensions = find_car("renault-zoe")->dimensions();
    for (const std::string& name :
         {std::string(), std::string("Citro\u00ebn \u0160koda \u00a9"), std::string("a<b>&\"c\"</title>"),
          std::string(100000, 'w'), std::string("bad \xff\xc0\x80\xed\xa0\x80 bytes \xe2\x82"),
          std::string("two\nlines\tand\0nul", 17)}) {
        const Car car(dimensions, name);
        const Slot slot = roomy(car);
        for (const PictureFormat format : formats) {
            expect_whole(draw_maneuver(slot, shuffle(car, slot, 2), format), format);
        }
    }
    const Car car(dimensions, "<&> \xff");
    const std::string svg = draw_maneuver(roomy(car), shuffle(car, roomy(car), 1), PictureFormat::svg);
    EXPECT_NE(svg.find("<title>&lt;&amp;&gt; \ufffd, slot"), std::string::npos);
}

TEST(Picture, WorksAtEveryScale) {
    const CarDimensions zoe = find_car("renault-zoe")->dimensions();
    for (const double scale : {1e-5, 1e-3, 0.1, 10.0, 1e3, 1e5}) {
        const Car car({zoe.width * scale, zoe.front * scale, zoe.rear * scale, zoe.wheelbase * scale, zoe.max_steer});
        const Slot slot = roomy(car);
        expect_whole(draw_maneuver(slot, shuffle(car, slot, 8), PictureFormat::png), PictureFormat::png);
        expect_whole(draw_entries(car, slot, answer_with(shuffle(car, slot, 8)), PictureFormat::png),
                     PictureFormat::png);
    }
    const Car car(zoe);
    for (const double length : {1e-6, 1.0, 60.0, 1e6}) {
        for (const double width : {1e-6, 1.0, 60.0, 1e6}) {
            const Slot slot({length, width});
            for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf}) {
                expect_whole(draw_maneuver(car, slot, {}, format), format);
                expect_whole(draw_entries(car, slot, {}, format), format);
            }
        }
    }
}

TEST(Picture, OfHundredsOfMovesStaysOnAPage) {
    const Car car = *find_car("mid-size");
    const Slot slot = roomy(car);
    const std::string bytes = draw_maneuver(slot, shuffle(car, slot, 2000), PictureFormat::png);
    expect_whole(bytes, PictureFormat::png);
    EXPECT_LT(read_png(bytes).height, 4000);
}

TEST(PictureFormat, IsToldByTheExtension) {
    EXPECT_EQ(picture_format("zoe.svg"), PictureFormat::svg);
    EXPECT_EQ(picture_format("a/b.c/Zoe.PDF"), PictureFormat::pdf);
    EXPECT_EQ(picture_format(".png"), PictureFormat::png);
    for (const char* name : {"", "zoe", "zoe.jpg", "zoe.svg.gz", "svg", "a.png/zoe"}) {
        EXPECT_FALSE(picture_format(name)) << name;
    }
}

}  // namespace
}  // namespace snug
