import type { Torus } from '../model/torus';

/** The placement of the torus domain in a picture: its longer period is horizontal, and y is upward. */
export class TorusLayout {
  private readonly cosine: number;
  private readonly sine: number;
  /** The corners of the parallelogram, in order around it. */
  readonly corners: [number, number][];
  readonly low: [number, number];
  readonly high: [number, number];

  constructor(private readonly torus: Torus) {
    const first = torus.inPlane(1, 0),
      second = torus.inPlane(0, 1);
    const across = Math.hypot(...first) >= Math.hypot(...second) ? first : second;
    const length = Math.hypot(...across);
    this.cosine = across[0] / length;
    this.sine = across[1] / length;
    this.corners = [this.place(0, 0), this.place(1, 0), this.place(1, 1), this.place(0, 1)];
    const range = (c: number, of: (...values: number[]) => number) => of(...this.corners.map((p) => p[c]));
    this.low = [range(0, Math.min), range(1, Math.min)];
    this.high = [range(0, Math.max), range(1, Math.max)];
  }

  place(u: number, v: number): [number, number] {
    const [x, y] = this.torus.inPlane(u, v);
    return [this.cosine * x + this.sine * y, this.cosine * y - this.sine * x];
  }

  turnsAt(x: number, y: number): [number, number] {
    return this.torus.fromPlane(this.cosine * x - this.sine * y, this.sine * x + this.cosine * y);
  }
}

/** Copies of the triangles, translated by whole turns, which together cover the domain. */
export function copiesOverDomain(cornerTurns: Float32Array): { triangles: Uint32Array; turns: Float32Array } {
  const triangles: number[] = [],
    turns: number[] = [];
  for (let t = 0; t < cornerTurns.length / 6; ++t) {
    const corners = cornerTurns.subarray(6 * t, 6 * t + 6);
    // Whole turns k for which the triangle's range [least, most] + k meets [0, 1].
    const [across, along] = [0, 1].map((c) => {
      const least = Math.min(corners[c], corners[2 + c], corners[4 + c]),
        most = Math.max(corners[c], corners[2 + c], corners[4 + c]);
      return [Math.ceil(-most), Math.floor(1 - least)];
    });
    for (let du = across[0]; du <= across[1]; ++du)
      for (let dv = along[0]; dv <= along[1]; ++dv) {
        triangles.push(t);
        for (let k = 0; k < 3; ++k) turns.push(corners[2 * k] + du, corners[2 * k + 1] + dv);
      }
  }
  return { triangles: Uint32Array.from(triangles), turns: Float32Array.from(turns) };
}
