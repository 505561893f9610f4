#ifndef PROSUP_OUTPUT_VTK_ERRORS_H
#define PROSUP_OUTPUT_VTK_ERRORS_H

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkLogger.h>

namespace prosup::output {

/// Takes the error messages of a VTK reader or writer and of its executive, which
/// they would print otherwise.
class VtkErrors : public vtkCommand {
public:
  static VtkErrors* New() { return new VtkErrors; }

  void listen_to(vtkAlgorithm& algorithm) {
    algorithm.AddObserver(ErrorEvent, this);
    algorithm.GetExecutive()->AddObserver(ErrorEvent, this);
  }

  void Execute(vtkObject*, unsigned long, void*) override { any_ = true; }

  bool any() const { return any_; }

private:
  bool any_ = false;
};

/// Keeps what VTK logs from standard error while it lives; VtkErrors still hears it.
class QuietVtk {
public:
  QuietVtk() : before_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~QuietVtk() { vtkLogger::SetStderrVerbosity(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

private:
  vtkLogger::Verbosity before_;
};

} // namespace prosup::output

#endif
