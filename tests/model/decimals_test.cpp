// Numbers in sentences and in files have a decimal point, whatever the locale.
#include <clocale>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

#include "gtest/gtest.h"
#include "sample.hpp"
#include "sentences/decimals.hpp"

namespace {

/// What a stream writes, by the standard the same.
std::string streamed(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(12);
    text << value;
    return text.str();
}

double any_double(std::mt19937_64& bits) {
    const std::uint64_t number = bits();
    double value = 0.0;
    std::memcpy(&value, &number, sizeof value);
    return value;
}

void check_spelling() {
    std::mt19937_64 bits(17);
    const int count = snug::test::sample(20'000, 2'000'000);
    for (int i = 0; i < count; ++i) {
        const double odd = any_double(bits);
        const double length = static_cast<double>(bits() % 10'000'000) / 1e6;
        EXPECT_EQ(snug::spelled(odd), streamed(odd)) << "seed 17, number " << i;
        EXPECT_EQ(snug::spelled(length), streamed(length)) << "seed 17, number " << i;
        EXPECT_EQ(snug::decimal(streamed(length)), length) << "seed 17, number " << i;
    }
    for (const double special : {0.0, -0.0, 1e22, std::numeric_limits<double>::infinity()})
        EXPECT_EQ(snug::spelled(special), streamed(special));
}

TEST(Decimals, AreSpelledAsByAStream) { check_spelling(); }

TEST(Decimals, DoNotMindTheLocale) {
    // Whichever of them this machine has; one with a decimal comma, one with a longer sign.
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "ps_AF.UTF-8"}) {
        if (std::setlocale(LC_ALL, name) == nullptr) continue;
        check_spelling();
        std::setlocale(LC_ALL, "C");
    }
}

TEST(Decimals, AreNumbersAndNothingElse) {
    for (const char* good : {"1", "-2.5", "+3", ".5", "5.", "1e3", "1E-3", "-0"})
        EXPECT_TRUE(snug::decimal(good)) << good;
    for (const char* bad :
         {"", "-", ".", "e5", "1e", "1.2.3", "1,5", "0x10", "nan", "inf", " 1", "1 ", "1e999", "4.5m"})
        EXPECT_FALSE(snug::decimal(bad)) << bad;
    EXPECT_EQ(snug::decimal("1e-999"), 0.0);
}

}  // namespace
