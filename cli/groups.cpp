// Cars, slots, neighbours, ways of driving and files, as they are asked for on the command line.
#include "cli/groups.hpp"

#include <unistd.h>

#include <algorithm>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/words.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/io.hpp"
#include "snug/limits.hpp"

namespace snug::cli {
namespace {

constexpr double full_turn = 6.2832;  // as people round it; larger angles are degrees, or mistakes
constexpr Quantity size = {" m", limits::shortest, limits::longest};
constexpr Quantity extra = {" m", -limits::longest, limits::longest};
constexpr Quantity distance = {" m", 0.0, limits::longest};
constexpr Quantity coordinate = {" m", -limits::farthest, limits::farthest};
constexpr Quantity angle = {" rad", -full_turn, full_turn};

/// One side of the slot, given itself or by what it has beyond the car's.
double side_of_slot(const Option<double>& direct, const Option<double>& beyond, double car_size) {
    if (direct && beyond)
        throw Error(direct.name() + " and " + beyond.name() + " exclude each other; give one of them");
    if (direct) return *direct;
    if (!beyond)
        throw Error(direct.name() + " is missing; give " + direct.name() + " or " + beyond.name() + " in metres");
    check_between(beyond.name(), *beyond, limits::shortest - car_size, limits::longest - car_size, " m");
    return car_size + *beyond;
}

void check_setback(const Option<double>& setback, double width) {
    if (setback && *setback > width)
        throw Error(setback.name() + " is " + spelled(*setback) + " m, but the slot is only " + spelled(width) +
                    " m wide; give at most its width");
}

}  // namespace

Point point(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != 2)
        throw Error(option + ": " + in_quotes(text) + " is no point; write X,Y in metres, for example 12.5,-3");
    return {number(option, parts[0], coordinate), number(option, parts[1], coordinate)};
}

Pose pose(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != 3)
        throw Error(option + ": " + in_quotes(text) +
                    " is no pose; write X,Y,HEADING in metres and radians, for example -3.4,-0.9,0");
    return {number(option, parts[0], coordinate), number(option, parts[1], coordinate),
            number(option, parts[2], angle)};
}

CarOptions::CarOptions(Options& options)
    : name(options.group("Car").text(
          "--car", "NAME|FILE",
          "A name that `snug cars` lists, a JSON file (see\nsnug cars --help), or - for one on standard input.")) {}

Car CarOptions::car() const {
    if (!name) throw Error(name.name() + " is missing; give a name that `snug cars` lists, or a JSON file");
    try {
        return find_or_read_car(*name);
    } catch (const Error& error) {
        throw Error(name.name() + ": " + error.what());
    }
}

Car find_or_read_car(const std::string& name_or_file) {
    if (const std::optional<Car> known = find_car(name_or_file)) return *known;
    if (name_or_file == "-") return read_car("/dev/stdin");
    const bool is_file = name_or_file.find('/') != name_or_file.npos ||
                         (name_or_file.size() > 5 && name_or_file.substr(name_or_file.size() - 5) == ".json") ||
                         access(name_or_file.c_str(), F_OK) == 0;
    if (is_file) return read_car(name_or_file);
    throw Error(in_quotes(name_or_file) + " is no known car; " +
                did_you_mean(nearest_car_name(name_or_file),
                             "`snug cars` lists those there are, and a JSON file does as well"));
}

SlotOptions::SlotOptions(Options& options)
    : length(options.group("Slot").number("--length", "M", "Along the road, between the neighbours [m].", size)),
      width(options.number("--width", "M", "From the road to the curb [m].", size)),
      extra_length(options.number("--extra-length", "M", "Length beyond the car's, instead of --length [m].", extra)),
      extra_width(options.number("--extra-width", "M", "Width beyond the car's, instead of --width [m].", extra)),
      side(options.choice<Side>("--side", "SIDE", "Side of the road: right (default) or left.",
                                {{"right", Side::right}, {"left", Side::left}})),
      corner(options.declared<Point>("--corner", "X,Y", "Front corner at the road, in the world [m] (0,0).", point)),
      heading(options.number("--heading", "RAD", "Heading of a car parked parallel, in the world\n[rad] (0).", angle)) {
}

SlotDimensions SlotOptions::dimensions(const Car& car) const {
    SlotDimensions slot;
    slot.length = side_of_slot(length, extra_length, car.length());
    slot.width = side_of_slot(width, extra_width, car.width());
    slot.side = side.value_or(Side::right);
    slot.corner = corner.value_or({});
    slot.heading = heading.value_or(0.0);
    return slot;
}

NeighbourOptions::NeighbourOptions(Options& options)
    : front_setback(options.group("Neighbours and curb")
                        .number("--front-setback", "M",
                                "How much deeper than the road's edge the front\nneighbour begins [m] (0).", distance)),
      rear_setback(options.number("--rear-setback", "M", "Likewise the rear neighbour [m] (0).", distance)),
      curb(options.choice<Curb>(
          "--curb", "CURB", "high (default): it stops the whole car; low: only\nthe wheels, the body may pass over it.",
          {{"high", Curb::high}, {"low", Curb::low}})),
      curb_clearance(
          options.number("--curb-clearance", "M", "Distance to keep from the curb [m] (as --clearance).", distance)) {}

void NeighbourOptions::check_within(double width) const {
    check_setback(front_setback, width);
    check_setback(rear_setback, width);
}

void NeighbourOptions::describe(SlotDimensions& slot) const {
    check_within(slot.width);
    slot.front_setback = front_setback.value_or(0.0);
    slot.rear_setback = rear_setback.value_or(0.0);
    slot.curb = curb.value_or(Curb::high);
}

Option<double> angle_option(Options& options) {
    return options.group("Street").number(
        "--angle", "DEG",
        "Between the parked car and the street [degrees]: 0\n(parallel, default) to 90 (perpendicular).",
        {" degrees", 0.0, 90.0});
}

Option<double> stretch_option(Options& options) {
    return options.number("--stretch", "M", "How far ahead of and behind the slot the rear axle\nmay go [m] (10).",
                          {" m", 0.0, 1e4});
}

StreetOptions::StreetOptions(Options& options)
    : angle(angle_option(options)),
      road(options.number("--road", "M", "A wall along the street so far beyond the slot's edge\n[m] (none).", size)),
      stretch(stretch_option(options)) {}

Street StreetOptions::street(const SlotDimensions& slot) const {
    Street street;
    street.length = slot.length;
    street.width = slot.width;
    street.angle = std::min(angle.value_or(0.0) * degree, limits::quarter_turn);
    if (road) street.road = *road;
    street.stretch = stretch.value_or(street.stretch);
    street.side = slot.side;
    street.corner = slot.corner;
    street.heading = slot.heading;
    street.front_setback = slot.front_setback;
    street.rear_setback = slot.rear_setback;
    street.curb = slot.curb;
    return street;
}

BayOptions::BayOptions(Options& options) : car(options), slot(options), street(options), neighbours(options) {}

SlotDimensions BayOptions::dimensions(const Car& of) const {
    SlotDimensions described = slot.dimensions(of);
    neighbours.describe(described);
    return described;
}

Street BayOptions::bay(const Car& of, const Driving& driving) const {
    Street made = street.street(dimensions(of));
    made.enter = driving.enter;
    made.curb_clearance = driving.curb_clearance;
    return made;
}

ParkedOptions::ParkedOptions(Options& options)
    : heading(options.group("What counts as parked")
                  .number("--parked-heading", "DEG", "At most so far off parallel [degrees] (any heading).",
                          {" degrees", 0.0, 90.0})),
      curb(options.number("--parked-curb", "M",
                          "The car's nearest point at most so far from the\ncurb [m] (anywhere in the slot).",
                          distance)) {}

Parked ParkedOptions::parked() const {
    Parked parked;
    if (heading) parked.heading = *heading * degree;
    if (curb) parked.curb = *curb;
    return parked;
}

Option<double> clearance_option(Options& options) {
    return options.number("--clearance", "M", "Distance to keep from everything while driving\n[m] (0).", distance);
}

DrivingOptions::DrivingOptions(Options& options)
    : enter(options.group("Driving").choice<Enter>("--enter", "HOW", "backward (default), or forward: nose first.",
                                                   {{"backward", Enter::backward}, {"forward", Enter::forward}})),
      clearance(clearance_option(options)) {}

Driving DrivingOptions::driving() const {
    Driving driving;
    driving.clearance = clearance.value_or(0.0);
    driving.enter = enter.value_or(Enter::backward);
    return driving;
}

Driving DrivingOptions::driving(const NeighbourOptions& neighbours) const {
    Driving with_curb = driving();
    if (neighbours.curb_clearance) with_curb.curb_clearance = *neighbours.curb_clearance;
    return with_curb;
}

Option<double> resolution_option(Options& options, const std::string& finest_by_default, const std::string& begins) {
    return options.number("--resolution", "M",
                          begins + " lattice [m] (" + (finest_by_default[0] == 'e' ? "an " : "a ") + finest_by_default +
                              " of the\ncar's length).",
                          {" m", limits::finest, limits::longest});
}

Option<double> time_limit_option(Options& options, const std::string& begins) {
    return options.number("--time-limit", "S", begins + " with the bounds found by then [s].", {" s", 0.0, 1e9});
}

SteppingOptions::SteppingOptions(Options& options)
    : step(options.number("--step", "M", "stepping: path of one step [m] (0.001).", {" m", 1e-7, 1.0})),
      heading_step(options.number("--heading-step", "RAD", "stepping: between entry headings [rad] (0.0001).",
                                  {" rad", 1e-6, limits::quarter_turn})),
      stop(options.choice<StopRule>(
          "--stop", "WHEN",
          "stepping: looks whether the car is parked on\ncontact (default), or after every step: inside.",
          {{"contact", StopRule::contact}, {"inside", StopRule::inside}})) {}

Stepping SteppingOptions::stepping(bool asked_for) const {
    belongs_to(step, asked_for, "stepping");
    belongs_to(heading_step, asked_for, "stepping");
    belongs_to(stop, asked_for, "stepping");
    Stepping stepping;
    stepping.step = step.value_or(stepping.step);
    stepping.heading_step = heading_step.value_or(stepping.heading_step);
    stepping.stop = stop.value_or(stepping.stop);
    return stepping;
}

void refuse_for_baselines(Planner planner, const NeighbourOptions& neighbours, const ParkedOptions& parked) {
    if (planner == Planner::max_steer || planner == Planner::fewest) return;
    const auto refuse = [](const auto& option, bool plain) {
        if (option && !plain)
            throw Error(option.name() +
                        " is beyond what this strategy knows, which is the paper's slot; leave it out, or "
                        "give --strategy max-steer or fewest");
    };
    refuse(neighbours.front_setback, neighbours.front_setback.value_or(0.0) == 0.0);
    refuse(neighbours.rear_setback, neighbours.rear_setback.value_or(0.0) == 0.0);
    refuse(neighbours.curb, neighbours.curb.value_or(Curb::high) == Curb::high);
    refuse(neighbours.curb_clearance, false);
    refuse(parked.heading, false);
    refuse(parked.curb, false);
}

OutputOptions::OutputOptions(Options& options, const std::string& formats)
    : chosen(options.group("Output").choice<Format>(
          "--format", "FORMAT", formats, {{"text", Format::text}, {"json", Format::json}, {"csv", Format::csv}})),
      file(options.text("-o,--output", "FILE", "Write the answer there, whole or not at all.")) {}

Format OutputOptions::format_without_csv(const std::string& why_no_csv) const {
    if (format() == Format::csv) throw Error(chosen.name() + ": " + why_no_csv + "; write text or json");
    return format();
}

std::string OutputOptions::path() const {
    if (!file) return {};
    check_writable(file.name(), *file);
    return *file;
}

void refuse_same_file(const Option<std::string>& one, const Option<std::string>& other) {
    if (one && other && *one == *other)
        throw Error(one.name() + " and " + other.name() + " are the same file; give them different names");
}

Option<std::string> draw_option(Options& options) {
    return options.text("--draw", "FILE", "Draw a picture: FILE ends with .svg, .pdf or .png.");
}

std::optional<PictureFile> picture_file(const Option<std::string>& draw, const OutputOptions& output) {
    if (!draw) return std::nullopt;
    const std::optional<PictureFormat> format = picture_format(*draw);
    if (!format)
        throw Error(draw.name() + ": " + in_quotes(*draw) + " has no known extension; end it with .svg, .pdf or .png");
    refuse_same_file(draw, output.file);
    check_writable(draw.name(), *draw);
    return PictureFile{*draw, *format};
}

Option<int> threads_option(Options& options, const std::string& otherwise) {
    return options.whole_number("--threads", "N", "At most that many threads, 1 to 1024" + otherwise + ".", 1,
                                limits::most_threads);
}

int exit_code(const Answer& answer) {
    return answer.direction_changes ? solved : answer.proved ? cannot_park : undecided;
}

}  // namespace snug::cli
