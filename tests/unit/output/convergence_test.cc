#include "prosup/output/convergence.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

std::vector<ConvergenceEntry> run() {
  ConvergenceEntry first;
  first.stage = "material";
  first.level_mm = 8.;
  first.seconds = 1.;
  first.similarity = 200.;
  first.shear_modulus = 300.;
  first.error = evaluation::ErrorStatistics{2., 1., 5., 4., 10};
  ConvergenceEntry second = first;
  second.iteration = 1;
  second.seconds = 3.;
  second.similarity = 50.;
  second.error = evaluation::ErrorStatistics{0.5, 0.1, 1., 0.9, 10};
  return {first, second};
}

TEST(Convergence, HasOneRowPerState) {
  const TemporaryFolder folder;
  write_convergence(run(), folder / "convergence.csv");
  EXPECT_EQ(contents(folder / "convergence.csv"),
            "stage,level_mm,iteration,seconds,similarity,shear_modulus_Pa,poisson_ratio,"
            "gland_ratio,chest_stiffness_Pa_per_mm,force_weight_Pa,tre_mean_mm,tre_p95_mm,"
            "tre_max_mm\n"
            "material,8,0,1.00,200,300,0,0,0,0,2.0000,4.0000,5.0000\n"
            "material,8,1,3.00,50,300,0,0,0,0,0.5000,0.9000,1.0000\n");
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++n;
  return n;
}

TEST(Convergence, PictureShowsErrorsOnlyWhereTheyAreKnown) {
  const TemporaryFolder folder;
  std::vector<ConvergenceEntry> entries = run();
  write_convergence_picture(entries, folder / "with.svg");
  const std::string with = contents(folder / "with.svg");
  EXPECT_EQ(count(with, "<polyline"), 4u); // similarity; mean, p95 and max
  EXPECT_EQ(count(with, "<circle"), 8u);
  EXPECT_EQ(count(with, "nan"), 0u);
  for (ConvergenceEntry& entry : entries)
    entry.error.reset();
  write_convergence_picture(entries, folder / "without.svg");
  EXPECT_EQ(count(contents(folder / "without.svg"), "<polyline"), 1u);
}

} // namespace
} // namespace prosup::tests
