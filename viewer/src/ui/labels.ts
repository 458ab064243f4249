/** A point in pixels, y downward, and the width of its label. */
export interface LabelledPoint {
  x: number;
  y: number;
  width: number;
}

export interface LabelPlace {
  dx: number;
  dy: number;
  textAnchor: 'start' | 'middle' | 'end';
}

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const lineHeight = 13;
const gap = 11;
const choices: LabelPlace[] = [
  { dx: 0, dy: -gap, textAnchor: 'middle' },
  { dx: 0, dy: gap, textAnchor: 'middle' },
  { dx: gap - 3, dy: 0, textAnchor: 'start' },
  { dx: 3 - gap, dy: 0, textAnchor: 'end' },
];

/**
 * Places each label above, below, right or left of its point: at the first place where it overlaps no point and no
 * label placed before, if there is one.
 */
export function placeLabels(points: LabelledPoint[]): LabelPlace[] {
  const taken: Box[] = points.map((p) => ({ x: p.x - 4, y: p.y - 4, width: 8, height: 8 }));
  return points.map((point, i) => {
    const free = choices.find((choice) => {
      const box = boxOf(point, choice);
      return !taken.some((other, k) => k !== i && meets(box, other));
    });
    const place = free ?? choices[0];
    taken.push(boxOf(point, place));
    return place;
  });
}

function boxOf(point: LabelledPoint, place: LabelPlace): Box {
  const shift = { start: 0, middle: -point.width / 2, end: -point.width }[place.textAnchor];
  return {
    x: point.x + place.dx + shift,
    y: point.y + place.dy - lineHeight / 2,
    width: point.width,
    height: lineHeight,
  };
}

function meets(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}
