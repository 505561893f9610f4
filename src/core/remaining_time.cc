#include "prosup/core/remaining_time.h"

#include <cmath>

#include "prosup/core/log.h"

namespace prosup {

namespace {

const RemainingTime* outermost = nullptr;

// By what an estimate may differ from what is shown: estimates are right to a factor of two or so.
constexpr double tolerated_part = 0.3, tolerated_seconds = 3.;

constexpr double least_seconds = 4.; // that are worth a word

/// As coarse as the estimates.
std::string rounded(double seconds) {
  if (seconds < 55.)
    return format("%.0f s",
                  seconds < 15. ? 5. * std::ceil(seconds / 5.) : 10. * std::round(seconds / 10.));
  const double minutes = seconds / 60.;
  if (minutes < 55.)
    return format("%.0f min", minutes < 10. ? std::round(minutes) : 5. * std::round(minutes / 5.));
  return format("%.0f h", std::ceil(minutes / 60.));
}

} // namespace

void Countdown::expect(double seconds, double now) {
  if (!std::isfinite(seconds) || seconds < 0.)
    return forget();
  const double shown = end_ ? *end_ - now : -1.;
  if (shown < 0. ||
      std::abs(seconds - shown) > tolerated_seconds + tolerated_part * std::max(seconds, shown))
    end_ = now + seconds;
}

std::string Countdown::in_words(double now) const {
  return end_ && *end_ - now >= least_seconds ? ", about " + rounded(*end_ - now) + " left" : "";
}

RemainingTime::RemainingTime() : start_(std::chrono::steady_clock::now()) {
  if (outermost == nullptr)
    outermost = this;
}

RemainingTime::~RemainingTime() {
  if (outermost == this)
    outermost = nullptr;
}

double RemainingTime::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RemainingTime::expect(const std::optional<double>& seconds) {
  if (seconds)
    countdown_.expect(*seconds, elapsed());
  else
    countdown_.forget();
}

std::string RemainingTime::in_words() {
  return outermost == nullptr ? "" : outermost->countdown_.in_words(outermost->elapsed());
}

} // namespace prosup
