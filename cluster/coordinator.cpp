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

bool Coordinator::build(AtlasBuild& build, const AtlasBuildOptions& options) {
    const std::size_t cars = build.plan().cars.size();
    tell_all(MessageKind::task, to_bytes(Task{{build.plan().cars, {}, {}, build.plan().options}, options.threads}));
    working_ = messages_.processes() - 1;

    std::atomic<bool> failed = false;  // here or elsewhere: then all stop
    std::atomic<bool> solving = true;
    const auto go_on = [&] { return !failed && (!options.go_on || options.go_on()); };
    std::exception_ptr solver_failure;
    std::thread solver([&] {
        try {
            const CellQueue queue = {[&] { return build.next(); },
                                     [&](const SolvedBatch& solved) { build.store(solved); }};
            solve_all(build.plan(), queue, options.threads, go_on);
        } catch (...) {
            solver_failure = std::current_exception();
            failed = true;
        }
        solving = false;
    });

    std::exception_ptr failure;
    const auto attend = [&](const Message& message) {
        switch (message.kind) {
            case MessageKind::want:
                messages_.send(message.sender, MessageKind::batch, to_bytes(go_on() ? build.next() : CellBatch{}));
                break;
            case MessageKind::solved:
                if (!failed) build.store(solved_from(message.text, cars));
                break;
            case MessageKind::done:
                --working_;
                if (!message.text.empty())
                    throw Error("process " + std::to_string(message.sender) + ": " + message.text);
                break;
            default: break;  // goes the other way
        }
    };
    std::optional<Clock::time_point> stopped;
    while (solving || (working_ > 0 && !(stopped && Clock::now() > *stopped + patience))) {
        try {
            if (!stopped && !go_on()) {
                stopped = Clock::now();
                tell_all(MessageKind::stop);
                if (!failed) build.commit();
            }
            if (const std::optional<Message> message = messages_.receive()) {
                attend(*message);
            } else {
                std::this_thread::sleep_for(Messages::pause);
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

void Coordinator::dismiss(int exit_code) {
    if (working_ > 0) Messages::abort(exit_code);  // one of them is dead, or deaf
    tell_all(MessageKind::leave, std::to_string(exit_code));
}

void Coordinator::tell_all(MessageKind kind, const std::string& text) {
    for (int process = 1; process < messages_.processes(); ++process) messages_.send(process, kind, text);
}

}  // namespace snug::cluster
