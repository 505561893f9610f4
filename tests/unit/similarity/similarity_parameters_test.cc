#include "prosup/similarity/similarity_parameters.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/core/parameters.h"
#include "warped_pairs.h"

namespace prosup::tests {
namespace {

using similarity::Metric;
using similarity::metric_names;
using similarity::SimilarityParameters;

/// A metric as a host program may bring it: a constant that is a parameter.
class Constant : public Metric {
public:
  explicit Constant(std::string name) : name_(std::move(name)) {}
  std::string name() const override { return name_; }
  bool needs_same_contrast() const override { return false; }
  void declare_parameters(dealii::ParameterHandler& prm) override {
    prm.enter_subsection(name_);
    prm.add_parameter("Value", value_);
    prm.leave_subsection();
  }
  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override {
    derivatives.reset(pair.in_domain.size());
    return value_;
  }

private:
  std::string name_;
  double value_ = 1.;
};

double value_of(const Metric& metric) {
  VoxelDerivatives derivatives;
  return metric.evaluate(warped_pair(
                             blobs, [](const auto& x) { return 1. - blobs(x); }, 0.05),
                         derivatives);
}

/// The value with a metric and the overrides.
double value_with(const std::vector<Override>& overrides) {
  SimilarityParameters parameters;
  dealii::ParameterHandler handler;
  read_parameters(handler, {}, overrides);
  return value_of(*parameters.make_metric());
}

TEST(SimilarityParameters, MetricsHaveDifferentNames) {
  std::vector<std::string> names = metric_names();
  EXPECT_EQ(SimilarityParameters().make_metric()->name(), names.front());
  EXPECT_EQ(SimilarityParameters().make_metric(true)->name(), "lncc");
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

TEST(SimilarityParameters, EachMetricReadsItsOwnSubsection) {
  const double present = value_with({"Similarity/Metric=lncc"});
  EXPECT_NE(value_with({"Similarity/Metric=lncc", "Similarity/lncc/Noise=0.1"}), present);
  EXPECT_NE(value_with({"Similarity/Metric=lncc", "Similarity/lncc/Window radius=6"}), present);
  EXPECT_EQ(value_with({"Similarity/Metric=lncc", "Similarity/nmi/Bins=16"}), present);
  EXPECT_NE(value_with({"Similarity/Metric=nmi", "Similarity/nmi/Bins=16"}),
            value_with({"Similarity/Metric=nmi"}));
  SimilarityParameters chosen;
  chosen.metric = "ssd";
  EXPECT_EQ(chosen.make_metric(true)->name(), "ssd");
  expect_error([] { value_with({"Similarity/lncc/Noise=-1"}); }, {"Noise", "-1"});
  expect_error([] { value_with({"Similarity/lncc/Bins=16"}); }, {"Bins"});
}

TEST(SimilarityParameters, UnknownNameIsAnsweredWithTheList) {
  expect_error(
      [] {
        SimilarityParameters parameters;
        parameters.metric = "psnr";
        parameters.make_metric();
      },
      {"psnr", "allowed are: ssd, nmi, lncc"});
  expect_error([] { value_with({"Similarity/Metric=psnr"}); }, {"psnr", "ssd", "nmi", "lncc"});
}

TEST(SimilarityParameters, TakeAMetricOfTheHost) {
  SimilarityParameters parameters;
  parameters.add_metric(std::make_shared<Constant>("constant"));
  dealii::ParameterHandler handler;
  read_parameters(handler, {}, {"Similarity/Metric=constant", "Similarity/constant/Value=7"});
  EXPECT_EQ(value_of(*parameters.make_metric()), 7.);
  expect_error([&] { parameters.add_metric(std::make_shared<Constant>("lncc")); },
               {"lncc", "another name"});
}

} // namespace
} // namespace prosup::tests
