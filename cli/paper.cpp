// snug paper: the data of every figure of the paper and every claim of it, beside the exact answers.
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "paper/paper.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "Computes the paper again: a CSV file for each of its figures, claims.json with\n"
    "every claim beside the exact answer, and a table of how long slots must be.";

constexpr const char* examples =
    "Takes about a minute on two cores. Existing files are replaced, each as a whole;\n"
    "nothing is written before all is computed.\n\n"
    "Examples:\n"
    "  snug paper\n"
    "  snug paper --out results\n\n"
    "Exit codes: 0 done; 2 bad input.";

/// Makes the last folder of the path if it is missing, and says so before the work when it cannot be written.
void prepare_folder(const std::string& folder) {
    if (folder.empty()) throw Error("--out is empty; give a folder");
    struct stat status = {};
    if (stat(folder.c_str(), &status) != 0) {
        if (mkdir(folder.c_str(), 0777) != 0)
            throw Error("--out: cannot make the folder " + in_quotes(folder) + ": " +
                        std::generic_category().message(errno) + "; give a folder whose parent exists and is writable");
    } else if (!S_ISDIR(status.st_mode)) {
        throw Error("--out: " + in_quotes(folder) + " is a file; give a folder");
    }
    check_writable("--out", folder + "/claims.json");
}

}  // namespace

Action parse_paper(const Arguments& arguments) {
    Options options("snug paper", purpose, examples);
    const Option<std::string> out =
        options.group("Output").text("--out", "DIR", "The folder for the files, made if it is missing\n(snug-paper).");
    const Option<int> threads = threads_option(options);
    if (!options.read(arguments)) return say(options.help());
    const std::string folder = out.value_or("snug-paper");
    paper::Options paper_options;
    if (threads) paper_options.threads = *threads;
    return [folder, paper_options]() mutable {
        prepare_folder(folder);
        paper_options.progress = show_progress();
        const std::vector<paper::File> files = paper::regenerate(paper_options);
        wipe_progress();
        for (const paper::File& file : files) write_file("--out", folder + '/' + file.name, file.bytes);
        print(std::to_string(files.size()) + " files are in " + folder +
              ", among them claims.json and extra_lengths.md.\n");
        return solved;
    };
}

}  // namespace snug::cli
