// Public now.
#pragma once

#include "snug/answer.hpp"
