// Registers a prone and a supine image of one breast with prosup's default scheme, and says where
// the point x y z (LPS, mm) of the prone image lies in the supine one:
//   register PRONE PRONE_LABELS SUPINE SUPINE_LABELS x y z [PARAMETERS.prm]
#include <prosup/core/error.h>
#include <prosup/core/parameters.h>
#include <prosup/core/session.h>
#include <prosup/evaluation/point_mapper.h>
#include <prosup/registration/registration.h>

#include <iostream>

int main(int argc, char** argv) {
  const prosup::Session session(argc, argv);
  try {
    if (argc < 8)
      throw prosup::Error("Four files and a point are needed; see the head of main.cc.");
    prosup::registration::RegistrationParameters parameters;
    prosup::read_parameters(argc > 8 ? argv[8] : "");

    prosup::registration::CaseFiles files;
    files.images = {argv[1], argv[3]};
    files.labels = {argv[2], argv[4]};
    files.chest = prosup::unloading::ChestCondition::fixed;

    prosup::registration::Registration registration(parameters);
    registration.read(files);
    registration.unload();
    registration.match_properties();
    registration.match_images();
    const auto result = registration.result();

    if (session.is_first()) {
      const prosup::evaluation::PointMapper prone(result.meshes.prone),
          supine(result.meshes.supine);
      const dealii::Point<3> lesion(std::stod(argv[5]), std::stod(argv[6]), std::stod(argv[7]));
      std::cout << supine.to_loaded(prone.to_unloaded(lesion)) << '\n';
    }
    return result.converged ? 0 : 2;
  } catch (const std::exception& error) {
    if (session.is_first())
      std::cerr << error.what() << '\n';
    return 1;
  }
}
