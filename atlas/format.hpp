// The exported atlas file, version 2: its parts as they lie in it. docs/atlas-format.md tells the same to people.
//
//     Head, CarEntry[cars], names, corners, widths, lengths | blocks | IndexEntry[blocks] | Trailer
//
// A block holds some successive cells: first their records, all of one size so that one is found without looking for it,
// then their bodies, whose size the record tells. Every part begins at a multiple of 8 bytes, numbers are little-endian,
// and checksums cover each byte of the file.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

#include "snug/maneuver.hpp"

namespace snug::atlas_format {

static_assert(std::endian::native == std::endian::little, "numbers in the file are taken as they are in memory");

constexpr std::string_view begin_mark = "snug-atl";
constexpr std::string_view end_mark = "snug-end";
constexpr std::uint32_t version = 2;  // 1 knew rectangles only
constexpr std::uint64_t most_cells = std::uint64_t{1} << 40;

struct Head {
    std::array<char, 8> mark;
    std::uint32_t version;
    std::uint32_t cars;
    std::uint32_t widths;
    std::uint32_t lengths;
    std::uint32_t cells_per_block;
    std::uint32_t strategy;    // 0 max-steer, 1 fewest
    std::int32_t max_changes;  // -1 none given
    std::uint32_t enter;       // 0 backward, 1 forward
    double resolution;
    double min_range;
    double clearance;
    std::array<char, 32> made_by;
    std::uint64_t name_bytes;
    std::uint64_t corners;  // of all outlines
};
static_assert(sizeof(Head) == 112);

struct CarEntry {
    double width;
    double front;
    double rear;
    double wheelbase;
    double max_steer;
    std::uint32_t name_at;  // among the names
    std::uint32_t name_bytes;
    std::uint32_t corners_at;  // among the corners
    std::uint32_t corners;     // of the outline; 0 for a rectangle
};
static_assert(sizeof(CarEntry) == 56);

/// A corner of an outline.
struct Corner {
    double x;
    double y;
};
static_assert(sizeof(Corner) == 16);

/// A cell's answer in short.
struct Record {
    std::int32_t direction_changes;  // -1 none
    std::int32_t lower_bound;
    std::uint32_t ranges;
    std::uint32_t moves;
    std::uint32_t flags;
    std::uint32_t body_at;  // from the block's begin
};
static_assert(sizeof(Record) == 24);
constexpr std::uint32_t proved = 1;
constexpr std::uint32_t angles_stored = 2;

struct RangeEntry {
    double min;
    double max;
    std::int32_t direction_changes;
    std::int32_t subrange;
};
static_assert(sizeof(RangeEntry) == 24);

struct IndexEntry {
    std::uint64_t block_at;
    std::uint64_t checksum;
};
static_assert(sizeof(IndexEntry) == 16);

struct Trailer {
    std::uint64_t index_at;
    std::uint64_t file_bytes;
    std::uint64_t front_checksum;
    std::uint64_t index_checksum;
    std::uint64_t trailer_checksum;  // of the four above
    std::array<char, 8> mark;
};
static_assert(sizeof(Trailer) == 48);

/// What is stored at some byte, aligned or not.
template <class T>
T load(const std::byte* from) noexcept {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 7) / 8 * 8; }

/// Grows with the atlas, so that the index stays within a megabyte and opening takes the same time for any size.
constexpr std::uint32_t cells_per_block(std::uint64_t cells) {
    std::uint32_t per_block = 64;
    while ((cells + per_block - 1) / per_block > 65536) per_block *= 2;
    return per_block;
}

/// A body: the entry pose if there are moves, the ranges, the moves' lengths, their steering angles if some are stored, and
/// their codes. This is where they begin and where it ends.
struct BodyParts {
    std::uint64_t ranges;
    std::uint64_t lengths;
    std::uint64_t angles;
    std::uint64_t codes;
    std::uint64_t end;
};
constexpr BodyParts body_parts(std::uint64_t ranges, std::uint64_t moves, bool with_angles) {
    BodyParts parts{};
    parts.ranges = moves > 0 ? 3 * sizeof(double) : 0;
    parts.lengths = parts.ranges + ranges * sizeof(RangeEntry);
    parts.angles = parts.lengths + moves * sizeof(double);
    parts.codes = parts.angles + (with_angles ? moves * sizeof(double) : 0);
    parts.end = parts.codes + padded(moves);
    return parts;
}

/// A move's code: what ends it in bits 0 to 5, its steering in bits 6 and 7.
enum class Steering : std::uint8_t { full_right, straight, full_left, stored };
constexpr std::uint8_t obstacles = 5;
constexpr std::uint8_t most_contact = 1 + 11 * obstacles + 4;
constexpr std::uint8_t contact_bits = 63;

/// A checksum of whole words: four chains side by side, because one would wait for its multiplications. Each step can be
/// undone, so different words never lead to the same sum as long as they lie in one chain: a change within one word is
/// always seen, any other with all but one chance in 2^64 if it happens by accident.
inline std::uint64_t checksum(std::span<const std::byte> bytes) noexcept {
    const auto step = [](std::uint64_t sum, std::uint64_t word) {
        sum = (sum ^ word) * 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio, odd
        return sum ^ (sum >> 32);
    };
    std::uint64_t lanes[4] = {1, 2, 3, 4};
    const std::byte* at = bytes.data();
    std::size_t words = bytes.size() / 8;
    for (; words >= 4; words -= 4, at += 32)
        for (std::size_t lane = 0; lane < 4; ++lane)
            lanes[lane] = step(lanes[lane], load<std::uint64_t>(at + 8 * lane));
    for (std::size_t lane = 0; lane < words; ++lane)
        lanes[lane] = step(lanes[lane], load<std::uint64_t>(at + 8 * lane));
    std::uint64_t sum = bytes.size();
    for (const std::uint64_t lane : lanes) sum = step(sum, lane);
    return sum;
}

}  // namespace snug::atlas_format
