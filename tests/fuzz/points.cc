#include "prosup/evaluation/points.h"
#include "fuzz_target.h"

/// Points in all three formats: the first byte chooses one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prosup;
  if (size == 0)
    return 0;
  const char* const names[] = {"points.csv", "points.fcsv", "points.mrk.json"};
  const auto file = tests::input_file(names[data[0] % 3], data + 1, size - 1);
  tests::parse_or_refuse([&] { evaluation::read_points(file); });
  return 0;
}
