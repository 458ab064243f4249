import { describe, expect, it } from 'vitest';
import { Mark } from '../../src/model/mark';
import type { MarkData } from '../../src/model/report_data';
import { Report } from '../../src/model/report';
import { areaVectors, pointNormals } from '../../src/model/surface';
import { encoded, smallReport } from '../support/small_report';

// Two shapes with a mark of three points each; point i is nearest to corner i % 3 of triangle i.
function markData(kind: MarkData['kind']): MarkData {
  const weights = Array.from({ length: 6 }, (_, i) => [0, 1, 2].map((k) => (k === i % 3 ? 0.5 : 0.25)));
  return {
    name: 'rim',
    kind,
    colour: '#0072b2',
    scatter_mm: 0.5,
    shapes: encoded(new Uint32Array([0, 2]), [2]),
    places: {
      triangles: encoded(new Uint32Array([0, 1, 2, 3, 4, 5]), [6]),
      weights: encoded(new Float32Array(weights.flat()), [6, 3]),
    },
  };
}

describe('a mark', () => {
  it('is joined within each shape: an open curve from end to end, a closed one all round, a point not', () => {
    expect([...new Mark(markData('open')).pieces()]).toEqual([0, 1, 1, 2, 3, 4, 4, 5]);
    expect([...new Mark(markData('closed')).pieces()]).toEqual([0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3]);
    expect(new Mark(markData('point')).pieces().length).toBe(0);
  });

  it('moves with the surface on which it lies', () => {
    const report = new Report({ ...smallReport(), marks: [markData('open')] });
    const { model, marks } = report;
    const { triangles } = model;
    for (const scores of [
      [0, 0],
      [2, -1],
    ]) {
      const points = model.shapeOf(scores);
      const normals = pointNormals(model.landmarks, triangles, areaVectors(points, triangles));
      const on = marks[0].points.lifted(points, normals, triangles, 0),
        above = marks[0].points.lifted(points, normals, triangles, 0.25);
      for (let i = 0; i < 6; ++i)
        for (let c = 0; c < 3; ++c) {
          const corner = (k: number, of: Float32Array) => of[3 * triangles[3 * i + k] + c];
          const mean = (of: Float32Array) => 0.25 * (corner(0, of) + corner(1, of) + corner(2, of) + corner(i % 3, of));
          expect(on[3 * i + c]).toBeCloseTo(mean(points), 4);
          expect(above[3 * i + c] - on[3 * i + c]).toBeCloseTo(0.25 * mean(normals), 4);
        }
    }
  });
});
