import { decoded } from './encoded_array';
import type { EncodedPlaces } from './report_data';

/** Points of the landmark mesh, such as those of a loop. They exist on every shape, so they can be drawn on each. */
export class SurfacePoints {
  private readonly triangles: Uint32Array;
  private readonly weights: Float32Array;

  constructor(data: EncodedPlaces) {
    this.triangles = decoded(data.triangles, 'u32');
    this.weights = decoded(data.weights, 'f32');
  }

  get length(): number {
    return this.triangles.length;
  }

  /**
   * The values at the points, for values at the landmarks with `size` numbers each. Those of point i begin at size * i.
   */
  values(size: number, valueOf: (triangle: number, corner: number, component: number) => number): Float32Array {
    const values = new Float32Array(size * this.length);
    for (let i = 0; i < this.length; ++i)
      for (let c = 0; c < size; ++c)
        for (let k = 0; k < 3; ++k) values[size * i + c] += this.weights[3 * i + k] * valueOf(this.triangles[i], k, c);
    return values;
  }

  /** The places of the points on a shape, moved outward by `lift` mm along the normals of its landmarks. */
  lifted(points: Float32Array, normals: Float32Array, triangles: Uint32Array, lift: number): Float32Array {
    return this.values(3, (triangle, corner, c) => {
      const at = 3 * triangles[3 * triangle + corner] + c;
      return points[at] + lift * normals[at];
    });
  }
}
