#include "parameterize/block_cholesky.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// The index of v in `rows`, which are sorted by order of elimination.
int place(const std::vector<int>& rows, const std::vector<int>& order, int v) {
  const auto it =
      std::lower_bound(rows.begin(), rows.end(), v, [&](int a, int b) { return order[a] < order[b]; });
  FORAMEN_ASSERT(it != rows.end() && *it == v);
  return static_cast<int>(it - rows.begin());
}

}  // namespace

void BlockMatrix::set_zero() {
  for (Mat2& m : diagonal) m.setZero();
  for (Mat2& m : coupling) m.setZero();
}

BlockCholesky::BlockCholesky(const Mesh& mesh, const Eigen::MatrixXd& coordinates) {
  const DissectionTree tree = dissect(mesh, coordinates);
  std::vector<int> order(mesh.vertex_count()), node_of(mesh.vertex_count());
  int next = 0;
  for (std::size_t k = 0; k < tree.size(); ++k)
    for (int v : tree[k].columns) {
      order[v] = next++;
      node_of[v] = static_cast<int>(k);
    }
  FORAMEN_ASSERT(next == mesh.vertex_count());
  fronts_.resize(tree.size());
  updates_.resize(tree.size());
  find_rows(mesh, tree, order);
  place_entries(mesh, order, node_of);
}

// The rows of a front are its columns and all later vertices that are neighbours of the columns or rows of
// its children.
void BlockCholesky::find_rows(const Mesh& mesh, const DissectionTree& tree, const std::vector<int>& order) {
  std::vector<int> seen_by(mesh.vertex_count(), -1);
  for (std::size_t k = 0; k < tree.size(); ++k) {
    Front& front = fronts_[k];
    front.columns = static_cast<int>(tree[k].columns.size());
    front.rows = tree[k].columns;
    for (int v : front.rows) seen_by[v] = static_cast<int>(k);
    const int last = front.columns > 0 ? order[front.rows.back()] : -1;
    const auto add = [&](int w) {
      if (seen_by[w] == static_cast<int>(k)) return;
      seen_by[w] = static_cast<int>(k);
      front.rows.push_back(w);
    };
    for (int v : tree[k].columns)
      for (HalfedgeId h : mesh.fan(VertexId(v)))
        if (order[mesh.to(h).index] > last) add(mesh.to(h).index);
    for (int child : tree[k].children) {
      if (child < 0) continue;
      front.children.push_back(child);
      const Front& c = fronts_[child];
      for (std::size_t i = c.columns; i < c.rows.size(); ++i) add(c.rows[i]);
    }
    std::sort(front.rows.begin() + front.columns, front.rows.end(),
              [&](int a, int b) { return order[a] < order[b]; });
    for (int child : front.children) {
      Front& c = fronts_[child];
      for (std::size_t i = c.columns; i < c.rows.size(); ++i)
        c.row_in_parent.push_back(place(front.rows, order, c.rows[i]));
    }
  }
}

void BlockCholesky::place_entries(const Mesh& mesh, const std::vector<int>& order,
                                  const std::vector<int>& node_of) {
  for (EdgeId e : mesh.edges()) {
    const int from = mesh.from(mesh.halfedge(e)).index, to = mesh.to(mesh.halfedge(e)).index;
    const bool from_first = order[from] < order[to];
    const int column = from_first ? from : to, row = from_first ? to : from;
    Front& front = fronts_[node_of[column]];
    // The stored block has the rows of `from`, but the entry below the diagonal needs the rows of the vertex
    // eliminated later.
    front.entries.push_back({e, place(front.rows, order, row), place(front.rows, order, column), from_first});
  }
}

void BlockCholesky::assemble(Front& front, Eigen::MatrixXd& update, const BlockMatrix& matrix) {
  const int below = static_cast<int>(front.rows.size()) - front.columns;
  front.factor.setZero(2 * static_cast<int>(front.rows.size()), 2 * front.columns);
  update.setZero(2 * below, 2 * below);
  for (int i = 0; i < front.columns; ++i)
    front.factor.block<2, 2>(2 * i, 2 * i) = matrix.diagonal[VertexId(front.rows[i])];
  for (const Entry& e : front.entries) {
    const Mat2& block = matrix.coupling[e.edge];
    if (e.transposed)
      front.factor.block<2, 2>(2 * e.row, 2 * e.column) = block.transpose();
    else
      front.factor.block<2, 2>(2 * e.row, 2 * e.column) = block;
  }
  for (int child : front.children) {
    const std::vector<int>& to = fronts_[child].row_in_parent;
    Eigen::MatrixXd& from = updates_[child];
    const int size = static_cast<int>(to.size());
    for (int j = 0; j < size; ++j) {
      const int column = to[j];
      const bool here = column < front.columns;
      Eigen::MatrixXd& target = here ? front.factor : update;
      const int shift = here ? 0 : front.columns;
      // Only the lower triangle is used, so entries above the diagonal of a diagonal block are arbitrary.
      for (int i = j; i < size; ++i)
        target.block<2, 2>(2 * (to[i] - shift), 2 * (column - shift)) += from.block<2, 2>(2 * i, 2 * j);
    }
    from.resize(0, 0);
  }
}

bool BlockCholesky::factor(const BlockMatrix& matrix) {
  for (std::size_t k = 0; k < fronts_.size(); ++k) {
    Front& front = fronts_[k];
    Eigen::MatrixXd& update = updates_[k];
    assemble(front, update, matrix);
    const Eigen::Index columns = 2 * front.columns, below = front.factor.rows() - columns;
    if (columns == 0) continue;
    auto top = front.factor.topRows(columns);
    auto bottom = front.factor.bottomRows(below);
    Eigen::Ref<Eigen::MatrixXd> pivot = top;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(pivot);
    if (in_place.info() != Eigen::Success) return false;
    if (below == 0) continue;
    pivot.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(bottom);
    update.selfadjointView<Eigen::Lower>().rankUpdate(bottom, -1.0);
  }
  return true;
}

void BlockCholesky::solve(Eigen::MatrixXd& rhs) const {
  Eigen::MatrixXd local, spread;
  for (const Front& front : fronts_) {
    const Eigen::Index columns = 2 * front.columns, below = front.factor.rows() - columns;
    if (columns == 0) continue;
    local.resize(columns, rhs.cols());
    for (int i = 0; i < front.columns; ++i) local.middleRows<2>(2 * i) = rhs.middleRows<2>(2 * front.rows[i]);
    front.factor.topRows(columns).triangularView<Eigen::Lower>().solveInPlace(local);
    for (int i = 0; i < front.columns; ++i) rhs.middleRows<2>(2 * front.rows[i]) = local.middleRows<2>(2 * i);
    spread.noalias() = front.factor.bottomRows(below) * local;
    for (std::size_t i = front.columns; i < front.rows.size(); ++i)
      rhs.middleRows<2>(2 * front.rows[i]) -= spread.middleRows<2>(2 * (static_cast<int>(i) - front.columns));
  }
  for (auto it = fronts_.rbegin(); it != fronts_.rend(); ++it) {
    const Front& front = *it;
    const Eigen::Index columns = 2 * front.columns, below = front.factor.rows() - columns;
    if (columns == 0) continue;
    local.resize(columns, rhs.cols());
    spread.resize(below, rhs.cols());
    for (int i = 0; i < front.columns; ++i) local.middleRows<2>(2 * i) = rhs.middleRows<2>(2 * front.rows[i]);
    for (std::size_t i = front.columns; i < front.rows.size(); ++i)
      spread.middleRows<2>(2 * (static_cast<int>(i) - front.columns)) = rhs.middleRows<2>(2 * front.rows[i]);
    local.noalias() -= front.factor.bottomRows(below).transpose() * spread;
    front.factor.topRows(columns).triangularView<Eigen::Lower>().transpose().solveInPlace(local);
    for (int i = 0; i < front.columns; ++i) rhs.middleRows<2>(2 * front.rows[i]) = local.middleRows<2>(2 * i);
  }
}

long BlockCholesky::entries() const {
  long sum = 0;
  for (const Front& front : fronts_) {
    const long n = 2 * front.columns, below = static_cast<long>(front.factor.rows()) - n;
    sum += n * (n + 1) / 2 + n * below;
  }
  return sum;
}

}  // namespace foramen
