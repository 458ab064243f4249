import { describe, expect, it } from 'vitest';
import { Report } from '../../src/model/report';
import { areaVectors, firstHit, opposing, pointNormals } from '../../src/model/surface';
import { smallReport } from '../support/small_report';

const { model } = new Report(smallReport());
const vectors = areaVectors(model.mean, model.triangles);

describe('areaVectors', () => {
  it('sum to zero over a closed surface', () => {
    for (let c = 0; c < 3; ++c) {
      let sum = 0;
      for (let i = c; i < vectors.length; i += 3) sum += vectors[i];
      expect(sum).toBeCloseTo(0, 3);
    }
  });
});

describe('pointNormals', () => {
  it('are unit vectors that point outward', () => {
    const normals = pointNormals(model.landmarks, model.triangles, vectors);
    for (let i = 0; i < model.landmarks; ++i) {
      const [x, y, z] = model.mean.subarray(3 * i),
        [nx, ny, nz] = normals.subarray(3 * i);
      expect(Math.hypot(nx, ny, nz)).toBeCloseTo(1, 5);
      const r = Math.hypot(x, y);
      expect(nx * (x - (20 * x) / r) + ny * (y - (20 * y) / r) + nz * z).toBeGreaterThan(4);
    }
  });
});

describe('opposing', () => {
  it('finds the triangles that are turned over', () => {
    expect(opposing(vectors, vectors)).toEqual([]);
    const turned = model.triangles.slice();
    [turned[3 * 5], turned[3 * 5 + 1]] = [turned[3 * 5 + 1], turned[3 * 5]];
    expect(opposing(areaVectors(model.mean, turned), vectors)).toEqual([5]);
  });
});

describe('firstHit', () => {
  it('finds each triangle from straight above its middle, and its nearest corner', () => {
    for (let t = 0; t < model.triangles.length / 3; ++t) {
      const corners = [0, 1, 2].map((k) => [
        ...model.mean.subarray(3 * model.triangles[3 * t + k], 3 * model.triangles[3 * t + k] + 3),
      ]);
      // Close to the first corner.
      const at = [0, 1, 2].map((c) => 0.8 * corners[0][c] + 0.12 * corners[1][c] + 0.08 * corners[2][c]);
      const n = [...vectors.subarray(3 * t, 3 * t + 3)],
        length = Math.hypot(...n);
      const origin = at.map((x, c) => x + n[c] / length);
      const hit = firstHit(
        model.mean,
        model.triangles,
        origin,
        n.map((x) => -x / length),
      );
      expect(hit).toMatchObject({ triangle: t, landmark: model.triangles[3 * t] });
      expect(hit!.at).toBeCloseTo(1, 3);
    }
  });
  it('finds nothing through the hole', () => {
    expect(firstHit(model.mean, model.triangles, [0, 0, 50], [0, 0, -1])).toBeNull();
  });
  it('finds nothing behind the eye', () => {
    expect(firstHit(model.mean, model.triangles, [20, 0, 50], [0, 0, 1])).toBeNull();
  });
});
