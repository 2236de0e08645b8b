#include "cluster/messages.hpp"

#define OMPI_SKIP_MPICXX 1  // of mpi.h only what is C
#include <mpi.h>

#include <chrono>
#include <climits>
#include <cstdlib>
#include <thread>
#include <utility>

#include "snug/error.hpp"

namespace snug::cluster {

struct Messages::Sent {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
};

Messages::Messages() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // whatever fails in MPI ends all processes
}

Messages::~Messages() {
    while (!sent_.empty()) {
        std::this_thread::sleep_for(pause);
        forget_sent();
    }
    MPI_Finalize();
}

int Messages::processes() const {
    int count = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    return count;
}

int Messages::number() const {
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    return number;
}

void Messages::send(int receiver, MessageKind kind, std::string text) {
    if (text.size() > INT_MAX) throw Error("there are too many cars to tell other processes; split the fleet");
    Sent& sent = sent_.emplace_back(Sent{std::move(text)});
    MPI_Isend(sent.text.data(), static_cast<int>(sent.text.size()), MPI_BYTE, receiver, static_cast<int>(kind),
              MPI_COMM_WORLD, &sent.request);
}

std::optional<Message> Messages::receive() {
    forget_sent();
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message = {status.MPI_SOURCE, MessageKind{status.MPI_TAG},
                       std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.text.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

Message Messages::wait() {
    while (true) {
        if (std::optional<Message> message = receive()) return std::move(*message);
        std::this_thread::sleep_for(pause);
    }
}

void Messages::abort(int exit_code) {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

void Messages::forget_sent() {
    sent_.remove_if([](Sent& sent) {
        int has_left = 0;
        MPI_Test(&sent.request, &has_left, MPI_STATUS_IGNORE);
        return has_left != 0;
    });
}

}  // namespace snug::cluster
