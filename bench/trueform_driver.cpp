// trueform_driver.cpp -- trueform as a peer of peers/boolean/bench.py:
//
//   d_trueform union|inter|diff|curve A.off B.off OUT.off|- REPS
//
// Built by bench/peers.bash with its headers and io.h of the peers. `build` is
// what it makes of each mesh before: a tree and the links of its faces; with
// REPS more than one these are kept.
#include <trueform/trueform.hpp>

#include "io.h"

namespace {

using Buffer = tf::polygons_buffer<int, double, 3, 3>;

Buffer buffer_of(const Mesh &mesh)
{
  Buffer buffer;
  auto &points = buffer.points_buffer();
  auto &faces = buffer.faces_buffer();
  points.allocate(mesh.nv);
  faces.allocate(mesh.nt);
  for (long i = 0; i < mesh.nv; i++) {
    for (int k = 0; k < 3; k++) {
      points[i][k] = mesh.v[3 * i + k];
    }
  }
  for (long i = 0; i < mesh.nt; i++) {
    for (int k = 0; k < 3; k++) {
      faces[i][k] = mesh.t[3 * i + k];
    }
  }
  return buffer;
}

// What it asks of a mesh.
struct Form {
  tf::face_membership<int> membership;
  tf::manifold_edge_link<int, 3> link;
  tf::aabb_tree<int, double, 3> tree;

  explicit Form(const Buffer &buffer)
  {
    const auto polygons = buffer.polygons();
    membership.build(polygons);
    link.build(polygons.faces(), membership);
    tree.build(polygons, tf::config_tree(4, 4));
  }

  auto of(const Buffer &buffer) const
  {
    return buffer.polygons() | tf::tag(link) | tf::tag(membership) |
           tf::tag(tree);
  }
};

void save(const char *name, Buffer &made)
{
  std::vector<double> v;
  std::vector<int> t;
  for (const auto &point : made.points()) {
    v.insert(v.end(), {point[0], point[1], point[2]});
  }
  for (const auto &face : made.faces()) {
    t.insert(t.end(), {face[0], face[1], face[2]});
  }
  save_off(name, v.data(), (long)(v.size() / 3), t.data(),
           (long)(t.size() / 3));
}

} // namespace

int main(int count, char **words)
{
  if (count != 6) {
    return 2;
  }
  const char *mode = words[1];
  const int reps = atoi(words[5]);
  const Buffer a = buffer_of(load_off(words[2]));
  const Buffer b = buffer_of(load_off(words[3]));
  std::vector<double> op((size_t)reps);
  long triangles = 0, pieces = 0, lines = 0;

  double start = now();
  const Form form_a(a), form_b(b);
  const double build = now() - start;
  for (double &seconds : op) {
    start = now();
    if (!strcmp(mode, "curve")) {
      auto curves = tf::make_intersection_curves(form_a.of(a), form_b.of(b));
      seconds = now() - start;
      lines = (long)curves.size();
      pieces = 0;
      for (const auto &path : curves.paths()) {
        pieces += (long)path.size() - 1;
      }
      continue;
    }
    const auto which = !strcmp(mode, "union")   ? tf::boolean_op::merge
                       : !strcmp(mode, "inter") ? tf::boolean_op::intersection
                                                : tf::boolean_op::left_difference;
    auto [made, labels] =
        tf::make_boolean(form_a.of(a), form_b.of(b), which);
    seconds = now() - start;
    triangles = (long)made.size();
    if (&seconds == &op.back()) {
      save(words[4], made);
    }
  }
  result(build, op.data(), reps, triangles, pieces, lines, "");
  return 0;
}
