// Every process but the first: one thread for the messages, and solve_all() beside it. In the queue between them lie batches
// that were asked for in time, so that no solver waits for messages, and answers that are to be sent.
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
struct Outgoing {
    std::vector<std::string> answers;
    std::size_t wanted = 0;  ///< batches
    bool finished = false;   ///< and these are the last answers
};

class Queue {
public:
    /// With room for so many batches to lie ready.
    explicit Queue(std::size_t room) : room_(room) {}

    // What solvers do.
    CellBatch next() {
        std::unique_lock lock(mutex_);
        solvers_.wait(lock, [&] { return stopped_ || !batches_.empty(); });
        if (stopped_) return {};
        CellBatch batch = std::move(batches_.front());
        batches_.pop_front();
        sender_.notify_one();
        return batch;
    }
    void store(std::string answers) {
        const std::lock_guard lock(mutex_);
        outgoing_.answers.push_back(std::move(answers));
        sender_.notify_one();
    }
    void finish() {
        const std::lock_guard lock(mutex_);
        outgoing_.finished = true;
        sender_.notify_one();
    }
    bool go_on() {
        const std::lock_guard lock(mutex_);
        return !stopped_;
    }

    // What the thread for the messages does.
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
    Outgoing take() {
        std::unique_lock lock(mutex_);
        const auto wanted = [&] { return last_came_ ? 0 : room_ - batches_.size() - asked_; };
        sender_.wait_for(lock, Messages::pause,
                         [&] { return outgoing_.finished || !outgoing_.answers.empty() || wanted() > 0; });
        outgoing_.wanted = wanted();
        asked_ += outgoing_.wanted;
        return std::exchange(outgoing_, {});
    }

private:
    const std::size_t room_;
    std::mutex mutex_;
    std::condition_variable solvers_;
    std::condition_variable sender_;
    std::deque<CellBatch> batches_;
    std::size_t asked_ = 0;
    Outgoing outgoing_;
    bool last_came_ = false;
    bool stopped_ = false;
};

/// Returns what went wrong; empty when nothing did.
std::string work(Messages& messages, const std::string& text) try {
    const Task task = task_from(text);
    const int threads = threads_at_once(task.threads);
    Queue queue(4 * static_cast<std::size_t>(threads));
    std::string trouble;
    std::thread solver([&] {
        try {
            const CellQueue cells = {[&] { return queue.next(); },
                                     [&](const SolvedBatch& solved) { queue.store(to_bytes(solved)); }};
            solve_all(task.plan, cells, threads, [&] { return queue.go_on(); });
        } catch (const std::exception& error) {
            trouble = error.what();
        }
        queue.finish();
    });
    for (bool finished = false; !finished;) {
        Outgoing outgoing = queue.take();
        for (std::string& answers : outgoing.answers) messages.send(0, MessageKind::solved, std::move(answers));
        for (; outgoing.wanted > 0; --outgoing.wanted) messages.send(0, MessageKind::want);
        finished = outgoing.finished;
        while (const std::optional<Message> message = messages.receive()) {
            if (message->kind == MessageKind::batch) queue.bring(batch_from(message->text, task.plan.cars.size()));
            if (message->kind == MessageKind::stop) queue.stop();
        }
    }
    solver.join();
    return trouble;
} catch (const std::exception& error) {
    return error.what();
}

}  // namespace

int serve(Messages& messages) {
    while (true) {
        const Message message = messages.wait();
        if (message.kind == MessageKind::task) messages.send(0, MessageKind::done, work(messages, message.text));
        if (message.kind == MessageKind::leave) return std::stoi(message.text);
        // Whatever else comes was on its way when the work ended.
    }
}

}  // namespace snug::cluster
