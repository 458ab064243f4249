import type { Report } from '../model/report';
import { landmarkDistances, largest, rootMeanSquare } from '../model/shape_model';
import { areaVectors, opposing } from '../model/surface';
import { roundedUp } from './ramp';
import type { Colouring, State } from './state';

export interface ShownSurface {
  title: string;
  points: Float32Array;
  /** One distance per landmark [mm]; null if the colours do not show distances. */
  values: Float32Array | null;
  flipped: number[];
}

/** The meaning of the colours. */
export interface Scale {
  label: string;
  /** The value of the last colour [mm]. */
  end: number;
}

/** What is to be shown for a state: one surface, or a training shape and the model's fit of it. */
export interface Shown {
  surfaces: ShownSurface[];
  colouring: Colouring;
  scale: Scale | null;
  status: string;
}

/** Computes Shown from State, and keeps results that do not change. */
export class Exhibitor {
  private readonly meanVectors: Float32Array;
  private readonly strengths: Float32Array[];
  private readonly errorEnd: number;
  private readonly displacementEnd: number;
  private readonly shapeDisplacementEnd: number;

  constructor(private readonly report: Report) {
    const { model, shapes } = report;
    this.meanVectors = areaVectors(model.mean, model.triangles);
    this.errorEnd = roundedUp(largest(shapes.map((s) => largest(s.errors))));
    this.strengths = Array.from({ length: model.modes }, (_, m) => model.strengthOf(m));
    this.displacementEnd = model.modes > 0 ? roundedUp(2 * largest(this.strengths[0])) : 1;
    this.shapeDisplacementEnd = roundedUp(
      largest(shapes.map((s) => largest(landmarkDistances(model.shapeOf(s.scores), model.mean)))),
    );
  }

  shown(state: State): Shown {
    return state.tab === 'modes' ? this.ofModes(state) : this.ofShape(state);
  }

  private ofModes(state: State): Shown {
    const { model } = this.report;
    const points = model.shapeOf(state.scores);
    const colouring = state.colouring.modes;
    const flipped = opposing(areaVectors(points, model.triangles), this.meanVectors);
    const moved = landmarkDistances(points, model.mean);
    const values = colouring === 'strength' ? this.strengths[state.strengthMode] : moved;
    const scale =
      colouring === 'strength'
        ? {
            label: `how far 1 sd of mode ${state.strengthMode + 1} moves a landmark, mm`,
            end: roundedUp(largest(values)),
          }
        : { label: 'displacement from the mean, mm', end: this.displacementEnd };
    return {
      surfaces: [{ title: '', points, values: isScalar(colouring) ? values : null, flipped }],
      colouring,
      scale: isScalar(colouring) ? scale : null,
      status: state.scores.every((score) => score === 0)
        ? 'The mean shape: all sliders stand at 0.'
        : `${scoresText(state.scores)}. Landmarks move by ${rootMeanSquare(moved).toFixed(1)} mm (root mean square), ` +
          `${largest(moved).toFixed(1)} mm at most. ` +
          (flipped.length === 0
            ? 'No triangle is turned against the mean.'
            : `${flipped.length} triangles are turned against the mean: no possible shape.`),
    };
  }

  private ofShape(state: State): Shown {
    const { model, shapes } = this.report;
    const shape = shapes[state.shape];
    const points = model.shapeOf(shape.scores);
    const fit = model.shapeOf(shape.scores, state.fitModes);
    const missed = landmarkDistances(points, fit);
    const colouring = state.colouring.shapes;
    const values = { error: shape.errors, fit: missed, displacement: landmarkDistances(points, model.mean) };
    const scales: Record<keyof typeof values, Scale> = {
      error: { label: 'distance to the input surface, mm', end: this.errorEnd },
      fit: { label: 'distance to the fit, landmark to landmark, mm', end: this.shapeDisplacementEnd },
      displacement: { label: 'displacement from the mean, mm', end: this.shapeDisplacementEnd },
    };
    const kind = colouring as keyof typeof values;
    const scalar = isScalar(colouring);
    const ofFit = { error: null, fit: missed, displacement: landmarkDistances(fit, model.mean) };
    return {
      surfaces: [
        { title: shape.name, points, values: scalar ? values[kind] : null, flipped: shape.plainFlips },
        {
          title: `Fit by ${state.fitModes} of ${model.modes} modes`,
          points: fit,
          values: scalar ? ofFit[kind] : null,
          flipped: opposing(areaVectors(fit, model.triangles), this.meanVectors),
        },
      ],
      colouring,
      scale: scalar ? scales[kind] : null,
      status:
        `The fit misses ${shape.name} by ${rootMeanSquare(missed).toFixed(2)} mm (root mean square over landmarks), ` +
        `${largest(missed).toFixed(2)} mm at most. The model has seen this shape: all its modes fit it exactly.`,
    };
  }
}

export function isScalar(colouring: Colouring): boolean {
  return colouring === 'displacement' || colouring === 'strength' || colouring === 'error' || colouring === 'fit';
}

const shownScores = 4;

function scoresText(scores: number[]): string {
  const moved = scores.flatMap((s, m) =>
    s === 0 ? [] : [`mode ${m + 1} at ${s > 0 ? '+' : '−'}${Math.abs(s).toFixed(1)} sd`],
  );
  const named =
    moved.slice(0, shownScores).join(', ') +
    (moved.length > shownScores ? ` and ${moved.length - shownScores} more` : '');
  return named[0].toUpperCase() + named.slice(1);
}
