#include "failures.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <memory>
#include <new>
#include <string>

#include "prosup/core/exception_text.h"
#include "prosup/core/unfinished.h"

namespace prosup {

namespace {

/// Is given back for the end of the program, which needs some itself.
std::unique_ptr<std::array<char, 1u << 20>> reserve;
/// The sentence on want of memory, ready for when there is none.
const char* no_memory = "";

/// Only the first time: clearing away may fail in its turn.
void say_once(const char* text) {
  static std::atomic_flag said = ATOMIC_FLAG_INIT;
  if (said.test_and_set())
    return;
  for (const char* part : {"prosup: ", text, "\n"})
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
      return; // nobody is there to read it
}

/// Whether the process has come near to the limit of its memory. Calls nothing that a signal
/// handler may not call.
bool is_short_of_memory() {
  constexpr double near = 0.85;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return false;
  std::array<char, 64> text{};
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  const bool is_read = file >= 0 && read(file, text.data(), text.size() - 1) > 0;
  if (file >= 0)
    close(file);
  return is_read && std::strtod(text.data(), nullptr) * static_cast<double>(sysconf(_SC_PAGESIZE)) >
                        near * static_cast<double>(limit.rlim_cur);
}

[[noreturn]] void end_now() {
  std::set_new_handler(nullptr);
  reserve.reset();
  signal(SIGALRM, [](int) { _exit(EXIT_FAILURE); });
  alarm(2); // s, should clearing away wait for a thread that waits for memory
  say_once(no_memory);
  abandon_unfinished();
  _exit(EXIT_FAILURE);
}

/// For exceptions that nobody catches, and for threads that cannot be started.
[[noreturn]] void on_terminate() {
  if (is_short_of_memory())
    end_now();
  std::string text = "A thread or a library of the program has failed.";
  if (const std::exception_ptr current = std::current_exception())
    try {
      std::rethrow_exception(current);
    } catch (const std::exception& exception) {
      text = text_of(exception);
    } catch (...) {
    }
  say_once(text.c_str());
  abandon_unfinished();
  signal(SIGABRT, SIG_DFL);
  std::abort();
}

extern "C" void on_crash(int number) {
  if (is_short_of_memory()) {
    say_once(no_memory);
    _exit(EXIT_FAILURE);
  }
  say_once("The program has crashed by a mistake in it or in a library; the next run into the same "
           "folder removes what is unfinished.");
  rlimit core{};
  if (getrlimit(RLIMIT_CORE, &core) != 0 || core.rlim_cur == 0)
    _exit(128 + number);
  signal(number, SIG_DFL);
  raise(number);
}

} // namespace

void end_without_memory() {
  static const std::string sentence = text_of(std::bad_alloc());
  no_memory = sentence.c_str();
  reserve = std::make_unique<std::array<char, 1u << 20>>();
  std::set_new_handler(end_now);
  std::set_terminate(on_terminate);
}

void end_on_crash() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    signal(number, on_crash);
}

} // namespace prosup
