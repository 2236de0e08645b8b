// Answers computed beforehand: an atlas opened, and looked up for one slot or many.
#include <algorithm>
#include <cmath>
#include <limits>

#include "module.hpp"
#include "snug/atlas.hpp"
#include "value.hpp"

namespace snug::python {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Objects share what is mapped.
struct OpenAtlas {
    std::string path;
    std::shared_ptr<const Atlas> atlas;
};

struct StoredFields {
    std::int64_t direction_changes = -1;
    std::int64_t lower_bound = 0;
    bool decided = true;
    double length = not_a_number;
    double width = not_a_number;
    double entry_heading = not_a_number;
};

std::vector<double> lengths_of(const Atlas& atlas) {
    std::vector<double> all;
    for (std::size_t i = 0; i < atlas.lengths(); ++i) all.push_back(atlas.length(i));
    return all;
}

std::vector<double> widths_of(const Atlas& atlas) {
    std::vector<double> all;
    for (std::size_t i = 0; i < atlas.widths(); ++i) all.push_back(atlas.width(i));
    return all;
}

/// The car of that name, or one equal to it.
std::size_t car_in(const Atlas& atlas, const py::object& wanted) {
    std::string names;
    for (std::size_t i = 0; i < atlas.cars(); ++i) {
        if (py::isinstance<Car>(wanted) ? atlas.car(i) == wanted.cast<Car>()
                                        : as_text(wanted, "car") == atlas.car_name(i))
            return i;
        names.append(names.empty() ? "" : ", ").append(atlas.car_name(i));
    }
    throw Error("car is " + std::string(py::repr(wanted)) + ", but the atlas has " + names);
}

double in_grid(const char* name, double asked, double least, double most) {
    if (!(asked >= least))
        throw Error(std::string(name) + " is " + few_digits(asked) + " m, but the atlas has " + name + "s from " +
                    few_digits(least) + " to " + few_digits(most) + " m; smaller slots have to be built first");
    return std::min(asked, most);
}

/// As the command looks it up: what is larger than all that is stored is answered by the largest, which fits into it.
AtlasAnswer found(const Atlas& atlas, std::size_t car, double length, double width) {
    const double stored_length = in_grid("length", length, atlas.length(0), atlas.length(atlas.lengths() - 1));
    const double stored_width = in_grid("width", width, atlas.width(0), atlas.width(atlas.widths() - 1));
    AtlasAnswer answer = atlas.look_up(car, stored_length, stored_width);
    if (answer.verdict == AtlasVerdict::damaged)
        throw Error("the part of the atlas that holds the answer is damaged; copy or export it again");
    if (length > stored_length || width > stored_width) {
        answer.lower_bound = 0;
        if (answer.verdict == AtlasVerdict::cannot_park) answer.verdict = AtlasVerdict::undecided;
    }
    return answer;
}

AskedAnswer look_up(const OpenAtlas& self, const Arguments& given) {
    const Atlas& atlas = *self.atlas;
    const std::size_t car = car_in(atlas, given.get<py::object>("car"));
    const auto slot = given.get<Slot>("slot");
    const AtlasAnswer stored = found(atlas, car, slot.length(), slot.width());
    AskedAnswer answer;
    answer.car = atlas.car(car);
    answer.slot = slot;
    answer.strategy = to_string(atlas.options().strategy);
    answer.max_changes = atlas.options().max_changes;
    answer.driving = atlas.options().driving;
    answer.cell = {stored.cell.length(), stored.cell.width()};
    const bool parks = stored.verdict == AtlasVerdict::parks;
    if (parks) {
        answer.direction_changes = stored.cell.direction_changes();
        answer.maneuver = maneuver(stored.cell, *answer.car, slot);
        for (std::size_t i = 0; i < stored.cell.ranges(); ++i) answer.ranges.push_back(stored.cell.range(i));
    }
    if (atlas.options().strategy == Strategy::fewest) {
        answer.lower_bound = stored.lower_bound;
        answer.proved = stored.verdict == AtlasVerdict::cannot_park ||
                        answer.direction_changes == std::optional<int>(stored.lower_bound);
    }
    answer.cancelled = stored.verdict == AtlasVerdict::undecided;
    return answer;
}

py::object look_ups(const OpenAtlas& self, const Arguments& given) {
    const Atlas& atlas = *self.atlas;
    const std::size_t car = car_in(atlas, given.get<py::object>("car"));
    const py::object together = py::module_::import("numpy").attr("broadcast_arrays")(given.get<Numbers>("lengths"),
                                                                                      given.get<Numbers>("widths"));
    const Numbers lengths(py::reinterpret_borrow<py::object>(py::list(together)[0]));
    const Numbers widths(py::reinterpret_borrow<py::object>(py::list(together)[1]));
    py::array_t<StoredFields> rows(std::vector<py::ssize_t>(lengths.shape(), lengths.shape() + lengths.ndim()));
    StoredFields* row = rows.mutable_data();
    for (py::ssize_t i = 0; i < lengths.size(); ++i, ++row) {
        const AtlasAnswer stored = found(atlas, car, lengths.data()[i], widths.data()[i]);
        *row = StoredFields{};
        row->decided = stored.verdict != AtlasVerdict::undecided;
        row->lower_bound = stored.lower_bound;
        row->length = stored.cell.length();
        row->width = stored.cell.width();
        if (stored.verdict != AtlasVerdict::parks) continue;
        row->direction_changes = *stored.cell.direction_changes();
        row->entry_heading = stored.cell.entry().heading;
    }
    return rows;
}

}  // namespace

void define_atlas(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(StoredFields, direction_changes, lower_bound, decided, length, width, entry_heading);
    const auto numbers = [](const std::vector<double>& all) {
        return py::object(Numbers(static_cast<py::ssize_t>(all.size()), all.data()));
    };
    const Signature signature("Atlas(path: " + path_type + ")");
    Value<OpenAtlas> type(
        module, "Atlas",
        signature.docstring(
            "Answers computed beforehand, in a file that `snug atlas export` wrote: open for look-ups.\n\n"
            "The file must not be changed while it is open. Raises Error when it cannot be read, is no atlas or is "
            "damaged."));
    type.field("path", &OpenAtlas::path, "Where the file is.")
        .property(
            "cars",
            [](const OpenAtlas& a) {
                std::vector<Car> all;
                for (std::size_t i = 0; i < a.atlas->cars(); ++i) all.push_back(a.atlas->car(i));
                return all;
            },
            "In alphabetical order of their names.")
        .property(
            "lengths", [numbers](const OpenAtlas& a) { return numbers(lengths_of(*a.atlas)); }, "Rising [m]",
            "NDArray[np.float64]")
        .property(
            "widths", [numbers](const OpenAtlas& a) { return numbers(widths_of(*a.atlas)); }, "Rising [m]",
            "NDArray[np.float64]")
        .property(
            "strategy", [](const OpenAtlas& a) { return a.atlas->options().strategy; },
            "'max-steer', full steering, or 'fewest', over all maneuvers.")
        .property(
            "max_changes", [](const OpenAtlas& a) { return a.atlas->options().max_changes; }, "As solved.")
        .property(
            "min_range", [](const OpenAtlas& a) { return a.atlas->options().min_range; }, "As solved [rad].")
        .property(
            "clearance", [](const OpenAtlas& a) { return a.atlas->options().driving.clearance; }, "As solved [m].")
        .property(
            "enter", [](const OpenAtlas& a) { return a.atlas->options().driving.enter; }, "As solved.")
        .property(
            "made_by", [](const OpenAtlas& a) { return std::string(a.atlas->made_by()); },
            "The version of snug whose answers these are.")
        .constructor(signature,
                     [](const Arguments& given) {
                         OpenAtlas made;
                         made.path = py::str(py::module_::import("os").attr("fspath")(given.get<py::object>("path")));
                         made.atlas = std::make_shared<const Atlas>(made.path);
                         return made;
                     })
        .finish();
    define_method(type, "look_up(self, car: Car | str, slot: Slot) -> Answer",
                  "What is stored for one car, or the name of one, in the nearest stored slot that is no longer and no "
                  "wider,\n"
                  "as an Answer whose `cell` is the size of that slot. Where that slot is too small and nothing is "
                  "proved of\n"
                  "the one asked about it is `cancelled`. Raises Error for slots smaller than all that are stored.",
                  look_up);
    define_method(
        type, "look_ups(self, car: Car | str, lengths: ArrayLike, widths: ArrayLike) -> NDArray[np.void]",
        "The same for many slots, lengths and widths broadcast: a structured array with direction_changes (-1\n"
        "where no maneuver is stored), lower_bound, decided, length and width of the stored slot [m], and\n"
        "entry_heading [rad] (NaN where there is none).",
        look_ups);
}

}  // namespace snug::python
