// Which places can exist, and what meets what in them.
#include "snug/place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "contact/place_contact.hpp"
#include "model/polygon.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/error.hpp"

namespace {

using namespace park_test;

snug::PlaceDescription square_to_park_in() {
    snug::PlaceDescription place;
    place.parked = snug::ParkedInside{{{0, 0}, {5, 0}, {5, 2}, {0, 2}}, 0.0, 0.5, {}};
    place.region = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    return place;
}

std::string refusal(const snug::PlaceDescription& description) {
    try {
        const Place place(description);
    } catch (const snug::Error& error) {
        return error.what();
    }
    return "";
}

TEST(Place, RefusesWhatIsNoPolygonAndSaysWhy) {
    EXPECT_EQ(refusal(square_to_park_in()), "");
    auto place = square_to_park_in();
    place.obstacles.push_back({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, false, "bow", {}});
    EXPECT_NE(refusal(place).find("obstacle [0] (bow) crosses itself"), std::string::npos) << refusal(place);
    place.obstacles[0].corners = {{0, 0}, {1, 1}};
    EXPECT_NE(refusal(place).find("has 2 corners"), std::string::npos) << refusal(place);
    place.obstacles[0].corners = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_NE(refusal(place), "");
    place.obstacles[0].corners = {{0, 0}, {1, NAN}, {2, 2}};
    EXPECT_NE(refusal(place), "");
    place = square_to_park_in();
    place.region = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
    EXPECT_NE(refusal(place).find("the region must be convex"), std::string::npos) << refusal(place);
}

TEST(Place, CutsPolygonsIntoConvexPiecesOfTheSameArea) {
    const int count = snug::test::sample(300, 20000);
    for (int i = 0; i < count; ++i) {
        // A star around the origin is simple.
        Random random(static_cast<std::uint64_t>(800000 + i));
        std::vector<Point> star;
        const int corners = random.whole(3, 14);
        for (int k = 0; k < corners; ++k) {
            const double angle = 6.283185307179586 * (k + random.between(0.05, 0.95)) / corners,
                         far = random.between(0.3, 4.0);
            star.push_back({far * std::cos(angle), far * std::sin(angle)});
        }
        if (snug::detail::area(star) < 1e-3 || snug::detail::crosses_itself(star))
            continue;  // the origin may be outside
        SCOPED_TRACE("star " + std::to_string(i));
        double total = 0.0;
        const auto pieces = snug::detail::convex_pieces(star);
        for (const auto& piece : pieces) {
            EXPECT_TRUE(snug::detail::is_convex(piece));
            EXPECT_GT(snug::detail::area(piece), 0.0);
            total += snug::detail::area(piece);
        }
        EXPECT_NEAR(total, snug::detail::area(star), 1e-9);
        // Points are in one piece exactly when they are in the star.
        for (int n = 0; n < 50; ++n) {
            const Point p{random.between(-4, 4), random.between(-4, 4)};
            bool in_star = false;
            for (std::size_t a = 0, b = star.size() - 1; a < star.size(); b = a++) {
                if ((star[a].y > p.y) != (star[b].y > p.y) &&
                    p.x < (star[b].x - star[a].x) * (p.y - star[a].y) / (star[b].y - star[a].y) + star[a].x)
                    in_star = !in_star;
            }
            const auto inside = [&](const std::vector<Point>& piece) { return outside(piece, {p.x, p.y}) < 0.0; };
            EXPECT_EQ(std::any_of(pieces.begin(), pieces.end(), inside), in_star) << p.x << " " << p.y;
        }
    }
}

TEST(PlaceContact, ComesWhereSteppingFindsIt) {
    const int count = snug::test::sample(2000, 200000);
    int contacts = 0;
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(900000 + i));
        SCOPED_TRACE("case " + std::to_string(i));
        const Car car = random_car(random);
        std::vector<Point> solid;
        const int corners = random.whole(3, 7);
        const double x = random.between(-8, 8), y = random.between(-8, 8), turned = random.between(0, 6);
        for (int k = 0; k < corners; ++k) {
            const double angle = turned + 6.283185307179586 * k / corners;
            solid.push_back({x + 2 * std::cos(angle), y + 2 * std::sin(angle)});
        }
        snug::detail::Path path;
        path.start = {random.between(-2, 2), random.between(-2, 2), random.between(-3, 3)};
        const double most = std::tan(car.max_steer()) / car.wheelbase();
        path.curvature = random.chance(0.2) ? 0.0 : random.between(-most, most);
        path.way = random.chance(0.5) ? 1.0 : -1.0;
        path.length = random.between(0.1, 15.0);
        const auto deep = [&](double distance) { return depth(car_at(car, path.at(distance), false), solid); };
        if (deep(0.0) > -1e-6) continue;
        const double found = snug::detail::first_contact(car.outline().corners(), path, solid, 1e-9);
        double stepped = snug::detail::never;
        for (double at = 0.0; at <= path.length; at += 0.01) {
            if (deep(at) > 1e-9) {
                stepped = at;
                break;
            }
        }
        if (found > path.length) {
            EXPECT_EQ(stepped, snug::detail::never);
            continue;
        }
        ++contacts;
        EXPECT_LE(found, stepped);
        EXPECT_NEAR(deep(found), 0.0, 1e-8);
        if (found > 1e-3) {
            EXPECT_LT(deep(found - 1e-3), 1e-9);
        }
    }
    EXPECT_GT(contacts, count / 20);
}

TEST(StreetPlace, IsWhatItSays) {
    Street street;
    street.length = 5.0;
    street.width = 2.0;
    street.road = 3.5;
    const Car zoe = *snug::find_car("renault-zoe");
    const Place parallel = street_place(street);
    EXPECT_LT(short_of_parked(zoe, parallel, {-4.2, -1.0, 0.0}), 0.0);
    EXPECT_LT(depth_in_place(zoe, parallel, {-4.2, -1.0, 0.0}), 0.0);
    EXPECT_GT(depth_in_place(zoe, parallel, {-4.4, -1.0, 0.0}), 0.0);  // in the rear neighbour
    EXPECT_GT(depth_in_place(zoe, parallel, {0.0, 3.0, 0.0}), 0.0);    // in the far side
    street.angle = 1.5707963267948966;
    street.width = 2.4;
    const Place perpendicular = street_place(street);
    EXPECT_LT(short_of_parked(zoe, perpendicular, {-1.2, -4.2, 1.5707963}), 0.0);
    EXPECT_LT(depth_in_place(zoe, perpendicular, {-1.2, -4.2, 1.5707963}), 0.0);
    EXPECT_GT(depth_in_place(zoe, perpendicular, {-1.2 - 0.4, -4.2, 1.5707963}), 0.0);
    street.enter = Enter::forward;
    EXPECT_LT(short_of_parked(zoe, street_place(street), {-1.2, -0.8, -1.5707963}), 0.0);
}

}  // namespace
