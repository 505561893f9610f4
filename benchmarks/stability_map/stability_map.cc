// Which corrections of the unloading converge: lag against damping against
// softness, the relaxed correction and the paper's full one, prone and supine.
// Writes stability_map.csv and pictures of it, and prints what linear theory says.

#include <cstdio>

#include "../setup.h"
#include "picture.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "spectrum.h"

using namespace prosup;
using namespace prosup::benchmarks;
using settling::CorrectionScheme;

namespace {

/// Dense matrices of finer bodies take too long. The lowest frequency changes little.
constexpr unsigned finest_spectrum = 1;

struct Plan {
  std::vector<double> softness{1., 2., 3., 4., 6., 8., 12.};
  std::vector<double> damping_factors{0.5, 1., 2., 4., 8., 16.};
  std::vector<double> lags{0.1, 0.3, 1., 2.5, 5., 10.};
  std::vector<unsigned> intervals{1, 10, 50, 200};
  unsigned n_refinements = 1;
  bool tells_spectra = true;
  unsigned max_steps = 20000;

  /// On a finer mesh, where modes are faster and steps shorter.
  static Plan fine() {
    return {{2., 3., 4.}, {0.5, 1., 2., 4.}, {1., 2.5, 5.}, {1, 10, 50, 200}, 2, false};
  }

  static Plan small() { return {{2., 8.}, {1.}, {2.5}, {1, 10, 50}, 0, false}; }

  std::vector<Correction> corrections() const {
    std::vector<Correction> result;
    for (const double lag : lags)
      result.push_back({CorrectionScheme::relaxed, lag, 1});
    for (const unsigned n : intervals)
      result.push_back({CorrectionScheme::full, 1., n});
    return result;
  }
};

const char* table_head =
    "| state | rho g L/mu | moves, mm | omega_1, 1/s | h, ms | asymmetry of A | angle of its "
    "eigenvalues | step with A over that with K | damping that stops the flutter: theory | "
    "observed | "
    "Re of K^-1 A from | largest jump |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";

/// Prints a row of the table of spectra.
void print(const HalfBall& breast, const Spectrum& spectrum) {
  const double unit = 2. * spectrum.lowest_frequency;
  const double predicted = spectrum.critical_damping;
  const double observed =
      predicted > 0. ? observed_critical_damping(breast, 0.25 * predicted, 8. * predicted) / unit
                     : 0.;
  std::printf(" %.1f | %.1f | %.2f | %.2f | %.0f deg | %.2f | %.2f | %s | %.2f | %.2f |\n",
              breast.motion, spectrum.lowest_frequency, 1e3 * spectrum.critical_step,
              spectrum.asymmetry, spectrum.largest_angle, spectrum.step_ratio, predicted / unit,
              observed > 0. ? format("%.2f", observed).c_str() : "", spectrum.smallest_following,
              spectrum.largest_jump);
  std::fflush(stdout);
}

const char* name_of(bool prone) {
  return prone ? "prone" : "supine";
}

std::string csv(const std::vector<Run>& runs) {
  std::string text =
      "cells,state,softness,correction,lag_factor,interval,interval_time,damping_factor,"
      "damping_rate,outcome,steps,error_mm\n";
  for (const Run& run : runs) {
    const bool relaxed = run.correction.scheme == CorrectionScheme::relaxed;
    text += format("%u,%s,%g,%s,%s,%u,%.3g,%g,%.4g,%s,%s,%s\n", run.n_cells, name_of(run.prone),
                   run.softness, relaxed ? "relaxed" : "full",
                   relaxed ? format("%g", run.correction.lag_factor).c_str() : "",
                   run.correction.interval, run.interval_time, run.damping_factor, run.damping_rate,
                   benchmarks::name_of(run.outcome),
                   run.outcome == Outcome::diverged ? "" : std::to_string(run.n_steps).c_str(),
                   run.outcome == Outcome::converged ? format("%.4f", run.error).c_str() : "");
  }
  return text;
}

std::vector<Run> all_runs(const Plan& plan) {
  std::vector<Run> runs;
  if (plan.tells_spectra)
    std::printf("%s", table_head);
  for (const bool prone : {true, false})
    for (const double softness : plan.softness) {
      const HalfBall coarse(softness, prone, std::min(plan.n_refinements, finest_spectrum));
      const Spectrum spectrum = coarse.has_solution ? measure_spectrum(coarse) : Spectrum();
      if (!spectrum.is_stable) {
        std::printf("| %s | %g | has no stable unloaded state | | | | | | | | | |\n",
                    name_of(prone), softness);
        continue;
      }
      if (plan.tells_spectra) {
        std::printf("| %s | %g |", name_of(prone), softness);
        print(coarse, spectrum);
      }
      const HalfBall breast(softness, prone, plan.n_refinements);
      for (const Correction& correction : plan.corrections())
        for (const double factor : plan.damping_factors) {
          Run run;
          run.n_cells = breast.body.n_global_cells();
          run.prone = prone;
          run.softness = softness;
          run.correction = correction;
          run.damping_factor = factor;
          run.damping_rate = 2. * factor * spectrum.lowest_frequency;
          simulate(breast, run, plan.max_steps);
          runs.push_back(run);
        }
    }
  return runs;
}

/// One line for each correction.
void print_summary(const std::vector<Run>& runs, const Plan& plan) {
  std::printf("\n%u tetrahedra\n\n| correction | converged | unsettled | diverged | largest error "
              "of the converged, mm |\n|---|---|---|---|---|\n",
              runs.empty() ? 0u : runs.front().n_cells);
  for (const Correction& correction : plan.corrections()) {
    unsigned n[3] = {0, 0, 0};
    double error = 0.;
    for (const Run& run : runs)
      if (run.correction.name() == correction.name()) {
        ++n[static_cast<unsigned>(run.outcome)];
        error = std::max(error, run.outcome == Outcome::converged ? run.error : 0.);
      }
    std::printf("| %s | %u | %u | %u | %.3f |\n", correction.name().c_str(), n[0], n[1], n[2],
                error);
  }
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Which corrections of the unloading converge.", "benchmark_stability_map"};
  std::filesystem::path folder;
  bool small = false;
  app.add_option("--output", folder, "Folder for stability_map.csv and the pictures")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--small", small, "A few fields of the map on a coarse body");
  return run_program(argc, argv, app, [&] {
    std::vector<Run> runs = all_runs(small ? Plan::small() : Plan());
    print_summary(runs, small ? Plan::small() : Plan());
    write_picture(runs, folder / "stability_map.svg");
    if (!small) {
      const std::vector<Run> fine = all_runs(Plan::fine());
      print_summary(fine, Plan::fine());
      write_picture(fine, folder / "stability_map_fine.svg");
      runs.insert(runs.end(), fine.begin(), fine.end());
    }
    write_text_file(csv(runs), folder / "stability_map.csv");
  });
}
