// Long rows of numbers in memory that one question uses again and again.
//
// A question has a hundred lattices, one after the other. Fresh memory is slow, because the system clears it page by page
// when it is first touched, and memory given back to the system is fresh the next time.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
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

    std::mutex mutex_;
    std::vector<Piece> pieces_;
    std::vector<Gap> gaps_;  // by address
    std::size_t total_ = 0;  ///< of the pieces
    std::size_t taken_ = 0;  ///< rows from them
};

/// Allocates from a store; without one, from the system. What is not given a value is not set.
template <class T>
class FromStore {
public:
    using value_type = T;
    using propagate_on_container_copy_assignment = std::true_type;
    using propagate_on_container_move_assignment = std::true_type;
    using propagate_on_container_swap = std::true_type;

    FromStore() = default;
    FromStore(std::shared_ptr<NumberStore> store) : store_(std::move(store)) {}  // NOLINT(google-explicit-constructor)
    template <class U>
    FromStore(const FromStore<U>& other) : store_(other.store()) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] const std::shared_ptr<NumberStore>& store() const { return store_; }
    T* allocate(std::size_t count) {
        return static_cast<T*>(store_ ? store_->take(count * sizeof(T)) : ::operator new(count * sizeof(T)));
    }
    void deallocate(T* numbers, std::size_t count) noexcept {
        if (store_) {
            store_->give_back(numbers, count * sizeof(T));
        } else {
            ::operator delete(numbers);
        }
    }
    template <class U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Args>
    void construct(U* at, Args&&... args) {
        ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
    }
    friend bool operator==(const FromStore& one, const FromStore& other) { return one.store_ == other.store_; }

private:
    std::shared_ptr<NumberStore> store_;
};

/// A row of them.
template <class T>
using Numbers = std::vector<T, FromStore<T>>;

}  // namespace snug::detail
