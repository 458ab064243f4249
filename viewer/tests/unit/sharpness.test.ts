import { expect, it } from 'vitest';
import { Sharpness } from '../../src/explorer/sharpness';

function after(frames: number, milliseconds: number, sharpness = new Sharpness()): number {
  let ratio = 0;
  for (let i = 0; i <= frames; ++i) ratio = sharpness.inMotion(i * milliseconds);
  return ratio;
}

it('falls on a slow machine and rises on a fast one', () => {
  expect(after(0, 16)).toBe(1);
  expect(after(10, 60)).toBeLessThan(1);
  expect(after(200, 16)).toBe(new Sharpness().sharpest);
});

it('is not misled by pauses', () => {
  expect(after(50, 1000)).toBe(1);
});
