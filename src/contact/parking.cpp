#include "contact/parking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace snug::detail {

namespace {

/// a c + b s + e <= 0, and how e changes with the entry heading.
struct Condition {
    double a, b, e, e_slope;

    [[nodiscard]] double at(double c, double s) const { return e + b * s + a * c; }
    [[nodiscard]] double by_heading(double c, double s) const { return b * c - a * s; }
};

struct Conditions {
    std::array<Condition, 4> all;
    std::size_t count = 0;

    Conditions(const Turn& turn, const Sector& sector) {
        const Problem& problem = *turn.problem;
        add({sector.top.y, sector.top.x, turn.y, turn.y_slope});
        if (by_height_alone(problem)) return;
        add({sector.frame_right.x, -sector.frame_right.y, turn.x, turn.x_slope});
        add({-sector.frame_left.x, sector.frame_left.y, -problem.length - turn.x, -turn.x_slope});
        if (!std::isinf(problem.parked.curb))
            add({sector.frame_low.y, sector.frame_low.x, turn.y + problem.width - problem.parked.curb, turn.y_slope});
    }

    void add(const Condition& condition) { all[count++] = condition; }

    [[nodiscard]] const Condition& worst(double c, double s) const {
        const Condition* found = &all[0];
        for (std::size_t i = 1; i < count; ++i)
            if (all[i].at(c, s) > found->at(c, s)) found = &all[i];
        return *found;
    }
    [[nodiscard]] double miss(double c, double s) const { return worst(c, s).at(c, s); }
};

bool lies_between(const Bearing& at, const Bearing& begin, const Bearing& end) {
    return at.c >= 0.0 && at.s >= 0.0 && at.order() < begin.order() && at.order() > end.order();
}

bool before(const QuarterHeading& a, const QuarterHeading& b) {
    return a.quarter != b.quarter ? a.quarter < b.quarter : a.order() > b.order();
}

/// The part of the turn that is as parallel as it must be; empty if none is.
std::optional<ParkedTurn> parallel_part(const Turn& turn, const QuarterHeading& from, const QuarterHeading& to) {
    const double most = turn.problem->parked.heading;
    if (std::isinf(most)) return ParkedTurn{from, to};
    const QuarterHeading first = in_quarters(most);
    const QuarterHeading last = in_quarters(-most);
    const ParkedTurn part = {before(from, first) ? first : from, before(to, last) ? to : last};
    if (before(part.to, part.from)) return std::nullopt;
    return part;
}

/// Calls `visit(sector, begin, end, quarter)` for the parts of a turn in each sector; it returns false to stop.
template <class Visit>
void each_sector(const TurningFrame& frame, const QuarterHeading& from, const QuarterHeading& to, Visit visit) {
    QuarterHeading now = from;
    int index = frame.sector_of(now);
    for (int i = 0; i <= 4 * frame.per_quarter; ++i) {
        const Sector& sector = frame.at(now.quarter, index);
        const bool last =
            now.quarter == to.quarter && (index + 1 == frame.per_quarter || to.order() >= sector.end_order);
        const Bearing end = last ? Bearing{to.c, to.s} : Bearing{sector.end_c, sector.end_s};
        if (!visit(sector, Bearing{now.c, now.s}, end, now.quarter) || last) return;
        if (++index == frame.per_quarter) {
            index = 0;
            now = {0.0, 1.0, now.quarter + 1};
        } else {
            now = {end.c, end.s, now.quarter};
        }
    }
}

}  // namespace

Miss least_miss(const Turn& turn, const QuarterHeading& from, const QuarterHeading& to, double from_slope,
                double to_slope) {
    const std::optional<ParkedTurn> part = parallel_part(turn, from, to);
    const auto slope_at = [](const Conditions& conditions, double c, double s, double heading_slope) {
        const Condition& worst = conditions.worst(c, s);
        return worst.e_slope + worst.by_heading(c, s) * heading_slope;
    };
    if (!part) {  // the end nearest to parallel
        const bool at_end = to.angle() > 0.0;
        const QuarterHeading& nearest = at_end ? to : from;
        const Conditions conditions(turn, turn.frame->at(nearest.quarter, turn.frame->sector_of(nearest)));
        const double off = std::abs(nearest.angle()) - turn.problem->parked.heading;
        const double missed = conditions.miss(nearest.c, nearest.s);
        const double heading_slope = at_end ? to_slope : from_slope;
        if (off > missed) return {off, at_end ? heading_slope : -heading_slope};
        return {missed, slope_at(conditions, nearest.c, nearest.s, heading_slope)};
    }
    Miss least = {std::numeric_limits<double>::infinity(), 0.0};
    const auto take = [&](double excess, double slope) {
        if (excess < least.excess) least = {excess, slope};
    };
    const bool whole_from = part->from.quarter == from.quarter && part->from.order() == from.order();
    const bool whole_to = part->to.quarter == to.quarter && part->to.order() == to.order();
    {
        const Conditions conditions(turn, turn.frame->at(part->from.quarter, turn.frame->sector_of(part->from)));
        take(conditions.miss(part->from.c, part->from.s),
             slope_at(conditions, part->from.c, part->from.s, whole_from ? from_slope : 0.0));
    }
    each_sector(*turn.frame, part->from, part->to, [&](const Sector& sector, Bearing begin, Bearing end, int quarter) {
        const Conditions conditions(turn, sector);
        for (std::size_t i = 0; i < conditions.count; ++i) {
            const Condition& one = conditions.all[i];
            const double radius = std::sqrt(one.a * one.a + one.b * one.b);
            const Bearing lowest = {-one.a / radius, -one.b / radius};
            if (lies_between(lowest, begin, end) && &conditions.worst(lowest.c, lowest.s) == &one)
                take(one.at(lowest.c, lowest.s), one.e_slope);
            for (std::size_t k = 0; k < i; ++k) {
                const Condition& other = conditions.all[k];
                roots(one.a - other.a, one.b - other.b, other.e - one.e, [&](const Bearing& at) {
                    if (!lies_between(at, begin, end)) return;
                    const double here = conditions.miss(at.c, at.s);
                    if (here > one.at(at.c, at.s) + 1e-9 * radius) return;  // a third is missed by more
                    const double mine = one.by_heading(at.c, at.s);
                    const double others = other.by_heading(at.c, at.s);
                    take(here, (one.e_slope * others - other.e_slope * mine) / (others - mine));
                });
            }
        }
        const bool at_end = whole_to && quarter == to.quarter && end.order() == to.order();
        take(conditions.miss(end.c, end.s), slope_at(conditions, end.c, end.s, at_end ? to_slope : 0.0));
        return true;
    });
    return least;
}

std::optional<ParkedTurn> first_parked(const Turn& turn, const QuarterHeading& from, const QuarterHeading& to,
                                       double allowed) {
    const std::optional<ParkedTurn> part = parallel_part(turn, from, to);
    if (!part) return std::nullopt;
    std::optional<ParkedTurn> found;
    each_sector(*turn.frame, part->from, part->to, [&](const Sector& sector, Bearing begin, Bearing end, int quarter) {
        const Conditions conditions(turn, sector);
        std::array<Bearing, 10> cuts;
        std::size_t count = 0;
        cuts[count++] = begin;
        for (std::size_t i = 0; i < conditions.count; ++i) {
            const Condition& one = conditions.all[i];
            roots(one.a, one.b, -one.e, [&](const Bearing& at) {
                if (lies_between(at, begin, end)) cuts[count++] = at;
            });
        }
        const auto later = [](const Bearing& a, const Bearing& b) { return a.order() > b.order(); };
        std::sort(cuts.begin() + 1, cuts.begin() + static_cast<std::ptrdiff_t>(count), later);
        cuts[count++] = end;
        if (!found && conditions.miss(begin.c, begin.s) <= allowed)
            found = ParkedTurn{{begin.c, begin.s, quarter}, {begin.c, begin.s, quarter}};
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double c = cuts[i].c + cuts[i + 1].c;
            const double s = cuts[i].s + cuts[i + 1].s;
            const double length = std::sqrt(c * c + s * s);
            if (conditions.miss(c / length, s / length) <= allowed) {
                if (!found) found = ParkedTurn{{cuts[i].c, cuts[i].s, quarter}, {}};
                found->to = {cuts[i + 1].c, cuts[i + 1].s, quarter};
            } else if (found) {
                return false;
            }
        }
        return true;
    });
    return found;
}

}  // namespace snug::detail
