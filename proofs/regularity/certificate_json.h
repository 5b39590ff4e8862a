// Meshes, witnesses and points of regularity certificates as JSON. Readers take one text per value and throw Rejected for others.
#pragma once

#include "proofs/certificate.h"
#include "proofs/regularity/cone_tests.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp {

/// {"points": [[..]], "faces": [[..]], "corners": [..]}: exact coordinates, two or three; corners rising.
Json to_json(const Surface<Rational>& surface);
Surface<Rational> surface_from(const Json& json);
RegularityMode mode_from(const Json& json);

/// {"path": "03", "test": "T2", and "sign": 1, or "n": [..] and "m": [..], or "n": [..]}.
Json to_json(const std::string& path, RegularityTest test, const RegularityWitness& witness);
struct LeafData {
  std::string path;
  RegularityTest test = RegularityTest::t2;
  RegularityWitness witness;
};
LeafData leaf_from(const Json& json, bool planar);

/// {"n": [..], "m": [..]}: what separates the edges of a whole mesh.
Json to_json(const RegularityWitness& separation);
RegularityWitness separation_from(const Json& json);

}  // namespace udcp
