#include <deal.II/base/parameter_acceptor.h>

#include "fuzz_target.h"
#include "prosup/core/parameters.h"

namespace prosup::tests {

namespace {

/// One entry of each kind that prosup declares.
class Entries : public dealii::ParameterAcceptor {
public:
  Entries() : ParameterAcceptor("Section/Inner") {}
  void declare_parameters(dealii::ParameterHandler& prm) override {
    using namespace dealii::Patterns;
    prm.add_parameter("Number", number_, "", Double(0., 1e3));
    prm.add_parameter("Count", count_, "", Integer(0, 10));
    prm.add_parameter("Choice", choice_, "", one_of({"first", "second one"}));
    prm.add_parameter("Direction", direction_);
    prm.add_parameter("Labels", labels_, "", List(Integer(0, 255), 1, 4));
    prm.add_parameter("Wanted", wanted_);
    prm.add_parameter("File", file_);
  }

private:
  double number_ = 1.;
  unsigned count_ = 1;
  std::string choice_ = "first", file_;
  dealii::Tensor<1, 3> direction_;
  std::vector<unsigned> labels_{1, 2};
  bool wanted_ = false;
};

} // namespace

/// A parameter file; what follows a zero byte is an override.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find('\0'), size);
  const auto file = input_file("input.prm", data, end);
  parse_or_refuse([&] {
    const Entries entries;
    read_parameters(file, end < size ? std::vector<Override>{text.substr(end + 1)}
                                     : std::vector<Override>{});
  });
  return 0;
}

} // namespace prosup::tests
