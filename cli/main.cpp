// The `snug` command.
#include "cli/command.hpp"
#include "cli/mpirun.hpp"
#include "cli/output.hpp"

int main(int count, char** words) {
    snug::cli::prepare_process();
    const snug::cli::Arguments arguments(words + (count > 0 ? 1 : 0), words + count);
    return snug::cli::is_one_of_many(arguments) ? snug::cli::go_on_with_mpi(arguments) : snug::cli::run(arguments);
}
