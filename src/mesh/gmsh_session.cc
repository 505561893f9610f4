#include "gmsh_session.h"

#include <gmsh.h>

#include <array>

namespace prosup::mesh {

namespace {

/// Initialises gmsh unless the host program has done so. gmsh cannot be asked,
/// but reads the command line at its first initialisation only: it is given an
/// unusual tolerance, and who finds it again was first.
bool initialise() {
  constexpr double mark = 1.0000001e-8;
  const std::array<const char*, 7> arguments{"prosup", "-v",   "0",           "-nt",
                                             "1",      "-tol", "1.0000001e-8"};
  gmsh::initialize(int(arguments.size()), const_cast<char**>(arguments.data()), false);
  double tolerance = 0.;
  gmsh::option::getNumber("Geometry.Tolerance", tolerance);
  if (tolerance != mark)
    return false;
  gmsh::option::setNumber("Geometry.Tolerance", 1e-8);
  return true;
}

} // namespace

GmshSession::GmshSession(const std::string& model_name)
    : is_owner_(initialise()), model_name_(model_name) {
  set_option("General.Terminal", 0.);
  set_option("General.Verbosity", 0.);
  set_option("General.AbortOnError", 0.);
  if (!is_owner_)
    gmsh::model::getCurrent(host_model_);
  gmsh::model::add(model_name_);
}

GmshSession::~GmshSession() {
  try {
    gmsh::model::setCurrent(model_name_);
    gmsh::model::remove();
    if (is_owner_) {
      gmsh::finalize();
      return;
    }
    gmsh::model::setCurrent(host_model_);
    for (auto option = host_options_.rbegin(); option != host_options_.rend(); ++option)
      gmsh::option::setNumber(option->first, option->second);
  } catch (...) {
    // gmsh throws integers and strings; a destructor has no one to tell.
  }
}

void GmshSession::set_option(const std::string& name, double value) {
  double host_value = 0.;
  gmsh::option::getNumber(name, host_value);
  host_options_.emplace_back(name, host_value);
  gmsh::option::setNumber(name, value);
}

} // namespace prosup::mesh
