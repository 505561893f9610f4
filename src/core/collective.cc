#include "prosup/core/collective.h"

#include <exception>
#include <string>

#include "prosup/core/exception_text.h"

namespace prosup {

namespace {

int rank_in(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

} // namespace

void on_every_rank(MPI_Comm communicator, const std::function<void()>& work) {
  const int rank = rank_in(communicator);
  constexpr int nobody = std::numeric_limits<int>::max();
  int first_failed = nobody;
  std::string message;
  try {
    work();
  } catch (const std::exception& exception) {
    first_failed = rank;
    message = text_of(exception);
  }
  MPI_Allreduce(MPI_IN_PLACE, &first_failed, 1, MPI_INT, MPI_MIN, communicator);
  if (first_failed == nobody)
    return;
  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, first_failed, communicator);
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, first_failed, communicator);
  throw Error(message);
}

void on_root(MPI_Comm communicator, const std::function<void()>& work) {
  on_every_rank(communicator, [&] {
    if (rank_in(communicator) == 0)
      work();
  });
}

} // namespace prosup
