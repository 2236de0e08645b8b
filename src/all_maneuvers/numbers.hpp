// Long rows of numbers in memory that one question uses again and again.
//
// A question has a hundred lattices, one after the other. Fresh memory is slow, because the system clears it page by page
// when it is first touched, and memory given back to the system is fresh the next time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace snug::detail {

/// Memory in few pieces, cut up for rows of numbers. Very long rows come from the system one by one, so that what is not in
/// use adds little to what a question takes at most.
class NumberStore {
public:
    /// So many numbers, not set.
    double* take(std::size_t count);
    /// Takes back what was taken, with the same count.
    void give_back(double* numbers, std::size_t count) noexcept;

private:
    struct Piece {
        std::unique_ptr<double[]> numbers;
        std::size_t count;
    };
    struct Gap {
        double* begin;
        std::size_t count;
    };
    [[nodiscard]] bool begins_piece(const double* numbers) const;
    void add_gap(const Gap& gap);
    void drop_unused_pieces();

    std::vector<Piece> pieces_;
    std::vector<Gap> gaps_;  // by address
    std::size_t total_ = 0;  ///< of the pieces
    std::size_t taken_ = 0;  ///< rows from them
};

/// A row of numbers.
class Numbers {
public:
    Numbers() = default;
    /// Not set.
    Numbers(std::shared_ptr<NumberStore> store, std::size_t count);
    Numbers(const Numbers& other);
    Numbers(Numbers&& other) noexcept;
    Numbers& operator=(Numbers other) noexcept;
    ~Numbers();

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    double& operator[](std::size_t i) { return numbers_[i]; }
    const double& operator[](std::size_t i) const { return numbers_[i]; }
    [[nodiscard]] double* begin() { return numbers_; }
    [[nodiscard]] const double* begin() const { return numbers_; }
    [[nodiscard]] const double* end() const { return numbers_ + count_; }

private:
    std::shared_ptr<NumberStore> store_;
    double* numbers_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace snug::detail
