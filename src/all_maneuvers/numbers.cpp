#include "all_maneuvers/numbers.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <new>
#include <utility>

namespace snug::detail {

namespace {

constexpr std::size_t first_piece = std::size_t{1} << 20;
constexpr std::size_t longest_piece = std::size_t{3} << 23;  // longer rows are on their own

/// Whole cache lines.
std::size_t whole(std::size_t bytes) { return (bytes + 63) / 64 * 64; }

}  // namespace

bool NumberStore::begins_piece(const std::byte* place) const {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return piece.begin.get() == place; });
}

void NumberStore::drop_unused_pieces() {
    const auto unused = [&](const Piece& piece) {
        const auto gap =
            std::find_if(gaps_.begin(), gaps_.end(), [&](const Gap& one) { return one.begin == piece.begin.get(); });
        if (gap == gaps_.end() || gap->bytes != piece.bytes) return false;
        total_ -= piece.bytes;
        gaps_.erase(gap);
        return true;
    };
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), unused), pieces_.end());
}

void* NumberStore::take(std::size_t bytes) {
    const std::lock_guard<Mutex> lock(mutex_);
    if (bytes <= longest_piece) return cut_off(whole(bytes));
    drop_unused_pieces();
    return ::operator new(bytes);
}

std::byte* NumberStore::cut_off(std::size_t bytes) {
    gaps_.reserve(taken_ + pieces_.size() + 2);  // there will be no more, so that giving back never fails
    // The smallest gap that will do: it was probably used before.
    auto best = gaps_.end();
    for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap)
        if (gap->bytes >= bytes && (best == gaps_.end() || gap->bytes < best->bytes)) best = gap;
    if (best == gaps_.end()) {
        const std::size_t size = std::max(bytes, std::clamp(3 * total_, first_piece, longest_piece));
        pieces_.push_back({std::unique_ptr<std::byte[]>(new std::byte[size]), size});
        total_ += size;
        add_gap({pieces_.back().begin.get(), size});
        return cut_off(bytes);
    }
    ++taken_;
    std::byte* const taken = best->begin;
    *best = {taken + bytes, best->bytes - bytes};
    if (best->bytes == 0) gaps_.erase(best);
    return taken;
}

void NumberStore::give_back(void* numbers, std::size_t bytes) noexcept {
    if (bytes > longest_piece) {
        ::operator delete(numbers);
        return;
    }
    const std::lock_guard<Mutex> lock(mutex_);
    --taken_;
    add_gap({static_cast<std::byte*>(numbers), whole(bytes)});
}

void NumberStore::add_gap(const Gap& gap) {
    const auto after = std::lower_bound(
        gaps_.begin(), gaps_.end(), gap.begin,
        [](const Gap& one, const std::byte* place) { return std::less<const std::byte*>()(one.begin, place); });
    const bool joins_after =
        after != gaps_.end() && gap.begin + gap.bytes == after->begin && !begins_piece(after->begin);
    const bool joins_before =
        after != gaps_.begin() && (after - 1)->begin + (after - 1)->bytes == gap.begin && !begins_piece(gap.begin);
    if (joins_before) {
        (after - 1)->bytes += gap.bytes + (joins_after ? after->bytes : 0);
        if (joins_after) gaps_.erase(after);
    } else if (joins_after) {
        *after = {gap.begin, gap.bytes + after->bytes};
    } else {
        gaps_.insert(after, gap);
    }
}

std::shared_ptr<NumberStore> new_store() { return std::make_shared<NumberStore>(); }

Bytes::Bytes(const Bytes& other) : store_(other.store_) {
    if (other.count_ == 0) return;
    make_room(other.count_);
    std::memcpy(begin_, other.begin_, other.count_);
    count_ = other.count_;
}

Bytes::Bytes(Bytes&& other) noexcept
    : store_(std::move(other.store_)),
      begin_(std::exchange(other.begin_, nullptr)),
      count_(std::exchange(other.count_, 0)),
      room_(std::exchange(other.room_, 0)) {}

Bytes& Bytes::operator=(Bytes other) noexcept {
    std::swap(store_, other.store_);
    std::swap(begin_, other.begin_);
    std::swap(count_, other.count_);
    std::swap(room_, other.room_);
    return *this;
}

Bytes::~Bytes() {
    if (begin_ == nullptr) return;
    if (store_) {
        store_->give_back(begin_, room_);
    } else {
        ::operator delete(begin_);
    }
}

void Bytes::make_room(std::size_t room) {
    if (room <= room_) return;
    Bytes larger(store_);
    larger.begin_ = store_ ? store_->take(room) : ::operator new(room);
    larger.room_ = room;
    if (count_ > 0) std::memcpy(larger.begin_, begin_, count_);
    larger.count_ = count_;
    *this = std::move(larger);
}

}  // namespace snug::detail
