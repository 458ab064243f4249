import { expect, it } from 'vitest';
import { placeLabels } from '../../src/ui/labels';

it('a label alone stands above its point', () => {
  expect(placeLabels([{ x: 0, y: 0, width: 60 }])).toEqual([{ dx: 0, dy: -11, textAnchor: 'middle' }]);
});

it('labels of close points keep apart', () => {
  const [first, second] = placeLabels([
    { x: 0, y: 0, width: 60 },
    { x: 20, y: 2, width: 60 },
  ]);
  expect(first.dy).toBe(-11);
  expect(second.dy).toBe(11);
});

it('a label does not cover another point', () => {
  const [first] = placeLabels([
    { x: 0, y: 0, width: 60 },
    { x: 5, y: -11, width: 60 },
  ]);
  expect(first.dy).not.toBe(-11);
});
