// The reader of exported atlases. Opening reads the front part and the index of the mapped file; a look-up is two binary
// searches for the stored slot, an index entry, and the record it leads to. The record is what one waits for: it may lie
// anywhere in memory, all else in a cache.
//
// Nothing in a file is trusted. The front part is checked on opening; a block is checked as a whole before anything in it
// is used, first its checksum and then that its records and their bodies are what they should be, so that look-ups need no further
// checks.
#include "snug/atlas.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "atlas/format.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"
#include "snug/version.hpp"

namespace snug {

namespace {

using namespace atlas_format;

Error refusal(const std::string& name, const std::string& why) { return Error(name + ": " + why); }

std::string quoted(const std::string& path) { return '"' + printable(path) + '"'; }

Error unreadable(const std::string& name, int reason) {
    return refusal(name, "cannot be read: " + std::generic_category().message(reason) +
                             "; give a file that `snug atlas export` wrote");
}

double value_at(const std::byte* values, std::size_t i) noexcept { return load<double>(values + i * sizeof(double)); }

bool rising(const std::byte* values, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        const double value = value_at(values, i);
        if (!std::isfinite(value) || (i > 0 && !(value > value_at(values, i - 1)))) return false;
    }
    return true;
}

/// The stored values next to the one asked for; the same where it is stored itself.
struct Neighbours {
    std::size_t below;
    std::size_t above;
};

std::optional<Neighbours> neighbours(const std::byte* values, std::size_t count, double asked) noexcept {
    if (!(asked >= value_at(values, 0) && asked <= value_at(values, count - 1))) return std::nullopt;
    std::size_t below = 0;
    for (std::size_t left = count; left > 1;) {
        const std::size_t half = left / 2;
        below = value_at(values, below + half) <= asked ? below + half : below;
        left -= half;
    }
    return Neighbours{below, value_at(values, below) == asked ? below : below + 1};
}

Steering steering_in(std::uint8_t code) noexcept { return static_cast<Steering>(code >> 6); }

CarEntry car_entry(std::span<const std::byte> bytes, std::size_t car) noexcept {
    return load<CarEntry>(bytes.data() + sizeof(Head) + car * sizeof(CarEntry));
}

bool options_possible(const Head& head) noexcept {
    const auto possible = [](double value) { return std::isfinite(value) && value >= 0.0; };
    return head.strategy <= 1 && head.enter <= 1 && head.max_changes >= -1 && possible(head.resolution) &&
           possible(head.min_range) && possible(head.clearance);
}

/// Where the parts of a file of `size` bytes begin; they lie in it, so that size_t holds them.
struct Layout {
    std::size_t names_at;
    std::size_t corners_at;
    std::size_t widths_at;
    std::size_t lengths_at;
    std::size_t blocks_at;
    std::size_t index_at;
    std::size_t blocks;
};

std::optional<Layout> layout(const Head& head, std::uint64_t size) noexcept {
    // Nothing overflows: counts are below 2^32, cells and blocks at most 2^40, and the names no longer than the file.
    const std::uint64_t rows = std::uint64_t{head.cars} * head.widths;
    if (rows == 0 || head.lengths == 0 || head.lengths > most_cells / rows || head.name_bytes > size ||
        head.corners > size || !std::has_single_bit(head.cells_per_block))
        return std::nullopt;
    const std::uint64_t blocks = (rows * head.lengths + head.cells_per_block - 1) / head.cells_per_block;
    const std::uint64_t names_at = sizeof(Head) + head.cars * std::uint64_t{sizeof(CarEntry)};
    const std::uint64_t corners_at = names_at + padded(head.name_bytes);
    const std::uint64_t widths_at = corners_at + head.corners * sizeof(Corner);
    const std::uint64_t lengths_at = widths_at + head.widths * std::uint64_t{sizeof(double)};
    const std::uint64_t blocks_at = lengths_at + head.lengths * std::uint64_t{sizeof(double)};
    const std::uint64_t behind_blocks = blocks * sizeof(IndexEntry) + sizeof(Trailer);
    if (blocks_at > size || behind_blocks > size - blocks_at) return std::nullopt;
    const auto in_memory = [](std::uint64_t value) { return static_cast<std::size_t>(value); };
    return Layout{in_memory(names_at),  in_memory(corners_at),           in_memory(widths_at), in_memory(lengths_at),
                  in_memory(blocks_at), in_memory(size - behind_blocks), in_memory(blocks)};
}

/// Whether a cell's answer is one that can be read.
bool readable(const Record& record, const std::byte* codes) noexcept {
    if (record.direction_changes < (record.moves > 0 ? 0 : -1) || record.lower_bound < 0) return false;
    return std::all_of(codes, codes + record.moves, [&](std::byte byte) {
        const auto code = std::to_integer<std::uint8_t>(byte);
        return (code & contact_bits) <= most_contact &&
               (steering_in(code) != Steering::stored || (record.flags & angles_stored) != 0);
    });
}

/// Whether a block is this many records and their bodies, one after the other.
bool holds_cells(std::span<const std::byte> block, std::uint64_t count) noexcept {
    std::uint64_t at = count * sizeof(Record);
    if (at > block.size()) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const auto record = load<Record>(block.data() + i * sizeof(Record));
        const BodyParts parts = body_parts(record.ranges, record.moves, (record.flags & angles_stored) != 0);
        if (record.body_at != at || parts.end > block.size() - at) return false;
        if (!readable(record, block.data() + at + parts.codes)) return false;
        at += parts.end;
    }
    return at == block.size();
}

}  // namespace

// Opening.

Atlas::Atlas(const std::string& path) : mapped_(map(path)), bytes_(mapped_.get(), mapped_.get_deleter().bytes) {
    open(quoted(path));
}

Atlas::Atlas(std::span<const std::byte> bytes) : bytes_(bytes) { open("the atlas in memory"); }

void Atlas::Unmap::operator()(const std::byte* mapped) const noexcept {
    ::munmap(const_cast<std::byte*>(mapped), bytes);
}

Atlas::Mapped Atlas::map(const std::string& path) {
    const std::string name = quoted(path);
    struct File {
        int descriptor;
        ~File() { ::close(descriptor); }
    };
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe would let us wait
    if (descriptor < 0) throw unreadable(name, errno);
    const File file{descriptor};
    struct stat about {};
    if (::fstat(file.descriptor, &about) != 0) throw unreadable(name, errno);
    if (S_ISDIR(about.st_mode)) throw refusal(name, "is a folder; give a file that `snug atlas export` wrote");
    if (!S_ISREG(about.st_mode))
        throw refusal(name, "is no regular file, which it must be to be mapped into memory; copy it into one");
    if (about.st_size == 0) throw refusal(name, "is empty; give a file that `snug atlas export` wrote");
    if (!std::in_range<std::size_t>(about.st_size)) throw unreadable(name, EFBIG);
    const auto size = static_cast<std::size_t>(about.st_size);
    void* const mapped = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file.descriptor, 0);
    if (mapped == MAP_FAILED) throw unreadable(name, errno);
    return {static_cast<const std::byte*>(mapped), Unmap{size}};
}

void Atlas::open(const std::string& name) {
    const std::uint64_t size = bytes_.size();
    const std::string ends = "ends after " + std::to_string(size) + " bytes, ";
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    if (text.starts_with("SQLite format 3"))
        throw refusal(name, "is the database, not an exported atlas; use `snug atlas export`");
    if (text.empty() || !text.starts_with(begin_mark.substr(0, text.size())))
        throw refusal(name, "is no atlas; give a file that `snug atlas export` wrote");
    if (size >= sizeof(Head)) {
        if (const std::uint32_t stored = load<Head>(bytes_.data()).version; stored != version)
            throw refusal(name, "has format version " + std::to_string(stored) +
                                    ", but snug " SNUG_VERSION " reads version " + std::to_string(version) +
                                    (stored > version ? "; use a newer snug, or export it again with this one"
                                                      : "; export it again"));
    }
    if (size < sizeof(Head) + sizeof(Trailer))
        throw refusal(name, ends + "too few for any atlas; it was cut short: copy it again");

    // From its end, because an atlas is written from its begin to its end and knows only then how large it is.
    const std::byte* const last = bytes_.data() + size - sizeof(Trailer);
    const auto trailer = load<Trailer>(last);
    if (std::string_view(trailer.mark.data(), trailer.mark.size()) != end_mark)
        throw refusal(name, ends + "but not as an atlas ends; it was cut short or added to: copy it again");
    if (trailer.trailer_checksum != checksum({last, offsetof(Trailer, trailer_checksum)}))
        throw refusal(name, "its last " + std::to_string(sizeof(Trailer)) + " bytes are damaged: copy it again");
    if (trailer.file_bytes != size)
        throw refusal(name, ends + "but says it has " + std::to_string(trailer.file_bytes) +
                                "; it was cut short or added to: copy it again");

    const auto head = load<Head>(bytes_.data());
    const std::optional<Layout> parts = layout(head, size);
    if (!parts || parts->index_at != trailer.index_at ||
        trailer.front_checksum != checksum(bytes_.first(parts->blocks_at)))
        throw refusal(name, "its first part is damaged: copy it again");
    const std::span<const std::byte> index = bytes_.subspan(parts->index_at, parts->blocks * sizeof(IndexEntry));
    if (trailer.index_checksum != checksum(index)) throw refusal(name, "its index is damaged: copy it again");

    cars_ = head.cars;
    widths_ = head.widths;
    lengths_ = head.lengths;
    blocks_ = parts->blocks;
    block_bits_ = std::countr_zero(head.cells_per_block);
    names_ = bytes_.data() + parts->names_at;
    corners_ = bytes_.data() + parts->corners_at;
    width_values_ = bytes_.data() + parts->widths_at;
    length_values_ = bytes_.data() + parts->lengths_at;
    first_block_ = bytes_.data() + parts->blocks_at;
    index_ = index.data();

    // What is left can only be wrong if it was written so.
    const auto impossible = [&](const std::string& what) {
        return refusal(name, what + ", which no snug writes; export it again");
    };
    if (!options_possible(head)) throw impossible("holds impossible options");
    if (!rising(width_values_, widths_)) throw impossible("its widths do not rise");
    if (!rising(length_values_, lengths_)) throw impossible("its lengths do not rise");
    for (std::size_t i = 0; i < cars_; ++i) {
        const CarEntry entry = car_entry(bytes_, i);
        if (std::uint64_t{entry.name_at} + entry.name_bytes > head.name_bytes)
            throw impossible("has a car without its name");
        if (std::uint64_t{entry.corners_at} + entry.corners > head.corners)
            throw impossible("has a car without its outline");
        if (i > 0 && car_name(i) <= car_name(i - 1)) throw impossible("its cars are not in order");
    }
    options_.strategy = head.strategy == 0 ? Strategy::max_steer : Strategy::fewest;
    if (head.max_changes >= 0) options_.max_changes = head.max_changes;
    options_.resolution = head.resolution;
    options_.min_range = head.min_range;
    options_.driving.clearance = head.clearance;
    options_.driving.enter = head.enter == 0 ? Enter::backward : Enter::forward;

    states_ = std::make_unique<std::atomic<Block>[]>(blocks_);
}

// What it holds.

std::string_view Atlas::made_by() const noexcept {
    const std::string_view padded_version(reinterpret_cast<const char*>(bytes_.data()) + offsetof(Head, made_by),
                                          sizeof(Head::made_by));
    return padded_version.substr(0, padded_version.find('\0'));
}

std::string_view Atlas::car_name(std::size_t car) const noexcept {
    const CarEntry entry = car_entry(bytes_, car);
    return {reinterpret_cast<const char*>(names_) + entry.name_at, entry.name_bytes};
}

std::optional<std::size_t> Atlas::find_car(std::string_view name) const noexcept {
    std::size_t first = 0;  // that is not before the name
    for (std::size_t left = cars_; left > 0;) {
        const std::size_t half = left / 2;
        if (car_name(first + half) < name) {
            first += half + 1;
            left -= half + 1;
        } else {
            left = half;
        }
    }
    if (first == cars_ || car_name(first) != name) return std::nullopt;
    return first;
}

Car Atlas::car(std::size_t car) const {
    const CarEntry entry = car_entry(bytes_, car);
    const std::string name(car_name(car));
    if (entry.corners == 0) return Car({entry.width, entry.front, entry.rear, entry.wheelbase, entry.max_steer}, name);
    std::vector<Point> corners;
    for (std::size_t i = 0; i < entry.corners; ++i) {
        const auto corner = load<Corner>(corners_ + (entry.corners_at + i) * sizeof(Corner));
        corners.push_back({corner.x, corner.y});
    }
    return Car(Outline(std::move(corners)), entry.wheelbase, entry.max_steer, name);
}

double Atlas::width(std::size_t i) const noexcept { return value_at(width_values_, i); }

double Atlas::length(std::size_t i) const noexcept { return value_at(length_values_, i); }

// Look-ups.

std::span<const std::byte> Atlas::block_bytes(std::size_t block) const noexcept {
    const auto begin_of = [&](std::size_t i) {
        return i == blocks_ ? static_cast<std::uint64_t>(index_ - bytes_.data())
                            : load<IndexEntry>(index_ + i * sizeof(IndexEntry)).block_at;
    };
    const std::uint64_t begin = begin_of(block);
    const std::uint64_t end = begin_of(block + 1);
    const bool among_blocks =
        begin >= static_cast<std::uint64_t>(first_block_ - bytes_.data()) && begin <= end && end <= begin_of(blocks_);
    if (!among_blocks) return {};
    return bytes_.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
}

bool Atlas::check(std::size_t block) const noexcept {
    const std::span<const std::byte> bytes = block_bytes(block);
    const std::uint64_t first_cell = std::uint64_t{block} << block_bits_;
    const std::uint64_t cells = std::uint64_t{cars_} * widths_ * lengths_;
    return checksum(bytes) == load<IndexEntry>(index_ + block * sizeof(IndexEntry)).checksum &&
           holds_cells(bytes, std::min(cells - first_cell, std::uint64_t{1} << block_bits_));
}

bool Atlas::block_is_whole(std::size_t block) const noexcept {
    // Nothing but the state itself passes from thread to thread, so that no order is needed.
    std::atomic<Block>& state = states_[block];
    Block known = state.load(std::memory_order_relaxed);
    if (known == Block::unknown) {
        known = check(block) ? Block::whole : Block::damaged;
        state.store(known, std::memory_order_relaxed);
    }
    return known == Block::whole;
}

std::optional<AtlasCell> Atlas::cell(std::size_t car, std::size_t width, std::size_t length) const noexcept {
    const std::uint64_t number = (std::uint64_t{car} * widths_ + width) * lengths_ + length;
    const auto block = static_cast<std::size_t>(number >> block_bits_);
    if (!block_is_whole(block)) return std::nullopt;
    const std::byte* const begin = bytes_.data() + load<IndexEntry>(index_ + block * sizeof(IndexEntry)).block_at;
    const auto in_block = static_cast<std::size_t>(number & ((std::uint64_t{1} << block_bits_) - 1));
    const auto record = load<Record>(begin + in_block * sizeof(Record));
    AtlasCell found;
    found.body_ = begin + record.body_at;
    found.length_ = this->length(length);
    found.width_ = this->width(width);
    found.enter_ = options_.driving.enter;
    found.max_steer_ = car_entry(bytes_, car).max_steer;
    found.direction_changes_ = record.direction_changes;
    found.lower_bound_ = record.lower_bound;
    found.proved_ = (record.flags & proved) != 0;
    found.angles_stored_ = (record.flags & angles_stored) != 0;
    found.ranges_ = record.ranges;
    found.moves_ = record.moves;
    return found;
}

AtlasAnswer Atlas::look_up(std::size_t car, double length, double width) const noexcept {
    AtlasAnswer answer;
    const auto say = [&](AtlasVerdict verdict) {
        answer.verdict = verdict;
        return answer;
    };
    if (car >= cars_) return say(AtlasVerdict::no_such_car);
    const std::optional<Neighbours> widths = neighbours(width_values_, widths_, width);
    const std::optional<Neighbours> lengths = neighbours(length_values_, lengths_, length);
    if (!widths || !lengths) return say(AtlasVerdict::outside_grid);

    const std::optional<AtlasCell> below = cell(car, widths->below, lengths->below);
    if (!below) return say(AtlasVerdict::damaged);
    answer.cell = *below;
    const bool exact = widths->below == widths->above && lengths->below == lengths->above;
    bool bound_damaged = false;
    if (options_.strategy == Strategy::fewest) {
        // A larger slot holds the maneuvers of a smaller one. Full steering knows no such order.
        const std::optional<AtlasCell> above = exact ? below : cell(car, widths->above, lengths->above);
        if (above) answer.lower_bound = above->lower_bound();
        bound_damaged = !above;
    }
    if (below->moves() > 0) return say(AtlasVerdict::parks);
    if (bound_damaged) return say(AtlasVerdict::damaged);
    const bool nothing_parks = options_.strategy == Strategy::fewest
                                   ? answer.lower_bound > options_.max_changes.value_or(limits::usual_changes)
                                   : exact && !below->direction_changes();
    return say(nothing_parks ? AtlasVerdict::cannot_park : AtlasVerdict::undecided);
}

// What is stored of one cell.

std::optional<int> AtlasCell::direction_changes() const noexcept {
    if (direction_changes_ < 0) return std::nullopt;
    return direction_changes_;
}

HeadingRange AtlasCell::range(std::size_t i) const noexcept {
    const BodyParts parts = body_parts(ranges_, moves_, angles_stored_);
    const auto range = load<RangeEntry>(body_ + parts.ranges + i * sizeof(RangeEntry));
    return {range.min, range.max, range.direction_changes, range.subrange};
}

Pose AtlasCell::entry() const noexcept {
    if (moves_ == 0) return {};
    return {value_at(body_, 0), value_at(body_, 1), value_at(body_, 2)};
}

AtlasMove AtlasCell::move(std::size_t i) const noexcept {
    const BodyParts parts = body_parts(ranges_, moves_, angles_stored_);
    const double length = value_at(body_ + parts.lengths, i);
    const auto code = load<std::uint8_t>(body_ + parts.codes + i);
    AtlasMove move;
    move.direction = std::signbit(length) ? Direction::backward : Direction::forward;
    move.length = std::abs(length);
    switch (steering_in(code)) {
        case Steering::full_right: move.steering_angle = -max_steer_; break;
        case Steering::straight: move.steering_angle = 0.0; break;
        case Steering::full_left: move.steering_angle = max_steer_; break;
        case Steering::stored: move.steering_angle = value_at(body_ + parts.angles, i); break;
    }
    if (const int contact = (code & contact_bits) - 1; contact >= 0)
        move.contact = Contact{static_cast<CarPart>(contact / obstacles), static_cast<Obstacle>(contact % obstacles)};
    return move;
}

namespace {

/// What no atlas stores of a contact: which corner of the outline meets the obstacle, the one that is farthest that way; of an
/// edge, which meets a neighbour's corner, the one that it follows.
std::size_t part_index(const Car& car, const Slot& slot, const Pose& at, Obstacle obstacle) {
    const double c = std::cos(at.heading), s = std::sin(at.heading);
    std::vector<Point> corners = car.outline().corners();
    for (Point& corner : corners)
        corner = slot.to_slot(Point{at.x + c * corner.x - s * corner.y, at.y + s * corner.x + c * corner.y});
    const auto apart = [&](std::size_t i) {
        const Point& from = corners[i];
        switch (obstacle) {
            case Obstacle::curb: return from.y;
            case Obstacle::front_side: return -from.x;
            case Obstacle::rear_side: return from.x;
            default: break;
        }
        const Point& to = corners[(i + 1) % corners.size()];
        const Point met = {obstacle == Obstacle::front_corner ? 0.0 : -slot.length(), 0.0};
        const Point edge = {to.x - from.x, to.y - from.y};
        const double part =
            ((met.x - from.x) * edge.x + (met.y - from.y) * edge.y) / (edge.x * edge.x + edge.y * edge.y);
        const double on = std::clamp(part, 0.0, 1.0);
        return std::hypot(from.x + on * edge.x - met.x, from.y + on * edge.y - met.y);
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (apart(i) < apart(nearest)) nearest = i;
    return nearest;
}

}  // namespace

Maneuver maneuver(const AtlasCell& cell, const Car& car, const Slot& slot) {
    // The stored slot lies in the real one with its entry corner on that one's. What it lacks, it lacks at the other end.
    const bool backward = cell.enter() == Enter::backward;
    const auto is_there = [&](Obstacle obstacle) {
        switch (obstacle) {
            case Obstacle::curb: return cell.width() == slot.width();
            case Obstacle::front_side:
            case Obstacle::front_corner: return backward || cell.length() == slot.length();
            case Obstacle::rear_side:
            case Obstacle::rear_corner: break;
        }
        return !backward || cell.length() == slot.length();
    };
    Maneuver driven{car, {}};
    Pose entry = cell.entry();
    if (!backward) entry.x -= slot.length() - cell.length();
    Pose pose = slot.to_world(entry);
    for (std::size_t i = 0; i < cell.moves(); ++i) {
        const AtlasMove stored = cell.move(i);
        Move move;
        move.direction = stored.direction;
        move.steering_angle = slot.mirrored(stored.steering_angle);
        move.length = stored.length;
        if (stored.contact && is_there(stored.contact->obstacle)) move.contact = stored.contact;
        if (move.contact && slot.side() == Side::left) move.contact->part = mirrored(move.contact->part);
        move.start = pose;
        move.end = pose = drive(car, move.start, move.direction, move.steering_angle, move.length);
        if (move.contact) move.contact->part_index = part_index(car, slot, move.end, move.contact->obstacle);
        driven.moves.push_back(move);
    }
    return driven;
}

}  // namespace snug
