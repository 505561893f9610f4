#ifndef PROSUP_PIPELINE_PEERS_H
#define PROSUP_PIPELINE_PEERS_H

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/child_process.h"

namespace prosup::pipeline {

/// What a peer is asked to do: find where the points of the prone image lie in the
/// supine one.
struct PeerTask {
  std::filesystem::path prone_image, supine_image;
  std::filesystem::path parameters; ///< of the peer
  std::filesystem::path folder;     ///< for what it writes
  unsigned threads = 1;
};

/// A registration program that a user might take instead of prosup.
class Peer {
public:
  virtual ~Peer() = default;
  virtual std::string program() const = 0;
  virtual std::string package() const = 0; ///< of Debian

  /// Does the registration; its time counts. May write files to the folder of the task.
  virtual Command registration(const PeerTask& task) const = 0;
  /// Makes the displacement field of its result; empty if it is there already.
  virtual Command field(const PeerTask&) const { return {}; }
  /// The displacement field from prone to supine on the voxels of the prone image, mm.
  virtual std::filesystem::path displacement(const PeerTask& task) const = 0;
};

/// The peer of a parameter file's name, such as `elastix-bspline`: it starts with the
/// name of the program.
/// @throws Error for a program that is not known (the message lists those that are) or
/// not installed (the message names the Debian package).
std::unique_ptr<Peer> make_peer(const std::string& name);

/// The first line that the program says of its version.
std::string peer_version(const Peer& peer, const std::filesystem::path& folder);

} // namespace prosup::pipeline

#endif
