#include "render/grid_cut.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

using Triangle = std::array<Vec2, 3>;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double area(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]) / 2; }

double area(const GridPiece& piece) {
  double doubled = 0;
  for (std::size_t i = 2; i < piece.corners.size(); ++i)
    doubled +=
        cross(piece.corners[i - 1].at - piece.corners[0].at, piece.corners[i].at - piece.corners[0].at);
  return doubled / 2;
}

// Triangles of sizes from a part of a cell to many cells. Some have corners on lines.
std::vector<Triangle> triangles() {
  Rng rng(5);
  std::vector<Triangle> out;
  for (int i = 0; i < 400; ++i) {
    const double size = std::pow(10.0, rng.uniform(-2, 1));
    Triangle t;
    for (Vec2& p : t) {
      p = Vec2(rng.uniform(-3, 3), rng.uniform(-3, 3)) + size * Vec2(rng.normal(), rng.normal());
      if (i % 4 == 0) p.x() = std::round(p.x());
      if (i % 6 == 0) p.y() = std::round(p.y());
    }
    out.push_back(t);
  }
  return out;
}

TEST(GridCut, EveryPieceLiesInItsCell) {
  for (const Triangle& t : triangles())
    for (const GridPiece& piece : cut_by_grid(t)) {
      EXPECT_GE(piece.corners.size(), 3u);
      for (const GridCorner& c : piece.corners)
        for (int k = 0; k < 2; ++k) {
          EXPECT_GE(c.at[k], piece.cell[k]);
          EXPECT_LE(c.at[k], piece.cell[k] + 1);
        }
    }
}

TEST(GridCut, PiecesKeepTheSenseOfRotationAndFillTheTriangle) {
  for (const Triangle& t : triangles()) {
    double sum = 0;
    for (const GridPiece& piece : cut_by_grid(t)) {
      EXPECT_GE(area(piece) * (area(t) < 0 ? -1 : 1), -1e-12);
      sum += area(piece);
    }
    EXPECT_NEAR(sum, area(t), 1e-12 * (1 + std::abs(area(t))));
  }
}

TEST(GridCut, BarycentricCoordinatesAreThoseOfTheCorners) {
  for (const Triangle& t : triangles())
    for (const GridPiece& piece : cut_by_grid(t))
      for (const GridCorner& c : piece.corners) {
        EXPECT_GE(c.barycentric.minCoeff(), 0);
        EXPECT_NEAR(c.barycentric.sum(), 1, 1e-14);
        const Vec2 at = c.barycentric[0] * t[0] + c.barycentric[1] * t[1] + c.barycentric[2] * t[2];
        EXPECT_NEAR((at - c.at).norm(), 0, 1e-12);
      }
}

// Every point of the triangle is in the piece of its cell, and no cell has two pieces.
TEST(GridCut, APointIsInThePieceOfItsCell) {
  Rng rng(6);
  for (const Triangle& t : triangles()) {
    if (std::abs(area(t)) < 1e-3) continue;
    const auto pieces = cut_by_grid(t);
    for (int i = 0; i < 20; ++i) {
      double u = rng.uniform(0, 1), v = rng.uniform(0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec2 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      const Vec2i cell(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
      int found = 0;
      for (const GridPiece& piece : pieces) {
        if (piece.cell != cell) continue;
        ++found;
        for (std::size_t k = 0; k < piece.corners.size(); ++k) {
          const Vec2& a = piece.corners[k].at;
          const Vec2& b = piece.corners[(k + 1) % piece.corners.size()].at;
          EXPECT_GE(cross(b - a, p - a) * (area(t) < 0 ? -1 : 1), -1e-10);
        }
      }
      EXPECT_EQ(found, 1);
    }
  }
}

TEST(GridCut, ATriangleThatNoLineCrossesIsOnePiece) {
  const Triangle touching{Vec2(2, -1), Vec2(3, -0.5), Vec2(2.5, 0)};  // three corners on lines
  const auto pieces = cut_by_grid(touching);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].cell, Vec2i(2, -1));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(pieces[0].corners[k].at, touching[k]);
}

TEST(GridCut, HalfOfABigSquareIsHalvesAndWholesOfItsCells) {
  const auto pieces = cut_by_grid({Vec2(0, 0), Vec2(3, 0), Vec2(0, 3)});
  int halves = 0, wholes = 0;
  for (const GridPiece& piece : pieces) {
    if (area(piece) == 0.5) ++halves;
    if (area(piece) == 1.0) ++wholes;
  }
  EXPECT_EQ(halves, 3);
  EXPECT_EQ(wholes, 3);
  EXPECT_EQ(pieces.size(), 6u);
}

}  // namespace
}  // namespace foramen
