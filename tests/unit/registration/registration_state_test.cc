#include "prosup/registration/registration_state.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/core/parameters.h"
#include "prosup/registration/registration.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::registration;

CaseFiles small_case() {
  const std::string folder = PROSUP_TEST_DATA "/small/";
  CaseFiles files;
  files.images = {folder + "prone.nii.gz", folder + "supine.nrrd"};
  files.labels = {folder + "prone_labels.nii.gz", folder + "supine_labels.mha"};
  return files;
}

struct Outcome {
  RegistrationResult result;
  std::vector<SimilarityRecord> records;
};

/// Coarse, so that it takes a second.
class State : public ::testing::TestWithParam<std::vector<Override>> {
protected:
  State() {
    std::vector<Override> all{"Images/Voxel edge=2", "Meshing/Edge length=13",
                              "Material update/Levels=8", "Image forces/Levels=8, 6",
                              "Image forces/Updates per level=3"};
    all.insert(all.end(), GetParam().begin(), GetParam().end());
    read_parameters("", all);
  }

  /// Does what is left to do. Keeps the states before it and at every point if `states` is given.
  Outcome run(Registration& registration, std::vector<RegistrationState>* states = nullptr) const {
    Outcome outcome;
    registration.set_observer(
        [&](const SimilarityRecord& record) { outcome.records.push_back(record); });
    const auto keep = [&] {
      if (states != nullptr)
        states->push_back(registration.state());
    };
    registration.set_keeper(keep);
    registration.unload();
    keep();
    registration.match_properties();
    keep();
    registration.match_images();
    keep();
    outcome.result = registration.result();
    return outcome;
  }

  const RegistrationParameters parameters_;
};

INSTANTIATE_TEST_SUITE_P(Parameters, State,
                         ::testing::Values(std::vector<Override>{},
                                           std::vector<Override>{"Material update/Method=stepwise",
                                                                 "Image forces/Scheme=accumulated"},
                                           std::vector<Override>{
                                               "Image forces/Scheme=l-bfgs",
                                               "Pre-alignment/Method=chest surface"}),
                         [](const auto& info) { return "number_" + std::to_string(info.index); });

double largest_distance(const std::vector<Point<3>>& a, const std::vector<Point<3>>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, a[i].distance(b[i]));
  return largest;
}

// What a state leaves out differs by rounding only: planes of sliding nodes are found anew.
TEST_P(State, ARegistrationThatGoesOnEndsWhereItWouldHave) {
  Registration whole(parameters_);
  whole.read(small_case());
  std::vector<RegistrationState> states;
  const Outcome expected = run(whole, &states);
  ASSERT_GE(states.size(), 5u);
  // A few of them: the middle of the search, and of the image forces, and the ends of stages.
  for (std::size_t i = 0; i < states.size(); i += std::max<std::size_t>(1, states.size() / 4)) {
    Registration rest(parameters_);
    rest.read(small_case());
    rest.resume(states[i]);
    const Outcome found = run(rest);
    for (const Position position : both_positions) {
      const auto &a = found.result.meshes[position], &b = expected.result.meshes[position];
      EXPECT_EQ(a.mesh.cells, b.mesh.cells);
      EXPECT_LT(largest_distance(a.mesh.points, b.mesh.points), 1e-9) << i;
      EXPECT_LT(largest_distance(a.unloaded, b.unloaded), 1e-4) << i;
    }
    EXPECT_EQ(found.result.properties.tissue.shear_modulus,
              expected.result.properties.tissue.shear_modulus);
    EXPECT_EQ(found.result.converged, expected.result.converged);
    // It tells of the rest only, and of that in the same way.
    ASSERT_LE(found.records.size(), expected.records.size());
    const std::size_t n_before = expected.records.size() - found.records.size();
    for (std::size_t r = 0; r < found.records.size(); ++r) {
      EXPECT_EQ(found.records[r].iteration, expected.records[n_before + r].iteration);
      EXPECT_NEAR(found.records[r].value, expected.records[n_before + r].value,
                  1e-4 * expected.records[n_before + r].value);
    }
  }
}

TEST(RegistrationState, OfAnotherMeshIsRefused) {
  const RegistrationParameters parameters;
  read_parameters("", {"Images/Voxel edge=2", "Meshing/Edge length=13"});
  Registration first(parameters), second(parameters);
  first.read(small_case());
  first.build();
  RegistrationState state = first.state();
  for (const Position position : both_positions)
    if (!state.breasts[position].nodes.empty())
      state.breasts[position].nodes.back() += 1000000;
  second.read(small_case());
  expect_error([&] { second.resume(state); }, {"lacks its node", "another mesh"});
}

TEST(RegistrationState, OfFiniteDifferencesThereIsNone) {
  const RegistrationParameters parameters;
  read_parameters("", {"Simulation/Method=fdm"});
  Registration registration(parameters);
  EXPECT_FALSE(registration.has_state());
  expect_error([&] { registration.resume({}); }, {"finite differences"});
}

} // namespace
} // namespace prosup::tests
