// Every claim of the paper's results beside the answer with the paper's own steps and the exact one.
#pragma once

#include <vector>

#include "paper/headings.hpp"
#include "paper/minima.hpp"
#include "paper/trials.hpp"
#include "paper/work.hpp"

namespace snug::paper {

/// What the figures show, from which claims are judged.
struct Evidence {
    std::vector<CarMinima> minima;
    std::vector<SlotHeadings> over_width;
    std::vector<SlotHeadings> over_length;
    std::vector<SlotHeadings> stepped_over_width;
    std::vector<TrialsInSlot> trials;
};

/// claims.json: a list of {id, section, claim, unit, published, paper_steps, exact, agrees, finding}. A claim is a number
/// (direction changes or metres), or a statement that is true or false; a value that was not computed is null.
File claims(const Evidence& evidence, Work& work);

}  // namespace snug::paper
