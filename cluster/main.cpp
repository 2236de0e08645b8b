// snug-mpi: `snug atlas build` as one of the processes that mpirun started. The first does what the command says; the others
// help it, need no files, and leave every word about the work to the first.
#include <csignal>

#include "cli/atlas.hpp"
#include "cli/output.hpp"
#include "cluster/build.hpp"
#include "snug/error.hpp"

namespace snug::cluster {
namespace {

int lead(Messages& messages, const cli::Arguments& words) {
    Coordinator coordinator(messages);
    const int exit_code = cli::answered("snug atlas: ", [&] {
        if (words.size() < 2 || words[0] != "atlas" || words[1] != "build")
            throw Error("snug-mpi builds atlases only; write atlas build and its options, or use snug");
        return cli::parse_atlas_build(
            {words.begin() + 2, words.end()},
            [&](AtlasBuild& build, const AtlasBuildOptions& options) { return coordinator.build(build, options); })();
    });
    coordinator.dismiss(exit_code);
    return exit_code;
}

/// mpirun hands every signal to all processes: the first decides what becomes of it, and those it needs must stay.
int follow(Messages& messages) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
    return serve(messages);
}

}  // namespace
}  // namespace snug::cluster

int main(int count, char** words) {
    using namespace snug::cluster;
    snug::cli::prepare_process();
    Messages messages;
    return messages.number() == 0 ? lead(messages, {words + (count > 0 ? 1 : 0), words + count}) : follow(messages);
}
