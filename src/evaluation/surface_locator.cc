#include "surface_locator.h"

#include <algorithm>
#include <limits>

namespace prosup::evaluation {

namespace {

constexpr unsigned leaf_size = 4;

/// A point on a triangle. Weights are exactly 0 where it lies on an edge or corner.
struct Candidate {
  std::array<double, 3> weights;
  double squared_distance;
};

/// Position of p along the edge `e` as part of its length, for e . p and e . e.
double along(double e_dot_p, double e_dot_e) {
  return e_dot_e > 0. ? std::clamp(e_dot_p / e_dot_e, 0., 1.) : 0.;
}

/// The closest point of the triangle (0, e1, e2) to r.
Candidate closest_to(const Tensor<1, 3>& r, const Tensor<1, 3>& e1, const Tensor<1, 3>& e2) {
  const double e11 = e1 * e1, e12 = e1 * e2, e22 = e2 * e2, r1 = e1 * r, r2 = e2 * r;
  const auto at = [&](double w0, double w1, double w2) {
    return Candidate{{w0, w1, w2}, (r - w1 * e1 - w2 * e2).norm_square()};
  };
  const double squared_area = e11 * e22 - e12 * e12;
  if (squared_area > 1e-20 * e11 * e22) {
    const double w1 = (e22 * r1 - e12 * r2) / squared_area,
                 w2 = (e11 * r2 - e12 * r1) / squared_area;
    if (w1 >= 0. && w2 >= 0. && w1 + w2 <= 1.)
      return at(1. - w1 - w2, w1, w2);
  }
  const double t1 = along(r1, e11), t2 = along(r2, e22),
               t12 = along(r2 - r1 - e12 + e11, e11 - 2. * e12 + e22);
  return std::min({at(1. - t1, t1, 0.), at(1. - t2, 0., t2), at(0., 1. - t12, t12)},
                  [](const Candidate& a, const Candidate& b) {
                    return a.squared_distance < b.squared_distance;
                  });
}

/// Gradients of the weights with respect to the point that is projected.
std::array<Tensor<1, 3>, 3> weight_gradients(const std::array<double, 3>& weights,
                                             const Tensor<1, 3>& e1, const Tensor<1, 3>& e2) {
  std::array<Tensor<1, 3>, 3> gradients;
  const std::array<Tensor<1, 3>, 3> corners = {Tensor<1, 3>(), e1, e2};
  const auto n_used =
      std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0.; });
  if (n_used == 3) {
    const double e11 = e1 * e1, e12 = e1 * e2, e22 = e2 * e2, squared_area = e11 * e22 - e12 * e12;
    gradients[1] = (e22 * e1 - e12 * e2) / squared_area;
    gradients[2] = (e11 * e2 - e12 * e1) / squared_area;
    gradients[0] = -(gradients[1] + gradients[2]);
  } else if (n_used == 2) {
    const unsigned a = weights[0] > 0. ? 0 : 1, b = weights[2] > 0. ? 2 : 1;
    const Tensor<1, 3> edge = corners[b] - corners[a];
    gradients[b] = edge / edge.norm_square();
    gradients[a] = -gradients[b];
  }
  return gradients;
}

} // namespace

SurfaceLocator::SurfaceLocator(const std::vector<Point<3>>& nodes, const std::vector<Face>& faces)
    : place_of_face_(faces.size()) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Point<3>& origin = nodes[faces[f][0]];
    triangles_.push_back({origin, nodes[faces[f][1]] - origin, nodes[faces[f][2]] - origin, f});
  }
  add_box(0, static_cast<unsigned>(triangles_.size()));
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    place_of_face_[triangles_[i].face] = static_cast<unsigned>(i);
}

unsigned SurfaceLocator::add_box(unsigned first, unsigned end) {
  const auto index = static_cast<unsigned>(boxes_.size());
  Box box{triangles_[first].origin, triangles_[first].origin, first, end, 0};
  for (unsigned i = first; i < end; ++i)
    for (const Tensor<1, 3>& corner : {Tensor<1, 3>(), triangles_[i].e1, triangles_[i].e2})
      for (unsigned d = 0; d < 3; ++d) {
        box.low[d] = std::min(box.low[d], triangles_[i].origin[d] + corner[d]);
        box.high[d] = std::max(box.high[d], triangles_[i].origin[d] + corner[d]);
      }
  boxes_.push_back(box);
  if (end - first <= leaf_size)
    return index;
  const Tensor<1, 3> extent = box.high - box.low;
  unsigned axis = extent[1] > extent[0] ? 1 : 0;
  axis = extent[2] > extent[axis] ? 2 : axis;
  const unsigned middle = first + (end - first) / 2;
  const auto centre = [axis](const Triangle& t) {
    return 3. * t.origin[axis] + t.e1[axis] + t.e2[axis];
  };
  std::nth_element(triangles_.begin() + first, triangles_.begin() + middle,
                   triangles_.begin() + end,
                   [&](const Triangle& a, const Triangle& b) { return centre(a) < centre(b); });
  add_box(first, middle);
  boxes_[index].second_half = add_box(middle, end);
  return index;
}

SurfaceLocator::Hit SurfaceLocator::closest(const Point<3>& p) const {
  return closest(p, triangles_.front().face);
}

SurfaceLocator::Hit SurfaceLocator::closest(const Point<3>& p, std::size_t guess) const {
  unsigned best = place_of_face_[guess];
  const auto look_at = [&](unsigned i) {
    const Triangle& t = triangles_[i];
    return closest_to(p - t.origin, t.e1, t.e2);
  };
  Candidate closest = look_at(best);
  struct Waiting {
    unsigned box;
    double squared_distance;
  };
  std::array<Waiting, 64> waiting; // the tree is at most 32 boxes deep
  std::size_t n_waiting = 0;
  waiting[n_waiting++] = {0, boxes_[0].squared_distance(p)};
  while (n_waiting > 0) {
    const Waiting next = waiting[--n_waiting];
    if (next.squared_distance >= closest.squared_distance)
      continue;
    const Box& box = boxes_[next.box];
    if (box.second_half == 0) {
      for (unsigned i = box.first; i < box.end; ++i)
        if (const Candidate c = look_at(i); c.squared_distance < closest.squared_distance) {
          closest = c;
          best = i;
        }
      continue;
    }
    Waiting near{next.box + 1, boxes_[next.box + 1].squared_distance(p)},
        far{box.second_half, boxes_[box.second_half].squared_distance(p)};
    if (far.squared_distance < near.squared_distance)
      std::swap(near, far);
    waiting[n_waiting++] = far;
    waiting[n_waiting++] = near;
  }
  const Triangle& t = triangles_[best];
  return {t.face, closest.weights, weight_gradients(closest.weights, t.e1, t.e2),
          closest.squared_distance};
}

} // namespace prosup::evaluation
