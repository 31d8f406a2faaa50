// Finite elements on a mesh that no process holds. Solves Laplace's equation with linear elements on a plate with a
// hole; the values on the boundary are those of the harmonic function exp(x) sin(y). Halving the edges divides the
// error by four.
//   mpirun -n 3 example_laplace_in_pieces
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <pardel/distributed/distributed.hpp>
#include <pardel/mpi/mpi_ranks.hpp>
#include <pardel/pardel.hpp>
#include <vector>

namespace {

using Vector = std::vector<double>;  // one value per vertex of the piece

double solution(pardel::Point p) { return std::exp(p.x) * std::sin(p.y); }

double sum_over_ranks(double value) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

/// A triangle of the plane: its area, and the gradients of the functions that are 1 at one corner and 0 at the others.
struct Element {
  double area;
  std::array<pardel::Point, 3> gradient;

  explicit Element(const std::array<pardel::Point, 3>& p) {
    area = 0.5 * ((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
    for (std::size_t i = 0; i < 3; ++i) {
      const pardel::Point a = p[(i + 1) % 3], b = p[(i + 2) % 3];
      gradient[i] = {(a.y - b.y) / (2 * area), (b.x - a.x) / (2 * area)};
    }
  }
};

class Laplace {
 public:
  explicit Laplace(const pardel::MeshPiece& piece) : piece_(piece), mesh_(piece.mesh) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    // A vertex may be in the pieces of several ranks. In sums over all vertices, the first of these ranks counts it.
    is_counted_.assign(mesh_.points.size(), 1);
    for (const pardel::SharedVertices& shared : piece_.shared) {
      at_border_.insert(at_border_.end(), shared.vertices.begin(), shared.vertices.end());
      for (const pardel::Index v : shared.vertices)
        if (shared.rank < rank_) is_counted_[v] = 0;
    }
    std::ranges::sort(at_border_);
    at_border_.erase(std::unique(at_border_.begin(), at_border_.end()), at_border_.end());
    assemble();
  }

  /// Conjugate gradients. Returns the number of steps.
  int solve(Vector& u) const {
    const std::size_t n = mesh_.points.size();
    u.assign(n, 0);
    for (std::size_t v = 0; v < n; ++v)
      if (is_boundary(v)) u[v] = solution(mesh_.points[v]);
    Vector residual = times(u), direction(n);
    for (double& r : residual) r = -r;
    direction = residual;
    double squared = dot(residual, residual);
    const double goal = 1e-24 * squared;
    int steps = 0;
    for (; squared > goal; ++steps) {
      const Vector image = times(direction);
      const double step = squared / dot(direction, image);
      for (std::size_t v = 0; v < n; ++v) {
        u[v] += step * direction[v];
        residual[v] -= step * image[v];
      }
      const double before = squared;
      squared = dot(residual, residual);
      for (std::size_t v = 0; v < n; ++v) direction[v] = residual[v] + squared / before * direction[v];
    }
    return steps;
  }

  /// The error in the L2 norm, by a rule that is exact for quadratic functions, and the largest one at a vertex.
  [[nodiscard]] std::array<double, 2> errors(const Vector& u) const {
    double squared = 0, largest = 0;
    for (const pardel::Triangle& t : mesh_.triangles) {
      const auto p = corners(t);
      const double weight = Element(p).area / 3;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const pardel::Point middle{0.5 * (p[i].x + p[j].x), 0.5 * (p[i].y + p[j].y)};
        const double error = 0.5 * (u[t.v[i]] + u[t.v[j]]) - solution(middle);
        squared += weight * error * error;
      }
    }
    for (std::size_t v = 0; v < u.size(); ++v) largest = std::max(largest, std::abs(u[v] - solution(mesh_.points[v])));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return {std::sqrt(sum_over_ranks(squared)), largest};
  }

 private:
  /// Without markers in the input, exactly the vertices on the boundary have one.
  [[nodiscard]] bool is_boundary(std::size_t v) const { return mesh_.point_markers[v] != 0; }
  [[nodiscard]] std::array<pardel::Point, 3> corners(const pardel::Triangle& t) const {
    return {mesh_.points[t.v[0]], mesh_.points[t.v[1]], mesh_.points[t.v[2]]};
  }

  /// The sum over the triangles of this piece, row by row: row v is entries_[start_[v]] to entries_[start_[v + 1] - 1].
  void assemble() {
    std::vector<Entry> all;
    for (const pardel::Triangle& t : mesh_.triangles) {
      const Element element(corners(t));
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const pardel::Point a = element.gradient[i], b = element.gradient[j];
          all.push_back({t.v[i], t.v[j], element.area * (a.x * b.x + a.y * b.y)});
        }
    }
    std::ranges::sort(
        all, [](const Entry& a, const Entry& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
    start_.assign(mesh_.points.size() + 1, 0);
    for (const Entry& e : all) {
      if (!entries_.empty() && entries_.back().row == e.row && entries_.back().column == e.column) {
        entries_.back().value += e.value;
      } else {
        entries_.push_back(e);
        ++start_[e.row + 1];
      }
    }
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) start_[v + 1] += start_[v];
  }

  /// The product with the matrix of the whole mesh. Rows of the boundary are zero.
  [[nodiscard]] Vector times(const Vector& x) const {
    Vector y(x.size(), 0);
    for (std::size_t v = 0; v < x.size(); ++v)
      for (std::size_t k = start_[v]; k < start_[v + 1]; ++k) y[v] += entries_[k].value * x[entries_[k].column];
    add_shared(y);
    for (std::size_t v = 0; v < x.size(); ++v)
      if (is_boundary(v)) y[v] = 0;
    return y;
  }

  /// Each shared vertex gets the sum of its values on all ranks that have it. All of them add in the order of the
  /// ranks, so they get the same number.
  void add_shared(Vector& x) const {
    const std::size_t count = piece_.shared.size();
    std::vector<Vector> sent(count), arrived(count);
    std::vector<MPI_Request> requests(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
      const pardel::SharedVertices& shared = piece_.shared[i];
      for (const pardel::Index v : shared.vertices) sent[i].push_back(x[v]);
      arrived[i].resize(sent[i].size());
      const auto n = static_cast<int>(sent[i].size());
      MPI_Irecv(arrived[i].data(), n, MPI_DOUBLE, shared.rank, 0, MPI_COMM_WORLD, &requests[2 * i]);
      MPI_Isend(sent[i].data(), n, MPI_DOUBLE, shared.rank, 0, MPI_COMM_WORLD, &requests[2 * i + 1]);
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    const Vector own = x;
    for (const pardel::Index v : at_border_) x[v] = 0;
    std::size_t i = 0;
    for (; i < count && piece_.shared[i].rank < rank_; ++i) add(arrived[i], piece_.shared[i].vertices, x);
    for (const pardel::Index v : at_border_) x[v] += own[v];
    for (; i < count; ++i) add(arrived[i], piece_.shared[i].vertices, x);
  }
  static void add(const Vector& values, const std::vector<pardel::Index>& at, Vector& x) {
    for (std::size_t k = 0; k < values.size(); ++k) x[at[k]] += values[k];
  }

  [[nodiscard]] double dot(const Vector& a, const Vector& b) const {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
      if (is_counted_[v] != 0) sum += a[v] * b[v];
    return sum_over_ranks(sum);
  }

  struct Entry {
    pardel::Index row, column;
    double value;
  };

  const pardel::MeshPiece& piece_;
  const pardel::Mesh& mesh_;
  int rank_ = 0;
  std::vector<char> is_counted_;
  std::vector<pardel::Index> at_border_;  // the shared vertices
  std::vector<Entry> entries_;
  std::vector<std::size_t> start_;
};

int run() {
  pardel::mpi::MpiRanks ranks;
  pardel::Pslg plate;
  plate.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  plate.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  plate.holes = {{0.5, 0.5}};
  const auto domain = pardel::validate(plate);
  if (!domain) return 1;
  if (ranks.rank() == 0) std::printf("longest edge   vertices  steps   L2 error  max error\n");
  for (const double longest_edge : {0.1, 0.05, 0.025}) {
    // The tiles are small, so that the small meshes of this example are divided, too.
    const auto piece = pardel::mesh(
        *domain, {.min_angle_deg = 28, .max_area = 0.3 * longest_edge * longest_edge, .max_edge = longest_edge},
        {.threads = 1, .triangles_per_tile = 200}, ranks);
    if (!piece) {
      std::fprintf(stderr, "%s\n", piece.error().message.c_str());
      return 1;
    }
    const Laplace laplace(*piece);
    Vector u;
    const int steps = laplace.solve(u);
    const auto [l2, largest] = laplace.errors(u);
    if (ranks.rank() == 0)
      std::printf("%12g %10llu %6d %.16e %.16e\n", longest_edge, static_cast<unsigned long long>(piece->points), steps,
                  l2, largest);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  const int code = run();
  if (code != 0) MPI_Abort(MPI_COMM_WORLD, code);  // the other ranks may wait for this one
  MPI_Finalize();
  return 0;
}
