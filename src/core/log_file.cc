#include "prosup/core/log_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <ctime>
#include <sstream>
#include <utility>

#include "prosup/core/text_file.h"

namespace prosup {

namespace {

LogFile* open_file = nullptr; // of all Logs of the process

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  localtime_r(&seconds, &parts);
  char text[32] = "";
  std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", &parts);
  return text;
}

} // namespace

LogFile::LogFile(std::filesystem::path file) : file_(std::move(file)) {
  // What ranks append does not overwrite that of others.
  descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw_cannot_write(file_);
  open_file = this;
}

LogFile::~LogFile() {
  open_file = nullptr;
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void LogFile::close() {
  open_file = nullptr;
  if (descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0)
    is_complete_ = false;
  if (!is_complete_)
    throw_cannot_write(file_);
}

void LogFile::add(const std::string& text) {
  if (open_file != nullptr)
    open_file->write(text);
}

void LogFile::write(const std::string& text) {
  std::string lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines += now() + (line.empty() ? "" : "  ") + line + "\n";
  if (::write(descriptor_, lines.data(), lines.size()) != static_cast<ssize_t>(lines.size()))
    is_complete_ = false;
}

} // namespace prosup
