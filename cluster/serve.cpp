// Every process but the first: one thread for the letters, and solve_all() beside it. On the desk between them lie batches
// that were asked for in time, so that no solver waits for the post, and answers that are to be sent.
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cluster/build.hpp"
#include "cluster/bytes.hpp"
#include "sweep/cores.hpp"

namespace snug::cluster {
namespace {

/// What is to be written to the first process.
struct Outbox {
    std::vector<std::string> answers;
    std::size_t wanted = 0;  ///< batches
    bool finished = false;   ///< and these are the last answers
};

class Desk {
public:
    /// With room for so many batches to lie ready.
    explicit Desk(std::size_t room) : room_(room) {}

    // What solvers do.
    CellBatch next() {
        std::unique_lock lock(mutex_);
        solvers_.wait(lock, [&] { return stopped_ || !batches_.empty(); });
        if (stopped_) return {};
        CellBatch batch = std::move(batches_.front());
        batches_.pop_front();
        post_.notify_one();
        return batch;
    }
    void store(std::string answers) {
        const std::lock_guard lock(mutex_);
        outbox_.answers.push_back(std::move(answers));
        post_.notify_one();
    }
    void finish() {
        const std::lock_guard lock(mutex_);
        outbox_.finished = true;
        post_.notify_one();
    }
    bool go_on() {
        const std::lock_guard lock(mutex_);
        return !stopped_;
    }

    // What the post does.
    void bring(CellBatch batch) {
        const std::lock_guard lock(mutex_);
        --asked_;
        last_came_ = last_came_ || batch.lengths.empty();
        batches_.push_back(std::move(batch));
        solvers_.notify_one();
    }
    void stop() {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        solvers_.notify_one();
    }
    /// Waits a little for something to send.
    Outbox take() {
        std::unique_lock lock(mutex_);
        const auto wanted = [&] { return last_came_ ? 0 : room_ - batches_.size() - asked_; };
        post_.wait_for(lock, Mail::pause, [&] { return outbox_.finished || !outbox_.answers.empty() || wanted() > 0; });
        outbox_.wanted = wanted();
        asked_ += outbox_.wanted;
        return std::exchange(outbox_, {});
    }

private:
    const std::size_t room_;
    std::mutex mutex_;
    std::condition_variable solvers_;
    std::condition_variable post_;
    std::deque<CellBatch> batches_;
    std::size_t asked_ = 0;
    Outbox outbox_;
    bool last_came_ = false;
    bool stopped_ = false;
};

/// Returns what went wrong; empty when nothing did.
std::string work(Mail& mail, const std::string& text) try {
    const Task task = task_from(text);
    const int threads = threads_at_once(task.threads);
    Desk desk(4 * static_cast<std::size_t>(threads));
    std::string trouble;
    std::thread solver([&] {
        try {
            const CellDesk cells = {[&] { return desk.next(); },
                                    [&](const SolvedBatch& solved) { desk.store(to_bytes(solved)); }};
            solve_all(task.plan, cells, threads, [&] { return desk.go_on(); });
        } catch (const std::exception& error) {
            trouble = error.what();
        }
        desk.finish();
    });
    for (bool finished = false; !finished;) {
        Outbox outbox = desk.take();
        for (std::string& answers : outbox.answers) mail.send(0, Subject::solved, std::move(answers));
        for (; outbox.wanted > 0; --outbox.wanted) mail.send(0, Subject::want);
        finished = outbox.finished;
        while (const std::optional<Letter> letter = mail.receive()) {
            if (letter->subject == Subject::batch) desk.bring(batch_from(letter->text, task.plan.cars.size()));
            if (letter->subject == Subject::stop) desk.stop();
        }
    }
    solver.join();
    return trouble;
} catch (const std::exception& error) {
    return error.what();
}

}  // namespace

int serve(Mail& mail) {
    while (true) {
        const Letter letter = mail.wait();
        if (letter.subject == Subject::task) mail.send(0, Subject::done, work(mail, letter.text));
        if (letter.subject == Subject::leave) return std::stoi(letter.text);
        // Whatever else comes was on its way when the work ended.
    }
}

}  // namespace snug::cluster
