import { decoded } from './encoded_array';
import { Loop } from './loop';
import type { ReportData, TrainingShape } from './report_data';
import { ShapeModel } from './shape_model';
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
