#include "../arithmetic/exact_sum.hpp"
#include "stages.hpp"

namespace pardel::checker {

void measure(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, Certificate& certificate) {
  scan.measures.report(certificate);
  certificate.area = covered_area(mesh.points.span(), adjacency).rounded() / 2;
}

}  // namespace pardel::checker
