// Files that are no atlas, or no longer one: refused with a reason, or found damaged where they are used; never a crash.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "atlas/format.hpp"
#include "cli/process.hpp"
#include "model/refusals.hpp"
#include "random_atlas.hpp"
#include "reseal.hpp"
#include "sample.hpp"

namespace snug {
namespace {

using namespace test;
using namespace atlas_format;
using model::refusal;

/// Bytes that end where their memory ends, so that the address sanitizer sees who reads on.
class Exact {
public:
    explicit Exact(const std::string& bytes) : size_(bytes.size()), memory_(new std::byte[size_]) {
        std::memcpy(memory_.get(), bytes.data(), size_);
    }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {memory_.get(), size_}; }

private:
    std::size_t size_;
    std::unique_ptr<std::byte[]> memory_;
};

/// Not opened, or a block of it is not whole.
bool detected(const std::string& bytes) {
    const Exact exact(bytes);
    try {
        const Atlas atlas(exact.bytes());
        for (std::size_t block = 0; block < atlas.blocks(); ++block)
            if (!atlas.block_is_whole(block)) return true;
        return false;
    } catch (const Error&) {
        return true;
    }
}

WrittenAtlas small_atlas(std::uint64_t seed) {
    Random random(seed);
    WrittenAtlas atlas;
    do {
        atlas = random_atlas(random, 3, 4, 20);
    } while (atlas.answers.size() < 70 || atlas.answers.size() > 140);  // two or three blocks
    return atlas;
}

TEST(DamagedAtlas, CutShortAnywhereItIsRefused) {
    const std::string whole = small_atlas(1).bytes;
    ASSERT_FALSE(detected(whole));
    for (std::size_t left = 0; left < whole.size(); ++left) {
        const Exact cut(whole.substr(0, left));
        const std::string why = refusal([&] { Atlas{cut.bytes()}; });
        EXPECT_NE(why, "") << left << " bytes left";
        if (left == 0) continue;
        ASSERT_NE(why.find("ends after " + std::to_string(left) + " bytes, "), std::string::npos) << why;
    }
    EXPECT_TRUE(detected(whole + '\0'));
    EXPECT_TRUE(detected(whole + whole));
}

TEST(DamagedAtlas, EveryBitIsGuarded) {
    std::string bytes = small_atlas(2).bytes;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            const char right = bytes[at];
            bytes[at] = static_cast<char>(right ^ (1 << bit));
            ASSERT_TRUE(detected(bytes)) << "byte " << at << " bit " << bit;
            bytes[at] = right;
        }
    }
}

TEST(DamagedAtlas, AnyDamageIsSeen) {
    const std::string whole = small_atlas(3).bytes;
    for (int i = 0; i < sample(20000, 1000000); ++i) {
        Random random(static_cast<std::uint64_t>(i));
        std::string bytes = whole;
        const auto somewhere = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(bytes.size()))); };
        const std::size_t from = somewhere();
        const std::size_t count = std::min(bytes.size() - from, std::size_t{1} << random.below(12));
        switch (random.below(5)) {
            case 0:  // noise
                for (std::size_t k = 0; k < count; ++k) bytes[from + k] = static_cast<char>(random.below(256));
                break;
            case 1: std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(from), count, '\0'); break;
            case 2: bytes.erase(from, count); break;
            case 3: bytes.insert(somewhere(), bytes.substr(from, count)); break;
            default:  // a stretch of it elsewhere, as when pages are mixed up
                bytes.replace(std::min(somewhere() / 8 * 8, bytes.size() - count), count, bytes.substr(from, count));
        }
        if (bytes == whole) continue;
        ASSERT_TRUE(detected(bytes)) << "case " << i;
    }
}

TEST(DamagedAtlas, OnlyTheAnswersOfADamagedBlockAreLost) {
    const WrittenAtlas written = small_atlas(4);
    const Atlas whole(as_bytes(written.bytes));
    ASSERT_GE(whole.blocks(), 2U);
    const Trailer trailer = load<Trailer>(as_bytes(written.bytes).last(sizeof(Trailer)).data());
    std::string bytes = written.bytes;
    bytes[trailer.index_at - 1] = static_cast<char>(bytes[trailer.index_at - 1] ^ 1);  // in the last block
    const Atlas atlas(as_bytes(bytes));
    for (std::size_t at = 0; at < written.answers.size(); ++at) {
        const std::size_t l = at % atlas.lengths();
        const std::size_t w = at / atlas.lengths() % atlas.widths();
        const std::size_t c = at / atlas.lengths() / atlas.widths();
        const bool lost = at / 64 == atlas.blocks() - 1;
        const std::optional<AtlasCell> cell = atlas.cell(c, w, l);
        ASSERT_EQ(cell.has_value(), !lost) << at;
        ASSERT_EQ(atlas.look_up(c, atlas.length(l), atlas.width(w)).verdict == AtlasVerdict::damaged, lost) << at;
        if (!cell) continue;
        ASSERT_EQ(told(stored_in(*cell)), told(written.answers[at]));
    }
}

/// Reads all there is to read, but for the cells of enormous atlases, of which it reads some.
double read_all(const Atlas& atlas, Random& random) {
    double sum = static_cast<double>(atlas.made_by().size());
    const auto some = [&](std::size_t count) {
        return static_cast<std::size_t>(random.unit() * static_cast<double>(count));
    };
    const auto read_cell = [&](const AtlasCell& cell, std::size_t c) {
        const CellAnswer answer = stored_in(cell);
        for (const HeadingRange& range : answer.ranges) sum += range.min;
        try {
            const Maneuver driven = maneuver(cell, atlas.car(c), Slot({.length = 5, .width = 2, .side = Side::left}));
            if (!driven.moves.empty()) sum += driven.goal().x;
            for (const Move& move : driven.moves)
                if (move.contact) sum += static_cast<double>(to_string(move.contact->part).size());
        } catch (const Error&) {  // no such car can exist
        }
    };
    for (std::size_t i = 0; i < std::min<std::size_t>(atlas.cars(), 100); ++i) {
        const std::size_t c = some(atlas.cars());
        if (const auto found = atlas.find_car(atlas.car_name(c))) sum += static_cast<double>(*found);
    }
    for (int i = 0; i < 200; ++i) {
        const std::size_t c = some(atlas.cars() + 1);
        const AtlasAnswer answer = atlas.look_up(c, random.between(0.9, 6.1), random.between(0.9, 6.1));
        if (answer.verdict != AtlasVerdict::no_such_car) read_cell(answer.cell, c);
        const std::size_t car = some(atlas.cars());
        if (const auto cell = atlas.cell(car, some(atlas.widths()), some(atlas.lengths()))) read_cell(*cell, car);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(atlas.blocks(), 100); ++i)
        sum += atlas.block_is_whole(some(atlas.blocks())) ? 1.0 : 0.0;
    return sum;
}

TEST(HostileAtlas, WithRightChecksumsReadsNothingOutside) {
    int opened = 0;
    int damaged = 0;
    const int cases = sample(20000, 1000000);
    std::string whole;
    double sum = 0.0;
    for (int i = 0; i < cases; ++i) {
        Random random(static_cast<std::uint64_t>(i));
        if (i % 100 == 0) whole = small_atlas(static_cast<std::uint64_t>(i)).bytes;
        std::string bytes = whole;
        const auto index_at =
            static_cast<std::size_t>(load<Trailer>(as_bytes(bytes).last(sizeof(Trailer)).data()).index_at);
        for (int k = random.below(4); k >= 0; --k) {
            // Head, blocks, or the end: each as likely, since there are so few bytes in the first and the last.
            const std::size_t from = random.chance(0.4) ? 8 : random.chance(0.7) ? 112 : index_at;
            const std::size_t to = from == 8 ? 112 : from == 112 ? index_at : bytes.size();
            const std::size_t at =
                from + static_cast<std::size_t>(random.unit() * static_cast<double>(to - from)) / 4 * 4;
            const std::uint32_t old = load<std::uint32_t>(as_bytes(bytes).data() + std::min(at, bytes.size() - 4));
            const std::uint32_t values[] = {0,        1,          2,           8,       old + 1,
                                            old - 1,  old + 8,    old - 8,     old * 2, 0x7fffffff,
                                            1U << 31, 0xffffffff, 0xfffffff8U, 64,      1U << random.below(32)};
            const std::uint32_t value = random.chance(0.3) ? old ^ (1U << random.below(32)) : values[random.below(15)];
            std::memcpy(bytes.data() + std::min(at, bytes.size() - 4), &value, 4);
        }
        reseal(bytes);
        const Exact exact(bytes);
        std::unique_ptr<Atlas> atlas;
        ASSERT_NO_THROW(try { atlas = std::make_unique<Atlas>(exact.bytes()); } catch (const Error&){}) << "case " << i;
        if (!atlas) continue;
        ++opened;
        sum += read_all(*atlas, random);
        for (std::size_t block = 0; block < std::min<std::size_t>(atlas->blocks(), 10); ++block)
            damaged += atlas->block_is_whole(block) ? 0 : 1;
    }
    EXPECT_GT(opened, cases / 5);
    EXPECT_GT(damaged, cases / 20);
    EXPECT_NE(sum, 1.0);  // so that it is computed
}

TEST(HostileAtlas, IsToldWhatIsImpossible) {
    AtlasPlan plan = {{*find_car("mid-size"), *find_car("renault-zoe")}, {2.0, 2.1}, {5.0, 5.1, 5.2}, {}};
    CellAnswer one_move;
    one_move.direction_changes = 0;
    one_move.moves.push_back({Direction::backward, plan.cars[0].max_steer(), 1.0, {}});
    const std::string whole = written(plan, std::vector<CellAnswer>(12, one_move));
    const Trailer trailer = load<Trailer>(as_bytes(whole).last(sizeof(Trailer)).data());
    const std::uint64_t first_car = sizeof(Head);
    const std::uint64_t widths =
        first_car + 2 * sizeof(CarEntry) + padded(std::string_view("mid-sizerenault-zoe").size());
    const std::uint64_t blocks = widths + 5 * sizeof(double);
    ASSERT_EQ(load<double>(as_bytes(whole).data() + widths), 2.0);
    const auto with = [&](std::uint64_t at, const auto& value) {
        std::string bytes = whole;
        std::memcpy(bytes.data() + at, &value, sizeof(value));
        reseal(bytes);
        return bytes;
    };
    const auto said = [&](std::uint64_t at, const auto& value) {
        const Exact exact(with(at, value));
        return refusal([&] { Atlas{exact.bytes()}; });
    };
    const auto has = [](const std::string& sentence, const std::string& words) {
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    };
    constexpr std::uint32_t huge = 0xffffffff;
    EXPECT_FALSE(detected(with(0, 's')));
    has(said(offsetof(Head, lengths), huge), "its first part is damaged");
    has(said(offsetof(Head, cars), 0U), "its first part is damaged");
    has(said(offsetof(Head, cells_per_block), 3U), "its first part is damaged");
    has(said(offsetof(Head, cells_per_block), 1U), "its first part is damaged");
    has(said(offsetof(Head, strategy), 2U), "holds impossible options");
    has(said(offsetof(Head, clearance), -1.0), "holds impossible options");
    has(said(first_car + offsetof(CarEntry, name_bytes), huge), "has a car without its name");
    has(said(first_car + offsetof(CarEntry, name_at), 12U), "has a car without its name");
    has(said(first_car + sizeof(CarEntry) + offsetof(CarEntry, name_at), 3U), "its cars are not in order");
    has(said(widths, 2.2), "its widths do not rise");
    has(said(widths + 3 * sizeof(double), std::numeric_limits<double>::quiet_NaN()), "its lengths do not rise");

    const auto lost = [&](std::uint64_t at, const auto& value) { return detected(with(at, value)); };
    const std::uint64_t first_body = blocks + 12 * sizeof(Record);
    const std::uint64_t first_code = first_body + body_parts(0, 1, false).codes;
    EXPECT_TRUE(lost(blocks + offsetof(Record, direction_changes), -1)) << "moves without their count";
    EXPECT_TRUE(lost(blocks + offsetof(Record, moves), huge));
    EXPECT_TRUE(lost(blocks + offsetof(Record, ranges), huge));
    EXPECT_TRUE(lost(blocks + offsetof(Record, body_at), huge));
    EXPECT_TRUE(lost(first_code, std::uint8_t{61})) << "no such contact";
    EXPECT_FALSE(lost(first_code, std::uint8_t{60}));
    EXPECT_TRUE(lost(first_code, std::uint8_t{3 << 6})) << "a stored angle where none is";
    EXPECT_TRUE(lost(trailer.index_at, std::uint64_t{0})) << "a block in the front part";
    EXPECT_TRUE(lost(trailer.index_at, trailer.file_bytes)) << "a block behind the file";
}

TEST(ForeignFile, IsRefusedWithAReason) {
    const Folder folder;
    const std::string whole = small_atlas(5).bytes;
    const auto said = [](const std::string& path) { return refusal([&] { Atlas{path}; }); };
    const auto has = [](const std::string& sentence, const std::string& words) {
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    };
    EXPECT_EQ(said(folder.with("whole", whole)), "");
    has(said(folder.file("none")), "none\": cannot be read: No such file or directory; give a file that");
    has(said(""), "cannot be read: No such file");
    has(said(folder.file("")), "is a folder");
    has(said(folder.with("empty", "")), "is empty");
    has(said(folder.with("fleet.sqlite", std::string("SQLite format 3\0", 16) + std::string(4080, '\0'))),
        "is the database, not an exported atlas; use `snug atlas export`");
    has(said(folder.with("text", "car,width,length\n")), "is no atlas");
    has(said(folder.with("byte", "x")), "is no atlas");
    has(said(folder.with("zeros", std::string(10000, '\0'))), "is no atlas");
    has(said(folder.with("cut", whole.substr(0, 1000))), "ends after 1000 bytes, but not as an atlas ends");
    has(said(folder.with("begin", whole.substr(0, 5))), "ends after 5 bytes, too few");
    std::string newer = whole;
    newer[8] = 3;
    has(said(folder.with("newer", newer)), "has format version 3, but snug");
    std::string older = whole;
    older[8] = 1;
    has(said(folder.with("older", older)), "has format version 1, but snug");
    has(said(folder.with("older", older)), "export it again");
    ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
    has(said(folder.file("pipe")), "is no regular file");
    has(said("/dev/zero"), "is no regular file");
    if (geteuid() != 0) {
        ASSERT_EQ(chmod(folder.file("whole").c_str(), 0), 0);
        has(said(folder.file("whole")), "cannot be read: Permission denied");
    }
}

}  // namespace
}  // namespace snug
