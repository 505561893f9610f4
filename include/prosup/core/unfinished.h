#ifndef PROSUP_CORE_UNFINISHED_H
#define PROSUP_CORE_UNFINISHED_H

#include <functional>
#include <list>
#include <mutex>

namespace prosup {

/// What a process that is ended in the middle has to clear away: temporary files, child processes.
/// Lasts as long as the object. `clear` may run in another thread while this one goes on working.
class Unfinished {
public:
  explicit Unfinished(std::function<void()> clear);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

private:
  std::list<std::function<void()>>::iterator place_;
};

/// Clears away all that is unfinished, last first, for a program that is about to end. Waits for
/// what holds uninterrupted(); whoever asks for that afterwards waits for the end of the program.
/// @returns whether there was anything.
bool abandon_unfinished();

/// While the lock is held, abandon_unfinished() waits: for moving results into place, and for
/// error messages, which may be due to what was cleared away.
std::unique_lock<std::recursive_mutex> uninterrupted();

} // namespace prosup

#endif
