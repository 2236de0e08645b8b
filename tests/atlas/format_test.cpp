// docs/atlas-format.md is right: the reader it shows, which shares nothing with the library, reads the same.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "cli/process.hpp"
#include "random_atlas.hpp"
#include "sample.hpp"

namespace snug {
namespace {

using namespace test;

/// Tells every cell as told() does.
const std::string teller = R"(
import sys
from math import copysign

parts = [f"{side} corner" for side in ("front-left", "rear-left", "rear-right", "front-right")]
parts += [f"{side} edge" for side in ("front", "left", "rear", "right")]
obstacles = ["front side", "rear side", "curb", "front corner", "rear corner"]
atlas = Atlas(sys.argv[1])
for c in range(len(atlas.names)):
    for w in range(len(atlas.widths)):
        for l in range(len(atlas.lengths)):
            changes, bound, proved, entry, ranges, moves = atlas.cell(c, w, l)
            assert (changes, bound) == atlas.look_up(atlas.names[c], atlas.lengths[l], atlas.widths[w])[:2]
            print(changes, bound, int(proved), "entry", *(f"{x:.17g}" for x in entry or (0, 0, 0)))
            for least, greatest, count, subrange in ranges:
                print("range", f"{least:.17g} {greatest:.17g}", count, subrange)
            for length, angle, contact in moves:
                words = ["backward" if copysign(1, length) < 0 else "forward", f"{angle:.17g} {abs(length):.17g}"]
                print("move", *words, *([parts[contact[0]], obstacles[contact[1]]] if contact else []))
)";

std::string documented_reader() {
    const std::string page = contents(std::filesystem::path(SNUG_ROOT) / "docs/atlas-format.md");
    const std::string begin = "```python\n";
    const std::size_t from = page.find(begin) + begin.size();
    return page.substr(from, page.find("```", from) - from);
}

TEST(AtlasFormat, TheDocumentedReaderReadsTheSame) {
    const Folder folder;
    const std::string program = folder.with("reader.py", documented_reader() + teller);
    for (int i = 0; i < sample(10, 200); ++i) {
        Random random(static_cast<std::uint64_t>(i));
        const WrittenAtlas written = random_atlas(random);
        std::string expected;
        for (const CellAnswer& answer : written.answers) expected += told(answer) + '\n';
        const std::string command = "/usr/bin/python3 " + program + ' ' + folder.with("atlas", written.bytes) + " > ";
        ASSERT_EQ(std::system((command + folder.file("told")).c_str()), 0) << "case " << i;
        ASSERT_EQ(contents(folder.file("told")), expected) << "case " << i;
    }
}

}  // namespace
}  // namespace snug
