import { decoded } from './encoded_array';
import { Loop } from './loop';
import type { ReportData, TrainingShape } from './report_data';
import { ShapeModel } from './shape_model';
import { Torus } from './torus';

/** A training shape with its numbers decoded. */
export interface Shape extends Omit<TrainingShape, 'error' | 'plain_flips' | 'confirmed_flips'> {
  /** Of each landmark: the largest distance between the landmarks' surface and the input around it, mm. */
  errors: Float32Array;
  plainFlips: number[];
  confirmedFlips: number[];
}

/** A report's data in the form that the page works with. */
export class Report {
  readonly model: ShapeModel;
  readonly torus: Torus;
  readonly loops: Loop[];
  readonly shapes: Shape[];

  constructor(readonly data: ReportData) {
    this.model = new ShapeModel(data.model);
    this.torus = new Torus(data.torus, this.model.triangles);
    this.loops = data.loops.map((loop) => new Loop(loop));
    this.shapes = data.shapes.map(({ error, plain_flips, confirmed_flips, ...shape }) => ({
      ...shape,
      errors: Float32Array.from(decoded(error, 'u16'), (units) => units * data.error_unit_mm),
      plainFlips: [...decoded(plain_flips, 'u32')],
      confirmedFlips: [...decoded(confirmed_flips, 'u32')],
    }));
  }
}
