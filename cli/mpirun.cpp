// snug itself needs no MPI: what does is a program of its own.
#include "cli/mpirun.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "cli/output.hpp"

namespace snug::cli {
namespace {

/// What Open MPI's mpirun tells each process; -1 without it.
int told(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? -1 : std::atoi(text);
}

}  // namespace

bool is_one_of_many(const Arguments& arguments) {
    return arguments.size() >= 2 && arguments[0] == "atlas" && arguments[1] == "build" &&
           told("OMPI_COMM_WORLD_SIZE") > 1;
}

int go_on_with_mpi(const Arguments& arguments) {
    std::error_code no_link;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", no_link).parent_path();
    const std::string program = folder / "snug-mpi";
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), program);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    if (told("OMPI_COMM_WORLD_RANK") == 0)
        complain(
            "snug atlas: there is no " + program +
            ", which builds with mpirun; install it (it is built where Open MPI's headers are), or leave out mpirun");
    return bad_input;
}

}  // namespace snug::cli
