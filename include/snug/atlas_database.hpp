// The database behind an atlas: built once over cars and slots, on one machine or many, asked and exported ever after.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "snug/atlas_build.hpp"

namespace snug {

/// Cells of one car (its place in the plan) and one width that are still to be solved.
struct CellBatch {
    std::size_t car = 0;
    double width = 0.0;           ///< [m]
    std::vector<double> lengths;  ///< [m]; none: nothing is left

    friend bool operator==(const CellBatch&, const CellBatch&) = default;
};

/// A batch and its answers: as many as lengths, or fewer when the work was given up.
struct SolvedBatch {
    CellBatch cells;
    std::vector<CellAnswer> answers;

    friend bool operator==(const SolvedBatch&, const SolvedBatch&) = default;
};

/// How far a build has come.
struct AtlasProgress {
    std::uint64_t stored = 0;  ///< cells in the database
    std::uint64_t solved = 0;  ///< of them by this build
    std::uint64_t cells = 0;   ///< that the atlas will have

    friend bool operator==(const AtlasProgress&, const AtlasProgress&) = default;
};

/// A database open for building. One at a time: a second one throws. May be used from many threads.
///
/// Answers are committed several times a second; whatever ends the process or the machine, what was committed stays and the
/// rest is missing, to be solved by the next build of the same plan.
class AtlasBuild {
public:
    /// Opens the database, or makes it. Cars, widths and lengths that are new are added to those it has; then every car is to
    /// be solved in every slot. Throws Error when the file cannot be written, is something else, is being built already, or
    /// holds what does not go together with the plan: other options, another version's answers, a car of the same name with
    /// other dimensions, widths or lengths that the plan has not.
    AtlasBuild(const std::string& path, const AtlasPlan& plan);
    ~AtlasBuild();
    AtlasBuild(const AtlasBuild&) = delete;
    AtlasBuild& operator=(const AtlasBuild&) = delete;

    /// All there is to solve: the plan with the cars that were in the database before.
    [[nodiscard]] const AtlasPlan& plan() const;
    [[nodiscard]] AtlasProgress progress() const;

    /// The next cells that are missing and that no earlier call has given out.
    CellBatch next();
    /// Keeps answers. Throws Error when there is no room.
    void store(const SolvedBatch& solved);
    /// Commits what is stored. Throws Error when there is no room.
    void commit();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Where cells come from and answers go. Neither is called from two threads at once, nor `next` again once it had none.
struct CellQueue {
    std::function<CellBatch()> next;
    std::function<void(const SolvedBatch&)> store;
};

/// Solves what the queue has on so many threads (0: all cores), until there is nothing left or `go_on`, which is asked from
/// all of them, says no. Throws what the queue throws.
void solve_all(const AtlasPlan& plan, const CellQueue& queue, int threads, const std::function<bool()>& go_on);

struct AtlasBuildOptions {
    int threads = 0;  ///< 0: all cores
    std::function<void(const AtlasProgress&)> progress =
        {};                            ///< told from time to time, never from two threads at once
    std::function<bool()> go_on = {};  ///< asked often, from many threads; false ends the build with what is stored
};

/// Solves every cell that is missing. True when none is left.
bool build_atlas(AtlasBuild& build, const AtlasBuildOptions& options = {});

/// A database to read; it may be under construction.
class AtlasDatabase {
public:
    /// Throws Error when the file cannot be read, is something else or of another version.
    explicit AtlasDatabase(const std::string& path);
    ~AtlasDatabase();
    AtlasDatabase(const AtlasDatabase&) = delete;
    AtlasDatabase& operator=(const AtlasDatabase&) = delete;

    /// Cars in alphabetical order, widths and lengths rising.
    [[nodiscard]] const AtlasPlan& plan() const;
    /// The version of snug whose answers these are.
    [[nodiscard]] const std::string& made_by() const;
    [[nodiscard]] std::uint64_t cells() const;   ///< that the atlas has when it is complete
    [[nodiscard]] std::uint64_t stored() const;  ///< that are solved

    /// What is stored for a car of the plan in a slot of the grid; empty when that cell is not solved yet.
    [[nodiscard]] std::optional<CellAnswer> cell(std::size_t car, double width, double length) const;
    /// Calls `take` with every stored cell: cars outside, then widths, lengths inside; until it says no.
    void each(const std::function<bool(std::size_t car, double width, double length, const CellAnswer&)>& take) const;
    /// What SQLite finds wrong with the file; empty when nothing is.
    [[nodiscard]] std::string trouble() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace snug
