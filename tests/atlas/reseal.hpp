// What a damaged atlas needs to be believed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "../../atlas/format.hpp"

namespace snug::test {

/// Makes all checksums right again, as somebody would who wants to be believed.
inline void reseal(std::string& bytes) {
    using namespace atlas_format;
    const auto all = [&] { return std::as_bytes(std::span(bytes)); };
    const auto put = [&](std::uint64_t at, const auto& value) {
        std::memcpy(bytes.data() + at, &value, sizeof(value));
    };
    const std::uint64_t trailer_at = bytes.size() - sizeof(Trailer);
    const Head head = load<Head>(all().data());
    Trailer trailer = load<Trailer>(all().data() + trailer_at);
    const std::uint64_t index_at = std::min<std::uint64_t>(trailer.index_at, trailer_at);
    for (std::uint64_t at = index_at; at + sizeof(IndexEntry) <= trailer_at; at += sizeof(IndexEntry)) {
        IndexEntry entry = load<IndexEntry>(all().data() + at);
        std::uint64_t end = index_at;
        if (at + 2 * sizeof(IndexEntry) <= trailer_at)
            end = load<IndexEntry>(all().data() + at + sizeof(IndexEntry)).block_at;
        if (entry.block_at > end || end > bytes.size()) continue;
        entry.checksum = checksum(all().subspan(entry.block_at, end - entry.block_at));
        put(at, entry);
    }
    const std::uint64_t front = sizeof(Head) + head.cars * std::uint64_t{sizeof(CarEntry)} +
                                padded(std::min<std::uint64_t>(head.name_bytes, bytes.size())) +
                                std::min<std::uint64_t>(head.corners, bytes.size()) * sizeof(Corner) +
                                (std::uint64_t{head.widths} + head.lengths) * sizeof(double);
    if (front <= bytes.size()) trailer.front_checksum = checksum(all().first(front));
    trailer.index_checksum = checksum(all().subspan(index_at, trailer_at - index_at));
    put(trailer_at, trailer);
    trailer.trailer_checksum = checksum(all().subspan(trailer_at, offsetof(Trailer, trailer_checksum)));
    put(trailer_at, trailer);
}

}  // namespace snug::test
