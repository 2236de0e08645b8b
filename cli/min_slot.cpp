// snug min-slot: how small may a slot be, for so many direction changes; and how does one slot compare with that.
#include "cli/min_slot.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/command.hpp"
#include "cli/numbers.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr double longest = 1e6;  // [m], what a Slot accepts
constexpr int most_changes = 100000;
constexpr double many_points = 1e6;
constexpr std::size_t points_at_once = 4096;

constexpr const char* purpose =
    "How short a parallel parking slot may be for a given width, or how narrow for a\n"
    "given length, so that the car parks with so many direction changes; or, for one\n"
    "slot, how many it takes and what a little more or less room would change.";

constexpr const char* examples =
    "Lists are a,b,c; ranges are from:to:step, both ends included. A slot smaller\n"
    "than the car is a row without an answer. Without --max-changes, and with one\n"
    "--length and one --width, the answer is about that slot; its rows are the\n"
    "shortest slots of its width for one change fewer, for its own count and for\n"
    "what the next shorter slot needs.\n\n"
    "Examples:\n"
    "  snug min-slot --car renault-zoe --max-changes 0,1,2,5,10 --width 1.8:2.4:0.1\n"
    "  snug min-slot --car my-car.json --max-changes 2 --length 5:6:0.1 --format csv\n"
    "  snug min-slot --car vw-transporter --extra-length 0.8 --extra-width 0.3\n\n"
    "Exit codes: 0 solved; 1 understood, and no row has an answer; 2 bad input, with\n"
    "one line that says what is wrong.";

struct Question {
    Car car;
    Given given = Given::width;
    std::vector<double> sizes;  ///< the widths or lengths given
    std::vector<int> max_changes;
    MinSlotOptions options;
    Strategy strategy;
    double step = 0.01;  ///< of the paper's loop [m]
    int threads = 0;
};

bool is_typed(const Options& options, const std::string& name) {
    return options.typed("--" + name) != nullptr || options.typed("--extra-" + name) != nullptr;
}

/// The widths or lengths asked about.
std::vector<double> sizes(const Options& options, const std::string& name, double car_size) {
    const std::string direct = "--" + name;
    const std::string extra = "--extra-" + name;
    const std::string* text = options.typed(direct);
    const std::string* extra_text = options.typed(extra);
    if (text != nullptr && extra_text != nullptr) {
        throw Error(direct + " and " + extra + " exclude each other; give one of them");
    }
    if (text != nullptr) return numbers(direct, *text, {" m", shortest, longest});
    std::vector<double> all = numbers(extra, *extra_text, {" m", shortest - car_size, longest - car_size});
    for (double& size : all) size = std::round((car_size + size) * 1e12) / 1e12;  // 1.781, not 1.7809999999999999
    return all;
}

double one_size(const Options& options, const std::string& name, double car_size) {
    const std::vector<double> all = sizes(options, name, car_size);
    if (all.size() > 1) {
        throw Error("--" + name + " is a list, but without --max-changes one slot is asked about; give one " + name +
                    ", or --max-changes and either lengths or widths");
    }
    return all.front();
}

std::vector<int> counts(const Options& options) {
    const std::string* text = options.typed("--max-changes");
    if (text == nullptr) {
        throw Error("--max-changes is missing; give the direction changes allowed, for example 0,1,2,5,10");
    }
    std::vector<int> all;
    for (const double count : numbers("--max-changes", *text, {"", 0.0, most_changes})) {
        all.push_back(static_cast<int>(count));
    }
    return all;
}

/// max-steer, or stepping with the step of its loop.
void set_strategy(const Options& options, Question& question) {
    static_cast<void>(options.choice("--strategy", {"max-steer", "fewest", "stepping"}));  // no trials
    question.strategy = strategy(options);
    const bool stepping = std::holds_alternative<Stepping>(question.strategy);
    const char* used = question.given == Given::width ? "--length-step" : "--width-step";
    const char* unused = question.given == Given::width ? "--width-step" : "--length-step";
    for (const char* option : {used, unused}) {
        if (!stepping && options.typed(option) != nullptr) {
            throw Error(std::string(option) + " belongs to --strategy stepping; leave it out or give that strategy");
        }
    }
    if (options.typed(unused) != nullptr) {
        throw Error(std::string(unused) + " is of no use here; give " + used + ", or leave it out");
    }
    question.step = options.number(used, question.step, 1e-5, 1e3, " m");
}

MinSlotOptions min_slot_options(const Options& options, const Car& car) {
    MinSlotOptions question;
    question.min_range = options.number("--min-range", 0.0, 0.0, std::numbers::pi / 2.0, " rad");
    question.driving.clearance = clearance(options);
    question.driving.enter = enter(options);
    const double usual = std::min(car.length() + 4.0, longest);
    const double max_length = options.number("--max-length", usual, shortest, longest, " m");
    question.longest = std::max(0.0, max_length - car.length() - 2.0 * question.driving.clearance);
    return question;
}

std::vector<MinSlotRow> answer(const Question& question, const std::vector<double>& sizes, const SweepOptions& sweep) {
    const bool width = question.given == Given::width;
    if (const auto* stepping = std::get_if<Stepping>(&question.strategy)) {
        const auto loop = width ? min_lengths_by_stepping : min_widths_by_stepping;
        return loop(question.car, sizes, question.max_changes, *stepping, question.step, question.options, sweep);
    }
    const auto exactly = width ? min_lengths : min_widths;
    return exactly(question.car, sizes, question.max_changes, question.options, sweep);
}

/// From counts outside to counts inside, so that what belongs to one width (or length) stands together.
std::vector<MinSlotRow> counts_inside(const std::vector<MinSlotRow>& rows, std::size_t counts) {
    std::vector<MinSlotRow> turned;
    const std::size_t sizes = rows.size() / counts;
    for (std::size_t i = 0; i < sizes; ++i) {
        for (std::size_t k = 0; k < counts; ++k) turned.push_back(rows[k * sizes + i]);
    }
    return turned;
}

std::string row_json(Given given, const MinSlotRow& row) {
    Json json = {{"max_changes", row.max_changes}, {"width", nullptr}, {"length", nullptr}, {"entry_heading", nullptr}};
    json[given == Given::width ? "width" : "length"] = row.given;
    if (row.slot) {
        json[given == Given::width ? "length" : "width"] = given == Given::width ? row.slot->length : row.slot->width;
        json["entry_heading"] = row.slot->entry_heading;
    }
    std::string text = write(json);
    text.pop_back();
    return text;
}

std::string row_csv(Given given, const MinSlotRow& row) {
    const std::string size = write(row.given);
    const std::string found = !row.slot ? "" : write(given == Given::width ? row.slot->length : row.slot->width);
    return std::to_string(row.max_changes) + ',' + (given == Given::width ? size + ',' + found : found + ',' + size) +
           ',' + (row.slot ? write(row.slot->entry_heading) : "") + '\n';
}

/// The answer part by part, for it may be too long to hold.
class Report {
public:
    Report(const Question& question, Format format, const std::string& path) : question_(question), format_(format) {
        if (!path.empty()) file_.emplace("--output", path);
        switch (format) {
            case Format::text: text_ = heading(); break;
            case Format::csv: text_ = "max_changes,width,length,entry_heading\n"; break;
            case Format::json: {
                const Json json = {{"schema", 1},
                                   {"car", as_json(question.car)},
                                   {"strategy", to_string(question.strategy)},
                                   {"rows", Json::array()}};
                text_ = write(json);
                const std::size_t rows = text_.rfind("[]");
                end_ = text_.substr(rows + 1);
                text_.resize(rows + 1);
            }
        }
    }

    void add(const std::vector<MinSlotRow>& rows) {
        if (format_ == Format::text) text_ += min_slot_table(question_.given, rows, question_.max_changes.size());
        for (const MinSlotRow& row : rows) {
            any_ = any_ || row.slot;
            if (format_ == Format::csv) text_ += row_csv(question_.given, row);
            if (format_ == Format::json) text_ += (first_ ? "\n    " : ",\n    ") + row_json(question_.given, row);
            first_ = false;
            if (text_.size() > 1'000'000) flush();
        }
    }

    int finish() {
        if (format_ == Format::json) text_ += "\n  " + end_;
        if (format_ == Format::text) text_ += "Rounded up to millimetres; - where no slot will do.\n";
        flush();
        if (file_) file_->finish();
        return any_ ? solved : cannot_park;
    }

private:
    [[nodiscard]] std::string heading() const {
        const Car& car = question_.car;
        const bool width = question_.given == Given::width;
        return name(car) + " (" + fixed(car.length(), 3) + " x " + fixed(car.width(), 3) + " m): the " +
               (width ? "shortest" : "narrowest") + " slot [m] it parks in,\nby the slot's " +
               (width ? "width" : "length") + " [m] and the most direction changes allowed\n\n";
    }

    void flush() {
        if (file_) {
            file_->write(text_);
        } else {
            print(text_);
        }
        text_.clear();
    }

    const Question& question_;
    Format format_;
    std::optional<FileInParts> file_;
    std::string text_;  ///< not yet written
    std::string end_;   ///< of the JSON
    bool first_ = true;
    bool any_ = false;  ///< some row has an answer
};

int answer_all(const Question& question, Format format, const std::string& path) {
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
        const std::vector<MinSlotRow> rows = answer(question, some, sweep);
        if (show) wipe_progress();
        report.add(counts_inside(rows, count));
    }
    return report.finish();
}

int answer_one(Question question, double length, double width, Format format, const std::string& path) {
    const OneSlot one = one_slot(question.car, length, width, question.options);
    if (format == Format::text) {
        put_out(path, one_slot_text(one));
    } else {
        for (const MinSlotRow& row : one.rows) question.max_changes.push_back(row.max_changes);
        Report report(question, format, path);
        report.add(one.rows);
        report.finish();
    }
    return one.changes ? solved : cannot_park;
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

std::string fewest_written(const Car& car, const std::vector<FewestLengthRow>& rows, Format format) {
    if (format == Format::json) {
        Json json = {{"schema", 1}, {"car", as_json(car)}, {"strategy", "fewest"}, {"rows", Json::array()}};
        for (const FewestLengthRow& row : rows)
            json["rows"].push_back({{"max_changes", row.max_changes},
                                    {"width", row.width},
                                    {"length", number_or_null(row.found.length)},
                                    {"length_lower", row.found.length_lower}});
        return write(json);
    }
    if (format == Format::csv) {
        std::string text = "max_changes,width,length,length_lower\n";
        for (const FewestLengthRow& row : rows)
            text += std::to_string(row.max_changes) + ',' + write(row.width) + ',' +
                    (row.found.length ? write(*row.found.length) : "") + ',' + write(row.found.length_lower) + '\n';
        return text;
    }
    const auto up = [](double length) { return fixed(std::ceil(length * 1e3 - 1e-6) / 1e3, 3); };
    const auto down = [](double length) { return fixed(std::floor(length * 1e3 + 1e-6) / 1e3, 3); };
    std::vector<std::vector<std::string>> lines = {{"width", "changes", "impossible below", "parks in"}};
    for (const FewestLengthRow& row : rows)
        lines.push_back({fixed(row.width, 3), std::to_string(row.max_changes), down(row.found.length_lower),
                         row.found.length ? up(*row.found.length) : "-"});
    return name(car) + " (" + fixed(car.length(), 3) + " x " + fixed(car.width(), 3) +
           " m): the shortest slot [m] over all maneuvers,\nby the slot's width [m] and the most direction changes "
           "allowed\n\n" +
           table(lines, "rrrr");
}

/// --strategy fewest: two lengths for each width and count.
Action fewest_action(const Options& options, const Question& question) {
    if (question.given == Given::length)
        throw Error("--strategy: fewest finds lengths; give --width or --extra-width, and no lengths");
    FewestLengthOptions asked;
    asked.driving.clearance = question.options.driving.clearance;
    asked.driving.enter = question.options.driving.enter;
    asked.longest = question.options.longest;
    asked.resolution = options.number("--resolution", 0.0, 1e-9, longest, " m");
    return [question, asked, sizes = sizes(options, "width", question.car.width()), most = counts(options),
            chosen = format(options), path = output(options)] {
        SweepOptions sweep;
        sweep.threads = question.threads;
        sweep.progress = show_progress();
        const std::vector<FewestLengthRow> rows = min_lengths_fewest(question.car, sizes, most, asked, sweep);
        if (sweep.progress) wipe_progress();
        put_out(path, fewest_written(question.car, rows, chosen));
        const bool any = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.found.length; });
        return any ? solved : cannot_park;
    };
}

}  // namespace

Action parse_min_slot(const Arguments& arguments) {
    Options options("snug min-slot", purpose, examples);
    add_car(options);
    options.group("Slot");
    options.add("--max-changes", "LIST", "Direction changes allowed, one or several.");
    options.add("--width", "RANGE", "Widths to find the shortest slot for [m].");
    options.add("--length", "RANGE", "Lengths to find the narrowest slot for [m].");
    options.add("--extra-width", "RANGE", "Widths beyond the car's [m].");
    options.add("--extra-length", "RANGE", "Lengths beyond the car's [m].");
    options.add("--max-length", "M", "No longer slots [m] (4 m more than the car's length).");
    options.add("--min-range", "RAD", "Entry headings must hold a stretch that wide [rad]\n(0).");
    add_driving(options);
    options.group("Strategy");
    options.add("--strategy", "NAME",
                "max-steer (default): exactly; fewest: over all\nmaneuvers, between two proved lengths; stepping: the\n"
                "paper's loop over slots, for comparison.");
    options.add("--resolution", "M", "fewest: finest lattice [m] (a two-thousandth of the\ncar's length).");
    options.add("--length-step", "M", "stepping: between the lengths tried [m] (0.01).");
    options.add("--width-step", "M", "stepping: between the widths tried [m] (0.01).");
    options.add("--step", "M", "stepping: path of one step [m] (0.001).");
    options.add("--heading-step", "RAD", "stepping: between entry headings [rad] (0.0001).");
    options.add("--stop", "WHEN",
                "stepping: looks whether the car is parked on\ncontact (default), or after every step: inside.");
    add_output(options);
    add_threads(options);
    if (!options.read(arguments)) return say(options.help());

    Question question{car(options), Given::width, {}, {}, {}, MaxSteer{}};
    const Car& the_car = question.car;
    const bool width = is_typed(options, "width");
    const bool length = is_typed(options, "length");
    if (!width && !length) {
        throw Error("--width is missing; give --width or --extra-width, or --length or --extra-length, in metres");
    }
    question.given = width ? Given::width : Given::length;
    question.options = min_slot_options(options, the_car);
    if (options.typed("--threads") != nullptr) question.threads = threads(options);
    set_strategy(options, question);
    if (const std::string* name = options.typed("--strategy"); name != nullptr && *name == "fewest") {
        if (width && length) throw Error("--strategy: fewest finds lengths; leave out --length");
        if (options.typed("--min-range") != nullptr)
            throw Error("--min-range asks for headings, but fewest has none; leave it out or change --strategy");
        return fewest_action(options, question);
    }
    const Format chosen = format(options);
    if (width && length) {
        if (options.typed("--max-changes") != nullptr) {
            throw Error("--length and --width are both given, and --max-changes; leave out one of the three");
        }
        if (!std::holds_alternative<MaxSteer>(question.strategy)) {
            throw Error(
                "--strategy: one slot is answered for max-steer only; leave it out, or give --max-changes and "
                "either lengths or widths");
        }
        return [question, slot_length = one_size(options, "length", the_car.length()),
                slot_width = one_size(options, "width", the_car.width()), chosen,
                path = output(options)] { return answer_one(question, slot_length, slot_width, chosen, path); };
    }
    if (length && options.typed("--max-length") != nullptr) {
        throw Error("--max-length belongs to --width; leave it out where the length is given");
    }
    question.max_changes = counts(options);
    question.sizes = width ? sizes(options, "width", the_car.width()) : sizes(options, "length", the_car.length());
    return
        [question = std::move(question), chosen, path = output(options)] { return answer_all(question, chosen, path); };
}

}  // namespace snug::cli
