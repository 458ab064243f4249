import { decoded } from './encoded_array';
import type { ReportData } from './report_data';

/**
 * The model x = mean + sum of score * mode. A mode is the displacement by one standard deviation. Lengths are in mm.
 */
export class ShapeModel {
  readonly landmarks: number;
  readonly modes: number;
  /** The number of modes of the model that are not in the page. */
  readonly modesLeftOut: number;
  readonly varianceShares: number[];
  readonly mean: Float32Array;
  readonly triangles: Uint32Array;
  private readonly displacements: Float32Array[];

  constructor(data: ReportData['model']) {
    this.mean = decoded(data.mean, 'f32');
    this.triangles = decoded(data.triangles, 'u32');
    this.landmarks = this.mean.length / 3;
    this.modes = data.modes.shape[0];
    this.modesLeftOut = data.modes_of_model - this.modes;
    this.varianceShares = data.variance_shares;
    const all = decoded(data.modes, 'f32');
    const size = this.mean.length;
    this.displacements = Array.from({ length: this.modes }, (_, m) => all.subarray(m * size, (m + 1) * size));
  }

  /** The landmarks (x y z each) of the shape with these scores of the first modes, in standard deviations. */
  shapeOf(scores: ArrayLike<number>, modes = this.modes): Float32Array {
    const shape = this.mean.slice();
    for (let m = 0; m < Math.min(modes, scores.length); ++m) {
      const score = scores[m];
      if (score === 0) continue;
      const mode = this.displacements[m];
      for (let i = 0; i < shape.length; ++i) shape[i] += score * mode[i];
    }
    return shape;
  }

  /** The distance by which one standard deviation of a mode moves each landmark. */
  strengthOf(mode: number): Float32Array {
    const d = this.displacements[mode];
    return Float32Array.from({ length: this.landmarks }, (_, i) => Math.hypot(d[3 * i], d[3 * i + 1], d[3 * i + 2]));
  }
}

/** The distance of each landmark of one shape to the same landmark of another. */
export function landmarkDistances(a: Float32Array, b: Float32Array): Float32Array {
  const distances = new Float32Array(a.length / 3);
  for (let i = 0; i < distances.length; ++i)
    distances[i] = Math.hypot(a[3 * i] - b[3 * i], a[3 * i + 1] - b[3 * i + 1], a[3 * i + 2] - b[3 * i + 2]);
  return distances;
}

/** The largest value; 0 if there are none. */
export function largest(values: ArrayLike<number>): number {
  let most = values.length > 0 ? -Infinity : 0;
  for (let i = 0; i < values.length; ++i) most = Math.max(most, values[i]);
  return most;
}

export function rootMeanSquare(values: Float32Array): number {
  let sum = 0;
  for (const v of values) sum += v * v;
  return Math.sqrt(sum / values.length);
}
