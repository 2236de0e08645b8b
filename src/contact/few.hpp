// A list that is mostly short: up to so many elements lie in place, and no memory is asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace snug::detail {

/// For plain values; more than `InPlace` of them lie in a vector. What it does not hold yet is not touched, nor copied.
template <class T, std::size_t InPlace>
class Few {
    static_assert(std::is_aggregate_v<T> && std::is_trivially_copyable_v<T>);

public:
    Few() {}  // a default one would clear all its bytes where it is made by {}; NOLINT(modernize-use-equals-default)
    Few(const Few& other) : size_(other.size_), many_(other.many_) {
        place();
        copy_own(other);
    }
    Few& operator=(const Few& other) {
        if (this == &other) return *this;
        size_ = other.size_;
        many_ = other.many_;
        place();
        copy_own(other);
        return *this;
    }
    ~Few() = default;

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T* data() { return data_; }
    [[nodiscard]] const T* data() const { return data_; }
    [[nodiscard]] T* begin() { return data(); }
    [[nodiscard]] T* end() { return data() + size_; }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }

    void push_back(const T& element) {
        if (size_ < InPlace) {
            own()[size_++] = element;
            return;
        }
        if (size_ == InPlace) many_.assign(own(), own() + InPlace);
        many_.push_back(element);
        ++size_;
        place();
    }
    /// New elements are to be set.
    void resize(std::size_t size) {
        if (size > InPlace) {
            if (size_ <= InPlace) many_.assign(own(), own() + size_);
            many_.resize(size);
        } else if (size_ > InPlace) {
            std::copy_n(many_.data(), size, own());
        }
        size_ = size;
        place();
    }

private:
    [[nodiscard]] T* own() { return reinterpret_cast<T*>(bytes_.data()); }
    [[nodiscard]] const T* own() const { return reinterpret_cast<const T*>(bytes_.data()); }
    void place() { data_ = size_ <= InPlace ? own() : many_.data(); }
    void copy_own(const Few& other) {
        if (size_ <= InPlace) std::copy_n(other.own(), size_, own());
    }

    alignas(T) std::array<std::byte, InPlace * sizeof(T)> bytes_;
    std::size_t size_ = 0;
    T* data_ = own();  ///< where they are
    std::vector<T> many_;
};

}  // namespace snug::detail
