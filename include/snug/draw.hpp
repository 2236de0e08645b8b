// Pictures of parking: one maneuver, or the set of entry positions, as SVG, PDF or PNG.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/park.hpp"
#include "snug/park_map.hpp"
#include "snug/scene.hpp"
#include "snug/slot.hpp"

namespace snug {

enum class PictureFormat { svg, pdf, png };

/// The format a file name asks for by its extension (.svg, .pdf, .png in any case); empty for any other.
std::optional<PictureFormat> picture_format(std::string_view file_name);

/// What people call what a car meets, in pictures and in text: "front neighbour". Programs read to_string().
std::string_view called(Obstacle obstacle);

/// What the answer was asked with.
struct PictureOptions {
    Driving driving = {};
    bool leaving = false;                        ///< draw_maneuver(): from the parked pose out onto the road
    std::vector<std::vector<Pose>> tracks = {};  ///< of a car that errs, below the maneuver of draw_park()
};

// All pictures lie in the slot's own frame with the road at the top, whatever the slot's corner and heading. A slot on
// the right is seen by cars that drive to the right, one on the left by cars that drive to the left; nothing is mirrored.
// Colours follow the paper: the slot is blue, entry positions are orange, goal positions green.
//
// They return the bytes of the whole file; the same input gives the same bytes. They throw std::runtime_error when Cairo
// fails (out of memory).

/// The answer's maneuver: slot and neighbours, entry and goal, the path of the rear axle centre, the frame at every
/// direction change, contacts, and a table of the moves. A car that cannot park stands at the parallel entry position.
std::string draw_maneuver(const Car& car, const Slot& slot, const Answer& answer, PictureFormat format,
                          const PictureOptions& options = {});

/// The same for any maneuver. One without moves shows the car at the parallel entry position.
std::string draw_maneuver(const Slot& slot, const Maneuver& maneuver, PictureFormat format,
                          const PictureOptions& options = {});
/// A maneuver alone, without what stands around; x runs to the right and y upward. It must have a move.
std::string draw_maneuver(const Maneuver& maneuver, PictureFormat format);

/// The paper's first two figures side by side: possible entry positions, and those found with their goal positions;
/// below them the headings on a scale.
std::string draw_entries(const Car& car, const Slot& slot, const Answer& answer, PictureFormat format,
                         const PictureOptions& options = {});

/// Where the car stands in a street, the way into the slot, and a table of the moves; without a maneuver the car alone.
std::string draw_park(const Car& car, const Street& street, const Pose& start, const ParkAnswer& answer,
                      PictureFormat format, const PictureOptions& options = {});
/// The same in a scene, whose x runs to the right and y upward.
std::string draw_park(const Car& car, const Scene& scene, const ParkAnswer& answer, PictureFormat format,
                      const PictureOptions& options = {});

/// A street coloured by the number of changes needed from every place in it, for the heading of a car that stands there.
std::string draw_map(const ParkMap& map, const Street& street, const Pose& start, PictureFormat format);
std::string draw_map(const ParkMap& map, const Scene& scene, PictureFormat format);

}  // namespace snug
