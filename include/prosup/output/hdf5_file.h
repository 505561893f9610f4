#ifndef PROSUP_OUTPUT_HDF5_FILE_H
#define PROSUP_OUTPUT_HDF5_FILE_H

#include <mpi.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace prosup::output {

/// An HDF5 file that is written by all ranks of a communicator, and is there completely or not at
/// all: commit() writes what was collected under a temporary name, and renames it. Names are paths,
/// "prone/mesh/cells"; groups are made as they are named. The last 23 bytes of the file, which HDF5
/// does not look at, are a checksum of all others. All functions are collective.
///
/// HDF5 never prints: the first error that it reports is what commit() throws.
class Hdf5Writer {
public:
  /// `kind` tells what is in the file; Hdf5Reader asks for it.
  Hdf5Writer(const std::filesystem::path& file, const std::string& kind, MPI_Comm communicator);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// A data set of the rows that the ranks have, one rank after the other. Each writes its own.
  void rows(const std::string& name, const std::vector<double>& mine, unsigned n_columns = 1);
  void rows(const std::string& name, const std::vector<float>& mine, unsigned n_columns = 1);
  void rows(const std::string& name, const std::vector<unsigned>& mine, unsigned n_columns = 1);
  /// Attributes of the group in which they are named; the same on all ranks.
  void number(const std::string& name, double value);
  void text(const std::string& name, const std::string& value);

  /// Writes the file, in place of an older one.
  /// @throws Error if it cannot be written completely, on a full disk for instance; the older one
  /// is then still there.
  void commit();

private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads what Hdf5Writer wrote, on any number of ranks. All functions are collective, and give
/// every rank the same. They throw an Error where something is missing.
class Hdf5Reader {
public:
  /// `advice` says what to do instead: it ends the sentence of an error.
  /// @throws Error if there is no such file, it is damaged, or it is of another kind or layout.
  Hdf5Reader(const std::filesystem::path& file, const std::string& kind, MPI_Comm communicator,
             const std::string& advice);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  /// The rows of a data set, one after the other.
  std::vector<double> doubles(const std::string& name) const;
  std::vector<float> floats(const std::string& name) const;
  std::vector<unsigned> integers(const std::string& name) const;
  /// An attribute.
  double number(const std::string& name) const;
  std::string text(const std::string& name) const;
  /// The data sets of a group, or the attributes; sorted. None if there is no such group.
  std::vector<std::string> data_sets(const std::string& group) const;
  std::vector<std::string> attributes(const std::string& group) const;

private:
  struct File;
  std::unique_ptr<File> file_;
};

} // namespace prosup::output

#endif
