// Branch and bound over boxes of headings. The strategy is driven with all headings of a box at once, every quantity a
// Form (enclosure.hpp): driver.hpp says what comes of a box, cuts.hpp where it is cut when that cannot be told, and here is
// the queue of boxes and what is made of them.
#include "full_steering/proof/proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "full_steering/proof/cuts.hpp"
#include "model/angles.hpp"

namespace snug::detail {

namespace {

using namespace proof;

class Prover {
public:
    Prover(const ProofProblem& problem, int max_changes, Find find, const ProofHints& hints, const Progress& progress,
           std::size_t most_moves)
        : problem_(problem),
          driver_(problem, max_changes),
          asked_(max_changes),
          limit_(max_changes),
          find_(find),
          hints_(hints),
          progress_(progress),
          most_moves_(most_moves) {}

    ProvedRanges run() {
        divide();
        if (find_ == Find::all) {
            limit_ = asked_;
            search();
        } else {
            // Few moves first: no box is driven far for nothing. Then only what could still park goes on.
            int allowed = hints_.changes >= 0 ? std::min(hints_.changes, asked_) : std::min(2, asked_);
            for (bool first = true;; first = false) {
                const int before = limit_;
                const std::vector<Sliver> left = found_.undecided;
                limit_ = allowed;
                if (!first) {
                    boxes_.swap(later_);
                    std::reverse(boxes_.begin(), boxes_.end());
                    later_.clear();
                }
                search();
                const bool complete = driver_.moves() <= most_moves_;
                if (!complete && !first && found_.ranges.empty()) {  // what was proved before stays
                    limit_ = before;
                    found_.undecided = left;
                }
                if (!complete || !found_.ranges.empty() || allowed == asked_ || found_.cancelled) break;
                allowed = std::min(asked_, 2 * allowed + 2);
            }
            put_in_order(found_.undecided);
            std::erase_if(found_.ranges, [this](const CountedHeadings& range) { return range.changes > limit_; });
        }
        std::erase_if(found_.undecided, [this](const Sliver& sliver) { return sliver.from_changes > limit_; });
        found_.proved_changes = limit_;
        found_.boxes = driver_.boxes();
        found_.moves = driver_.moves();
        return std::move(found_);
    }

private:
    /// All headings there are, in a first few boxes.
    void divide() {
        const double end = quarter_turn;
        std::vector<double> cuts = {0.0};
        for (const double cut : hints_.headings) {
            if (cut > cuts.back() && cut < end) cuts.push_back(cut);
        }
        constexpr int first_boxes = 16;
        if (cuts.size() == 1) {
            for (int i = 1; i < first_boxes; ++i) cuts.push_back(end * i / first_boxes);
        }
        cuts.push_back(std::nextafter(end, 2.0));
        for (std::size_t i = cuts.size() - 1; i-- > 0;) boxes_.emplace_back(cuts[i], cuts[i + 1]);
    }

    void search() {
        std::size_t next_report = 100'000;
        while (!boxes_.empty()) {
            Box box = boxes_.back();
            boxes_.pop_back();
            if (progress_ && driver_.moves() >= next_report) {
                next_report = driver_.moves() + 100'000;
                if (!progress_(box.min / quarter_turn)) found_.cancelled = true;
            }
            if (found_.cancelled || driver_.moves() > most_moves_) {
                note_undecided(box, 0);
                continue;
            }
            if (box.ends_in >= 0) {
                note_undecided(box, box.ends_in);
                continue;
            }
            const Outcome outcome = driver_.look(box, limit_);
            switch (outcome.what) {
                case Outcome::none:
                    if (outcome.goes_on && limit_ < asked_ && find_ != Find::all) keep(box, outcome.move + 1);
                    break;
                case Outcome::parks:
                    if (find_ != Find::all) limit_ = std::min(limit_, outcome.move);
                    note_range(box, outcome.move);
                    break;
                case Outcome::undecided:
                    if (!hopeless(box, outcome.failure)) {
                        cut(box, outcome, driver_, problem_.radius, boxes_);
                    } else if (box.driven > 0) {  // what it inherits of a wider box may be all there is in its way
                        box.driven = 0;
                        boxes_.push_back(box);
                    } else {
                        note_undecided(box, outcome.move);
                    }
                    break;
            }
        }
    }

    /// For when more moves are allowed.
    void keep(const Box& box, int driven) {
        Box& kept = later_.emplace_back(box);
        if (kept.doubtful) {
            kept.driven = 0;
        } else if (!driver_.forked()) {
            kept.driven = driven;
            kept.state = driver_.before(kept.driven);
        }
    }

    /// In rising order, those that touch as one.
    static void put_in_order(std::vector<Sliver>& slivers) {
        std::sort(slivers.begin(), slivers.end(), [](const Sliver& a, const Sliver& b) { return a.min < b.min; });
        std::vector<Sliver> whole;
        for (const Sliver& sliver : slivers) {
            if (!whole.empty() && whole.back().max == sliver.min) {
                whole.back().max = sliver.max;
                whole.back().from_changes = std::min(whole.back().from_changes, sliver.from_changes);
            } else {
                whole.push_back(sliver);
            }
        }
        slivers = whole;
    }

    void note_range(const Box& box, int changes) {
        std::vector<CountedHeadings>& ranges = found_.ranges;
        if (!ranges.empty() && ranges.back().changes == changes && ranges.back().max == box.min) {
            ranges.back().max = box.max;
        } else {
            ranges.push_back({box.min, box.max, changes});
        }
    }

    void note_undecided(const Box& box, int from_changes) {
        std::vector<Sliver>& slivers = found_.undecided;
        if (!slivers.empty() && slivers.back().max == box.min) {
            slivers.back().max = box.max;
            slivers.back().from_changes = std::min(slivers.back().from_changes, from_changes);
        } else {
            slivers.push_back({box.min, box.max, from_changes});
        }
    }

    const ProofProblem& problem_;
    Driver driver_;
    int asked_;
    int limit_;
    Find find_;
    const ProofHints& hints_;
    const Progress& progress_;
    std::size_t most_moves_;
    std::vector<Box> boxes_;  ///< to be looked at, the lowest headings last
    std::vector<Box> later_;  ///< none of their headings parks yet
    ProvedRanges found_;
};

}  // namespace

double steepest_parked(const ProofProblem& problem, bool above) {
    const double size = size_of(problem.frame) + size_of(problem.at_curb);
    const double room = problem.width + problem.width_error + 1e-12 * size;
    double steepest = problem.parked_heading;
    while (steepest > 0.0) {
        const auto [s, c] = angles::sine_cosine(above ? steepest : -steepest);
        const auto height = [sine = s, cosine = c](const Point& corner) { return corner.x * sine + corner.y * cosine; };
        const auto lower = [&](const Point& a, const Point& b) { return height(a) < height(b); };
        const Point low = *std::min_element(problem.at_curb.begin(), problem.at_curb.end(), lower);
        const Point high = *std::max_element(problem.frame.begin(), problem.frame.end(), lower);
        if (height(high) - height(low) <= room) break;
        // These two are too far apart as long as their line is no farther than this from upright.
        const double apart = angles::hypot(high.x - low.x, high.y - low.y);
        const double upright = angles::atan2(above ? high.x - low.x : low.x - high.x, high.y - low.y);
        steepest = std::min(upright - angles::acos(std::min(room / apart, 1.0)), steepest - 1e-12);
    }
    return std::max(steepest, 0.0) + 1e-9;
}

bool none_parks(const ProofProblem& problem, int max_changes, std::size_t& moves_left) {
    constexpr int first_boxes = 16;
    constexpr double narrow_enough = 1e-11;  ///< [rad]
    // Many boxes narrower than this tell no more of slots that differ that much; a few may close in on a sliver.
    const double blurred = 0.01 * (problem.length_error + problem.width_error);
    constexpr int most_blurred = 20;
    int seen_blurred = 0;
    double slivers = 0.0;
    Driver driver(problem, max_changes);
    std::vector<Box> boxes;
    for (int i = first_boxes; i-- > 0;) {
        const double end =
            i + 1 < first_boxes ? quarter_turn * (i + 1) / first_boxes : std::nextafter(quarter_turn, 2.0);
        boxes.emplace_back(quarter_turn * i / first_boxes, end);
    }
    bool none = true;
    while (none && !boxes.empty() && driver.moves() < moves_left) {
        Box box = boxes.back();
        boxes.pop_back();
        const Outcome outcome = driver.look(box, max_changes);
        none = outcome.what != Outcome::parks;
        if (outcome.what != Outcome::undecided) continue;
        const double width = box.max - box.min;
        if (width < blurred && ++seen_blurred > most_blurred) {
            none = false;
        } else if (width > narrow_enough) {
            cut(box, outcome, driver, problem.radius, boxes);
        } else {
            slivers += width;
            none = slivers <= most_undecided;
        }
    }
    none = none && boxes.empty();
    moves_left -= std::min(moves_left, driver.moves());
    return none;
}

ProvedRanges prove_ranges(const ProofProblem& problem, int max_changes, Find find, const ProofHints& hints,
                          const Progress& progress, std::size_t most_moves) {
    return Prover(problem, max_changes, find, hints, progress, most_moves).run();
}

ProofProblem proof_problem(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked) {
    const bool nose_first = driving.enter == Enter::forward;
    const auto entering = [&](const Outline& outline) {
        const Outline on_the_right = slot.side() == Side::left ? outline.mirrored() : outline;
        return nose_first ? on_the_right.turned_about() : on_the_right;
    };
    const SlotDimensions& dimensions = slot.dimensions();
    ProofProblem made;
    made.frame = entering(car.outline()).corners();
    made.body = entering(car.outline()).grown(driving.clearance).corners();
    const Outline& meets_curb = dimensions.curb == Curb::low ? car.wheels() : car.outline();
    made.at_curb = entering(meets_curb).grown(driving.at_curb()).corners();
    made.radius = car.turning_radius();
    made.length = dimensions.length;
    made.width = dimensions.width;
    made.front_setback = nose_first ? dimensions.rear_setback : dimensions.front_setback;
    made.rear_setback = nose_first ? dimensions.front_setback : dimensions.rear_setback;
    made.parked_heading = std::min(parked.heading, quarter_turn);
    made.parked_curb = parked.curb;
    // Of the corners ahead of the rear axle the one farthest from the first move's centre.
    double farthest = 0.0;
    for (std::size_t i = 0; i < made.body.size(); ++i) {
        const Point& corner = made.body[i];
        const double distance = angles::hypot(corner.x, corner.y - made.radius);
        if (corner.x > 0.0 && distance > farthest) farthest = distance, made.entry_corner = i;
    }
    return made;
}

}  // namespace snug::detail
