// manifold_driver.cpp -- Manifold as a peer of peers/boolean/bench.py:
//
//   d_manifold union|inter|diff A.off B.off OUT.off|- REPS
//   d_manifold many OUT.off|- REPS A.off B.off ...
//
// Built by bench/peers.bash with its headers and io.h of the peers. `build` is
// what it makes of each mesh before. many: the union of all, in one call.
#include <manifold/manifold.h>

#include "io.h"

using manifold::Manifold;
using manifold::MeshGL64;
using manifold::OpType;

namespace {

Manifold solid_of(const Mesh &mesh)
{
  MeshGL64 gl;

  gl.numProp = 3;
  gl.vertProperties.assign(mesh.v, mesh.v + 3 * mesh.nv);
  gl.triVerts.assign(mesh.t, mesh.t + 3 * mesh.nt);
  return Manifold(gl);
}

OpType operation_of(const char *mode)
{
  return !strcmp(mode, "inter")  ? OpType::Intersect
         : !strcmp(mode, "diff") ? OpType::Subtract
                                 : OpType::Add;
}

void save(const char *name, const Manifold &solid)
{
  const MeshGL64 gl = solid.GetMeshGL64();
  const std::vector<int> t(gl.triVerts.begin(), gl.triVerts.end());
  std::vector<double> v;

  for (size_t i = 0; i < gl.NumVert(); i++) {
    const double *at = &gl.vertProperties[i * gl.numProp];
    v.insert(v.end(), at, at + 3);
  }
  save_off(name, v.data(), (long)(v.size() / 3), t.data(),
           (long)(t.size() / 3));
}

} // namespace

int main(int count, char **words)
{
  const bool many = count > 4 && !strcmp(words[1], "many");
  if (!many && count != 6) {
    return 2;
  }
  const char *out = words[many ? 2 : 4];
  const int reps = atoi(words[many ? 3 : 5]);
  std::vector<Mesh> mesh;
  for (int i = many ? 4 : 2; i < (many ? count : 4); i++) {
    mesh.push_back(load_off(words[i]));
  }
  std::vector<double> op((size_t)reps);
  std::vector<Manifold> solid;
  long triangles = 0;

  double start = now();
  for (const Mesh &m : mesh) {
    solid.push_back(solid_of(m));
  }
  const double build = now() - start;
  for (double &seconds : op) {
    start = now();
    const Manifold made = Manifold::BatchBoolean(solid, operation_of(words[1]));
    triangles = (long)made.NumTri(); // until then nothing is done
    seconds = now() - start;
    if (&seconds == &op.back()) {
      save(out, made);
    }
  }
  result(build, op.data(), reps, triangles, 0, 0, "");
  return 0;
}
