// Does README.md and everything in docs/ show what really works and is really printed?
//
// console: lines "$ snug ..." or "$ cat" of a file that it wrote, each followed by its output. sh: commands, one a line;
// a single "build/release/snug ..." may be followed by a block with its output; a make target must be in the Makefile, and
// everything else in a test. cpp and cmake: part of an example or of the project that tests the package. json: a car.
// python: run by tests/python. {...}: for Sphinx.
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

namespace snug::test {
namespace {

const std::filesystem::path root = SNUG_ROOT;

/// What stands between two fences.
struct Block {
    std::string kind;
    std::string text;
    bool follows_at_once = false;  ///< nothing but an empty line since the block before
};

std::vector<Block> blocks(const std::filesystem::path& file) {
    std::vector<Block> found;
    bool inside = false;
    bool text_between = true;
    std::istringstream lines(contents(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("```", 0) == 0) {
            if (!inside) found.push_back({line.substr(3), "", !text_between});
            inside = !inside;
            text_between = false;
        } else if (inside) {
            found.back().text += line + "\n";
        } else {
            text_between = text_between || !line.empty();
        }
    }
    return found;
}

/// Words one by one; numbers may differ in their last digits, which depend on the machine's sines.
void expect_alike(const std::string& printed, const std::string& shown, const std::string& where) {
    const auto words = [](std::string text) {
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream in(text);
        return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
    };
    const std::vector<std::string> b = words(shown);
    std::vector<std::string> a = words(printed);
    const auto dots = std::find(b.begin(), b.end(), "...");
    if (dots != b.end() && a.size() >= b.size()) {  // what they stand for is left out
        const auto left_out = a.begin() + (dots - b.begin());
        *left_out = "...";
        a.erase(left_out + 1, a.end() - (b.end() - dots - 1));
    }
    ASSERT_EQ(a.size(), b.size()) << where << "\nprints\n" << printed;
    for (std::size_t i = 0; i < a.size(); ++i) {
        char* end = nullptr;
        const double number = std::strtod(a[i].c_str(), &end);
        const bool near = *end == '\0' && std::abs(number - std::strtod(b[i].c_str(), nullptr)) < 1e-7;
        EXPECT_TRUE(a[i] == b[i] || near) << where << "\nprints " << a[i] << " and not " << b[i];
    }
}

/// Works in a new folder, with an empty build/ in it, until it goes away.
class Elsewhere {
public:
    Elsewhere() {
        std::filesystem::current_path(folder_.file(""));
        std::filesystem::create_directory("build");
    }
    ~Elsewhere() { std::filesystem::current_path(before_); }
    Elsewhere(const Elsewhere&) = delete;
    Elsewhere& operator=(const Elsewhere&) = delete;

private:
    Folder folder_;
    std::filesystem::path before_ = std::filesystem::current_path();
};

/// Commands with their outputs.
void check_console(const std::string& text, const std::string& where) {
    const Elsewhere elsewhere;
    std::string command;
    std::string output;
    std::istringstream lines(text);
    const auto expect = [&] {
        if (command.empty()) return;
        const std::string what = where + " shows: " + command;
        if (command.rfind("cat ", 0) == 0) {
            const std::string file = command.substr(4);
            expect_alike(contents(file), output, what);
        } else {
            ASSERT_EQ(command.rfind("snug ", 0), 0U) << what;
            expect_alike(run(command.substr(5)).out, output, what);
        }
    };
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("$ ", 0) == 0) {
            expect();
            command = line.substr(2);
            output.clear();
        } else {
            output += line + "\n";
        }
    }
    EXPECT_NE(command, "") << where << " has a console block without a command: " << text;
    expect();
}

/// Everything below these folders and files, one after the other.
std::string all_of(const std::vector<std::string>& places) {
    std::string text;
    for (const std::string& place : places) {
        if (std::filesystem::is_directory(root / place)) {
            for (const auto& entry : std::filesystem::recursive_directory_iterator(root / place))
                if (entry.is_regular_file()) text += contents(entry.path()) + "\n";
        } else {
            text += contents(root / place);
        }
    }
    return text;
}

void check_shell(const Block& block, const Block* next, const std::string& where) {
    const Elsewhere elsewhere;
    const std::string built = "build/release/snug ";
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find(" #"));
        line.erase(line.find_last_not_of(' ') + 1);
        if (line.rfind(built, 0) == 0) {
            const Result result = run(line.substr(built.size()));
            EXPECT_LE(result.exit_code, 1) << where << ": " << line << '\n' << result.err;
            if (next != nullptr && next->kind.empty() && next->follows_at_once)
                expect_alike(result.out, next->text, where + " shows: " + line);
        } else if (line.rfind("make ", 0) == 0) {
            EXPECT_NE(contents(root / "Makefile").find("\n" + line.substr(5) + ":"), std::string::npos)
                << where << ": " << line;
        } else {
            EXPECT_NE(all_of({"tests"}).find(line), std::string::npos) << where << ", but in no test: " << line;
        }
    }
}

void check_car(const std::string& text, const std::string& where) {
    const Folder folder;
    const Result result = run("cars " + folder.with("car.json", text));
    EXPECT_EQ(result.exit_code, 0) << where << ": " << text << result.err;
}

void check(const std::filesystem::path& file) {
    const std::string where = file.filename().string();
    const std::vector<Block> all = blocks(file);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Block& block = all[i];
        if (block.kind == "console") {
            check_console(block.text, where);
        } else if (block.kind == "sh") {
            check_shell(block, i + 1 < all.size() ? &all[i + 1] : nullptr, where);
        } else if (block.kind == "cpp" || block.kind == "cmake") {
            EXPECT_NE(all_of({"examples", "tests/consumer", "bindings/ompl"}).find(block.text), std::string::npos)
                << where << ", but in no example:\n"
                << block.text;
        } else if (block.kind == "json") {
            check_car(block.text, where);
        } else if (block.kind.empty()) {
            EXPECT_TRUE(i > 0 && all[i - 1].kind == "sh" && block.follows_at_once)
                << where << " has a block that nothing prints:\n"
                << block.text;
        } else {
            EXPECT_TRUE(block.kind == "python" || block.kind[0] == '{')
                << where << " has a block of an unknown kind, " << block.kind;
        }
    }
}

TEST(Docs, ShowWhatReallyWorks) {
    check(root / "README.md");
    for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") check(entry.path());
}

// docs/atlas.md asks the database some questions, set off by four spaces.
TEST(Docs, TheAtlasAnswersTheQuestionsShown) {
    const Folder folder;
    const std::string database = folder.file("two.sqlite");
    run("atlas build --cars renault-zoe,opel-corsa --width 1.8:2.2:0.1 --length 4.4:5.2:0.1 --db " + database);
    std::istringstream lines(contents(root / "docs/atlas.md"));
    std::string question;
    int asked = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("    SELECT ", 0) != 0 && question.empty()) continue;
        question += line + '\n';
        if (line.back() != ';') continue;
        const std::string ask = "sqlite3 -bail " + database + " <" + folder.with("question", question) + " >" +
                                folder.file("answer") + " 2>&1";
        EXPECT_EQ(std::system(ask.c_str()), 0) << question << contents(folder.file("answer"));
        EXPECT_NE(contents(folder.file("answer")), "") << question;
        question.clear();
        ++asked;
    }
    EXPECT_GT(asked, 0);
}

TEST(Docs, TheReadmesExampleIsTheFirstOne) {
    const std::string example = contents(root / "examples/01_first_answer.cpp");
    EXPECT_NE(contents(root / "README.md").find("```cpp\n" + example + "```"), std::string::npos);
}

}  // namespace
}  // namespace snug::test
