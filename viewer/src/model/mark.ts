import { decoded } from './encoded_array';
import type { MarkData } from './report_data';
import { SurfacePoints } from './surface_points';

/** What people marked under one name, on all shapes that have it. */
export class Mark {
  readonly name: string;
  readonly isCurve: boolean;
  readonly colour: string;
  readonly scatter: number;
  readonly shapeCount: number;
  /** The points of all shapes, shape after shape. */
  readonly points: SurfacePoints;
  private readonly isClosed: boolean;

  constructor(data: MarkData) {
    this.name = data.name;
    this.isCurve = data.kind !== 'point';
    this.isClosed = data.kind === 'closed';
    this.colour = data.colour;
    this.scatter = data.scatter_mm;
    this.shapeCount = decoded(data.shapes, 'u32').length;
    this.points = new SurfacePoints(data.places);
  }

  /** The two points of each piece of the curves; none if the mark is a point. */
  pieces(): Uint32Array {
    if (!this.isCurve) return new Uint32Array(0);
    const size = this.points.length / this.shapeCount;
    const pieces: number[] = [];
    for (let start = 0; start < this.points.length; start += size)
      for (let i = 0; i < (this.isClosed ? size : size - 1); ++i) pieces.push(start + i, start + ((i + 1) % size));
    return Uint32Array.from(pieces);
  }
}
