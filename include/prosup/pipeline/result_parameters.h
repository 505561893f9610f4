#ifndef PROSUP_PIPELINE_RESULT_PARAMETERS_H
#define PROSUP_PIPELINE_RESULT_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

namespace prosup::pipeline {

/// Contents of the result folder, section "Results".
class ResultParameters : public dealii::ParameterAcceptor {
public:
  ResultParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  double voxel_edge = 1.; ///< of the common unloaded grid, mm
  double margin = 10.;    ///< of that grid around both meshes, mm
  bool other_states = true;
  bool pictures = true;
};

} // namespace prosup::pipeline

#endif
