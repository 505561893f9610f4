#ifndef PROSUP_SETTLING_SETTLING_H
#define PROSUP_SETTLING_SETTLING_H

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "prosup/core/log.h"
#include "prosup/settling/effort.h"
#include "prosup/settling/settling_parameters.h"
#include "prosup/settling/settling_result.h"
#include "prosup/settling/simulation.h"
#include "prosup/settling/stall_watch.h"

namespace prosup::settling {

/// Runs a simulation until it has settled: the loop of prediction and correction of
/// the paper's Fig. 3, and the recovery from divergence and stalls
/// (docs/stability.md).
///
/// After every block of n steps the unloaded configuration is corrected, by the
/// part min(1, n h/tau) with the lag tau = lag factor/(r/rho), or in full. From time
/// to time the best state so far is kept. A simulation that diverges or stalls goes
/// back to it and continues with safer values. When all retries are used up, a body
/// that has never settled is searched for the largest part of gravity under which
/// it does, to tell the user.
class Settling {
public:
  /// Values that each return to a good state makes safer.
  struct Caution {
    double lag_factor, step_safety, gravity_ramp; ///< as in the parameters
    unsigned update_interval; ///< corrections between two updates of the time step
    double tolerance;         ///< factor on the tolerances
  };

  /// Keeps references to simulation and parameters.
  Settling(Simulation& simulation, const SettlingParameters& parameters, Description description,
           const Log& log = Log());

  /// Simulates until the tolerances are met.
  /// @throws DivergenceError with a diagnosis if all retries are used up; the last
  /// good state is then restored.
  SettlingResult run(const Effort& effort = {});
  /// Simulates `n_steps` steps. @throws as run().
  SettlingResult advance(unsigned n_steps);

  /// `observer` is called with the number of steps so far in this call after every
  /// block that ends in a healthy state; the simulation stops if it returns false. It
  /// has to return the same on all ranks.
  void set_observer(std::function<bool(unsigned)> observer) { observer_ = std::move(observer); }

  /// `keeper` is called with the number of steps so far in a call of run() that has needed no
  /// retry, after every few corrections: a new call goes on from there with the same steps, in
  /// another process too. The same on all ranks.
  void set_keeper(std::function<void(unsigned)> keeper) { keeper_ = std::move(keeper); }

  const Caution& caution() const { return caution_; }
  /// Whether a call has ever ended in a settled state.
  bool has_settled() const { return has_settled_; }

  /// What earlier calls have learnt, by name, for a simulation that goes on in another process.
  std::map<std::string, double> memory() const;
  /// @throws std::out_of_range if something is missing.
  void set_memory(const std::map<std::string, double>& memory);

private:
  SettlingResult simulate(unsigned max_steps, bool until_settled);
  void begin();
  std::string trouble_in(const Report& report) const;
  double judge(const Report& report, SettlingResult& result);
  void correct();
  // recovery.cc
  bool recover_from_stall(double error, SettlingResult& result);
  void retreat(const std::string& what, Trouble trouble, SettlingResult& result);
  std::string what_did_not_help(unsigned n_retries) const;
  void be_safer(Trouble trouble, bool keep_lag);
  void end_unsettled(SettlingResult& result);
  [[noreturn]] void give_up(const std::string& what);
  // load_search.cc
  std::string search_load();
  bool settles();
  void be_careful();

  bool is_full_correction() const;
  std::string state_text(const SettlingResult& result) const;

  Simulation& simulation_;
  const SettlingParameters& parameters_;
  const Description description_;
  const Log log_;
  std::function<bool(unsigned)> observer_;
  std::function<void(unsigned)> keeper_;
  Caution caution_, caution_at_begin_;
  unsigned max_retries_;
  bool gives_up_early_ = false;
  Snapshot first_, last_good_;
  double last_good_error_ = 0.;
  bool has_kept_ = false; // a state, since the last return
  StallWatch stall_watch_;
  bool is_fully_loaded_ = false;
  bool has_settled_ = false; // ever
  bool is_searching_ = false;
};

} // namespace prosup::settling

#endif
