import { describe, expect, it } from 'vitest';
import { roundedUp } from '../../src/explorer/ramp';
import { Exhibitor } from '../../src/explorer/shown';
import { initialState } from '../../src/explorer/state';
import { Report } from '../../src/model/report';
import { smallReport } from '../support/small_report';

const report = new Report(smallReport());
const exhibitor = new Exhibitor(report);
const state = () => initialState(report);

describe('Exhibitor', () => {
  it('shows the shape of the sliders, coloured by how far it is from the mean', () => {
    const shown = exhibitor.shown({
      ...state(),
      scores: [1, 0],
      colouring: { ...state().colouring, modes: 'displacement' },
    });
    expect(shown.surfaces).toHaveLength(1);
    expect(shown.surfaces[0].points).toEqual(report.model.shapeOf([1, 0]));
    expect(Math.max(...shown.surfaces[0].values!)).toBeCloseTo(2.8, 4);
    expect(shown.status).toContain('Mode 1 at +1.0 sd');
    expect(shown.scale!.end).toBeGreaterThanOrEqual(2.8);
  });
  it('counts triangles that the sliders turn over', () => {
    const mirrored = exhibitor.shown({ ...state(), scores: [-20, 0] });
    expect(mirrored.surfaces[0].flipped.length).toBeGreaterThan(40);
    expect(mirrored.status).toContain('no possible shape');
  });
  it('shows a training shape beside a fit that reaches it with all modes', () => {
    const of = (fitModes: number) =>
      exhibitor.shown({
        ...state(),
        tab: 'shapes',
        shape: 0,
        fitModes,
        colouring: { ...state().colouring, shapes: 'fit' },
      });
    expect(of(2).surfaces[1].points).toEqual(of(2).surfaces[0].points);
    expect(Math.max(...of(2).surfaces[0].values!)).toBe(0);
    const first = of(1);
    const missed = Math.max(...first.surfaces[0].values!);
    expect(missed).toBeCloseTo(0.8 * Math.sin((2 * Math.PI) / 5), 4);
    expect(first.status).toContain(`${missed.toFixed(2)} mm at most`);
  });
  it('shows recorded errors and flips of a training shape', () => {
    const shown = exhibitor.shown({ ...state(), tab: 'shapes', shape: 2 });
    expect(shown.surfaces[0].values).toEqual(report.shapes[2].errors);
    expect(shown.surfaces[0].flipped).toEqual([3, 7]);
    expect(shown.surfaces[1].values).toBeNull();
  });
});

describe('roundedUp', () => {
  it('is a round number not below the value and less than double', () => {
    for (const value of [0.0123, 0.3, 1, 1.01, 3.7, 9.9, 10, 640]) {
      expect(roundedUp(value)).toBeGreaterThanOrEqual(value * (1 - 1e-9));
      expect(roundedUp(value)).toBeLessThan(2 * value);
      expect(Number(roundedUp(value).toPrecision(2))).toBeCloseTo(roundedUp(value), 9);
    }
    expect(roundedUp(0)).toBe(1);
  });
});
