// Is the first contact of any move where the oracle, by safe steps and by tiny ones, finds it?
#include <gtest/gtest.h>

#include <cstdio>
#include <optional>
#include <vector>

#include "oracle/dense_stepping.hpp"
#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/contact.hpp"

namespace oracle {
namespace {

snug::Pose into_world(const snug::SlotDimensions& slot, const Place<double>& place) {
    const double mirror = slot.side == snug::Side::left ? -1.0 : 1.0;
    const double c = std::cos(slot.heading), s = std::sin(slot.heading), y = mirror * place.y;
    return {slot.corner.x + c * place.x - s * y, slot.corner.y + s * place.x + c * y,
            slot.heading + mirror * place.heading};
}

/// What the oracle finds on one move.
struct Exact {
    long double contact;
    long double inside_from, inside_to = 0;
    bool never_inside;  // not even if it were a nanometre smaller
    bool grazing;       // a nanometre makes a difference
};

struct Question {
    Case asked;
    Problem<double> problem;
    Place<double> place;
    double steering;  // slot frame
    snug::Direction direction;

    Path<double> path() const {
        return {place,
                steering == 0 ? std::numeric_limits<double>::infinity() : asked.car.wheelbase / std::tan(steering),
                direction == snug::Direction::forward ? 1 : -1};
    }
    double farthest() const {
        return steering == 0 ? 1e7 : 2 * std::numbers::pi * asked.car.wheelbase / std::abs(std::tan(steering));
    }
    /// In long double, since a hardly steered car turns on a huge circle; the pose itself is rounded to double.
    Exact exact() const {
        auto fine = make_problem<long double>(asked);
        fine.forgiven = 1e-12L;
        const long double radius = steering == 0 ? std::numeric_limits<long double>::infinity()
                                                 : static_cast<long double>(asked.car.wheelbase) /
                                                       std::tan(static_cast<long double>(steering));
        const Path<long double> way{{place.x, place.y, place.heading}, radius, path().direction};
        const long double far = farthest();
        Exact result;
        result.contact = oracle::first_contact(fine, way, far);
        const auto inside_from = [&](long double smaller) {
            auto other = fine;
            other.car = fine.car.grown(-smaller);
            return first_parked(other, way, std::min(result.contact, far));
        };
        result.inside_from = inside_from(0);
        result.never_inside = std::isinf(inside_from(1e-9L));
        if (std::isfinite(result.inside_from)) {
            const Path<long double> on{way.at(result.inside_from), way.radius, way.direction};
            result.inside_to =
                result.inside_from + last_parked(fine, on, std::min(result.contact, far) - result.inside_from);
        }
        auto larger = fine;
        larger.body = fine.body.grown(1e-9L), larger.at_curb = fine.at_curb.grown(1e-9L);
        const long double sooner =
            depth(larger, way.start) > 0 ? result.contact : oracle::first_contact(larger, way, far);
        const long double later = oracle::first_contact(fine, way, far, 1e-9L);
        result.grazing = !(later - sooner < 1e-4L) && std::isfinite(sooner);
        return result;
    }
    snug::Contact in_slot(snug::Contact contact) const {
        if (asked.slot.side == snug::Side::right) return contact;
        constexpr std::array<int, 8> swapped = {3, 2, 1, 0, 4, 7, 6, 5};
        contact.part = static_cast<snug::CarPart>(swapped[static_cast<std::size_t>(contact.part)]);
        return contact;
    }
    snug::FirstContact answer() const {
        const double mirror = asked.slot.side == snug::Side::left ? -1.0 : 1.0;
        return snug::first_contact(snug::Car(asked.car), snug::Slot(asked.slot), into_world(asked.slot, place),
                                   direction, mirror * steering, asked.driving);
    }
    std::string text() const {
        std::ostringstream out;
        out.precision(17);
        out << command_line(asked) << "\n    in the slot frame at " << place.x << ", " << place.y << ", heading "
            << place.heading << ", " << snug::to_string(direction) << " steering " << steering << " (left +)";
        return out.str();
    }
};

void choose_move(Random& random, Question& question) {
    const double kind = random.unit();
    const double most = question.asked.car.max_steer;
    question.steering = kind < 0.2 ? 0.0 : kind < 0.6 ? random.between(-most, most) : random.chance(0.5) ? most : -most;
    if (kind > 0.2 && kind < 0.25)
        question.steering = std::copysign(1e-6, question.steering) + 1e-4 * question.steering;
    question.direction = random.chance(0.5) ? snug::Direction::forward : snug::Direction::backward;
}

/// Random cases, made once.
const Case& some_case(int i) {
    static const std::vector<Case> cases = [] {
        std::vector<Case> made;
        const int count = snug::test::sample(200, 200);  // what makes them solves them, which takes its time
        for (int k = 0; k < count; ++k) made.push_back(random_case(31, static_cast<std::uint64_t>(k)));
        return made;
    }();
    return cases[std::size_t(i) % cases.size()];
}

/// A random case with a car anywhere near its slot, free of everything.
std::optional<Question> anywhere(std::uint64_t seed, int i) {
    Question question;
    question.asked = some_case(i);
    Random random(seed * 1000003 + std::uint64_t(i));
    if (question.asked.kind != "exotic" && random.chance(0.3)) question.asked.slot.length += random.between(0, 4);
    const Case& asked = question.asked;
    question.problem = make_problem<double>(asked);
    const double length = asked.slot.length, width = asked.slot.width;
    for (int k = 0; k < 100; ++k) {
        question.place = {random.between(-length - 3, 4), random.between(-width, 4),
                          random.chance(0.5) ? random.between(-0.3, 0.8) : random.between(-3.2, 3.2)};
        if (random.chance(0.5))
            question.place = {random.between(-length, 0), random.between(-width, 0.3), random.between(-0.3, 0.3)};
        if (depth(question.problem, question.place) < -1e-6) {
            choose_move(random, question);
            return question;
        }
    }
    return {};
}

struct Seen {
    int contacts = 0, frees = 0, insides = 0, grazing = 0;
};

/// Compares the answer with the oracle's safe steps.
void compare(const Question& question, Seen& seen) {
    const snug::FirstContact got = question.answer();
    const Path<double> path = question.path();
    const Exact exact = question.exact();
    const double size = 1 + std::abs(question.place.x) + std::abs(question.place.y) + question.asked.car_length();
    const double reach = std::isinf(path.radius) ? 1e3 : std::abs(path.radius) * 7;
    // Where something grazes or the contact is nearly tangent, rounding decides where it is.
    if (exact.grazing) {
        ++seen.grazing;
        return;
    }
    if (std::isfinite(exact.contact)) {
        ++seen.contacts;
        ASSERT_NEAR(got.distance, double(exact.contact), 1e-9 * size + 1e-12 * reach) << question.text();
        ASSERT_TRUE(got.contact) << question.text();
        // Tiny steering angles make the oracle's own arc imprecise in double.
        const double apart = gap_between(question.problem, path.at(got.distance), question.in_slot(*got.contact), true);
        EXPECT_LE(apart, 1e-9 * size + 1e-15 * reach)
            << question.text() << "\n    " << snug::to_string(got.contact->part) << " and "
            << snug::to_string(got.contact->obstacle) << " at " << got.distance;
    } else {
        ++seen.frees;
        ASSERT_TRUE(std::isinf(got.distance)) << question.text() << "\n    touches at " << got.distance;
        EXPECT_FALSE(got.contact) << question.text();
    }
    // A stretch shorter than this may be rounding.
    const long double stretch = exact.inside_to - exact.inside_from;
    if (std::isfinite(exact.inside_from) && stretch > 1e-5) {
        ++seen.insides;
        ASSERT_TRUE(got.inside) << question.text() << "\n    inside from " << exact.inside_from;
        EXPECT_NEAR(got.inside->from, double(exact.inside_from), 1e-7) << question.text();
        if (std::isfinite(exact.contact) || exact.inside_to < std::abs(path.radius) * 6) {
            EXPECT_NEAR(got.inside->to, double(exact.inside_to), 1e-7) << question.text();
        }
    } else if (exact.never_inside) {
        EXPECT_FALSE(got.inside) << question.text() << "\n    never inside";
    }
}

TEST(FirstContact, AgreesWithSafeStepsFromAnywhere) {
    Seen seen;
    const int questions = snug::test::sample(10000, 500000);
    for (int i = 0; i < questions && !HasFailure(); ++i)
        if (const auto question = anywhere(31, i)) compare(*question, seen);
    std::printf("%d contacts, %d never, %d stretches inside, %d grazing left out\n", seen.contacts, seen.frees,
                seen.insides, seen.grazing);
    EXPECT_GT(seen.contacts, questions / 10);
    EXPECT_LT(seen.grazing, questions / 50);
}

TEST(FirstContact, AgreesWithSafeStepsWhenTheCarTouchesAlready) {
    Seen seen;
    int stopped = 0;
    const int questions = snug::test::sample(10000, 500000);
    for (int i = 0; i < questions && !HasFailure(); ++i) {
        auto question = anywhere(32, i);
        if (!question) continue;
        const double first = oracle::first_contact(question->problem, question->path(), question->farthest());
        if (first > 1e3) continue;
        question->place = question->path().at(first);
        Random random(std::uint64_t(i) + 77);
        choose_move(random, *question);
        // Sliding along what it touches, or turning about the point it touches with, is decided by rounding.
        const double just_after = depth(question->problem, question->path().at(1e-6));
        if (std::abs(just_after) < 1e-9) continue;
        compare(*question, seen);
        stopped += just_after > 0;
    }
    std::printf("%d contacts, %d of them at once, %d never, %d stretches inside, %d grazing left out\n", seen.contacts,
                stopped, seen.frees, seen.insides, seen.grazing);
    EXPECT_GT(seen.contacts, questions / 10);
}

TEST(FirstContact, ACornerExactlyOnASlotsCornerStopsTheCarOnlyWhereItWouldMoveIn) {
    int stopped = 0, free = 0;
    for (int i = 0; i < snug::test::sample(20000, 1000000); ++i) {
        auto question = anywhere(34, i);
        if (!question) continue;
        Random random(std::uint64_t(i) + 99);
        if (random.chance(0.5)) question->asked.car.max_steer = random.between(0.5, 1.5);  // turns within its own width
        const Case& asked = question->asked;
        question->place = {0, 0, random.between(-3.2, 3.2)};
        const Vec<double> corner = at(question->problem.body, question->place)[std::size_t(random.below(4))];
        question->place.x = (random.chance(0.5) ? -asked.slot.length : 0.0) - corner.x;
        question->place.y = -corner.y;
        if (depth(question->problem, question->place) > 1e-12) continue;
        choose_move(random, *question);
        if (question->steering != 0 && std::abs(question->steering) < 1e-4) continue;  // rounding: a circle of many km
        const double just_after = depth(question->problem, question->path().at(1e-6));
        if (std::abs(just_after) < 1e-8) continue;  // along an edge
        const double distance = question->answer().distance;
        if (just_after > 0) {
            ++stopped;
            EXPECT_LT(distance, 1e-8) << question->text();
        } else {
            ++free;
            EXPECT_GT(distance, 1e-6) << question->text();
        }
    }
    std::printf("%d stopped, %d moving away\n", stopped, free);
    EXPECT_GT(std::min(stopped, free), snug::test::sample(20000, 1000000) / 50);
}

TEST(FirstContact, AgreesWithTinySteps) {
    int contacts = 0, insides = 0;
    const int questions = snug::test::sample(100, 10000);
    for (int i = 0; i < questions; ++i) {
        const auto question = anywhere(33, i);
        if (!question) continue;
        const Path<double> path = question->path();
        const snug::FirstContact got = question->answer();
        const double step = 2e-4,
                     farthest = std::isinf(path.radius) ? 15.0 : std::min(30.0, 6.283 * std::abs(path.radius));
        const Stepped<double> stepped = step_along(question->problem, path, farthest, step);
        if (got.distance < farthest) {
            // A contact so shallow that no step sees it is no disagreement.
            if (std::isfinite(got.distance) && depth(question->problem, path.at(got.distance + step)) < 1e-7) continue;
            ++contacts;
            EXPECT_NEAR(stepped.contact, got.distance + step / 2, step) << question->text();
        } else {
            EXPECT_TRUE(std::isinf(stepped.contact)) << question->text() << "\n    stepped into " << stepped.contact;
        }
        if (got.inside && got.inside->to - got.inside->from > 3 * step && got.inside->to < farthest) {
            ++insides;
            EXPECT_NEAR(stepped.inside_from, got.inside->from, 1.01 * step) << question->text();
            EXPECT_NEAR(stepped.inside_to, got.inside->to, 1.01 * step) << question->text();
        } else if (!got.inside) {
            EXPECT_TRUE(std::isinf(stepped.inside_from)) << question->text();
        }
    }
    std::printf("%d contacts, %d stretches inside\n", contacts, insides);
}

TEST(FirstContact, AnOverlapIsAContactAtOnce) {
    const int questions = snug::test::sample(5000, 200000);
    int overlapping = 0;
    for (int i = 0; i < questions; ++i) {
        Question question;
        question.asked = some_case(i);
        const Case& asked = question.asked;
        question.problem = make_problem<double>(asked);
        Random random{std::uint64_t(i)};
        question.place = {random.between(-asked.slot.length - 3, 3), random.between(-asked.slot.width - 1, 2),
                          random.between(-3.2, 3.2)};
        choose_move(random, question);
        if (depth(question.problem, question.place) < 1e-7) continue;
        ++overlapping;
        const snug::FirstContact got = question.answer();
        EXPECT_EQ(got.distance, 0.0) << question.text();
        EXPECT_TRUE(got.contact) << question.text();
        EXPECT_FALSE(got.inside && got.inside->to > 0) << question.text();
    }
    EXPECT_GT(overlapping, questions / 4);
}

}  // namespace
}  // namespace oracle
