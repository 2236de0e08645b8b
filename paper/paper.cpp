#include "paper/paper.hpp"

#include "paper/claims.hpp"
#include "paper/headings.hpp"
#include "paper/minima.hpp"
#include "paper/scenes.hpp"
#include "paper/trials.hpp"
#include "paper/work.hpp"

namespace snug::paper {

namespace {

void append(std::vector<File>& files, std::vector<File> more) {
    for (File& file : more) files.push_back(std::move(file));
}

}  // namespace

std::vector<File> regenerate(const Options& options) {
    try {
        Work work(options);
        Evidence evidence;
        std::vector<File> files = scenes();
        work.stage(0.02);
        evidence.trials = trials_over_length(work);
        files.push_back(trials_file(evidence.trials));
        work.stage(0.04);
        evidence.over_width = headings_over_width(work);
        work.stage(0.12);
        evidence.over_length = headings_over_length(work);
        append(files, headings_files(evidence.over_width, evidence.over_length));
        work.stage(0.15);
        evidence.stepped_over_width = stepped_headings(work);
        work.stage(0.7);
        evidence.minima = minima(work);
        work.stage(0.95);
        add_stepped(evidence.minima, work);
        append(files, minima_files(evidence.minima));
        work.stage(0.96);
        append(files, extra_length_table(work));
        work.stage(1.0);
        files.push_back(claims(evidence, work));
        return files;
    } catch (const GivenUp&) {
        return {};
    }
}

}  // namespace snug::paper
