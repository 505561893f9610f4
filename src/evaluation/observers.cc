#include "prosup/evaluation/observers.h"

#include <algorithm>
#include <map>

#include "csv.h"
#include "prosup/core/error.h"
#include "prosup/evaluation/points.h"
#include "text_input.h"

namespace prosup::evaluation {

namespace {

const Landmark* find(const LandmarkObserver& observer, const std::string& id) {
  const auto found = std::find_if(observer.landmarks.begin(), observer.landmarks.end(),
                                  [&](const Landmark& landmark) { return landmark.id == id; });
  return found == observer.landmarks.end() ? nullptr : &*found;
}

std::vector<NamedPoint> read_supine_points(const std::filesystem::path& file, Remarks& remarks) {
  if (point_format(file) != PointFormat::csv)
    return read_points(file, remarks);
  const csv::Table table(as_utf8(read_file(file), file.string(), remarks), file.string());
  if (!table.find("supine_x"))
    return read_points(file, remarks);
  const std::size_t id = table.id_column();
  const csv::PointColumns columns = table.point_columns("supine_", remarks);
  std::vector<NamedPoint> points;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    points.push_back({table.text(row, id), table.point(row, columns)});
  return points;
}

ErrorStatistics statistics_or_none(std::vector<double> values) {
  return values.empty() ? ErrorStatistics() : statistics(std::move(values));
}

using Position = Point<3> Landmark::*;

} // namespace

LandmarkObserver read_observer(const std::filesystem::path& file, Remarks& remarks) {
  return {file.stem().string(), read_landmarks(file, remarks)};
}

LandmarkObserver read_control_observer(const std::filesystem::path& file,
                                       const LandmarkObserver& first, Remarks& remarks) {
  LandmarkObserver control{file.stem().string(), {}};
  for (const NamedPoint& point : read_supine_points(file, remarks)) {
    const Landmark* shown = find(first, point.id);
    if (shown == nullptr || find(control, point.id) != nullptr)
      throw Error("The landmark '" + point.id + "' of the control observer '" + file.string() +
                  (shown == nullptr ? "' is none of those of the first observer, '" + first.name +
                                          "'; use the ids of the first observer."
                                    : "' occurs twice; give it once."));
    control.landmarks.push_back({point.id, shown->prone, point.position, {}});
  }
  return control;
}

ObserverStudy::ObserverStudy(std::vector<LandmarkObserver> observers, double exclude_above) {
  if (observers.empty())
    throw Error("No observer is given; name at least one file of landmarks.");
  std::map<std::string, std::size_t> n_seen;
  for (const LandmarkObserver& observer : observers)
    for (const Landmark& landmark : observer.landmarks)
      ++n_seen[landmark.id];
  for (const LandmarkObserver& observer : observers)
    common_.push_back({observer.name, {}});
  for (const Landmark& landmark : observers[0].landmarks)
    if (n_seen[landmark.id] == observers.size())
      for (std::size_t o = 0; o < observers.size(); ++o)
        common_[o].landmarks.push_back(*find(observers[o], landmark.id));
  if (n_landmarks() == 0)
    throw Error("There is no landmark that all observers have; give the same structure the same "
                "id in all files.");
  n_incomplete_ = n_seen.size() - n_landmarks();

  for (std::size_t l = 0; l < n_landmarks(); ++l) {
    double largest = 0.;
    for (const LandmarkObserver& a : common_)
      for (const LandmarkObserver& b : common_)
        for (const Position position : {&Landmark::prone, &Landmark::supine})
          largest =
              std::max(largest, (a.landmarks[l].*position).distance(b.landmarks[l].*position));
    reliable_.push_back(largest <= exclude_above);
    if (!reliable_.back())
      outliers_.push_back(common_[0].landmarks[l].id);
  }
}

std::vector<Landmark> ObserverStudy::select(const LandmarkObserver& observer,
                                            Selection selection) const {
  std::vector<Landmark> selected;
  for (std::size_t l = 0; l < n_landmarks(); ++l)
    if (selection == Selection::all || reliable_[l])
      selected.push_back(observer.landmarks[l]);
  return selected;
}

LandmarkObserver ObserverStudy::mean_observer() const {
  LandmarkObserver mean{"mean position", common_[0].landmarks};
  const auto n = double(common_.size());
  for (std::size_t l = 0; l < n_landmarks(); ++l)
    for (const Position position : {&Landmark::prone, &Landmark::supine}) {
      dealii::Tensor<1, 3> sum;
      for (const LandmarkObserver& observer : common_)
        sum += observer.landmarks[l].*position - Point<3>();
      mean.landmarks[l].*position = Point<3>(sum / n);
    }
  return mean;
}

std::vector<ObserverDistance> ObserverStudy::distances() const {
  std::vector<ObserverDistance> result;
  const auto add = [&](const LandmarkObserver& a, const LandmarkObserver& b, const char* state,
                       Position position) {
    std::vector<double> all, reliable;
    for (std::size_t l = 0; l < n_landmarks(); ++l) {
      all.push_back((a.landmarks[l].*position).distance(b.landmarks[l].*position));
      if (reliable_[l])
        reliable.push_back(all.back());
    }
    if (*std::max_element(all.begin(), all.end()) > 0.)
      result.push_back(
          {a.name, b.name, state, statistics(all), statistics_or_none(std::move(reliable))});
  };
  for (std::size_t a = 0; a < common_.size(); ++a)
    for (std::size_t b = a + 1; b < common_.size(); ++b) {
      add(common_[a], common_[b], "prone", &Landmark::prone);
      add(common_[a], common_[b], "supine", &Landmark::supine);
    }
  return result;
}

std::vector<ObserverRow> ObserverStudy::rows(const PointMapper& prone,
                                             const PointMapper& supine) const {
  std::vector<ObserverRow> result;
  const auto add = [&](const std::string& name, Selection selection,
                       const std::vector<Landmark>& landmarks) {
    ObserverRow row{name, selection, {}, {}};
    if (!landmarks.empty()) {
      row.initial = initial_error(landmarks);
      row.error = unloaded_error(landmarks, prone, supine);
    }
    result.push_back(std::move(row));
  };
  for (const LandmarkObserver& observer : common_)
    add(observer.name, Selection::all, observer.landmarks);
  if (common_.size() == 1)
    return result;
  std::vector<Landmark> together;
  for (const LandmarkObserver& observer : common_) {
    const std::vector<Landmark> reliable = select(observer, Selection::reliable);
    add(observer.name, Selection::reliable, reliable);
    together.insert(together.end(), reliable.begin(), reliable.end());
  }
  add("combined", Selection::reliable, together);
  add("mean position", Selection::reliable, select(mean_observer(), Selection::reliable));
  return result;
}

} // namespace prosup::evaluation
