// Under mpirun an atlas comes out as it does from one process, and whatever dies on the way, the file is whole, the run ends
// and the same command completes it.
#include <chrono>
#include <thread>

#include "../cli/process.hpp"
#include "cluster/bytes.hpp"
#include "sample.hpp"
#include "snug/atlas_database.hpp"
#include "snug/error.hpp"

namespace snug::test {
namespace {

/// Enough cells for something to happen in their midst: 2222 of them, or 252 for a command that is slow with sanitizers.
const std::string grid = std::string(" --cars mid-size,renault-zoe") +
                         (is_set("SNUG_SMALL") ? " --width 1.9:2.4:0.1 --length 4.8:5.8:0.05"
                                               : " --width 1.9:2.4:0.05 --length 4.8:5.8:0.01");
const std::string small_fewest =
    " --cars renault-zoe --width 2,2.2 --length 5.2:5.6:0.2 --strategy fewest --resolution 0.01";

/// mpirun with so many processes of a command, which write to `folder`/out and err.
pid_t start_mpirun(const Folder& folder, int processes, const std::string& command, const std::string& line) {
    std::vector<std::string> all = {"mpirun", "--oversubscribe", "-n", std::to_string(processes), command};
    for (const std::string& word : words(line)) all.push_back(word);
    const pid_t child = fork();
    if (child == -1) std::abort();
    if (child != 0) return child;
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // Open MPI keeps what it has until the process ends
    std::freopen("/dev/null", "r", stdin);
    std::freopen(folder.file("out").c_str(), "w", stdout);
    std::freopen(folder.file("err").c_str(), "w", stderr);
    std::vector<char*> pointers;
    for (std::string& word : all) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execvp("mpirun", pointers.data());
    _exit(98);
}

Result mpirun(int processes, const std::string& line, const std::string& command = SNUG_COMMAND) {
    const Folder folder;
    Result result;
    result.exit_code = wait_for(start_mpirun(folder, processes, command, line));
    result.out = contents(folder.file("out"));
    result.err = contents(folder.file("err"));
    return result;
}

/// Every cell of a database with all that is stored of it, and the file exported from it.
std::string content(const Folder& folder, const std::string& path) {
    std::string all;
    AtlasDatabase(path).each([&](std::size_t car, double width, double length, const CellAnswer& answer) {
        all += cluster::to_bytes(SolvedBatch{{car, width, {length}}, {answer}});
        return true;
    });
    EXPECT_EQ(run("atlas export --db " + path + " -o " + folder.file("x.atlas")).exit_code, 0);
    return all + contents(folder.file("x.atlas"));
}

/// The process of that rank which mpirun started; 0 while there is none.
pid_t process_of(pid_t parent, int rank) {
    const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank);
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != name.npos) continue;
        const std::string status = contents(entry.path() / "status");
        if (status.find("\nPPid:\t" + std::to_string(parent) + '\n') == status.npos) continue;
        const std::string environment = '\0' + contents(entry.path() / "environ");
        if (environment.find('\0' + wanted + '\0') != environment.npos) return std::stoi(name);
    }
    return 0;
}

void strike(pid_t parent, int rank, int number) {
    if (const pid_t process = process_of(parent, rank); process > 0) kill(process, number);  // 0 would be ourselves
}

/// Waits until some cells are stored, or the work has ended.
bool has_begun(const std::string& path, pid_t child) {
    while (true) {
        try {
            if (AtlasDatabase(path).stored() > 0) return true;
        } catch (const Error&) {  // not made yet
        }
        siginfo_t info = {};
        if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

class Mpirun : public testing::Test {
protected:
    std::string build(const std::string& name, const std::string& what) {
        return "atlas build --db " + folder.file(name) + what;
    }
    /// Begins a build of three processes, does something to it, and completes it alone.
    void interrupt_and_resume(const std::function<void(pid_t)>& harm, bool told) {
        const pid_t child = start_mpirun(folder, 3, SNUG_COMMAND, build("hit", grid));
        const bool struck = has_begun(folder.file("hit"), child);
        if (struck) harm(child);
        const int exit_code = wait_for(child);
        const std::string err = contents(folder.file("err"));
        if (struck && AtlasDatabase(folder.file("hit")).stored() < AtlasDatabase(folder.file("hit")).cells()) {
            EXPECT_NE(exit_code, 0);
            EXPECT_FALSE(err.empty());
            if (told) {
                EXPECT_NE(err.find("goes on from there"), err.npos) << err;
            }
        }
        EXPECT_EQ(AtlasDatabase(folder.file("hit")).trouble(), "");
        // Processes that mpirun has given up on may hold the file for a moment more.
        Result again = run(build("hit", grid));
        for (int i = 0; i < 200 && again.err.find("is being built") != again.err.npos; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            again = run(build("hit", grid));
        }
        EXPECT_EQ(again.exit_code, 0) << again.err;
        ASSERT_EQ(run(build("one", grid)).exit_code, 0);
        EXPECT_TRUE(content(folder, folder.file("hit")) == content(folder, folder.file("one")));
    }

    Folder folder;
};

TEST_F(Mpirun, AnyNumberOfProcessesBuildsTheSame) {
    for (const std::string& what : {grid, small_fewest}) {
        const Folder fresh;
        const std::string one = fresh.file("one");
        ASSERT_EQ(run("atlas build --db " + one + what).exit_code, 0);
        const std::vector<int> numbers = is_set("SNUG_SMALL") ? std::vector{3} : std::vector{2, 3, 4};
        for (const int processes : numbers) {
            const std::string many = fresh.file(std::to_string(processes));
            const Result result = mpirun(processes, "atlas build --db " + many + what);
            EXPECT_EQ(result.exit_code, 0) << result.err;
            EXPECT_EQ(result.err, "");
            EXPECT_NE(result.out.find("All are stored"), result.out.npos) << result.out;
            EXPECT_TRUE(content(fresh, many) == content(fresh, one)) << processes;
        }
    }
}

TEST_F(Mpirun, WhatIsCompleteStaysSo) {
    ASSERT_EQ(run(build("a", small_fewest)).exit_code, 0);
    const Result again = mpirun(2, build("a", small_fewest));
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_NE(again.out.find(" 0 of them"), again.out.npos) << again.out;
}

TEST_F(Mpirun, AWorkerThatDiesEndsTheRunAndLosesNothing) {
    interrupt_and_resume([](pid_t child) { strike(child, 1, SIGKILL); }, false);
}

TEST_F(Mpirun, TheFirstThatDiesEndsTheRunAndLosesNothing) {
    interrupt_and_resume([](pid_t child) { strike(child, 0, SIGKILL); }, false);
}

TEST_F(Mpirun, InterruptedItSaysHowToGoOn) {
    interrupt_and_resume([](pid_t child) { kill(child, SIGINT); }, true);
}

TEST_F(Mpirun, ASignalToTheFirstEndsThemAll) {
    interrupt_and_resume([](pid_t child) { strike(child, 0, SIGTERM); }, true);
}

TEST_F(Mpirun, WrongInputIsToldOnce) {
    const Result result = mpirun(3, build("a", " --cars nobody --width 2 --length 5"));
    EXPECT_EQ(result.exit_code, 2);
    const std::size_t first = result.err.find("nobody");
    EXPECT_NE(first, result.err.npos) << result.err;
    EXPECT_EQ(result.err.find("nobody", first + 1), result.err.npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
}

TEST_F(Mpirun, HelpIsToldOnce) {
    const Result help = mpirun(2, "atlas build --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.out, run("atlas build --help").out);
}

TEST_F(Mpirun, WithoutItsProgramItSaysWhatIsMissing) {
    std::filesystem::copy(SNUG_COMMAND, folder.file("snug"));
    const Result result = mpirun(2, build("a", grid), folder.file("snug"));
    EXPECT_EQ(result.exit_code, 2);
    const std::size_t first = result.err.find("there is no " + folder.file("snug-mpi"));
    EXPECT_NE(first, result.err.npos) << result.err;
    EXPECT_EQ(result.err.find("there is no ", first + 1), result.err.npos) << result.err;
}

TEST_F(Mpirun, OtherCommandsStayWhatTheyAre) {
    const Result result = mpirun(2, "cars renault-zoe");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out.size(), 2 * run("cars renault-zoe").out.size());
}

}  // namespace
}  // namespace snug::test
