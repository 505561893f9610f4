#include "prosup/core/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "prosup/core/error.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

constexpr const char* lock_name = "lock";

std::string this_host() {
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

/// Who holds or held a lock, as it stands in the lock file.
struct Holder {
  pid_t process = 0;
  std::string host;

  explicit Holder(const fs::path& file) { std::ifstream(file) >> process >> host; }
  std::string text() const {
    return process == 0 ? "" : " (process " + std::to_string(process) + " on " + host + ")";
  }
  /// For file systems without locks; a process of another host may well be alive.
  bool may_be_alive() const {
    return process != 0 && (host != this_host() || kill(process, 0) == 0 || errno != ESRCH);
  }
};

enum class Attempt { got, held, moved, failed };

/// Tries to lock a file that `descriptor` has open.
Attempt try_lock(int descriptor, const fs::path& file) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK)
      return Attempt::held;
    if (Holder(file).may_be_alive())
      return Attempt::held;
  }
  // The former holder may have removed the file after it was opened here.
  struct stat opened {
  }, there{};
  if (fstat(descriptor, &opened) != 0 || stat(file.c_str(), &there) != 0 ||
      opened.st_ino != there.st_ino || opened.st_dev != there.st_dev)
    return Attempt::moved;
  return Attempt::got;
}

void note_holder(int descriptor) {
  const std::string text = std::to_string(getpid()) + " " + this_host() + "\n";
  if (ftruncate(descriptor, 0) == 0 && pwrite(descriptor, text.data(), text.size(), 0) < 0)
    return; // it is needed for messages only
}

/// Removes a folder while other ranks may still be writing to it.
void remove_stubbornly(const fs::path& folder) {
  std::error_code error;
  for (unsigned n = 0; n < 50 && fs::exists(folder, error); ++n) {
    fs::remove_all(folder, error);
    if (error)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

bool is_foreign(const fs::path& folder) {
  std::error_code error;
  return !fs::is_empty(folder, error) && !error && !fs::exists(folder / lock_name);
}

[[noreturn]] void throw_cannot_write_to(const std::string& what, const fs::path& folder,
                                        int reason) {
  std::error_code ignored;
  fs::remove(folder, ignored); // if it is empty
  throw Error("The output '" + what + "' cannot be written to (" + std::strerror(reason) +
              "); choose another place with --output.");
}

} // namespace

FolderLock::FolderLock(fs::path folder, const std::string& what) : folder_(std::move(folder)) {
  const fs::path file = folder_ / lock_name;
  Attempt attempt = Attempt::moved;
  while (attempt == Attempt::moved) {
    if (mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST)
      throw_cannot_write_to(what, folder_, errno);
    if (is_foreign(folder_))
      throw Error("The folder '" + folder_.string() +
                  "' is in the way of unfinished results and was not made by prosup; move it.");
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == ENOENT)
      continue;
    if (descriptor_ < 0)
      throw_cannot_write_to(what, folder_, errno);
    attempt = try_lock(descriptor_, file);
    if (attempt != Attempt::got)
      close(descriptor_);
    if (attempt == Attempt::held)
      throw Error("Another run" + Holder(file).text() + " is writing to '" + what +
                  "'; wait for its end or choose another place with --output.");
  }
  note_holder(descriptor_);
  remove_stubbornly(work());
  if (mkdir(work().c_str(), 0777) != 0) {
    const int reason = errno;
    clear();
    close(descriptor_);
    throw_cannot_write_to(what, folder_, reason);
  }
}

FolderLock::~FolderLock() {
  clear();
  close(descriptor_);
}

void FolderLock::clear() const {
  remove_stubbornly(work());
  std::error_code error;
  fs::remove(folder_ / lock_name, error);
  fs::remove(folder_, error);
}

bool FolderLock::clear_leftover(const fs::path& folder) {
  const fs::path file = folder / lock_name;
  const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  const bool free = try_lock(descriptor, file) == Attempt::got;
  if (free) {
    remove_stubbornly(folder / "result");
    std::error_code error;
    fs::remove(file, error);
    fs::remove(folder, error);
  }
  close(descriptor);
  return free;
}

} // namespace prosup
