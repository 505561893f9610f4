#include "table.h"

#include "prosup/core/log.h"

namespace prosup::benchmarks {

namespace {

const char* const about = R"(# Stability

This page says what the unloading does when a simulation goes wrong, and lists the hard cases on
which it is tested. The whole page is written by

    build/release/benchmarks/benchmark_hard_cases --write docs/stability.md

and the tests run the same cases on small meshes (`--small`); `--case NAME` runs one.

## What is chosen from the scene

- The **damping** follows the lowest frequency of the body, r/rho = 2 omega,
  measured from its motion.
- **Lag** of the unloaded positions and **ramp** of gravity are multiples of the
  damping time 1/(r/rho).
- The **time step** is 0.9 of the critical one, measured by Lanczos' method on the
  deformed body every 20 corrections.
- It has **settled** when the residual is below its fraction of the weight, max |x - u - X| is below
  its tolerance, and the residual times the largest displacement is below it too: this estimates how
  far the remaining forces may still move the body.

## When it goes wrong

After every block of steps the program checks for an element that has collapsed
(J < 0.02) or is inverted in the unloaded configuration, for forces that are not
finite, for a body that moves faster than in a free fall, and for a stall: an error
that falls by less than a fifth in 10 lag times and 300 steps. (Soft bodies swing
around the unloaded state without end if the lag is short.) In all these cases the
simulation

1. returns to the last good state: the one under the full load that was nearest to
   settled, or the initial state if there is none;
2. continues with twice the lag, r/rho = 4 omega, and a ramp at least four times as
   long as the lag. A load that rises faster than the unloaded positions follow acts
   on a body that already hangs, which is what makes soft ones collapse. After a
   divergence it also takes 0.8 of the time step, and updates the masses twice as
   often;
3. from then on uses a quarter of the tolerances, since a body that needed a return has
   soft modes, in which a small |x - u - X| means a larger error of X;
4. after a stall, takes the damping from the lowest frequency if it was fixed and more
   than three times too high or too low.
5. if the breast slides and has never settled: after a stall in which a few sliding nodes alone have
   not settled (at most 3 % of those that slide), holds these where they are, and changes nothing
   else; at the third return begins anew with all of the chest held. Both are warnings of
   `summary.json` ([supports.md](supports.md)).

Each return is logged. After `Unloading/Maximum retries` returns the program gives up
and reports the first element that collapsed, its place in the loaded mesh and its J, the
softness rho g L/mu, and the part of the weight for which it does find an unloaded
state. It searches for that part in five short runs, each from the last one that
settled. The part is a lower bound: Newton's method, where the table has it, gets
further. `unload` and `load` write the last good state then. A simulation that neither settles nor diverges stops at `Maximum steps`,
is marked as not converged, and says why.

The finite differences share this policy (module `settling`), but for what
[fdm.md](fdm.md) says.

## Hard cases

Bodies are label images of a breast on a cylindrical chest, meshed by the program. Unless the case
says otherwise, they have averaged nodal pressure, fat of 357 Pa and nu = 0.45, prone gravity, chest
and cut planes held, and default parameters. *Distance* is the largest distance over all nodes
between the unloaded positions found and those of Newton's method on the same mesh (for two
components, on the mesh of the larger one); it has to be below 0.05 mm. If there is no unloaded
state, the fractions of the weight found by both methods have to agree to 0.1.
)";

} // namespace

std::string page_head(Size size) {
  return std::string(about) + (size == Size::small ? "\nOn the small meshes of the tests:\n" : "") +
         "\n| case | what is hard | cells | steps | retries | distance, mm | outcome | expected | "
         "ok "
         "|\n|---|---|---|---|---|---|---|---|---|\n";
}

std::string row(const Case& hard_case, const Result& result) {
  std::string compared = result.is_compared ? format("%.3f", result.distance) : "";
  if (result.newton_fraction < 1.)
    compared = format("Newton: up to %.2f of the weight", result.newton_fraction);
  std::string outcome = name_of(result.outcome);
  if (!result.explanation.empty())
    outcome += ": " + result.explanation;
  for (std::size_t bar; (bar = outcome.find("max |x-u-X|")) != std::string::npos;)
    outcome.replace(bar, 11, "max \\|x-u-X\\|"); // bars end the cells of a table
  return "| " + hard_case.name + " | " + hard_case.hardness +
         format(" | %u | %u | %u | ", result.n_cells, result.n_steps, result.n_retries) + compared +
         " | " + outcome + " | " + name_of(hard_case.expected) + " | " +
         (result.as_expected ? "yes" : "**no**") + " |\n";
}

} // namespace prosup::benchmarks
