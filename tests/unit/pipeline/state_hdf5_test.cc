#include "pipeline/state_hdf5.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "box_of_tets.h"
#include "pipeline/run_record.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::pipeline;
using namespace prosup::registration;

/// A state as the ranks of a split have it: the first half holds the prone breast, the others the
/// supine one; one rank holds both. Each holding rank has two nodes.
RegistrationState state_of(unsigned rank, unsigned n_ranks) {
  RegistrationState state;
  state.stage = Stage::unloaded;
  state.properties.tissue.shear_modulus = 1000. / 3.;
  state.alignment.translation[1] = 0.1;
  state.alignment.rotation[0][2] = -0.7;
  state.converged = false;
  state.unloaded.supine.n_steps = 1234567;
  state.material.grid.size = {3, 4, 5};
  state.material.grid.origin[2] = -1. / 7.;
  state.material.is_exact = true;
  state.material.derivatives = {{1.f, 2.f, 3.f}, {4.f, 5.f, 6.f}};
  state.image_forces.weight = 1e-7;
  const unsigned n_prone = (n_ranks + 1) / 2;
  for (const Position position : both_positions) {
    const bool is_prone = position == Position::prone;
    if (n_ranks > 1 && is_prone != (rank < n_prone))
      continue;
    BreastState& breast = state.breasts[position];
    const unsigned rank_of_breast = is_prone || n_ranks == 1 ? rank : rank - n_prone;
    if (rank_of_breast == 0)
      breast.mesh = box_of_tets({0., 0., 0.}, {1., 2., 1. / 3.}, is_prone ? 2 : 3);
    breast.nodes = {2 * rank_of_breast + 1, 2 * rank_of_breast};
    for (unsigned i = 0; i < 6; ++i)
      breast.fields[is_prone ? "force" : "velocity"].push_back(100. * rank_of_breast + i + 1. / 3.);
    breast.numbers["time"] = is_prone ? 1.5 : 2.5;
  }
  return state;
}

TEST(StateHdf5, EveryRankReadsTheStateOfAll) {
  const MPI_Comm world = MPI_COMM_WORLD;
  const unsigned rank = dealii::Utilities::MPI::this_mpi_process(world),
                 n_ranks = dealii::Utilities::MPI::n_mpi_processes(world);
  const TemporaryFolder own;
  const std::filesystem::path file =
      dealii::Utilities::MPI::broadcast(world, (own / "state.h5").string());
  const RegistrationState written = state_of(rank, n_ranks);
  {
    output::Hdf5Writer writer(file, "test", world);
    write_state(writer, written, world);
    writer.commit();
  }
  const output::Hdf5Reader reader(file, "test", world, "-");
  const RegistrationState read = read_registration_state(reader);
  EXPECT_EQ(read.stage, Stage::unloaded);
  EXPECT_EQ(read.properties.tissue.shear_modulus, 1000. / 3.);
  EXPECT_EQ(read.alignment.translation, written.alignment.translation);
  EXPECT_EQ(read.alignment.rotation, written.alignment.rotation);
  EXPECT_FALSE(read.converged);
  EXPECT_EQ(read.unloaded.supine.n_steps, 1234567u);
  EXPECT_EQ(read.material.grid.size, written.material.grid.size);
  EXPECT_EQ(read.material.grid.origin, written.material.grid.origin);
  EXPECT_TRUE(read.material.is_exact);
  EXPECT_EQ(read.material.derivatives, written.material.derivatives);
  EXPECT_EQ(read.image_forces.weight, 1e-7);
  const unsigned n_prone = (n_ranks + 1) / 2;
  for (const Position position : both_positions) {
    const bool is_prone = position == Position::prone;
    const BreastState& breast = read.breasts[position];
    const unsigned n_holders = n_ranks == 1 ? 1 : is_prone ? n_prone : n_ranks - n_prone;
    EXPECT_EQ(breast.mesh.points.size(), is_prone ? 27u : 64u);
    ASSERT_EQ(breast.nodes.size(), 2 * n_holders);
    const auto& field = breast.fields.at(is_prone ? "force" : "velocity");
    ASSERT_EQ(field.size(), 6 * n_holders);
    for (unsigned holder = 0; holder < n_holders; ++holder) {
      EXPECT_EQ(breast.nodes[2 * holder], 2 * holder + 1);
      EXPECT_EQ(field[6 * holder + 5], 100. * holder + 5 + 1. / 3.);
    }
    EXPECT_EQ(breast.numbers.at("time"), is_prone ? 1.5 : 2.5);
  }
  MPI_Barrier(world);
}

TEST(RunRecord, HoldsWhatWasToldOfARun) {
  output::Summary summary, read;
  std::vector<output::ConvergenceEntry> convergence(2), read_convergence;
  summary.steps = 1234567890123u;
  summary.tre.unloaded = evaluation::ErrorStatistics{1. / 3., 2., 3., 4., 5};
  summary.time.mesh = 0.1;
  summary.alignment.emplace().method = "chest surface";
  summary.alignment->information = {0.1, 0.2};
  registration::Quality quality, read_quality;
  quality.at_bound = {"shear modulus"};
  quality.material.emplace().gland_dice = 0.75;
  convergence[1].stage = "material";
  convergence[1].similarity = 2. / 3.;
  convergence[1].error = summary.tre.unloaded;
  set_record(record_of(summary, quality, convergence), read, read_quality, read_convergence);
  EXPECT_EQ(read.steps, summary.steps);
  ASSERT_TRUE(read.tre.unloaded.has_value());
  EXPECT_EQ(read.tre.unloaded->mean, 1. / 3.);
  EXPECT_FALSE(read.tre.material.has_value());
  EXPECT_EQ(read.time.mesh, 0.1);
  ASSERT_TRUE(read.alignment.has_value());
  EXPECT_EQ(read.alignment->method, "chest surface");
  EXPECT_EQ(read.alignment->information, summary.alignment->information);
  EXPECT_EQ(read_quality.at_bound, quality.at_bound);
  ASSERT_TRUE(read_quality.material.has_value());
  EXPECT_EQ(read_quality.material->gland_dice, 0.75);
  EXPECT_FALSE(read_quality.unloaded.has_value());
  ASSERT_EQ(read_convergence.size(), 2u);
  EXPECT_EQ(read_convergence[1].similarity, 2. / 3.);
  ASSERT_TRUE(read_convergence[1].error.has_value());
  ASSERT_EQ(read.similarity.size(), 2u);
  EXPECT_EQ(read.similarity[1].stage, "material");
}

} // namespace
} // namespace prosup::tests
