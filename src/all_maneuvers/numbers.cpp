#include "all_maneuvers/numbers.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace snug::detail {

namespace {

constexpr std::size_t first_piece = std::size_t{1} << 17;    // 1 MB
constexpr std::size_t longest_piece = std::size_t{3} << 20;  // 24 MB; longer rows are on their own

/// Whole cache lines.
std::size_t whole(std::size_t count) { return (count + 7) / 8 * 8; }

}  // namespace

bool NumberStore::begins_piece(const double* numbers) const {
    return std::any_of(pieces_.begin(), pieces_.end(),
                       [&](const Piece& piece) { return piece.numbers.get() == numbers; });
}

void NumberStore::drop_unused_pieces() {
    const auto unused = [&](const Piece& piece) {
        const auto gap =
            std::find_if(gaps_.begin(), gaps_.end(), [&](const Gap& one) { return one.begin == piece.numbers.get(); });
        if (gap == gaps_.end() || gap->count != piece.count) return false;
        total_ -= piece.count;
        gaps_.erase(gap);
        return true;
    };
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), unused), pieces_.end());
}

double* NumberStore::take(std::size_t count) {
    if (count > longest_piece) {
        drop_unused_pieces();
        return new double[count];
    }
    count = whole(count);
    gaps_.reserve(taken_ + pieces_.size() + 2);  // there will be no more, so that giving back never fails
    // The smallest gap that will do: it was probably used before.
    auto best = gaps_.end();
    for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap)
        if (gap->count >= count && (best == gaps_.end() || gap->count < best->count)) best = gap;
    if (best == gaps_.end()) {
        const std::size_t size = std::max(count, std::clamp(3 * total_, first_piece, longest_piece));
        pieces_.push_back({std::unique_ptr<double[]>(new double[size]), size});
        total_ += size;
        add_gap({pieces_.back().numbers.get(), size});
        return take(count);
    }
    ++taken_;
    double* const taken = best->begin;
    *best = {taken + count, best->count - count};
    if (best->count == 0) gaps_.erase(best);
    return taken;
}

void NumberStore::give_back(double* numbers, std::size_t count) noexcept {
    if (count > longest_piece) {
        delete[] numbers;
        return;
    }
    --taken_;
    add_gap({numbers, whole(count)});
}

void NumberStore::add_gap(const Gap& gap) {
    const auto after = std::lower_bound(gaps_.begin(), gaps_.end(), gap.begin, [](const Gap& one, const double* place) {
        return std::less<const double*>()(one.begin, place);
    });
    const bool joins_after =
        after != gaps_.end() && gap.begin + gap.count == after->begin && !begins_piece(after->begin);
    const bool joins_before =
        after != gaps_.begin() && (after - 1)->begin + (after - 1)->count == gap.begin && !begins_piece(gap.begin);
    if (joins_before) {
        (after - 1)->count += gap.count + (joins_after ? after->count : 0);
        if (joins_after) gaps_.erase(after);
    } else if (joins_after) {
        *after = {gap.begin, gap.count + after->count};
    } else {
        gaps_.insert(after, gap);
    }
}

Numbers::Numbers(std::shared_ptr<NumberStore> store, std::size_t count)
    : store_(std::move(store)), numbers_(store_->take(count)), count_(count) {}

Numbers::Numbers(const Numbers& other) : store_(other.store_), count_(other.count_) {
    if (count_ == 0) return;
    numbers_ = store_->take(count_);
    std::copy_n(other.numbers_, count_, numbers_);
}

Numbers::Numbers(Numbers&& other) noexcept
    : store_(std::move(other.store_)),
      numbers_(std::exchange(other.numbers_, nullptr)),
      count_(std::exchange(other.count_, 0)) {}

Numbers& Numbers::operator=(Numbers other) noexcept {
    std::swap(store_, other.store_);
    std::swap(numbers_, other.numbers_);
    std::swap(count_, other.count_);
    return *this;
}

Numbers::~Numbers() {
    if (numbers_ != nullptr) store_->give_back(numbers_, count_);
}

}  // namespace snug::detail
