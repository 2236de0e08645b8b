// Numbers and lists of them as bytes and back, for a thread of the same program that shares no memory with this one.
//
// What is no plain number or list has a static pack(self, pack) that calls pack(...) with all its parts.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "snug/error.hpp"

namespace snug::detail {

class Packing {
public:
    explicit Packing(std::size_t about) { bytes.reserve(about); }

    template <class... Parts>
    void operator()(const Parts&... parts) {
        (one(parts), ...);
    }
    std::vector<std::byte> bytes;

private:
    void add(const void* from, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), first, first + size);
    }
    template <class Part>
    void one(const Part& part) {
        if constexpr (std::is_trivially_copyable_v<Part>)
            add(&part, sizeof part);
        else
            Part::pack(part, *this);
    }
    template <class Part>
    void one(const std::vector<Part>& list) {
        const std::size_t count = list.size();
        add(&count, sizeof count);
        if constexpr (std::is_trivially_copyable_v<Part>)
            add(list.data(), count * sizeof(Part));
        else
            for (const Part& part : list) one(part);
    }
};

/// Throws Error where there is less than is asked for.
class Unpacking {
public:
    explicit Unpacking(std::span<const std::byte> from) : next_(from.data()), left_(from.size()) {}

    template <class... Parts>
    void operator()(Parts&... parts) {
        (one(parts), ...);
    }
    [[nodiscard]] std::size_t left() const { return left_; }

private:
    void take(void* to, std::size_t size) {
        if (size > left_) throw Error("the packed map ends too soon; pack it again");
        if (size == 0) return;
        std::memcpy(to, next_, size);
        next_ += size;
        left_ -= size;
    }
    template <class Part>
    void one(Part& part) {
        if constexpr (std::is_trivially_copyable_v<Part>)
            take(&part, sizeof part);
        else
            Part::pack(part, *this);
    }
    template <class Part>
    void one(std::vector<Part>& list) {
        std::size_t count = 0;
        take(&count, sizeof count);
        // Every part takes a byte at least.
        if (count > left_ / (std::is_trivially_copyable_v<Part> ? sizeof(Part) : 1))
            throw Error("the packed map ends too soon; pack it again");
        list.resize(count);
        if constexpr (std::is_trivially_copyable_v<Part>)
            take(list.data(), count * sizeof(Part));
        else
            for (Part& part : list) one(part);
    }

    const std::byte* next_;
    std::size_t left_;
};

}  // namespace snug::detail
