#include "cluster/mail.hpp"

#define OMPI_SKIP_MPICXX 1  // of mpi.h only what is C
#include <mpi.h>

#include <chrono>
#include <climits>
#include <cstdlib>
#include <thread>
#include <utility>

#include "snug/error.hpp"

namespace snug::cluster {

struct Mail::Sent {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
};

Mail::Mail() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // whatever fails in MPI ends all processes
}

Mail::~Mail() {
    while (!sent_.empty()) {
        std::this_thread::sleep_for(pause);
        forget_sent();
    }
    MPI_Finalize();
}

int Mail::processes() const {
    int count = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    return count;
}

int Mail::number() const {
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    return number;
}

void Mail::send(int receiver, Subject subject, std::string text) {
    if (text.size() > INT_MAX) throw Error("there are too many cars to tell other processes; split the fleet");
    Sent& sent = sent_.emplace_back(Sent{std::move(text)});
    MPI_Isend(sent.text.data(), static_cast<int>(sent.text.size()), MPI_BYTE, receiver, static_cast<int>(subject),
              MPI_COMM_WORLD, &sent.request);
}

std::optional<Letter> Mail::receive() {
    forget_sent();
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Letter letter = {status.MPI_SOURCE, Subject{status.MPI_TAG}, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(letter.text.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return letter;
}

Letter Mail::wait() {
    while (true) {
        if (std::optional<Letter> letter = receive()) return std::move(*letter);
        std::this_thread::sleep_for(pause);
    }
}

void Mail::abort(int exit_code) {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

void Mail::forget_sent() {
    sent_.remove_if([](Sent& sent) {
        int has_left = 0;
        MPI_Test(&sent.request, &has_left, MPI_STATUS_IGNORE);
        return has_left != 0;
    });
}

}  // namespace snug::cluster
