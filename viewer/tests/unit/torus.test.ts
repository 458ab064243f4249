import { describe, expect, it } from 'vitest';
import { copiesOverDomain, TorusLayout } from '../../src/explorer/torus_layout';
import { Report } from '../../src/model/report';
import { smallReport } from '../support/small_report';

const { model, torus } = new Report(smallReport());

const signedArea = (p: ArrayLike<number>) => ((p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1])) / 2;

// The part of a polygon in which coordinate c is at least (sign 1) or at most (sign -1) the bound.
function clipped(polygon: [number, number][], c: 0 | 1, sign: number, bound: number): [number, number][] {
  const inside = (p: [number, number]) => sign * (p[c] - bound) >= 0;
  return polygon.flatMap((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const out: [number, number][] = inside(p) ? [p] : [];
    if (inside(p) !== inside(q)) {
      const s = (bound - p[c]) / (q[c] - p[c]);
      out.push([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])]);
    }
    return out;
  });
}

describe('Torus', () => {
  it('lays the corners of a triangle beside each other, so that areas sum to one turn squared', () => {
    let sum = 0;
    for (let t = 0; t < model.triangles.length / 3; ++t) {
      const area = signedArea(torus.cornerTurns.subarray(6 * t, 6 * t + 6));
      expect(area).toBeGreaterThan(0);
      sum += area;
    }
    expect(sum).toBeCloseTo(1, 5);
  });
  it('goes to the plane and back', () => {
    const [u, v] = torus.fromPlane(...torus.inPlane(0.3, 0.9));
    expect([u, v]).toEqual([expect.closeTo(0.3, 9), expect.closeTo(0.9, 9)]);
  });
  it('finds the nearest landmark across the borders', () => {
    for (let i = 0; i < model.landmarks; ++i)
      expect(torus.nearestLandmark(torus.turns[2 * i] + 0.999, torus.turns[2 * i + 1] - 1.001)).toBe(i);
  });
});

describe('copiesOverDomain', () => {
  it('covers the domain once', () => {
    const { triangles, turns } = copiesOverDomain(torus.cornerTurns);
    let covered = 0;
    for (let i = 0; i < triangles.length; ++i) {
      let polygon = [0, 1, 2].map((k) => [turns[6 * i + 2 * k], turns[6 * i + 2 * k + 1]] as [number, number]);
      for (const c of [0, 1] as const) polygon = clipped(clipped(polygon, c, 1, 0), c, -1, 1);
      for (let k = 1; k + 1 < polygon.length; ++k)
        covered += signedArea([...polygon[0], ...polygon[k], ...polygon[k + 1]]);
    }
    expect(covered).toBeCloseTo(1, 5);
  });
});

describe('TorusLayout', () => {
  it('lays the longer period across and keeps lengths', () => {
    const layout = new TorusLayout(torus);
    const [origin, along] = [layout.place(0, 0), layout.place(1, 0)];
    expect(along[1] - origin[1]).toBeCloseTo(0, 9);
    expect(along[0] - origin[0]).toBeCloseTo(1.5, 9);
    const [u, v] = layout.turnsAt(...layout.place(0.2, 0.7));
    expect([u, v]).toEqual([expect.closeTo(0.2, 9), expect.closeTo(0.7, 9)]);
  });
});
