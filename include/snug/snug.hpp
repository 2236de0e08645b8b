// Everything: the exact solver for parallel parking.
#pragma once

#include "snug/batch.hpp"
#include "snug/car.hpp"
#include "snug/contact.hpp"
#include "snug/entry.hpp"
#include "snug/error.hpp"
#include "snug/fewest.hpp"
#include "snug/geometry.hpp"
#include "snug/leave.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/min_slot.hpp"
#include "snug/slot.hpp"
#include "snug/stepping.hpp"
#include "snug/trials.hpp"
#include "snug/version.hpp"
#include "snug/waypoints.hpp"
