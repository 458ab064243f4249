import { decoded } from './encoded_array';
import type { ReportData } from './report_data';

/** A closed curve on the landmark mesh, so that it can be drawn on every shape. */
export class Loop {
  private readonly triangles: Uint32Array;
  private readonly weights: Float32Array;

  constructor(data: ReportData['loops'][number]) {
    this.triangles = decoded(data.triangles, 'u32');
    this.weights = decoded(data.weights, 'f32');
  }

  get length(): number {
    return this.triangles.length;
  }

  /**
   * The values along the curve, for values at the landmarks with `size` numbers each. Those of point i begin at size *
   * i.
   */
  along(size: number, valueOf: (triangle: number, corner: number, component: number) => number): Float32Array {
    const curve = new Float32Array(size * this.length);
    for (let i = 0; i < this.length; ++i)
      for (let c = 0; c < size; ++c)
        for (let k = 0; k < 3; ++k) curve[size * i + c] += this.weights[3 * i + k] * valueOf(this.triangles[i], k, c);
    return curve;
  }
}
