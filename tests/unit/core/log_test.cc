#include "prosup/core/log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "prosup/core/log_file.h"
#include "prosup/core/log_level.h"
#include "prosup/core/remaining_time.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

struct Shown {
  std::string out, err, file;
};

/// What a log shows and writes to its file at a level.
Shown shown_at(LogLevel level) {
  const TemporaryFolder folder;
  set_log_level(level);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    LogFile file(folder / "log.txt");
    const Log log(MPI_COMM_SELF);
    log.line("Meshing");
    log.progress("step 10");
    log.warning("It is late.");
    file.close();
  }
  set_log_level(LogLevel::info);
  Shown shown{testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr(), ""};
  shown.file = contents(folder / "log.txt");
  return shown;
}

TEST(Log, ShowsMoreFromLevelToLevel) {
  const std::string warning = "Warning: It is late.\n";
  const Shown error = shown_at(LogLevel::error), quiet = shown_at(LogLevel::warning),
              usual = shown_at(LogLevel::info), all = shown_at(LogLevel::debug);
  EXPECT_EQ(error.out + error.err, "");
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, warning);
  EXPECT_EQ(usual.out, "Meshing\n") << "the live line belongs to a terminal";
  EXPECT_EQ(usual.err, warning);
  EXPECT_EQ(all.out, "Meshing\nstep 10\n");
  EXPECT_EQ(all.err, warning);
}

TEST(Log, WritesLinesAndWarningsToTheFileAtAnyLevel) {
  for (const LogLevel level : {LogLevel::error, LogLevel::warning, LogLevel::info}) {
    const std::string file = shown_at(level).file;
    EXPECT_NE(file.find("  Meshing\n"), std::string::npos) << file;
    EXPECT_NE(file.find("  Warning: It is late.\n"), std::string::npos) << file;
    EXPECT_EQ(file.find("step 10"), std::string::npos) << file;
  }
  EXPECT_NE(shown_at(LogLevel::debug).file.find("  step 10\n"), std::string::npos);
}

/// Standard output on a terminal, as long as it lives.
class Terminal {
public:
  Terminal() {
    std::fflush(stdout);
    master_ = posix_openpt(O_RDWR | O_NOCTTY);
    grantpt(master_);
    unlockpt(master_);
    before_ = dup(STDOUT_FILENO);
    const int slave = open(ptsname(master_), O_RDWR | O_NOCTTY);
    dup2(slave, STDOUT_FILENO);
    close(slave);
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() {
    std::fflush(stdout);
    dup2(before_, STDOUT_FILENO);
    close(before_);
    close(master_);
  }
  std::string text() const {
    char buffer[4096];
    const ssize_t n = read(master_, buffer, sizeof(buffer));
    return n > 0 ? std::string(buffer, static_cast<std::size_t>(n)) : "";
  }

private:
  int master_, before_;
};

class LiveLine : public ::testing::Test {
protected:
  void SetUp() override {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
      GTEST_SKIP() << "mpirun's output is the terminal that counts";
  }
  void TearDown() override { set_log_level(LogLevel::info); }

  /// What a live line shows, long enough after the last one.
  static std::string progress() {
    usleep(220000);
    const Terminal terminal;
    Log(MPI_COMM_SELF).progress("step 10");
    return terminal.text();
  }
};

TEST_F(LiveLine, TellsTheRemainingTimeOfTheOutermostWork) {
  EXPECT_EQ(progress(), "\r\033[Kstep 10");
  RemainingTime stage;
  EXPECT_EQ(progress(), "\r\033[Kstep 10");
  stage.expect(121.);
  EXPECT_EQ(progress(), "\r\033[Kstep 10, about 2 min left");
  {
    RemainingTime part;
    part.expect(20.);
    EXPECT_EQ(progress(), "\r\033[Kstep 10, about 2 min left") << "a part is not heard";
  }
  EXPECT_EQ(progress(), "\r\033[Kstep 10, about 2 min left");
  stage.expect({});
  EXPECT_EQ(progress(), "\r\033[Kstep 10");
}

TEST_F(LiveLine, IsNotShownBelowInfo) {
  RemainingTime stage;
  stage.expect(121.);
  for (const LogLevel level : {LogLevel::error, LogLevel::warning}) {
    set_log_level(level);
    EXPECT_EQ(progress(), "");
  }
}

} // namespace
} // namespace prosup::tests
