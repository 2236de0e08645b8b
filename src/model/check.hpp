// Lives in sentences/ now, where the layers above may use it too.
#pragma once

#include "sentences/check.hpp"
