/**
 * The surface as vertices on the torus. A landmark has one vertex for each of its translates by whole turns that a
 * triangle uses.
 */
export interface Sheet {
  /** The landmark of each vertex. */
  landmarks: Uint32Array;
  /** The torus position of each vertex. */
  turns: Float32Array;
  /** Corners of the triangles. */
  corners: Uint32Array;
}

/**
 * Corners of triangles with the same landmark and the same place become one vertex. `turnsOf` has the positions of the
 * landmarks.
 */
export function sheetOf(cornerLandmarks: Uint32Array, cornerTurns: Float32Array, turnsOf: Float32Array): Sheet {
  const vertices = new Map<string, number>(),
    landmarks: number[] = [],
    turns: number[] = [];
  const corners = new Uint32Array(cornerLandmarks.length);
  cornerLandmarks.forEach((landmark, i) => {
    const whole = [0, 1].map((c) => Math.round(cornerTurns[2 * i + c] - turnsOf[2 * landmark + c]));
    const key = `${landmark} ${whole[0]} ${whole[1]}`;
    let vertex = vertices.get(key);
    if (vertex === undefined) {
      vertex = landmarks.length;
      vertices.set(key, vertex);
      landmarks.push(landmark);
      turns.push(cornerTurns[2 * i], cornerTurns[2 * i + 1]);
    }
    corners[i] = vertex;
  });
  return { landmarks: Uint32Array.from(landmarks), turns: Float32Array.from(turns), corners };
}

/** Copies the numbers of each landmark, `size` each, to its vertices. */
export function spread(target: Float32Array, size: number, values: Float32Array, landmarks: Uint32Array): void {
  for (let i = 0; i < landmarks.length; ++i)
    for (let c = 0; c < size; ++c) target[size * i + c] = values[size * landmarks[i] + c];
}
