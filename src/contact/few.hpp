// A list that is mostly short: up to so many elements lie in place, and no memory is asked for.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace snug::detail {

/// For plain values; more than `InPlace` of them lie in a vector.
template <class T, std::size_t InPlace>
class Few {
public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T* data() { return size_ <= InPlace ? own_.data() : many_.data(); }
    [[nodiscard]] const T* data() const { return size_ <= InPlace ? own_.data() : many_.data(); }
    [[nodiscard]] T* begin() { return data(); }
    [[nodiscard]] T* end() { return data() + size_; }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }

    void push_back(const T& element) {
        if (size_ < InPlace) {
            own_[size_++] = element;
            return;
        }
        if (size_ == InPlace) many_.assign(own_.begin(), own_.end());
        many_.push_back(element);
        ++size_;
    }
    void resize(std::size_t size) {
        if (size > InPlace) {
            if (size_ <= InPlace) many_.assign(own_.begin(), own_.begin() + static_cast<std::ptrdiff_t>(size_));
            many_.resize(size);
        } else if (size_ > InPlace) {
            for (std::size_t i = 0; i < size; ++i) own_[i] = many_[i];
        }
        size_ = size;
    }

private:
    std::array<T, InPlace> own_;
    std::size_t size_ = 0;
    std::vector<T> many_;
};

}  // namespace snug::detail
