# shellcheck shell=bash
# Sourced by the other scripts: changes to the project's folder and defines what several of them
# use.
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

# Inside containers Open MPI may be forbidden to read another process's memory. Its other way of
# passing messages on one machine works everywhere. The names are those of versions 4 and 5.
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_smsc=^cma

# die SENTENCE: prints one sentence to standard error and ends the script.
die() {
  printf '%s\n' "$*" >&2
  exit 1
}

# How many compilers fit into the free memory: one file with deal.II's headers takes up to 1.5 GiB.
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
