// Does README.md and everything in docs/ show what the command really prints?
//
// Two forms are checked: a block ```console with lines "$ snug ...", each followed by its output, and a block ```sh with
// one line "build/release/snug ..." followed by a block with its output.
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

namespace snug::test {
namespace {

const std::filesystem::path root = std::filesystem::path(__FILE__).parent_path() / "../..";

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

int check(const std::filesystem::path& file) {
    int commands = 0;
    const auto expect = [&](const std::string& arguments, const std::string& output) {
        expect_alike(run(arguments).out, output, file.filename().string() + " shows: snug " + arguments);
        ++commands;
    };
    const std::vector<Block> all = blocks(file);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string built = "build/release/snug ";
        if (all[i].kind == "sh" && all[i].text.rfind(built, 0) == 0 && i + 1 < all.size() && all[i + 1].kind.empty() &&
            all[i + 1].follows_at_once)
            expect(all[i].text.substr(built.size(), all[i].text.find('\n') - built.size()), all[i + 1].text);
        if (all[i].kind != "console") continue;
        std::string arguments;
        std::string output;
        std::istringstream lines(all[i].text);
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind("$ snug ", 0) != 0) {
                output += line + "\n";
                continue;
            }
            if (!arguments.empty()) expect(arguments, output);
            arguments = line.substr(7);
            output.clear();
        }
        expect(arguments, output);
    }
    return commands;
}

TEST(Docs, ShowWhatTheCommandPrints) {
    EXPECT_GE(check(root / "README.md"), 2);
    for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") check(entry.path());
}

TEST(Docs, TheReadmesExampleIsTheFirstOne) {
    const std::string example = contents(root / "examples/01_first_answer.cpp");
    EXPECT_NE(contents(root / "README.md").find("```cpp\n" + example + "```"), std::string::npos);
}

}  // namespace
}  // namespace snug::test
