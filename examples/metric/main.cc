// Registers a prone and a supine image of one breast with a metric of its own, and prints the mean
// error at landmarks, which the registration does not know, before and after, mm:
//   metric PRONE PRONE_LABELS SUPINE SUPINE_LABELS LANDMARKS [PARAMETERS.prm]
#include <prosup/core/error.h>
#include <prosup/core/parameters.h>
#include <prosup/core/session.h>
#include <prosup/evaluation/target_registration_error.h>
#include <prosup/registration/registration.h>

#include <iostream>

#include "charbonnier.h"

int main(int argc, char** argv) {
  const prosup::Session session(argc, argv);
  try {
    if (argc < 6)
      throw prosup::Error("Five files are needed; see the head of main.cc.");
    prosup::registration::RegistrationParameters parameters;
    // Known by its name from here on, with its parameters in 'Similarity/charbonnier'.
    parameters.similarity.add_metric(std::make_shared<Charbonnier>());
    prosup::read_parameters(argc > 6 ? argv[6] : "", {"Similarity/Metric=charbonnier"});

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
      using namespace prosup::evaluation;
      const auto landmarks = read_landmarks(argv[5]);
      std::cout << initial_error(landmarks).mean << ' '
                << unloaded_error(landmarks, PointMapper(result.meshes.prone),
                                  PointMapper(result.meshes.supine))
                       .mean
                << '\n';
    }
    return result.converged ? 0 : 2;
  } catch (const std::exception& error) {
    if (session.is_first())
      std::cerr << error.what() << '\n';
    return 1;
  }
}
