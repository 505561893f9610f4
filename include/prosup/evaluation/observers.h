#ifndef PROSUP_EVALUATION_OBSERVERS_H
#define PROSUP_EVALUATION_OBSERVERS_H

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"

namespace prosup::evaluation {

/// The landmarks that one observer picked.
struct LandmarkObserver {
  std::string name;
  std::vector<Landmark> landmarks;
};

/// Reads the landmarks of an observer, who is named after the file. What was turned or assumed
/// goes to `remarks`.
/// @throws Error as read_landmarks().
LandmarkObserver read_observer(const std::filesystem::path& file, Remarks& remarks);

/// Reads a control observer, who saw the prone landmarks of `first` and picked the supine
/// positions: a CSV file with the columns id, supine_x, supine_y and supine_z, or a file for
/// read_points(). The prone positions are those of `first`.
/// @throws Error as read_points(), or for an id that `first` does not have.
LandmarkObserver read_control_observer(const std::filesystem::path& file,
                                       const LandmarkObserver& first, Remarks& remarks);

/// The landmarks over which a statistic is taken.
enum class Selection { all, reliable };

/// A row of the tables, mm. `error` is empty (n = 0) if no landmark is left.
struct ObserverRow {
  std::string observer;
  Selection selection;
  ErrorStatistics initial; ///< distance between prone and supine position
  ErrorStatistics error;   ///< target registration error
};

/// Distances between the positions of two observers, mm.
struct ObserverDistance {
  std::string first, second;
  std::string state; ///< prone or supine
  ErrorStatistics all, reliable;
};

/// Landmarks of several observers, as in Eiben et al. (2016). If two observers place a landmark
/// further apart than a limit (10 mm in the paper), they may have picked different structures,
/// and the landmark is excluded. The remaining landmarks of all observers are pooled ("Two
/// observers, combined" in Table 3). The mean position of the observers is not in the paper.
class ObserverStudy {
public:
  /// Uses the landmarks whose id all observers have.
  /// `exclude_above` is the largest distance between two observers, mm.
  /// @throws Error if there is no observer, or no landmark that all of them have.
  ObserverStudy(std::vector<LandmarkObserver> observers, double exclude_above);

  std::size_t n_landmarks() const { return common_[0].landmarks.size(); }
  /// Number of landmarks that at least one observer does not have.
  std::size_t n_incomplete() const { return n_incomplete_; }
  /// Ids of the landmarks that are excluded.
  const std::vector<std::string>& outliers() const { return outliers_; }

  /// Each pair of observers, prone and supine (Table 5). Pairs with identical positions are
  /// left out, such as the prone ones of a control observer.
  std::vector<ObserverDistance> distances() const;

  /// Table 3: each observer with all landmarks, then with the reliable ones, then the reliable
  /// landmarks of all observers, pooled and as mean positions.
  std::vector<ObserverRow> rows(const PointMapper& prone, const PointMapper& supine) const;

private:
  LandmarkObserver mean_observer() const;
  std::vector<Landmark> select(const LandmarkObserver& observer, Selection selection) const;

  std::vector<LandmarkObserver> common_; ///< the landmarks that all have, in one order
  std::vector<bool> reliable_;
  std::vector<std::string> outliers_;
  std::size_t n_incomplete_ = 0;
};

/// The first line of what write_observer_tables() writes.
constexpr const char* observer_tables_header =
    "quantity,observer,landmarks,n,mean_mm,std_mm,max_mm";

/// Writes both tables to one CSV file with the columns quantity (initial_distance,
/// registration_error, observer_distance_prone or observer_distance_supine), observer,
/// landmarks (all or reliable), n, mean_mm, std_mm and max_mm.
/// @throws Error if the file cannot be written.
void write_observer_tables(const std::vector<ObserverRow>& rows,
                           const std::vector<ObserverDistance>& distances,
                           const std::filesystem::path& file);

/// The tables in Markdown, in the form of Tables 3 and 5 of the paper.
std::string observer_tables(const std::vector<ObserverRow>& rows,
                            const std::vector<ObserverDistance>& distances);

} // namespace prosup::evaluation

#endif
