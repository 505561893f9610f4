// A program of the build: prosup_manual FOLDER writes the manual pages and the completion of
// prosup, which cmake --install takes from there.
#include <cstdio>
#include <exception>

#include "pipeline/manual.h"

int main(int argc, char** argv) {
  try {
    prosup::pipeline::write_manual(argc > 1 ? argv[1] : "manual");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "prosup_manual: %s\n", error.what());
    return 1;
  }
  return 0;
}
