#ifndef PROSUP_CORE_REMAINING_TIME_H
#define PROSUP_CORE_REMAINING_TIME_H

#include <chrono>
#include <optional>
#include <string>

namespace prosup {

/// What a live line says of the time that remains. It counts down, and changes its mind only if a
/// new estimate differs by more than estimates do from each other, so that it does not flicker.
class Countdown {
public:
  /// The latest estimate, made at the time `now`; both s.
  void expect(double seconds, double now);
  void forget() { end_.reset(); }

  /// ", about 40 s left"; empty if nothing is known or hardly any time is left.
  std::string in_words(double now) const;

private:
  std::optional<double> end_; // s
};

/// A long piece of work that can tell how long it will still take, from its construction on. One
/// within another one is not heard: whoever waits wants to know of the whole. Log::progress()
/// shows what it says.
class RemainingTime {
public:
  RemainingTime();
  ~RemainingTime();
  RemainingTime(const RemainingTime&) = delete;
  RemainingTime& operator=(const RemainingTime&) = delete;

  /// Seconds since the construction.
  double elapsed() const;
  /// It will take `seconds` from now on, or nobody knows.
  void expect(const std::optional<double>& seconds);

  /// As Countdown::in_words(), of the outermost piece of work of this process.
  static std::string in_words();

private:
  const std::chrono::steady_clock::time_point start_;
  Countdown countdown_;
};

} // namespace prosup

#endif
