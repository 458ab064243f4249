import { expect, it } from 'vitest';
import { Report } from '../../src/model/report';
import { sheetOf, spread } from '../../src/model/sheet';
import { smallReport } from '../support/small_report';

const { model, torus } = new Report(smallReport());
const sheet = sheetOf(model.triangles, torus.cornerTurns, torus.turns);

it('a sheet has the corners of the triangles at their places', () => {
  sheet.corners.forEach((vertex, i) => {
    expect(sheet.landmarks[vertex]).toBe(model.triangles[i]);
    for (const c of [0, 1]) expect(sheet.turns[2 * vertex + c]).toBeCloseTo(torus.cornerTurns[2 * i + c], 5);
  });
});

it('no vertex of a sheet stands twice', () => {
  const places = new Set(
    Array.from(sheet.landmarks, (landmark, i) =>
      [
        landmark,
        Math.round(sheet.turns[2 * i] - torus.turns[2 * landmark]),
        Math.round(sheet.turns[2 * i + 1] - torus.turns[2 * landmark + 1]),
      ].join(),
    ),
  );
  expect(places.size).toBe(sheet.landmarks.length);
  expect(sheet.landmarks.length).toBeLessThan(2 * model.landmarks);
});

it('numbers are spread from landmarks to vertices', () => {
  const target = new Float32Array(3 * sheet.landmarks.length);
  spread(target, 3, model.mean, sheet.landmarks);
  sheet.landmarks.forEach((landmark, i) => expect(target[3 * i + 2]).toBe(model.mean[3 * landmark + 2]));
});
