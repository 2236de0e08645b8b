// The `snug` command.
#include "cli/command.hpp"
#include "cli/output.hpp"

int main(int count, char** words) {
    snug::cli::prepare_process();
    return snug::cli::run({words + (count > 0 ? 1 : 0), words + count});
}
