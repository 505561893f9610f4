#ifndef PROSUP_MESH_GMSH_SESSION_H
#define PROSUP_MESH_GMSH_SESSION_H

#include <string>
#include <utility>
#include <vector>

namespace prosup::mesh {

/// A gmsh model of its own for as long as the object lives. A host program that
/// uses gmsh finds its current model and all options as they were.
class GmshSession {
public:
  explicit GmshSession(const std::string& model_name);
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Sets an option until the session ends.
  void set_option(const std::string& name, double value);

private:
  bool is_owner_ = false; // of gmsh's initialisation
  std::string model_name_;
  std::string host_model_;
  std::vector<std::pair<std::string, double>> host_options_;
};

} // namespace prosup::mesh

#endif
