#ifndef PROSUP_EVALUATION_OBSERVERS_H
#define PROSUP_EVALUATION_OBSERVERS_H

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"

namespace prosup::evaluation {

/// The landmarks that one observer picked.
struct Observer {
  std::string name;
  std::vector<Landmark> landmarks;
};

/// Reads an observer; the name is that of the file. @throws Error as read_landmarks().
Observer read_observer(const std::filesystem::path& file);

/// Reads a control observer, who was shown the prone landmarks of `first` and picked
/// their supine partners: CSV with the columns id, supine_x, supine_y, supine_z, or
/// points as read_points() reads them. The prone positions are those of `first`.
/// @throws Error as read_points(), or for an id that `first` does not have.
Observer read_control_observer(const std::filesystem::path& file, const Observer& first);

/// Which landmarks a figure is of.
enum class Selection { all, reliable };

/// A row of the tables, mm. `error` is empty (n = 0) if no landmark was left.
struct ObserverRow {
  std::string observer;
  Selection selection;
  ErrorStatistics initial; ///< distance of prone and supine position
  ErrorStatistics error;   ///< target registration error
};

/// How far two observers were apart, mm.
struct ObserverDistance {
  std::string first, second;
  std::string state; ///< prone or supine
  ErrorStatistics all, reliable;
};

/// Landmarks of several observers, after Eiben et al. (2016): one that two observers
/// place further apart than a limit (10 mm there) may be of two structures and does
/// not count. Those of all observers within the limit are then taken together
/// ("Two observers, combined" of Table 3); the mean position of the observers is
/// an addition to the paper.
class ObserverStudy {
public:
  /// The landmarks are those that all observers have, by id.
  /// @param exclude_above limit of the distance, mm
  /// @throws Error if there is no observer, or no landmark that all have.
  ObserverStudy(std::vector<Observer> observers, double exclude_above);

  std::size_t n_landmarks() const { return common_[0].landmarks.size(); }
  /// Landmarks that some observer does not have.
  std::size_t n_incomplete() const { return n_incomplete_; }
  /// Ids of the landmarks that are excluded.
  const std::vector<std::string>& outliers() const { return outliers_; }

  /// Every pair of observers, in both states; a pair that has the same positions in
  /// a state, as a control observer does, is left out there. Table 5.
  std::vector<ObserverDistance> distances() const;

  /// Each observer with all landmarks; then the reliable ones of each, of all
  /// together, and of their mean positions. Table 3.
  std::vector<ObserverRow> rows(const PointMapper& prone, const PointMapper& supine) const;

private:
  Observer mean_observer() const;
  std::vector<Landmark> select(const Observer& observer, Selection selection) const;

  std::vector<Observer> common_; ///< the landmarks that all have, in one order
  std::vector<bool> reliable_;
  std::vector<std::string> outliers_;
  std::size_t n_incomplete_ = 0;
};

/// Writes both tables as one CSV file, one figure a row: quantity (initial_distance,
/// registration_error, observer_distance_prone, observer_distance_supine), observer,
/// landmarks (all, reliable), n, mean_mm, std_mm, max_mm.
/// @throws Error if the file cannot be written.
void write_observer_tables(const std::vector<ObserverRow>& rows,
                           const std::vector<ObserverDistance>& distances,
                           const std::filesystem::path& file);

/// The tables as Markdown, in the form of Tables 3 and 5 of the paper.
std::string observer_tables(const std::vector<ObserverRow>& rows,
                            const std::vector<ObserverDistance>& distances);

} // namespace prosup::evaluation

#endif
