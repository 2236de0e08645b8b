// The first process: one thread serves the others, which never wait for a solver, while solve_all() works beside it.
#include <atomic>
#include <chrono>
#include <exception>
#include <string>
#include <thread>

#include "cluster/build.hpp"
#include "cluster/bytes.hpp"
#include "snug/error.hpp"

namespace snug::cluster {
namespace {

using Clock = std::chrono::steady_clock;

// mpirun kills what has not ended a second after it asked: time enough to say how far the work has come.
constexpr std::chrono::milliseconds patience{500};

}  // namespace

bool Crew::build(AtlasBuild& build, const AtlasBuildOptions& options) {
    const std::size_t cars = build.plan().cars.size();
    tell_all(Subject::task, to_bytes(Task{{build.plan().cars, {}, {}, build.plan().options}, options.threads}));
    working_ = mail_.processes() - 1;

    std::atomic<bool> failed = false;  // here or elsewhere: then all stop
    std::atomic<bool> solving = true;
    const auto go_on = [&] { return !failed && (!options.go_on || options.go_on()); };
    std::exception_ptr solver_failure;
    std::thread solver([&] {
        try {
            const CellDesk desk = {[&] { return build.next(); },
                                   [&](const SolvedBatch& solved) { build.store(solved); }};
            solve_all(build.plan(), desk, options.threads, go_on);
        } catch (...) {
            solver_failure = std::current_exception();
            failed = true;
        }
        solving = false;
    });

    std::exception_ptr failure;
    const auto attend = [&](const Letter& letter) {
        switch (letter.subject) {
            case Subject::want:
                mail_.send(letter.sender, Subject::batch, to_bytes(go_on() ? build.next() : CellBatch{}));
                break;
            case Subject::solved:
                if (!failed) build.store(solved_from(letter.text, cars));
                break;
            case Subject::done:
                --working_;
                if (!letter.text.empty()) throw Error("process " + std::to_string(letter.sender) + ": " + letter.text);
                break;
            default: break;  // goes the other way
        }
    };
    std::optional<Clock::time_point> stopped;
    while (solving || (working_ > 0 && !(stopped && Clock::now() > *stopped + patience))) {
        try {
            if (!stopped && !go_on()) {
                stopped = Clock::now();
                tell_all(Subject::stop);
                if (!failed) build.commit();
            }
            if (const std::optional<Letter> letter = mail_.receive()) {
                attend(*letter);
            } else {
                std::this_thread::sleep_for(Mail::pause);
            }
            if (options.progress) options.progress(build.progress());
        } catch (...) {
            if (!failure) failure = std::current_exception();
            failed = true;
        }
    }
    solver.join();
    if (solver_failure) std::rethrow_exception(solver_failure);
    if (failure) std::rethrow_exception(failure);
    build.commit();
    const AtlasProgress progress = build.progress();
    return progress.stored == progress.cells;
}

void Crew::dismiss(int exit_code) {
    if (working_ > 0) Mail::abort(exit_code);  // one of them is dead, or deaf
    tell_all(Subject::leave, std::to_string(exit_code));
}

void Crew::tell_all(Subject subject, const std::string& text) {
    for (int process = 1; process < mail_.processes(); ++process) mail_.send(process, subject, text);
}

}  // namespace snug::cluster
