// snug min-slot: how small may a slot be, for so many direction changes; and how does one slot compare with that.
#include "cli/min_slot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/clearance.hpp"
#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/min_street.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "cli/way_out.hpp"
#include "cli/words.hpp"
#include "io/csv.hpp"
#include "sentences/check.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"
#include "snug/limits.hpp"

namespace snug::cli {
namespace {

constexpr double many_points = 1e6;
constexpr std::size_t points_at_once = 4096;

constexpr const char* purpose =
    "How short a parallel parking slot may be for a given width, or how narrow for a\n"
    "given length, so that the car parks with so many direction changes; or, for one\n"
    "slot, how many it takes and what a little more or less room would change, or\n"
    "which clearance the car can keep in it with so many; or how narrow a road or a\n"
    "bay at any angle may be.";

constexpr const char* examples =
    "Lists are a,b,c; ranges are from:to:step, both ends included. A slot smaller\n"
    "than the car is a row without an answer. Without --max-changes, and with one\n"
    "--length and one --width, the answer is about that slot; its rows are the\n"
    "shortest slots of its width for one change fewer, for its own count and for\n"
    "what the next shorter slot needs. With --max-changes as well, the answer is the\n"
    "largest clearance that still parks in it.\n\n"
    "With --angle, --road or --stretch the car starts where it does for snug park\n"
    "and may drive any maneuver. Of length, width and road two are given, one of\n"
    "them as a list; the third is sought (the road, where length and width are\n"
    "given), between one that parks and one below which all are impossible.\n\n"
    "Examples:\n"
    "  snug min-slot --car renault-zoe --max-changes 0,1,2,5,10 --width 1.8:2.4:0.1\n"
    "  snug min-slot --car my-car.json --max-changes 2 --length 5:6:0.1 --format csv\n"
    "  snug min-slot --car vw-transporter --extra-length 0.8 --extra-width 0.3\n"
    "  snug min-slot --car renault-zoe --length 5 --width 2 --max-changes 1,3,5\n"
    "  snug min-slot --car renault-zoe --angle 90 --length 5 --width 2.3,2.5 \\\n"
    "      --max-changes 1,2\n\n"
    "Exit codes: 0 solved; 1 understood, and no row has an answer; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given. Of\n"
    "streets, Ctrl-C ends with what is known so far.";

/// The options of `snug min-slot`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : car(options),
          max_changes(options.group("Slot").numbers(
              "--max-changes", "LIST", "Direction changes allowed, one or several.", {"", 0.0, limits::most_changes})),
          widths(options.numbers("--width", "RANGE", "Widths to find the shortest slot for [m].", size)),
          lengths(options.numbers("--length", "RANGE", "Lengths to find the narrowest slot for [m].", size)),
          extra_widths(options.numbers("--extra-width", "RANGE", "Widths beyond the car's [m].", extra)),
          extra_lengths(options.numbers("--extra-length", "RANGE", "Lengths beyond the car's [m].", extra)),
          max_length(
              options.number("--max-length", "M", "No longer slots [m] (4 m more than the car's length).", size)),
          min_range(options.number("--min-range", "RAD", "Entry headings must hold a range that wide [rad]\n(0).",
                                   {" rad", 0.0, limits::quarter_turn})),
          angle(angle_option(options)),
          roads(options.numbers("--road", "RANGE", "Walls along the street so far beyond the slot's edge\n[m].", size)),
          stretch(stretch_option(options)),
          neighbours(options),
          parked(options),
          driving(options),
          planner(options.group("Strategy")
                      .choice<Planner>("--strategy", "NAME",
                                       "max-steer (default): exactly; fewest: over all\nmaneuvers, between two proved "
                                       "lengths; stepping: the\n"
                                       "paper's loop over slots, for comparison.",
                                       {{"max-steer", Planner::max_steer},
                                        {"fewest", Planner::fewest},
                                        {"stepping", Planner::stepping}})),
          proof(options.choice<bool>("--proof", "PROOF",
                                     "none (default); smaller: that no smaller slot will do,\nor which sizes are left "
                                     "open (max-steer).",
                                     {{"none", false}, {"smaller", true}})),
          resolution(resolution_option(options, "two-thousandth")),
          length_step(options.number("--length-step", "M", "stepping: between the lengths tried [m] (0.01).", step)),
          width_step(options.number("--width-step", "M", "stepping: between the widths tried [m] (0.01).", step)),
          stepping(options),
          output(options),
          draw(draw_option(options)),
          threads(threads_option(options)) {}

    static constexpr Quantity size = {" m", limits::shortest, limits::longest};
    static constexpr Quantity extra = {" m", -limits::longest, limits::longest};
    static constexpr Quantity step = {" m", 1e-5, 1e3};

    CarOptions car;
    Option<std::vector<double>> max_changes;
    Option<std::vector<double>> widths;
    Option<std::vector<double>> lengths;
    Option<std::vector<double>> extra_widths;
    Option<std::vector<double>> extra_lengths;
    Option<double> max_length;
    Option<double> min_range;
    Option<double> angle;  ///< in degrees
    Option<std::vector<double>> roads;
    Option<double> stretch;
    NeighbourOptions neighbours;
    ParkedOptions parked;
    DrivingOptions driving;
    Option<Planner> planner;
    Option<bool> proof;
    Option<double> resolution;
    Option<double> length_step;
    Option<double> width_step;
    SteppingOptions stepping;
    OutputOptions output;
    Option<std::string> draw;  ///< one slot
    Option<int> threads;
};

/// The widths or lengths asked about: themselves, or what they have beyond the car's.
std::vector<double> sizes(const Option<std::vector<double>>& direct, const Option<std::vector<double>>& beyond,
                          double car_size) {
    if (direct && beyond)
        throw Error(direct.name() + " and " + beyond.name() + " exclude each other; give one of them");
    if (direct) return *direct;
    std::vector<double> all = *beyond;
    for (double& size : all) {
        check_between(beyond.name(), size, limits::shortest - car_size, limits::longest - car_size, " m");
        size = std::round((car_size + size) * 1e12) / 1e12;  // 1.781, not 1.7809999999999999
    }
    return all;
}
std::vector<double> widths(const Asked& asked, const Car& car) {
    return sizes(asked.widths, asked.extra_widths, car.width());
}
std::vector<double> lengths(const Asked& asked, const Car& car) {
    return sizes(asked.lengths, asked.extra_lengths, car.length());
}

double one_size(const std::vector<double>& all, const std::string& name) {
    if (all.size() > 1)
        throw Error("--" + name + " is a list, but with lengths and widths one slot is asked about; give one " + name +
                    ", or --max-changes and either lengths or widths");
    return all.front();
}

std::vector<int> counts(const Asked& asked, Planner planner) {
    if (!asked.max_changes)
        throw Error(asked.max_changes.name() +
                    " is missing; give the direction changes allowed, for example 0,1,2,5,10");
    std::vector<int> all;
    for (const double count : *asked.max_changes) {
        if (planner == Planner::fewest)
            check_between(asked.max_changes.name(), count, 0.0, limits::most_changes_fewest, "");
        all.push_back(static_cast<int>(count));
    }
    return all;
}

/// Throws Error where an option has no meaning in a street.
template <class Value>
void refuse_in_street(const Option<Value>& option) {
    if (option) throw Error(option.name() + " is not for streets; leave it out, or --angle, --road and --stretch");
}

/// A bay at a street: two of its length, its width and the road are given, one of them as a list.
MinStreetQuestion street_question(const Asked& asked) {
    MinStreetQuestion question = {asked.car.car(), {}, {}, StreetSize::width, {}, 0};
    const Car& car = question.car;
    refuse_in_street(asked.min_range);
    refuse_in_street(asked.length_step);
    refuse_in_street(asked.width_step);
    refuse_in_street(asked.draw);
    if (asked.planner && *asked.planner != Planner::fewest)
        throw Error("--strategy: in streets the answer is over all maneuvers; leave it out, or write fewest");
    const bool length = asked.lengths || asked.extra_lengths, width = asked.widths || asked.extra_widths;
    if (!length && !width)
        throw Error("--length is missing; give two of --length, --width and --road, and the third is sought");
    MinStreetOptions& options = question.options;
    const bool road = static_cast<bool>(asked.roads);
    if (length && width && road)
        throw Error(asked.roads.name() +
                    " stands beside a length and a width, so that nothing is sought; leave out one of them");
    if (!(length && width) && !road)
        throw Error((length ? std::string("--width") : std::string("--length")) +
                    " is missing; give two of --length, --width and --road, and the third is sought");
    options.sought = !road ? StreetSize::road : length ? StreetSize::width : StreetSize::length;
    options.resolution = asked.resolution.value_or(0.0);
    options.clearance = asked.driving.clearance.value_or(0.0);
    if (asked.max_length && options.sought != StreetSize::length)
        throw Error(asked.max_length.name() + " is for lengths that are sought; leave it out");
    // As far as sizes are looked at.
    options.largest = options.sought == StreetSize::road    ? 20.0
                      : options.sought == StreetSize::width ? car.width() + 4.0
                                                            : asked.max_length.value_or(car.length() + 4.0);
    question.max_changes = counts(asked, Planner::fewest);
    if (asked.threads) question.threads = *asked.threads;

    Street street;
    const Driving driving = asked.driving.driving(asked.neighbours);
    street.angle = std::min(asked.angle.value_or(0.0) * limits::quarter_turn / 90.0, limits::quarter_turn);
    street.stretch = asked.stretch.value_or(street.stretch);
    street.enter = driving.enter;
    street.curb_clearance = driving.curb_clearance;
    street.front_setback = asked.neighbours.front_setback.value_or(0.0);
    street.rear_setback = asked.neighbours.rear_setback.value_or(0.0);
    street.curb = asked.neighbours.curb.value_or(Curb::high);
    street.parked = asked.parked.parked();
    std::vector<std::pair<StreetSize, std::vector<double>>> given;
    if (length) given.emplace_back(StreetSize::length, lengths(asked, car));
    if (width) given.emplace_back(StreetSize::width, widths(asked, car));
    if (road) given.emplace_back(StreetSize::road, *asked.roads);
    if (given[0].second.size() > 1 && given[1].second.size() > 1)
        throw Error("--" + std::string(to_string(given[0].first)) + " and --" + std::string(to_string(given[1].first)) +
                    " are both lists; give one " + std::string(to_string(given[0].first)) + " or one " +
                    std::string(to_string(given[1].first)));
    if (given[0].second.size() > 1) std::swap(given[0], given[1]);
    question.listed = given[1].first;
    street = with_size(street, given[0].first, given[0].second.front());
    for (const double size : given[1].second) {
        question.streets.push_back(with_size(street, given[1].first, size));
        if (width) asked.neighbours.check_within(question.streets.back().width);
    }
    return question;
}

/// There is a picture of one slot.
void refuse_picture(const Asked& asked) {
    if (asked.draw)
        throw Error(asked.draw.name() +
                    " draws one slot; leave it out, or give one --length and one --width without --max-changes");
}

/// Between the slots that the paper's loop tries. [m]
double loop_step(const Asked& asked, Planner planner, Sought sought) {
    const Option<double>& used = sought == Sought::length ? asked.length_step : asked.width_step;
    const Option<double>& unused = sought == Sought::length ? asked.width_step : asked.length_step;
    belongs_to(used, planner == Planner::stepping, "stepping");
    belongs_to(unused, planner == Planner::stepping, "stepping");
    if (unused) throw Error(unused.name() + " is of no use here; give " + used.name() + ", or leave it out");
    return used.value_or(0.01);
}

MinSlotQuestion understood(const Asked& asked, Planner planner, Sought sought) {
    MinSlotQuestion question{asked.car.car(), {}, {}, {}};
    const Car& car = question.car;
    MinSlotOptions& options = question.options;
    options.sought = sought;
    options.strategy = planner == Planner::fewest ? Strategy::fewest : Strategy::max_steer;
    options.min_range = asked.min_range.value_or(0.0);
    options.driving = asked.driving.driving(asked.neighbours);
    options.parked = asked.parked.parked();
    refuse_for_baselines(planner, asked.neighbours, asked.parked);
    options.front_setback = asked.neighbours.front_setback.value_or(0.0);
    options.rear_setback = asked.neighbours.rear_setback.value_or(0.0);
    options.curb = asked.neighbours.curb.value_or(Curb::high);
    const double max_length = asked.max_length.value_or(std::min(car.length() + 4.0, limits::longest));
    const double neighbours_touched =
        (options.front_setback > 0.0 ? 0.0 : 1.0) + (options.rear_setback > 0.0 ? 0.0 : 1.0);
    options.longest = std::max(0.0, max_length - car.length() - neighbours_touched * options.driving.clearance);
    if (asked.threads) question.threads = *asked.threads;
    belongs_to(asked.proof, planner == Planner::max_steer, "max-steer");
    options.prove = asked.proof.value_or(false);
    belongs_to(asked.resolution, planner == Planner::fewest, "fewest");
    options.resolution = asked.resolution.value_or(0.0);
    if (planner == Planner::fewest && asked.min_range)
        throw Error(asked.min_range.name() +
                    " asks for headings, but fewest has none; leave it out or change --strategy");
    const Stepping stepping = asked.stepping.stepping(planner == Planner::stepping);
    if (planner == Planner::stepping) question.stepping = stepping;
    question.step = loop_step(asked, planner, sought);
    return question;
}

/// A neighbour cannot begin deeper than the slot.
void check_setbacks(const Asked& asked, const std::vector<double>& widths) {
    for (const double width : widths) asked.neighbours.check_within(width);
}

std::vector<MinSlot> answer(const MinSlotQuestion& question, const std::vector<double>& sizes,
                            const SweepOptions& sweep) {
    if (question.stepping)
        return min_slots_by_stepping(question.car, sizes, question.max_changes, *question.stepping, question.step,
                                     question.options, sweep);
    return min_slots(question.car, sizes, question.max_changes, question.options, sweep);
}

/// From counts outside to counts inside, so that what belongs to one width (or length) stands together.
std::vector<MinSlot> counts_inside(const std::vector<MinSlot>& rows, std::size_t counts) {
    std::vector<MinSlot> turned;
    const std::size_t sizes = rows.size() / counts;
    for (std::size_t i = 0; i < sizes; ++i) {
        for (std::size_t k = 0; k < counts; ++k) turned.push_back(rows[k * sizes + i]);
    }
    return turned;
}

/// The answer part by part, for it may be too long to hold.
class Report {
public:
    Report(const MinSlotQuestion& question, Format format, const std::string& path)
        : question_(question), format_(format), json_(question) {
        if (!path.empty()) file_.emplace("--output", path);
        if (format == Format::text) text_ = heading();
        if (format == Format::json) text_ = json_.begin();
        if (format == Format::csv) begin_csv();
    }

    void add(const std::vector<MinSlot>& rows) {
        if (format_ == Format::text)
            text_ += fewest() ? fewest_slot_table(sought(), rows)
                              : min_slot_table(sought(), rows, question_.max_changes.size());
        if (question_.options.prove)
            for (const MinSlot& row : rows) proofs_ += size_proof(sought(), row);
        for (const MinSlot& row : rows) {
            any_ = any_ || row.size(sought());
            if (!row.size(sought()) && !row.cancelled) without_.push_back(row);
            cancelled_ = cancelled_ || row.cancelled;
            if (format_ == Format::csv) add_csv(row);
            if (format_ == Format::json) text_ += json_.row(row);
            if (text_.size() + csv_.text().size() > 1'000'000) flush();
        }
    }

    int finish() {
        if (format_ == Format::json) text_ += json_.end();
        if (format_ == Format::text && !fewest()) {
            text_ += "Rounded up to millimetres; - where no slot will do.\n" + proofs_;
            text_ += question_.stepping ? "" : other_maneuvers(question_, without_);
        }
        flush();
        if (file_) file_->finish();
        return any_ ? solved : cancelled_ ? undecided : cannot_park;
    }

private:
    [[nodiscard]] Sought sought() const { return question_.options.sought; }
    [[nodiscard]] bool fewest() const { return question_.options.strategy == Strategy::fewest; }

    [[nodiscard]] std::string heading() const {
        const Car& car = question_.car;
        const bool length = sought() == Sought::length;
        return name(car) + " (" + fixed(car.length(), 3) + " x " + fixed(car.width(), 3) + " m): the " +
               (length ? "shortest" : "narrowest") + " slot [m] " + (fewest() ? "over all maneuvers" : "it parks in") +
               ",\nby the slot's " + (length ? "width" : "length") + " [m] and the most direction changes allowed\n\n";
    }

    void begin_csv() {
        for (const char* column : {"max_changes", "width", "length"}) csv_.add_field(column);
        csv_.add_field(fewest() ? std::string(to_string(sought())) + "_lower" : "entry_heading");
        csv_.end_row();
    }

    void add_csv(const MinSlot& row) {
        csv_.row(row.max_changes, row.width, row.length, fewest() ? std::optional(row.lower) : row.entry_heading);
    }

    void flush() {
        if (format_ == Format::csv) text_ += csv_.take();
        if (file_) {
            file_->write(text_);
        } else {
            print(text_);
        }
        text_.clear();
    }

    const MinSlotQuestion& question_;
    Format format_;
    std::optional<FileInParts> file_;
    MinSlotJson json_;
    Csv csv_;
    std::string text_;              ///< not yet written
    std::string proofs_;            ///< what is proved of smaller slots
    std::vector<MinSlot> without_;  ///< rows without an answer
    bool any_ = false;              ///< some row has an answer
    bool cancelled_ = false;        ///< some row is not decided
};

int answer_all(const MinSlotQuestion& question, Format format, const std::string& path) {
    const std::size_t count = question.max_changes.size();
    const double points = static_cast<double>(count) * static_cast<double>(question.sizes.size());
    if (points >= many_points) {
        complain("snug min-slot: " + fixed(points, 0) + " points will take long; rows are written as they are found");
    }
    Report report(question, format, path);
    const std::size_t at_once = std::max<std::size_t>(16, points_at_once / count);
    const std::function<bool(double)> show = show_progress();
    for (std::size_t from = 0; from < question.sizes.size(); from += at_once) {
        const std::size_t to = std::min(from + at_once, question.sizes.size());
        const auto begin = question.sizes.begin();
        SweepOptions sweep;
        sweep.threads = question.threads;
        if (show) {
            sweep.progress = [&](double done) {
                const double before = static_cast<double>(from);
                return show((before + done * static_cast<double>(to - from)) /
                            static_cast<double>(question.sizes.size()));
            };
        }
        const std::vector<double> some(begin + static_cast<std::ptrdiff_t>(from),
                                       begin + static_cast<std::ptrdiff_t>(to));
        const std::vector<MinSlot> rows = answer(question, some, sweep);
        if (show) wipe_progress();
        report.add(counts_inside(rows, count));
    }
    return report.finish();
}

/// What one slot is, with the neighbours asked about.
Slot slot_of(const MinSlotQuestion& question, double length, double width) {
    const MinSlotOptions& options = question.options;
    return Slot({.length = length,
                 .width = width,
                 .front_setback = options.front_setback,
                 .rear_setback = options.rear_setback,
                 .curb = options.curb});
}

int answer_one(MinSlotQuestion question, double length, double width, Format format, const std::string& path,
               const std::optional<PictureFile>& picture) {
    const OneSlot one = one_slot(question.car, length, width, question.options);
    if (picture) {
        EntryOptions options;
        options.min_range = question.options.min_range;
        options.driving = question.options.driving;
        options.parked = question.options.parked;
        const Slot slot = slot_of(question, length, width);
        write_file(
            "--draw", picture->path,
            draw_maneuver(question.car, slot, entry(question.car, slot, options), picture->format, {options.driving}));
    }
    if (format == Format::text) {
        std::string text = one_slot_text(one);
        if (!one.changes) {
            EntryOptions options;
            options.driving = question.options.driving;
            options.parked = question.options.parked;
            text += fewer_text(one.most_changes + 1,
                               any_maneuver({question.car, slot_of(question, length, width), options}));
        }
        put_out(path, text);
    } else {
        for (const MinSlot& row : one.rows) question.max_changes.push_back(row.max_changes);
        Report report(question, format, path);
        report.add(one.rows);
        report.finish();
    }
    return one.changes ? solved : cannot_park;
}

/// With the slot given whole and the changes too, clearance is what is left to ask for.
Action clearance_action(const MinSlotQuestion& question, const Slot& slot, Format format, const std::string& path) {
    return [asked = ClearanceQuestion{question.car, slot, question.options, question.max_changes}, format, path] {
        const std::vector<KeptClearance> rows = kept_clearances(asked);
        put_out(path, format == Format::json  ? clearance_json(asked, rows)
                      : format == Format::csv ? clearance_csv(asked, rows)
                                              : clearance_text(asked, rows));
        const bool any = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.clearance; });
        const bool open = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.upper > 0.0; });
        return any ? solved : open ? undecided : cannot_park;
    };
}

}  // namespace

Action parse_min_slot(const Arguments& arguments) {
    Options options("snug min-slot", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    if (asked.angle || asked.roads || asked.stretch)
        return min_street_action(street_question(asked), asked.output.format(), asked.output.path());
    const Planner planner = asked.planner.value_or(Planner::max_steer);
    const bool width = asked.widths || asked.extra_widths;
    const bool length = asked.lengths || asked.extra_lengths;
    MinSlotQuestion question = understood(asked, planner, width ? Sought::length : Sought::width);
    if (!width && !length)
        throw Error("--width is missing; give --width or --extra-width, or --length or --extra-length, in metres");
    const Format format = asked.output.format();
    if (width) check_setbacks(asked, widths(asked, question.car));
    if (width && length) {
        const double slot_length = one_size(lengths(asked, question.car), "length");
        const double slot_width = one_size(widths(asked, question.car), "width");
        if (asked.max_changes) {
            if (planner == Planner::stepping)
                throw Error("--strategy: clearances are found by max-steer and fewest only; give one of them");
            if (asked.driving.clearance)
                throw Error(asked.driving.clearance.name() +
                            " is what --length, --width and --max-changes together ask for; leave it out, or one of "
                            "them");
            refuse_picture(asked);
            question.max_changes = counts(asked, planner);
            return clearance_action(question, slot_of(question, slot_length, slot_width), format, asked.output.path());
        }
        if (planner != Planner::max_steer)
            throw Error(
                "--strategy: one slot is answered for max-steer only; leave it out, or give --max-changes and "
                "either lengths or widths");
        return [question, slot_length, slot_width, format, picture = picture_file(asked.draw, asked.output),
                path = asked.output.path()] {
            return answer_one(question, slot_length, slot_width, format, path, picture);
        };
    }
    refuse_picture(asked);
    if (length && asked.max_length)
        throw Error(asked.max_length.name() + " belongs to --width; leave it out where the length is given");
    if (length && planner == Planner::fewest && asked.parked.curb)
        throw Error(asked.parked.curb.name() +
                    " can make a wider slot harder, so that fewest can prove no width; leave it out, or give widths");
    question.max_changes = counts(asked, planner);
    question.sizes = width ? widths(asked, question.car) : lengths(asked, question.car);
    return [question = std::move(question), format, path = asked.output.path()] {
        return answer_all(question, format, path);
    };
}

}  // namespace snug::cli
