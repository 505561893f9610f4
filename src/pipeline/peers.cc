#include "peers.h"

#include <fstream>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/text_file.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

/// elastix: fixed points are carried to the moving image.
class Elastix : public Peer {
public:
  std::string program() const override { return "elastix"; }
  std::string package() const override { return "elastix"; }

  Command registration(const PeerTask& task) const override {
    return {"elastix",
            "-threads",
            std::to_string(task.threads),
            "-f",
            task.prone_image,
            "-m",
            task.supine_image,
            "-p",
            task.parameters,
            "-out",
            task.folder};
  }
  Command field(const PeerTask& task) const override {
    return {"transformix", "-def",     "all", "-tp", task.folder / "TransformParameters.0.txt",
            "-out",        task.folder};
  }
  fs::path displacement(const PeerTask& task) const override {
    return task.folder / "deformationField.nrrd";
  }
};

/// plastimatch reads the names of images in the same file as its stages.
class Plastimatch : public Peer {
public:
  std::string program() const override { return "plastimatch"; }
  std::string package() const override { return "plastimatch"; }

  Command registration(const PeerTask& task) const override {
    std::ostringstream text;
    text << "[GLOBAL]\nfixed=" << task.prone_image.string()
         << "\nmoving=" << task.supine_image.string() << "\nvf_out=" << displacement(task).string()
         << "\n\n"
         << std::ifstream(task.parameters).rdbuf();
    const fs::path file = task.folder / "plastimatch.txt";
    write_text_file(text.str(), file);
    return {"plastimatch", "register", file};
  }
  fs::path displacement(const PeerTask& task) const override {
    return task.folder / "displacement.nrrd";
  }
};

} // namespace

std::unique_ptr<Peer> make_peer(const std::string& name) {
  std::unique_ptr<Peer> peers[] = {std::make_unique<Elastix>(), std::make_unique<Plastimatch>()};
  std::string names;
  for (std::unique_ptr<Peer>& peer : peers) {
    const std::string program = peer->program();
    if (name == program || name.compare(0, program.size() + 1, program + "-") == 0) {
      if (find_program(program).empty())
        throw Error("The program '" + program +
                    "' that 'Comparison/Peers' names is not installed;"
                    " install Debian's package " +
                    peer->package() + ", or take it out of the list.");
      return std::move(peer);
    }
    names += (names.empty() ? "" : ", ") + program;
  }
  throw Error("The peer '" + name +
              "' of 'Comparison/Peers' is not known; it has to start with "
              "one of: " +
              names + ".");
}

std::string peer_version(const Peer& peer, const fs::path& folder) {
  const fs::path log = folder / ("version_" + peer.program());
  run_child({"timeout", "10", peer.program(), "--version"}, log);
  std::string line;
  std::getline(std::ifstream(log.string() + ".out") >> std::ws, line);
  return line.empty() ? "unknown" : line;
}

} // namespace prosup::pipeline
