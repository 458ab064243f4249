import { decoded } from './encoded_array';
import { Mark } from './mark';
import type { ReportData, TrainingShape } from './report_data';
import { ShapeModel } from './shape_model';
import { SurfacePoints } from './surface_points';
import { Torus } from './torus';

/** A training shape with its numbers decoded. */
export interface Shape extends Omit<TrainingShape, 'error' | 'plain_flips' | 'confirmed_flips'> {
  /** For each landmark, the largest distance [mm] between corresponding mesh and input around it. */
  errors: Float32Array;
  plainFlips: number[];
  confirmedFlips: number[];
}

/** The decoded data of a report. */
export class Report {
  readonly model: ShapeModel;
  readonly torus: Torus;
  /** Two closed curves. */
  readonly loops: SurfacePoints[];
  readonly marks: Mark[];
  readonly shapes: Shape[];

  constructor(readonly data: ReportData) {
    this.model = new ShapeModel(data.model);
    this.torus = new Torus(data.torus, this.model.triangles);
    this.loops = data.loops.map((loop) => new SurfacePoints(loop));
    this.marks = data.marks.map((mark) => new Mark(mark));
    this.shapes = data.shapes.map(({ error, plain_flips, confirmed_flips, ...shape }) => ({
      ...shape,
      errors: Float32Array.from(decoded(error, 'u16'), (units) => units * data.error_unit_mm),
      plainFlips: [...decoded(plain_flips, 'u32')],
      confirmedFlips: [...decoded(confirmed_flips, 'u32')],
    }));
  }
}
