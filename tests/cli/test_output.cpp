// Answers come whole or not at all, wherever they go.
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>

#include "questions.hpp"

namespace snug::test {
namespace {

TEST(Output, AFileHoldsWhatStandardOutputWould) {
    const Folder folder;
    for (const std::string format : {"text", "json", "csv"}) {
        const std::string file = folder.file(format);
        const Result written = run(zoe + "--format " + format + " -o " + file);
        EXPECT_EQ(written.exit_code, 0) << written.err;
        EXPECT_EQ(written.out, "");
        EXPECT_EQ(contents(file), run(zoe + "--format " + format).out);
    }
    EXPECT_EQ(folder.files(), 3U) << "nothing else remains";
}

TEST(Output, AFileKeepsItsModeAndItsLink) {
    const Folder folder;
    const std::string file = folder.with("real", "old");
    chmod(file.c_str(), 0640);
    std::filesystem::create_symlink("real", folder.file("link"));
    EXPECT_EQ(run("cars -o " + folder.file("link")).exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(contents(file), run("cars").out);
    struct stat status = {};
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(Output, RefusedInputLeavesFilesAlone) {
    const Folder folder;
    const std::string old = folder.with("old", "old");
    expect_refusal(run(zoe + "--side up -o " + old), {"--side"});
    expect_refusal(run(zoe + "--draw " + folder.file("x.gif") + " -o " + old), {"--draw", ".svg, .pdf or .png"});
    expect_refusal(run(zoe + "--draw " + folder.file("none/x.svg") + " -o " + old), {"--draw", "none/x.svg"});
    EXPECT_EQ(contents(old), "old");
    EXPECT_EQ(folder.files(), 1U);
}

TEST(Output, PlacesThatCannotBeWritten) {
    const Folder folder;
    expect_refusal(run("cars -o " + folder.file("")), {"--output", "directory"});
    expect_refusal(run("cars -o " + folder.file("none/x")), {"--output", "none/x"});
    expect_refusal(run("cars -o /dev/full"), {"--output", "/dev/full", "No space left"});
    expect_refusal(run("cars", "/dev/full"), {"standard output", "No space left"});
    expect_refusal(run("cars", "-"), {"standard output"});
    expect_refusal(run(zoe, "/dev/full"), {"standard output", "No space left"});
    expect_refusal(run("--help", "/dev/full"), {"standard output"});
    expect_refusal(run({"cars", "-o", ""}), {"--output"});
    expect_refusal(run(zoe + "-o same.svg --draw same.svg"), {"--draw", "--output"});
    EXPECT_EQ(run("cars -o /dev/null").exit_code, 0);
}

TEST(Output, AFullDiskLeavesNothing) {
    const Folder folder;
    const std::string err = folder.file("err");
    const pid_t shell = fork();
    if (shell == 0) {
        const rlimit no_room = {100, 100};  // bytes a file may hold
        setrlimit(RLIMIT_FSIZE, &no_room);
        _exit(wait_for(start({"cars", "-o", folder.file("out")}, "/dev/null", err)));
    }
    EXPECT_EQ(wait_for(shell), 2);
    EXPECT_NE(contents(err).find("--output"), std::string::npos) << contents(err);
    EXPECT_EQ(folder.files(), 1U) << "only the error is there";
}

TEST(Output, AClosedPipeIsAnError) {
    const Folder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    const int writer = open(pipe.c_str(), O_WRONLY);
    const pid_t child = fork();
    if (child == 0) {
        dup2(writer, STDOUT_FILENO);
        close(reader);
        close(writer);
        const int err = open(folder.file("err").c_str(), O_WRONLY | O_CREAT, 0600);
        dup2(err, STDERR_FILENO);
        usleep(100'000);  // the parent closes the reading end meanwhile
        execl(snug_command(), "snug", "cars", nullptr);
        _exit(98);
    }
    close(reader);
    close(writer);
    EXPECT_EQ(wait_for(child), 2);
    EXPECT_NE(contents(folder.file("err")).find("standard output"), std::string::npos);
}

TEST(Output, CtrlCRemovesTheTemporaryFile) {
    const Folder folder;
    const std::string file = folder.file("out.json");
    const std::vector<std::string> question =
        words(zoe + "--format json --strategy stepping --heading-step 0.0002 -o " + file);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(wait_for(start(question, "/dev/null", "/dev/null")), 0);
    const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
    int interrupted = 0;
    for (const int signal : {SIGINT, SIGTERM}) {
        for (int part = 0; part < 20; ++part) {
            const auto delay = whole.count() * part / 20;
            const pid_t child = start(question, "/dev/null", "/dev/null");
            usleep(static_cast<useconds_t>(delay));
            kill(child, signal);
            int status = 0;
            waitpid(child, &status, 0);
            // The signal may come before the command has got to its first line.
            interrupted += WIFEXITED(status) && WEXITSTATUS(status) == 128 + signal ? 1 : 0;
            EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 128 + signal || WEXITSTATUS(status) <= 1);
            EXPECT_LE(folder.files(), 1U);
            if (std::filesystem::exists(file)) {
                EXPECT_EQ(contents(file).back(), '\n') << "a whole answer or none";
                std::filesystem::remove(file);
            }
        }
    }
    EXPECT_GT(interrupted, 0);
}

}  // namespace
}  // namespace snug::test
