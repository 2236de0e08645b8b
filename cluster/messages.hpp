// Messages between the processes of a build. Nobody ever waits for one: sending and looking for one return at
// once.
#pragma once

#include <chrono>
#include <list>
#include <optional>
#include <string>

namespace snug::cluster {

enum class MessageKind {
    task,    ///< to a worker: what is to be answered
    want,    ///< to the first: send me a batch
    batch,   ///< to a worker: cells to solve; none when nothing is left
    solved,  ///< to the first: cells and their answers
    stop,    ///< to a worker: finish nothing more
    done,    ///< to the first: I have stopped; with the reason when something went wrong
    leave,   ///< to a worker: the end, with the exit code
};

struct Message {
    int sender = 0;
    MessageKind kind = MessageKind::leave;
    std::string text;
};

/// This process among those that mpirun started. One at a time, and used by one thread.
class Messages {
public:
    Messages();
    /// Ends the exchange with the others, which must all do so.
    ~Messages();
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;

    [[nodiscard]] int processes() const;
    [[nodiscard]] int number() const;  ///< of this process; the first has 0

    /// Throws Error when the text is 2 GB or longer.
    void send(int receiver, MessageKind kind, std::string text = {});
    /// A message from anybody, when there is one; messages of one sender come in the order they were sent.
    std::optional<Message> receive();
    /// The next message, however long it takes.
    Message wait();
    /// How long one who has nothing else to do sleeps between two looks: a thousandth part of a core.
    static constexpr std::chrono::milliseconds pause{4};

    /// Ends all processes at once, whatever they do.
    [[noreturn]] static void abort(int exit_code);

private:
    void forget_sent();

    struct Sent;
    std::list<Sent> sent_;  // must stay where they are until they have left
};

}  // namespace snug::cluster
