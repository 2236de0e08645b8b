// Long rows of numbers in memory that one question uses again and again.
//
// A question has a hundred lattices, one after the other. Fresh memory is slow, because the system clears it page by page
// when it is first touched, and memory given back to the system is fresh the next time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace snug::detail {

/// Memory in few pieces, cut up for rows of numbers. Very long rows come from the system one by one, so that what is not in
/// use adds little to what a question takes at most. Threads may share it.
class NumberStore {
public:
    /// So many bytes, not set.
    void* take(std::size_t bytes);
    /// Takes back what was taken, with the same count.
    void give_back(void* numbers, std::size_t bytes) noexcept;

private:
    struct Piece {
        std::unique_ptr<std::byte[]> begin;
        std::size_t bytes;
    };
    struct Gap {
        std::byte* begin;
        std::size_t bytes;
    };
    [[nodiscard]] bool begins_piece(const std::byte* place) const;
    void add_gap(const Gap& gap);
    void drop_unused_pieces();
    [[nodiscard]] std::byte* cut_off(std::size_t bytes);

#ifdef __EMSCRIPTEN__  // has no threads, and std::mutex is long
    struct Mutex {
        void lock() {}
        void unlock() {}
    };
#else
    using Mutex = std::mutex;
#endif

    Mutex mutex_;
    std::vector<Piece> pieces_;
    std::vector<Gap> gaps_;  // by address
    std::size_t total_ = 0;  ///< of the pieces
    std::size_t taken_ = 0;  ///< rows from them
};

std::shared_ptr<NumberStore> new_store();

/// Bytes from a store; without one, from the system.
class Bytes {
public:
    Bytes() = default;
    explicit Bytes(std::shared_ptr<NumberStore> store) : store_(std::move(store)) {}
    Bytes(const Bytes& other);
    Bytes(Bytes&& other) noexcept;
    Bytes& operator=(Bytes other) noexcept;
    ~Bytes();

    [[nodiscard]] void* begin() const { return begin_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t room() const { return room_; }
    /// New ones are not set.
    void resize(std::size_t count) {
        if (count > room_) make_room(count > 2 * room_ ? count : 2 * room_);
        count_ = count;
    }
    /// For at least so many.
    void make_room(std::size_t room);

private:
    std::shared_ptr<NumberStore> store_;
    void* begin_ = nullptr;
    std::size_t count_ = 0, room_ = 0;
};

/// A row of numbers, or of what else is copied byte by byte; what is not given a value is not set.
template <class T>
class Numbers {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    Numbers() = default;
    explicit Numbers(std::shared_ptr<NumberStore> store, std::size_t count = 0) : bytes_(std::move(store)) {
        resize(count);
    }

    [[nodiscard]] std::size_t size() const { return bytes_.count() / sizeof(T); }
    [[nodiscard]] bool empty() const { return bytes_.count() == 0; }
    [[nodiscard]] std::size_t capacity() const { return bytes_.room() / sizeof(T); }
    [[nodiscard]] T* data() { return static_cast<T*>(bytes_.begin()); }
    [[nodiscard]] const T* data() const { return static_cast<const T*>(bytes_.begin()); }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    [[nodiscard]] T* begin() { return data(); }
    [[nodiscard]] T* end() { return data() + size(); }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + size(); }

    void reserve(std::size_t count) { bytes_.make_room(count * sizeof(T)); }
    void resize(std::size_t count) { bytes_.resize(count * sizeof(T)); }
    void resize(std::size_t count, const T& value) {
        const std::size_t before = size();
        resize(count);
        if (count > before) std::fill(data() + before, data() + count, value);
    }
    void push_back(const T& value) {
        const T copy = value;
        resize(size() + 1);
        end()[-1] = copy;
    }
    /// What there is more room for is given back.
    void shrink_to_fit() {
        if (bytes_.room() > bytes_.count()) bytes_ = Bytes(bytes_);
    }

private:
    Bytes bytes_;
};

}  // namespace snug::detail
