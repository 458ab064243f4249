import { decoded } from './encoded_array';
import type { ReportData } from './report_data';

/** The landmarks on the flat torus, in turns: one turn is one period. */
export class Torus {
  readonly turns: Float32Array;
  /** Columns are the two periods in the plane; the area of the domain is 1. */
  readonly lattice: ReportData['torus']['lattice'];
  /**
   * The turns of each corner of each triangle, with whole turns added so that the corners of a triangle are close
   * together.
   */
  readonly cornerTurns: Float32Array;

  constructor(data: ReportData['torus'], triangles: Uint32Array) {
    this.lattice = data.lattice;
    this.turns = decoded(data.turns, 'f32');
    this.cornerTurns = continuedCorners(this.turns, decoded(data.jumps, 'i8'), triangles);
  }

  inPlane(u: number, v: number): [number, number] {
    const [[a, b], [c, d]] = this.lattice;
    return [a * u + b * v, c * u + d * v];
  }

  fromPlane(x: number, y: number): [number, number] {
    const [[a, b], [c, d]] = this.lattice;
    const determinant = a * d - b * c;
    return [(d * x - b * y) / determinant, (a * y - c * x) / determinant];
  }

  /** The landmark that is closest in the plane, also across the borders of the domain. */
  nearestLandmark(u: number, v: number): number {
    let best = -1,
      least = Infinity;
    for (let i = 0; i < this.turns.length / 2; ++i) {
      const du = toNearestTurn(this.turns[2 * i] - u),
        dv = toNearestTurn(this.turns[2 * i + 1] - v);
      const [x, y] = this.inPlane(du, dv);
      const squared = x * x + y * y;
      if (squared < least) [best, least] = [i, squared];
    }
    return best;
  }
}

/** The difference of two places on the circle, reduced to -1/2 .. 1/2 by whole turns. */
function toNearestTurn(difference: number): number {
  return difference - Math.round(difference);
}

// `jumps` has, for corner k of a triangle, the whole turns of its edge to the next corner.
function continuedCorners(turns: Float32Array, jumps: Int8Array, triangles: Uint32Array): Float32Array {
  const corners = new Float32Array(2 * triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const whole = [0, 0];
    for (let k = 0; k < 3; ++k)
      for (let c = 0; c < 2; ++c) {
        corners[2 * (t + k) + c] = turns[2 * triangles[t + k] + c] + whole[c];
        whole[c] += jumps[2 * (t + k) + c];
      }
  }
  return corners;
}
