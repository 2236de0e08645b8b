// Long questions: they leave the interpreter to other threads, tell how far they are and end at Ctrl-C.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <future>

#include "arguments.hpp"
#include "snug/sweep.hpp"

namespace snug::python {

/// What the caller wants to hear, and whether he still wants the answer. Told at most every 20 ms, because taking the
/// interpreter from other threads may last 5.
class Progress {
public:
    explicit Progress(py::object callback) : callback_(std::move(callback)) {}

    /// False gives the question up. Called with the interpreter released, by the thread that asked.
    template <class... Part>
    bool tell(const Part&... part) {
        if (failure_) return false;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_) return true;
        next_ = now + std::chrono::milliseconds(20);
        const py::gil_scoped_acquire interpreter;
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (callback_.is_none()) return true;
            const py::object said = callback_(part...);
            if (said.is_none()) return true;  // a function that only prints
            const int going_on = PyObject_IsTrue(said.ptr());
            if (going_on < 0) throw py::error_already_set();
            return going_on == 1;
        } catch (const py::error_already_set&) {
            failure_ = std::current_exception();
            return false;
        }
    }
    /// Raises what the callback, or Ctrl-C, did.
    void check() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    py::object callback_;
    std::chrono::steady_clock::time_point next_{};
    std::exception_ptr failure_;
};

/// Asks with the interpreter released.
template <class Question>
auto released(const Question& question) {
    const py::gil_scoped_release interpreter;
    return question();
}

/// Asks a question that tells its own progress, on the thread that asked.
template <class Question>
auto interruptible(Progress& progress, const Question& question) {
    auto answer = released(question);
    progress.check();
    return answer;
}

/// Asks a question that uses all cores, on a thread of its own: Python hands Ctrl-C to the one that asked only.
template <class Question>
auto interruptible(Progress& progress, SweepOptions& sweep, const Question& question) {
    std::atomic<double> part = 0.0;
    std::atomic<bool> given_up = false;
    sweep.progress = [&](double done) {
        part = done;
        return !given_up;
    };
    auto answer = released([&] {
        auto future = std::async(std::launch::async, question);
        while (future.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
            if (!given_up && !progress.tell(part.load())) given_up = true;
        return future.get();
    });
    progress.check();
    return answer;
}

}  // namespace snug::python
