#include "signals.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <thread>

#include "prosup/core/unfinished.h"
#include "start_up.h"

namespace prosup {

namespace {

constexpr int first_signal = 128; // exit codes, as a shell gives them
constexpr int n_patient = 2;      // signals after which the program ends without clearing away

// A handler may do almost nothing; it wakes a thread, which may do everything, also while the rest
// of the program is deep in a library or waits for another rank.
int wake_up[2] = {-1, -1};
std::atomic<int> n_received{0};

/// Whether nobody reads standard output any more. A lost connection of MPI also gives SIGPIPE.
bool output_is_closed() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

extern "C" void on_signal(int number) {
  const int error = errno;
  if (number != SIGPIPE && ++n_received > n_patient)
    _exit(first_signal + number);
  const auto byte = static_cast<unsigned char>(number);
  if (number != SIGPIPE || output_is_closed())
    while (write(wake_up[1], &byte, 1) < 0 && errno == EINTR) {
    }
  errno = error;
}

void say(const std::string& text) {
  const std::string line =
      std::string(isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + "prosup: " + text + "\n";
  if (write(STDERR_FILENO, line.data(), line.size()) < 0)
    return; // nobody is there to read it
}

/// Waits for a signal, for ever if none comes.
void end_on_signal() {
  unsigned char number = 0;
  while (read(wake_up[0], &number, 1) != 1) {
  }
  const bool was_at_work = abandon_unfinished();
  if (is_first_rank())
    say((number == SIGPIPE ? "Nobody reads the standard output any more"
                           : "Ended by a signal (" + std::string(strsignal(number)) + ")") +
        (was_at_work ? "; unfinished results were removed." : "."));
  _exit(first_signal + number);
}

} // namespace

void watch_signals() {
  // A file that grows beyond a limit is an error of writing, and is told as that.
  signal(SIGXFSZ, SIG_IGN);
  if (pipe2(wake_up, O_CLOEXEC) != 0)
    return; // without descriptors signals end the program as they always do
  std::thread(end_on_signal).detach();
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (const int number : {SIGHUP, SIGINT, SIGTERM, SIGXCPU, SIGUSR1, SIGUSR2, SIGPIPE}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN || number == SIGPIPE) // nohup lets SIGHUP be ignored
      sigaction(number, &action, nullptr);
  }
}

} // namespace prosup
