// The colours of distances: from the colour of bone for 0 through amber and red to plum, with decreasing lightness.
export const ramp = ['#e2d6c4', '#ecb55f', '#dd6f3a', '#b0273f', '#4d1450'] as const;

export const boneColour = ramp[0];
/** The colour of flipped triangles, which differs from those of the ramp and of the loops. */
export const flipColour = '#00b4e6';
export const loopColours = ['#c81e1e', '#145ac8'] as const;

export function channels(colour: string): [number, number, number] {
  const at = (i: number) => parseInt(colour.slice(i, i + 2), 16) / 255;
  return [at(1), at(3), at(5)];
}

/** A round number that is at least the value and not much larger; 1 for the value 0. */
export function roundedUp(value: number): number {
  if (!(value > 0)) return 1;
  const magnitude = 10 ** Math.floor(Math.log10(value));
  for (const factor of [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8])
    if (factor * magnitude >= value * (1 - 1e-9)) return factor * magnitude;
  return 10 * magnitude;
}
