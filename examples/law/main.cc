// Pulls a block of tissue along one axis at constant volume, and prints the stress of each law of
// the installed prosup against the stretch, Pa, as CSV.
#include <prosup/mechanics/laws/stress.h>

#include <cmath>
#include <iostream>
#include <tuple>

int main() {
  using namespace prosup::mechanics;
  const LameParameters tissue = lame_parameters(300., 0.45);
  std::cout << "stretch";
  for (const std::string& name : law_names())
    std::cout << ',' << name;
  std::cout << '\n';
  for (double stretch = 0.8; stretch < 1.61; stretch += 0.1) {
    dealii::Tensor<2, 3> F;
    F[0][0] = stretch;
    F[1][1] = F[2][2] = 1. / std::sqrt(stretch);
    std::cout << stretch;
    std::apply(
        [&](const auto&... law) {
          // Without the pressure that the sides would bear.
          const auto stress = [&](const Law& of) {
            const auto P = first_piola_kirchhoff_stress(F, tissue, of);
            return P[0][0] - P[1][1] * F[1][1] / F[0][0];
          };
          ((std::cout << ',' << stress(law)), ...);
        },
        AllLaws());
    std::cout << '\n';
  }
}
