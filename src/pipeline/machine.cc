#include "machine.h"

#include <Trilinos_version.h>
#include <mpi.h>
#include <petscversion.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "prosup/core/log.h"
#include "prosup/core/version.h"

namespace prosup::pipeline {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.compare(0, 10, "model name") == 0)
      return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string memory() {
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return format("%.0f GiB", bytes / (1024. * 1024. * 1024.));
}

std::string mpi_library() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string all(text);
  return all.substr(0, all.find(','));
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16] = "";
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::gmtime(&now));
  return text;
}

} // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
  return {{"processor", processor()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory", memory()},
          {"prosup", version()},
          {"deal.II", dealii_version()},
          {"PETSc",
           format("%d.%d.%d", PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"Trilinos", TRILINOS_VERSION_STRING},
          {"MPI", mpi_library()},
          {"compiler", __VERSION__},
          {"date", today()}};
}

} // namespace prosup::pipeline
