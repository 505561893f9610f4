// What has to be in order before the libraries are initialised, that is, before main().

#include "start_up.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

namespace prosup {

namespace {

/// What mpirun, or a queue, tells its processes.
constexpr const char* rank_variables[] = {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"};
constexpr long most_threads = 65536; // more are no wish but a mistake

/// Value of the variable in "NAME=value"; null if it has another name.
const char* value_of(const char* variable, const char* name) {
  const std::size_t length = std::strlen(name);
  return std::strncmp(variable, name, length) == 0 && variable[length] == '='
             ? variable + length + 1
             : nullptr;
}

const char* find(char** variables, const char* name) {
  for (char** variable = variables; *variable != nullptr; ++variable)
    if (const char* value = value_of(*variable, name))
      return value;
  return nullptr;
}

bool is_first_rank(char** variables) {
  for (const char* name : rank_variables)
    if (const char* rank = find(variables, name))
      return std::strcmp(rank, "0") == 0;
  return true;
}

/// Whether a value is a number of threads, or, for OpenMP, several with commas between.
bool is_number_of_threads(const char* value, bool may_be_list) {
  char* end = nullptr;
  const long number = std::strtol(value, &end, 10);
  while (std::isspace(static_cast<unsigned char>(*end)) != 0)
    ++end;
  if (end == value || number < 1 || number > most_threads)
    return false;
  return *end == '\0' || (may_be_list && *end == ',' && is_number_of_threads(end + 1, true));
}

/// deal.II reads its variable while it is loaded, and ends the program if it is no number.
void take_out_wrong_numbers_of_threads(char** variables) {
  for (const char* name : {"DEAL_II_NUM_THREADS", "OMP_NUM_THREADS"})
    for (char** variable = variables; *variable != nullptr;) {
      const char* value = value_of(*variable, name);
      if (value == nullptr || is_number_of_threads(value, name[0] == 'O')) {
        ++variable;
        continue;
      }
      if (is_first_rank(variables))
        std::fprintf(stderr,
                     "prosup: The environment variable %s is '%.80s', which is no number of "
                     "threads; it is ignored.\n",
                     name, value);
      for (char** next = variable; *next != nullptr; ++next)
        next[0] = next[1];
    }
}

/// A file that is opened later would get the number of a standard stream that is closed, and what
/// is printed would go into it.
void open_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0 &&
        open("/dev/null", descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY) < 0)
      return; // there is no /dev/null
}

/// Without rights of the owner neither MPI nor this program can work in the folders they make.
void keep_own_rights(char** variables) {
  constexpr mode_t of_owner = 0700;
  const mode_t mask = umask(0);
  umask(mask & ~of_owner);
  if ((mask & of_owner) != 0 && is_first_rank(variables))
    std::fprintf(stderr,
                 "prosup: The umask %04o takes from you the rights to what you make; files of "
                 "this run keep them.\n",
                 static_cast<unsigned>(mask));
}

void start_up(int, char**, char** variables) {
  open_standard_streams();
  keep_own_rights(variables);
  take_out_wrong_numbers_of_threads(variables);
}

// The linker runs these before the initialisation of any library.
__attribute__((section(".preinit_array"), used)) void (*const at_start)(int, char**,
                                                                        char**) = start_up;

} // namespace

bool is_first_rank() {
  return is_first_rank(environ);
}

void start_without_daemon() {
  for (const char* name : rank_variables)
    if (std::getenv(name) != nullptr)
      return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // Such processes share one folder for temporary files, which the first of them that ends removes;
  // this part of MPI's files, which prosup does not use, tells of that as of an error.
  setenv("OMPI_MCA_sharedfp", "^sm", 0);
}

void stay_on_this_machine() {
  const char *all = std::getenv("OMPI_COMM_WORLD_SIZE"),
             *here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (all != nullptr && here != nullptr && std::strcmp(all, here) == 0)
    setenv("OMPI_MCA_btl", "^tcp", 0);
}

} // namespace prosup
