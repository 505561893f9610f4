#include "prosup/core/unfinished.h"

#include <utility>

namespace prosup {

namespace {

/// Never destroyed: a thread may be ending the program while static objects go.
struct Registry {
  std::recursive_mutex mutex;
  std::list<std::function<void()>> entries;
};

Registry& registry() {
  static auto* const all = new Registry;
  return *all;
}

} // namespace

Unfinished::Unfinished(std::function<void()> clear) {
  const auto lock = uninterrupted();
  registry().entries.push_front(std::move(clear));
  place_ = registry().entries.begin();
}

Unfinished::~Unfinished() {
  const auto lock = uninterrupted();
  registry().entries.erase(place_);
}

bool abandon_unfinished() {
  registry().mutex.lock(); // for ever
  for (const std::function<void()>& clear : registry().entries)
    clear();
  return !registry().entries.empty();
}

std::unique_lock<std::recursive_mutex> uninterrupted() {
  return std::unique_lock(registry().mutex);
}

} // namespace prosup
