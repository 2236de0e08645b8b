// One build spread over the processes that mpirun started. The first owns the database and hands out what is missing, batch
// by batch, to whoever asks; all of them solve.
#pragma once

#include "cluster/messages.hpp"
#include "snug/atlas_database.hpp"

namespace snug::cluster {

/// The first process, as it deals with the others.
class Coordinator {
public:
    explicit Coordinator(Messages& messages) : messages_(messages) {}

    /// As build_atlas(), with everybody's help. Throws also what went wrong with the others.
    bool build(AtlasBuild& build, const AtlasBuildOptions& options);
    /// Lets them all go, whether or not there was anything to build.
    void dismiss(int exit_code);

private:
    void tell_all(MessageKind kind, const std::string& text = {});

    Messages& messages_;
    int working_ = 0;  ///< that have been given a task and have not reported back
};

/// What every other process does: solves what it is given until it is dismissed; returns the exit code it is told.
int serve(Messages& messages);

}  // namespace snug::cluster
