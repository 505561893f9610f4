#include "prosup/core/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/file_system.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::string first_line(const fs::path& file) {
  std::string line(4096, '\0'); // longer lines are none of ours
  std::ifstream stream(file, std::ios::binary);
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  return line.substr(0, line.find('\n'));
}

/// Whether a file or what a link leads to is a device or a pipe. These have to be opened by the
/// link: a pipe at the end of /dev/stdout has no other name.
bool is_device(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

} // namespace

OutputFile::OutputFile(const fs::path& file, OutputFileRules rules)
    : given_(file), rules_(std::move(rules)),
      file_(is_device(file) ? absolute_path(file) : without_links(file)) {
  check();
  if (is_device(file_))
    temporary_ = file_;
  else
    make_temporary();
}

OutputFile::~OutputFile() {
  const auto lock = uninterrupted();
  unfinished_.reset();
  std::error_code ignored;
  if (lock_ >= 0) {
    fs::remove(temporary_, ignored);
    close(lock_);
  }
}

void OutputFile::check() const {
  const fs::file_status status = fs::status(file_);
  if (fs::is_directory(status))
    throw Error("The output '" + given_.string() + "' is a folder; give the name of a file.");
  if (const fs::path input = input_at(file_, rules_.inputs); !input.empty())
    throw Error("The output '" + given_.string() + "' is the input '" + input.string() +
                "', which would be lost; give the name of another file.");
  if (fs::is_regular_file(status) && fs::file_size(file_) > 0 && !rules_.overwrite &&
      !rules_.first_line.empty() && !is_ours(first_line(file_)))
    throw_in_the_way();
}

bool OutputFile::is_ours(const std::string& line) const {
  const std::vector<std::string>& others = rules_.other_first_lines;
  return line == rules_.first_line || std::find(others.begin(), others.end(), line) != others.end();
}

void OutputFile::throw_in_the_way() const {
  throw Error("The output '" + given_.string() +
              "' exists and is not what this command has written; give the name of another file, "
              "or replace it with --overwrite.");
}

void OutputFile::make_temporary() {
  const fs::path folder = file_.parent_path();
  temporary_ = folder / unfinished_name(folder, file_.filename().string(), rules_.ending);
  lock_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0 && errno == EACCES && access(file_.c_str(), W_OK) == 0) {
    temporary_ = file_; // in a folder to which nothing can be added
    return;
  }
  if (lock_ < 0)
    throw Error("The file '" + given_.string() + "' cannot be written (" + std::strerror(errno) +
                "); check that its folder exists, may be written to and has space left.");
  unfinished_ = std::make_unique<Unfinished>([this] {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  });
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    unfinished_.reset();
    close(lock_);
    throw Error("Another run is writing to '" + given_.string() +
                "'; wait for its end or give the name of another file.");
  }
  name_ = std::make_unique<TemporaryName>(temporary_, given_);
  struct stat there {};
  if (stat(file_.c_str(), &there) == 0)
    fchmod(lock_, there.st_mode & 07777);
}

void OutputFile::commit() {
  const auto lock = uninterrupted();
  if (temporary_ == file_)
    return;
  check(); // it may have come there meanwhile
  std::error_code error;
  if (rules_.first_line.empty() && !rules_.overwrite && fs::exists(file_) &&
      contents(file_) != contents(temporary_))
    throw_in_the_way();
  flush_to_disk(temporary_);
  fs::rename(temporary_, file_, error);
  if (error)
    throw Error("The file '" + given_.string() + "' cannot be replaced (" + error.message() +
                "); give the name of another file.");
  unfinished_.reset();
  close(lock_);
  lock_ = -1;
}

} // namespace prosup
