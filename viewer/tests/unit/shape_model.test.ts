import { describe, expect, it } from 'vitest';
import { Report } from '../../src/model/report';
import { landmarkDistances, rootMeanSquare } from '../../src/model/shape_model';
import { smallReport } from '../support/small_report';

const { model, shapes } = new Report(smallReport());

describe('ShapeModel', () => {
  it('adds scores times modes to the mean', () => {
    const shape = model.shapeOf([2, -1]);
    for (let i = 0; i < model.landmarks; ++i) {
      expect(shape[3 * i]).toBeCloseTo(1.2 * model.mean[3 * i], 4);
      expect(shape[3 * i + 1]).toBe(model.mean[3 * i + 1]);
      expect(shape[3 * i + 2]).toBeCloseTo(0.9 * model.mean[3 * i + 2], 4);
    }
  });
  it('takes the first modes only when asked to', () => {
    expect(model.shapeOf([2, -1], 1)).toEqual(model.shapeOf([2, 0]));
    expect(model.shapeOf([2, -1], 0)).toEqual(model.mean);
  });
  it('leaves the mean as it is', () => {
    const before = model.mean.slice();
    model.shapeOf([3, 3]);
    expect(model.mean).toEqual(before);
  });
  it('knows how far a mode moves a landmark', () => {
    const moved = landmarkDistances(model.shapeOf([1, 0]), model.mean);
    model.strengthOf(0).forEach((strength, i) => expect(strength).toBeCloseTo(moved[i], 4));
    expect(rootMeanSquare(Float32Array.from([3, 4, 0, 0]))).toBeCloseTo(2.5, 6);
  });
});

describe('Report', () => {
  it('gives errors in millimetres and flips as numbers', () => {
    expect(shapes[0].errors[7]).toBeCloseTo(0.07, 6);
    expect(shapes[2].plainFlips).toEqual([3, 7]);
    expect(shapes[2].confirmedFlips).toEqual([7]);
  });
});
