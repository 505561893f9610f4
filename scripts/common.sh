# shellcheck shell=bash
# Sourced by the other scripts: goes to the project's folder and gives what
# more than one of them uses.
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

# Inside containers Open MPI may not read another process's memory; its other
# way of passing messages on one machine works everywhere.
export OMPI_MCA_btl_vader_single_copy_mechanism=none

# die SENTENCE: ends the script with one sentence on standard error.
die() {
  printf '%s\n' "$*" >&2
  exit 1
}

# Compilers that fit into the free memory at once: one file with deal.II's
# headers takes up to 1.5 GiB.
n_compilers() {
  local cores fitting
  cores=$(nproc)
  fitting=$(awk '/^MemAvailable:/ { print int($2 / (1.5 * 1024 * 1024)) }' /proc/meminfo)
  ((fitting >= 1)) || fitting=1
  echo $((cores < fitting ? cores : fitting))
}

# build_preset PRESET [TARGET...]: configures build/PRESET if need be, and builds there.
build_preset() {
  local preset=$1
  shift
  # Once configured, the build itself notices what else changed.
  if [[ ! build/$preset/build.ninja -nt CMakePresets.json ]]; then
    cmake --preset "$preset"
  fi
  cmake --build "build/$preset" --parallel "$(n_compilers)" ${1+--target "$@"}
}
